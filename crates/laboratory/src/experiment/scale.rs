//! Scales of plot axes: from values to positions along the axis, with round ticks.

/// A scale between two round ends.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Scale {
    low: f64,
    high: f64,
    /// Distance of ticks on a linear axis.
    step: f64,
    log: bool,
}

impl Scale {
    /// A scale that covers all finite `values` (if `log`, all positive ones); `None` without values.
    pub(super) fn new(values: impl Iterator<Item = f64>, log: bool) -> Option<Self> {
        let empty = (f64::INFINITY, f64::NEG_INFINITY);
        let (low, high) = values.filter(|v| v.is_finite()).fold(empty, |(l, h), v| (l.min(v), h.max(v)));
        if low > high {
            return None;
        }
        if log {
            let (low, high) = (low.log10().floor(), high.log10().ceil());
            return Some(Scale { low, high: high.max(low + 1.0), step: 1.0, log });
        }
        // A single value lies in the middle of an axis as long as the value.
        let margin = if high > low { 0.0 } else { 0.5 * high.abs().max(1.0) };
        let (low, high) = (low - margin, high + margin);
        let step = round_step((high - low) / 5.0);
        Some(Scale { low: (low / step + 1e-9).floor() * step, high: (high / step - 1e-9).ceil() * step, step, log })
    }

    /// A linear scale with exactly these ends.
    pub(super) fn exact(low: f64, high: f64) -> Self {
        Scale { low, high, step: 1.0, log: false }
    }

    pub(super) fn is_log(&self) -> bool {
        self.log
    }

    /// Position of `value` along the axis, 0 at its beginning and 1 at its end.
    pub(super) fn place(&self, value: f64) -> f64 {
        let value = if self.log { value.max(f64::MIN_POSITIVE).log10() } else { value };
        (value - self.low) / (self.high - self.low)
    }

    /// Values at which there are ticks.
    pub(super) fn ticks(&self) -> Vec<f64> {
        let n = ((self.high - self.low) / self.step).round() as i32;
        // Over many decades a tick at each would be too many.
        let every = if self.log { (n / 8 + 1) as usize } else { 1 };
        (0..=n)
            .step_by(every)
            .map(|k| self.low + f64::from(k) * self.step)
            .map(|v| if self.log { 10f64.powf(v) } else { v })
            .collect()
    }
}

/// The first of 1, 2, 5 times a power of ten that is not below `wanted`.
fn round_step(wanted: f64) -> f64 {
    let power = 10f64.powf(wanted.max(1e-300).log10().floor());
    [1.0, 2.0, 5.0].map(|k| k * power).into_iter().find(|s| *s >= wanted * (1.0 - 1e-9)).unwrap_or(10.0 * power)
}

/// The tick as text, with as many digits as the axis needs.
pub(super) fn tick_label(tick: f64, scale: &Scale) -> String {
    if scale.log {
        let decade = tick.log10().round() as i32;
        return if (-3..=4).contains(&decade) {
            format!("{tick:.*}", (-decade).max(0) as usize)
        } else {
            format!("1e{decade}")
        };
    }
    let digits = (-scale.step.log10().floor()).clamp(0.0, 9.0) as usize;
    if tick.abs() < scale.step * 1e-6 { "0".to_owned() } else { format!("{tick:.digits$}") }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ticks_are_round_and_cover_all_values() {
        let scale = Scale::new([0.13, 0.97].into_iter(), false).unwrap();
        let labels: Vec<_> = scale.ticks().iter().map(|t| tick_label(*t, &scale)).collect();
        assert_eq!(labels, ["0", "0.2", "0.4", "0.6", "0.8", "1.0"]);
        assert!(scale.place(0.13) > 0.0 && scale.place(0.97) < 1.0);
        let log = Scale::new([0.02, 300.0].into_iter(), true).unwrap();
        let labels: Vec<_> = log.ticks().iter().map(|t| tick_label(*t, &log)).collect();
        assert_eq!(labels, ["0.01", "0.1", "1", "10", "100", "1000"]);
    }

    #[test]
    fn a_single_value_is_in_the_middle() {
        let scale = Scale::new([3.0].into_iter(), false).unwrap();
        assert!((scale.place(3.0) - 0.5).abs() < 0.2);
        assert_eq!(Scale::new([f64::NAN].into_iter(), false), None);
    }
}
