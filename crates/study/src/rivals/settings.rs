//! Numbers that decide about the poses of subjects, each with its reason.

/// Settings of the decision between candidates.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct GroupSettings {
    /// Marginal probability from which a candidate is taken: the conventional level, one error in twenty.
    pub level: f64,
    /// Patches of the template whose mean positions are compared. Shapes vary smoothly, in far fewer directions.
    pub patches: usize,
    /// Most reliable subjects whose shapes are observed; more hardly change their mean.
    pub most_observed: usize,
    /// Most variables that are decided together; bounds the memory of the pairwise potentials.
    pub together: usize,
    /// Share of the old message that is kept; damps oscillations in loops.
    pub damping: f32,
    /// Iterations of belief propagation. Messages between all pairs settle in tens; a message of `exp(−80)` takes 116 halvings by the
    /// damping, and no tolerance in the largest message sees it.
    pub iterations: u32,
}

impl Default for GroupSettings {
    fn default() -> Self {
        GroupSettings { level: 0.95, patches: 256, most_observed: 200, together: 200, damping: 0.5, iterations: 200 }
    }
}
