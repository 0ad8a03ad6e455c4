//! Classifies a run from its series of message changes and labelings: converged, slow or oscillating.

/// State of a run when it ended.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum ConvergenceStatus {
    /// No message changed by more than the tolerance.
    Converged,
    /// Neither settled nor repeating: more iterations or more damping may help.
    Slow,
    /// The labelings repeat with this period while the messages do not settle. More iterations do not help; damping may.
    Oscillating {
        /// Iterations after which the labelings return, at least 2.
        period: u32,
    },
}

/// Convergence of a run.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Convergence {
    /// State at the end.
    pub status: ConvergenceStatus,
    /// Factor by which the largest message change shrank per iteration, a geometric mean over the last iterations (at
    /// most 16); below 1 while a run converges. `None` before the second iteration.
    pub residual_rate: Option<f64>,
}

/// Longest period that is detected, iterations.
const LONGEST_PERIOD: usize = 32;
/// Number of full periods required: two may be chance, three are a pattern.
const PERIODS_SEEN: usize = 3;
/// Ratio of largest message changes one period apart above which a run does not settle.
const SETTLING: f32 = 0.99;
/// Iterations on either side of the comparison that yields the rate.
const RATE_HALF: usize = 8;

/// Largest message change and labeling of every iteration.
#[derive(Debug, Clone, PartialEq, Default)]
pub(super) struct History {
    deltas: Vec<f32>,
    fingerprints: Vec<u64>,
}

impl History {
    /// One more iteration: its largest message change and the labeling decoded after it.
    pub(super) fn push(&mut self, delta: f32, labeling: impl Iterator<Item = u32>) {
        self.deltas.push(delta);
        self.fingerprints.push(fingerprint(labeling));
    }

    /// Classifies the series of a run that `settled` or not. Cost `O(LONGEST_PERIOD²)`.
    pub(super) fn convergence(&self, settled: bool) -> Convergence {
        let status = match self.period() {
            _ if settled => ConvergenceStatus::Converged,
            Some(period) => ConvergenceStatus::Oscillating { period: period as u32 },
            None => ConvergenceStatus::Slow,
        };
        Convergence { status, residual_rate: self.residual_rate() }
    }

    fn residual_rate(&self) -> Option<f64> {
        let half = (self.deltas.len() / 2).min(RATE_HALF);
        if half == 0 {
            return None;
        }
        let (early, late) = self.deltas[self.deltas.len() - 2 * half..].split_at(half);
        let (early, late) = (largest(early), largest(late));
        // A message that has stopped changing stays constant.
        Some(if early > 0.0 { f64::from(late / early).powf(1.0 / half as f64) } else { 0.0 })
    }

    /// The shortest period, at least 2, with which the labelings of the last [`PERIODS_SEEN`] periods repeat, if
    /// the message changes did not shrink in the last of them.
    fn period(&self) -> Option<usize> {
        let n = self.fingerprints.len();
        (2..=LONGEST_PERIOD.min(n / PERIODS_SEEN)).find(|&period| {
            let tail = &self.fingerprints[n - PERIODS_SEEN * period..];
            let repeats = tail.iter().zip(&tail[period..]).all(|(a, b)| a == b);
            let changes = tail.iter().any(|f| *f != tail[0]);
            let (before, last) = self.deltas[n - 2 * period..].split_at(period);
            repeats && changes && largest(last) >= SETTLING * largest(before)
        })
    }
}

fn largest(values: &[f32]) -> f32 {
    values.iter().copied().fold(0.0, f32::max)
}

/// FNV-1a over the labels, word by word; equal for equal labelings, and only by accident (2⁻⁶⁴) for others.
fn fingerprint(labeling: impl Iterator<Item = u32>) -> u64 {
    labeling.fold(0xcbf2_9ce4_8422_2325, |hash, x| (hash ^ u64::from(x)).wrapping_mul(0x0100_0000_01b3))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn history(deltas: impl Iterator<Item = f32>, labels: impl Iterator<Item = u32>) -> History {
        let mut history = History::default();
        for (delta, label) in deltas.zip(labels) {
            history.push(delta, [label, 7].into_iter());
        }
        history
    }

    #[test]
    fn a_repeated_pattern_of_labels_is_an_oscillation_with_its_period() {
        let pattern = |k: usize| [4, 1, 3][k % 3];
        let found = history(std::iter::repeat_n(0.5, 20), (0..20).map(pattern)).convergence(false);
        assert_eq!(found.status, ConvergenceStatus::Oscillating { period: 3 });
        assert_eq!(found.residual_rate, Some(1.0));
    }

    #[test]
    fn a_repeated_pattern_that_settles_is_slow() {
        let deltas = (0..20).map(|k| 0.9f32.powi(k));
        let found = history(deltas, (0..20).map(|k| k % 2)).convergence(false);
        assert_eq!(found.status, ConvergenceStatus::Slow);
        assert!((found.residual_rate.unwrap() - 0.9).abs() < 1e-5);
    }

    #[test]
    fn constant_and_short_series_are_slow() {
        let found = history(std::iter::repeat(0.5), 0..20).convergence(false);
        assert_eq!(found.status, ConvergenceStatus::Slow);
        let found = history(std::iter::repeat(0.5), std::iter::repeat_n(3, 20)).convergence(false);
        assert_eq!(found.status, ConvergenceStatus::Slow);
        let found = history(std::iter::repeat(0.5), (0..5).map(|k| k % 2)).convergence(false);
        assert_eq!(found.status, ConvergenceStatus::Slow);
        assert_eq!(History::default().convergence(true).residual_rate, None);
    }
}
