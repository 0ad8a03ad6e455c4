//! The annealing schedule: values that change geometrically from step to step.

/// The value between `from` and `to`, both positive, at `progress` from 0 to 1, by geometric interpolation.
pub fn annealed(from: f64, to: f64, progress: f64) -> f64 {
    from * (to / from).powf(progress)
}

/// Progress at `step` (from 0) of `steps` when the last step reaches the end value.
pub fn progress_to_end(step: u32, steps: u32) -> f64 {
    f64::from(step) / f64::from(steps.saturating_sub(1).max(1))
}

/// Progress at `step` (from 0) of `steps > 0` if the end value is reserved for the step after the last: the evaluation
/// of the result, or the next stage.
pub fn progress_short_of_end(step: u32, steps: u32) -> f64 {
    f64::from(step) / f64::from(steps)
}
