//! How fast the scale of a stage falls: a step is repeated while it still moves the surface.
//!
//! Pairs of hippocampi settle within few steps at each scale, surfaces bent against each other need many. A fixed
//! number of steps would be slow for the former or too few for the latter.

use homolog_registration::alignment::progress_to_end;
use nalgebra::Point3;

/// Root mean square movement in a step above which it is repeated, in roots of the area.
pub(super) const SETTLED: f64 = 0.006;

/// The steps of one stage.
pub(crate) struct Schedule {
    /// The next step, from 0.
    step: u32,
    steps: u32,
    /// Remaining repetitions.
    spare: u32,
    settled_mm: f64,
    is_settled: bool,
}

impl Schedule {
    /// `steps` over the scales of a stage, with at most this many `repetitions`; `root_mm` is the root of the area, mm.
    pub(crate) fn new(steps: u32, repetitions: u32, root_mm: f64) -> Schedule {
        Schedule { step: 0, steps, spare: repetitions, settled_mm: SETTLED * root_mm, is_settled: true }
    }

    /// The progress of the stage, from 0 to 1, at which the next step is made; `None` at the end.
    pub(crate) fn next(&mut self) -> Option<f64> {
        if !self.is_settled && self.spare > 0 {
            self.spare -= 1;
            self.step -= 1;
        }
        let step = self.step;
        self.step += 1;
        (step < self.steps).then(|| progress_to_end(step, self.steps))
    }

    /// Records how far a step has moved the points of a surface.
    pub(crate) fn note(&mut self, before: &[Point3<f64>], after: &[Point3<f64>]) {
        let squares: f64 = before.iter().zip(after).map(|(p, q)| (p - q).norm_squared()).sum();
        self.is_settled = squares <= before.len() as f64 * self.settled_mm * self.settled_mm;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The progress of each step of a stage whose steps move the surface by `movements`, in tolerances.
    fn shares(steps: u32, repetitions: u32, movements: &[f64]) -> Vec<f64> {
        let mut schedule = Schedule::new(steps, repetitions, 1.0);
        let mut movements = movements.iter().copied().chain(std::iter::repeat(0.0));
        let mut shares = Vec::new();
        while let Some(share) = schedule.next() {
            shares.push(share);
            let moved = movements.next().unwrap() * SETTLED;
            schedule.note(&[Point3::origin(); 2], &[Point3::new(0.0, moved, 0.0); 2]);
        }
        shares
    }

    #[test]
    fn a_step_is_repeated_while_it_moves_the_surface() {
        assert_eq!(shares(3, 5, &[]), [0.0, 0.5, 1.0]);
        assert_eq!(shares(3, 5, &[0.9, 1.1, 1.1, 0.9, 2.0, 0.5]), [0.0, 0.5, 0.5, 0.5, 1.0, 1.0]);
    }

    #[test]
    fn repetitions_are_bounded_over_the_stage() {
        assert_eq!(shares(2, 3, &[9.0; 20]), [0.0, 0.0, 0.0, 0.0, 1.0]);
        assert_eq!(shares(2, 0, &[9.0; 20]), [0.0, 1.0]);
    }
}
