//! Scales of plot axes: from values to positions along the axis, with round ticks.

/// A scale between two round ends.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Scale {
    /// The lower end, or its decimal logarithm.
    low: f64,
    high: f64,
    /// Distance of ticks on a linear axis.
    step: f64,
    log: bool,
}

/// The round numbers of a decade, up to the next decade.
const ROUND: [f64; 4] = [1.0, 2.0, 5.0, 10.0];
/// Decades of a logarithmic axis up to which all its round numbers are ticks.
const FEW_DECADES: f64 = 2.5;

impl Scale {
    /// A scale that covers all finite `values` (if `log`, all positive ones); `None` without values.
    pub fn new(values: impl Iterator<Item = f64>, log: bool) -> Option<Self> {
        let empty = (f64::INFINITY, f64::NEG_INFINITY);
        let (low, high) = values.filter(|v| v.is_finite()).fold(empty, |(l, h), v| (l.min(v), h.max(v)));
        if low > high {
            return None;
        }
        if log {
            let (low, high) = (round_below(low).log10(), round_above(high).log10());
            return Some(Scale { low, high: high.max(low + 1.0), step: 1.0, log });
        }
        // A single value lies in the middle of an axis as long as the value.
        let margin = if high > low { 0.0 } else { 0.5 * high.abs().max(1.0) };
        let (low, high) = (low - margin, high + margin);
        let step = round_step((high - low) / 5.0);
        Some(Scale { low: (low / step + 1e-9).floor() * step, high: (high / step - 1e-9).ceil() * step, step, log })
    }

    /// A linear scale with exactly these ends; its ticks are round.
    pub fn exact(low: f64, high: f64) -> Self {
        Scale { low, high, step: round_step((high - low) / 6.0), log: false }
    }

    /// Whether it is logarithmic.
    pub fn is_log(&self) -> bool {
        self.log
    }

    /// Position of `value` along the axis, 0 at its beginning and 1 at its end.
    pub fn place(&self, value: f64) -> f64 {
        let value = if self.log { value.max(f64::MIN_POSITIVE).log10() } else { value };
        (value - self.low) / (self.high - self.low)
    }

    /// A scale of whole numbers from `low` to `high`, which lie at its ends.
    pub fn counts(low: u32, high: u32) -> Self {
        let (low, high) = (f64::from(low), f64::from(high.max(low + 1)));
        Scale { low, high, step: round_step((high - low) / 6.0).max(1.0), log: false }
    }

    /// Values at which there are ticks.
    pub fn ticks(&self) -> Vec<f64> {
        let (low, high, slack) = (self.low, self.high, 1e-9 * (self.high - self.low));
        if !self.log {
            let first = (low / self.step - 1e-9).ceil();
            let n = ((high - first * self.step + slack) / self.step).floor() as i32;
            return (0..=n).map(|k| (first + f64::from(k)) * self.step).collect();
        }
        // Over many decades a tick at each would be too many.
        let every = ((high - low) / 8.0) as usize + 1;
        let of_each = if high - low <= FEW_DECADES { 3 } else { 1 };
        let decades = (low.floor() as i32..=high.ceil() as i32).step_by(every);
        let ticks = decades.flat_map(|decade| ROUND[..of_each].iter().map(move |round| round * 10f64.powi(decade)));
        ticks.filter(|tick| (low - slack..=high + slack).contains(&tick.log10())).collect()
    }
}

/// The largest of 1, 2, 5 times a power of ten that is not above a positive value.
fn round_below(value: f64) -> f64 {
    let power = 10f64.powf((value.log10() + 1e-9).floor());
    let found = ROUND.iter().rev().map(|round| round * power).find(|round| *round <= value * (1.0 + 1e-9));
    found.unwrap_or(power)
}

/// The smallest of 1, 2, 5 times a power of ten that is not below a positive value.
fn round_above(value: f64) -> f64 {
    let power = 10f64.powf((value.log10() - 1e-9).floor());
    let found = ROUND.iter().map(|round| round * power).find(|round| *round >= value * (1.0 - 1e-9));
    found.unwrap_or(10.0 * power)
}

/// The first of 1, 2, 5 times a power of ten that is not below `wanted`.
fn round_step(wanted: f64) -> f64 {
    let power = 10f64.powf(wanted.max(1e-300).log10().floor());
    [1.0, 2.0, 5.0].map(|k| k * power).into_iter().find(|s| *s >= wanted * (1.0 - 1e-9)).unwrap_or(10.0 * power)
}

/// The tick as text, with as many digits as the axis needs.
pub fn tick_label(tick: f64, scale: &Scale) -> String {
    if scale.log {
        let decade = (tick.log10() + 1e-9).floor() as i32;
        return match decade {
            -3..=4 => format!("{tick:.*}", (-decade).max(0) as usize),
            _ => format!("{:.0}e{decade}", tick / 10f64.powi(decade)),
        };
    }
    let digits = (-scale.step.log10().floor()).clamp(0.0, 9.0) as usize;
    let sign = if tick < 0.0 { "−" } else { "" };
    if tick.abs() < scale.step * 1e-6 { "0".to_owned() } else { format!("{sign}{:.digits$}", tick.abs()) }
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
        assert_eq!(labels, ["0.1", "1", "10", "100"]);
        assert!((log.place(0.02), log.place(500.0)) == (0.0, 1.0), "the ends are round");
        let short = Scale::new([12.0, 130.0].into_iter(), true).unwrap();
        let labels: Vec<_> = short.ticks().iter().map(|t| tick_label(*t, &short)).collect();
        assert_eq!(labels, ["10", "20", "50", "100", "200"]);
        let tiny = Scale::new([2e-7, 3e-6].into_iter(), true).unwrap();
        assert_eq!(tick_label(tiny.ticks()[0], &tiny), "2e-7");
        let counts = Scale::counts(1, 12);
        let labels: Vec<_> = counts.ticks().iter().map(|t| tick_label(*t, &counts)).collect();
        assert_eq!((labels.join(" "), counts.place(1.0)), ("2 4 6 8 10 12".to_owned(), 0.0));
        let around = Scale::exact(-1.4, 1.4);
        let labels: Vec<_> = around.ticks().iter().map(|t| tick_label(*t, &around)).collect();
        assert_eq!((labels.join(" "), around.place(1.4)), ("−1.0 −0.5 0 0.5 1.0".to_owned(), 1.0));
    }

    #[test]
    fn a_single_value_is_in_the_middle() {
        let scale = Scale::new([3.0].into_iter(), false).unwrap();
        assert!((scale.place(3.0) - 0.5).abs() < 0.2);
        assert_eq!(Scale::new([f64::NAN].into_iter(), false), None);
    }
}
