//! Progress on the standard error: a bar on a terminal; otherwise a line for each phase, or nothing.

use super::output::note;
use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};
use std::io::IsTerminal;

/// Steps of the bar; more than any terminal can show.
const STEPS: u64 = 1000;

/// What to show if the standard error is not a terminal.
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
    phase: std::sync::Mutex<String>,
}

impl Progress {
    pub(super) fn new(without_terminal: WithoutTerminal) -> Self {
        let terminal = std::io::stderr().is_terminal();
        let target = if terminal { ProgressDrawTarget::stderr() } else { ProgressDrawTarget::hidden() };
        let bar = ProgressBar::with_draw_target(Some(STEPS), target);
        // The template is a constant and tested, so the default style is never needed.
        if let Ok(style) = ProgressStyle::with_template("{msg:14} {bar:40} {percent:>3} % {elapsed:>4}") {
            bar.set_style(style);
        }
        let lines = !terminal && without_terminal == WithoutTerminal::Lines;
        Progress { bar, lines, phase: std::sync::Mutex::default() }
    }

    pub(super) fn phase(&self, name: &str) {
        let mut phase = self.phase.lock().unwrap_or_else(std::sync::PoisonError::into_inner);
        if *phase != name {
            name.clone_into(&mut phase);
            self.bar.set_message(name.to_owned());
            if self.lines {
                note(&format!("  {name}"));
            }
        }
    }

    pub(super) fn fraction(&self, fraction: f64) {
        self.bar.set_position((fraction.clamp(0.0, 1.0) * STEPS as f64) as u64);
    }
}

impl Drop for Progress {
    fn drop(&mut self) {
        self.bar.finish_and_clear();
    }
}

#[cfg(test)]
mod tests {
    #[test]
    fn the_template_is_valid() {
        assert!(indicatif::ProgressStyle::with_template("{msg:14} {bar:40} {percent:>3} % {elapsed:>4}").is_ok());
    }
}
