//! Progress on the standard error: a bar on a terminal; otherwise a line for each phase, or nothing.

use super::output::note;
use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};
use std::io::IsTerminal;
use std::time::{Duration, Instant};

/// Steps of the bar; more than any terminal can show.
const STEPS: u64 = 1000;
const TEMPLATE: &str = "{msg:14} {bar:40} {percent:>3} % {elapsed:>4}{prefix}";
/// Least fraction of the work, and least elapsed time, before the remaining time is estimated.
const LEAST_FRACTION: f64 = 0.1;
const LEAST_TIME: Duration = Duration::from_secs(2);

/// The output if the standard error is not a terminal.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum WithoutTerminal {
    /// Nothing.
    Silent,
    /// A line when the phase changes.
    Lines,
}

/// A progress display; it disappears when dropped.
pub(super) struct Progress {
    bar: ProgressBar,
    lines: bool,
    begun: Instant,
    title: std::sync::OnceLock<String>,
    phase: parking_lot::Mutex<String>,
}

impl Progress {
    pub(super) fn new(without_terminal: WithoutTerminal) -> Self {
        let terminal = std::io::stderr().is_terminal();
        let target = if terminal { ProgressDrawTarget::stderr() } else { ProgressDrawTarget::hidden() };
        let bar = ProgressBar::with_draw_target(Some(STEPS), target);
        // The template is a constant and tested, so the default style is never needed.
        if let Ok(style) = ProgressStyle::with_template(TEMPLATE) {
            bar.set_style(style);
        }
        let lines = !terminal && without_terminal == WithoutTerminal::Lines;
        let (begun, title) = (Instant::now(), std::sync::OnceLock::new());
        Progress { bar, lines, begun, title, phase: parking_lot::Mutex::default() }
    }

    /// Sets the title that is shown before the phase; only the first title counts.
    pub(super) fn title(&self, title: &str) {
        if !title.is_empty() {
            let _ = self.title.set(format!("{title}: "));
        }
    }

    pub(super) fn phase(&self, name: &str) {
        let mut phase = self.phase.lock();
        if *phase != name {
            name.clone_into(&mut phase);
            let title = self.title.get().map_or("", String::as_str);
            self.bar.set_message(format!("{title}{name}"));
            if self.lines {
                note(&format!("  {name}"));
            }
        }
    }

    pub(super) fn fraction(&self, fraction: f64) {
        let fraction = fraction.clamp(0.0, 1.0);
        if let Some(left) = left(self.begun.elapsed(), fraction) {
            self.bar.set_prefix(format!(", about {left} left"));
        }
        self.bar.set_position((fraction * STEPS as f64) as u64);
    }
}

/// The remaining time in words, if the work continues at the same rate; `None` if too little is done for an estimate.
fn left(elapsed: Duration, fraction: f64) -> Option<String> {
    if fraction < LEAST_FRACTION || elapsed < LEAST_TIME {
        return None;
    }
    let seconds = (elapsed.as_secs_f64() * (1.0 - fraction) / fraction).ceil();
    Some(if seconds < 120.0 { format!("{seconds} s") } else { format!("{} min", (seconds / 60.0).ceil()) })
}

impl Drop for Progress {
    fn drop(&mut self) {
        self.bar.finish_and_clear();
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_template_is_valid() {
        assert!(ProgressStyle::with_template(TEMPLATE).is_ok());
    }

    #[test]
    fn the_rest_takes_as_long_for_its_share_as_what_is_done() {
        let at = |seconds, fraction| left(Duration::from_secs(seconds), fraction);
        assert_eq!(at(30, 0.25).as_deref(), Some("90 s"));
        assert_eq!(at(60, 0.25).as_deref(), Some("3 min"));
        assert_eq!((at(1, 0.5), at(60, 0.05)), (None, None));
    }
}
