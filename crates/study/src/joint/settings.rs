//! Settings of joint correspondence.

/// Settings of joint correspondence.
#[derive(Debug, Clone, PartialEq)]
pub struct JointSettings {
    /// Most subjects that make the model; the maps of all others are revised under it. Bounds memory and the
    /// decompositions of a round.
    pub most_in_model: usize,
    /// Parts of these subjects that are left out in turn; each subject alone if there are fewer.
    pub folds: usize,
    /// Share of the variance of the other subjects that the modes explain.
    pub explained: f64,
    /// Most modes, as a share of the other subjects: the same bound as for distances from a shape model.
    pub most_modes: f64,
    /// Bound of the stiffness, which is estimated; the equations of slides need more steps the nearer it is to 1.
    pub most_stiffness: f64,
    /// Most steps of the solution of these equations in a round; the next round continues where they end.
    pub steps: usize,
    /// Longest slide of a vertex in a round, in mean edges: tangent planes leave a curved surface.
    pub longest_slide: f64,
    /// Most rounds.
    pub max_rounds: usize,
    /// RMS slide of a round, in mean edges, below which maps rest.
    pub tolerance: f64,
    /// Rounds that fit the mapped template to the vertices of a subject in the end.
    pub fitting_rounds: usize,
}

impl Default for JointSettings {
    fn default() -> Self {
        JointSettings {
            most_in_model: 500,
            folds: 20,
            explained: 0.9,
            most_modes: 0.25,
            most_stiffness: 0.98,
            steps: 40,
            longest_slide: 0.5,
            max_rounds: 12,
            tolerance: 0.03,
            fitting_rounds: 2,
        }
    }
}
