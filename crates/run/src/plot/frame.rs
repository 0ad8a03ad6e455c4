//! The frame of a plot: a rectangle of the picture with two scales, its axes, and marks at values.

use super::drawing::{Anchor, Drawing};
use super::scale::{Scale, tick_label};

const GRID: &str = "stroke=\"#ececf0\"";
const AXIS: &str = "stroke=\"#8a8a92\"";

/// A rectangle of a picture in which values have places.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Frame {
    /// Scale of the horizontal axis.
    pub x: Scale,
    /// Scale of the vertical axis.
    pub y: Scale,
    /// Left and right end, pixels.
    pub across: (f64, f64),
    /// Upper and lower end, pixels.
    pub down: (f64, f64),
}

impl Frame {
    /// The place of a value on the horizontal axis, pixels.
    pub fn x(&self, value: f64) -> f64 {
        self.across.0 + (self.across.1 - self.across.0) * self.x.place(value)
    }

    /// The place of a value on the vertical axis, pixels.
    pub fn y(&self, value: f64) -> f64 {
        self.down.1 - (self.down.1 - self.down.0) * self.y.place(value)
    }

    /// Both axes, with lines and labels at their ticks.
    pub fn axes(&self, to: &mut Drawing) {
        self.y_ticks(to);
        self.x_ticks(to);
        self.ends(to);
    }

    /// Lines and labels at the ticks of the vertical axis.
    pub fn y_ticks(&self, to: &mut Drawing) {
        for tick in self.y.ticks() {
            let y = self.y(tick);
            to.line([(self.across.0, y), (self.across.1, y)], GRID);
            to.text((self.across.0 - 8.0, y + 4.0), Anchor::End, tick_label(tick, &self.y));
        }
    }

    /// Lines and labels at the ticks of the horizontal axis.
    pub fn x_ticks(&self, to: &mut Drawing) {
        for tick in self.x.ticks() {
            let x = self.x(tick);
            to.line([(x, self.down.0), (x, self.down.1)], GRID);
            to.text((x, self.down.1 + 18.0), Anchor::Middle, tick_label(tick, &self.x));
        }
    }

    /// The lines of the axes themselves.
    pub fn ends(&self, to: &mut Drawing) {
        let ((left, right), (top, bottom)) = (self.across, self.down);
        to.line([(left, top), (left, bottom), (right, bottom)], AXIS);
    }

    /// A line through values.
    pub fn line(&self, to: &mut Drawing, values: impl IntoIterator<Item = (f64, f64)>, color: &str) {
        let points = values.into_iter().map(|(x, y)| (self.x(x), self.y(y)));
        to.line(points, &format!("stroke=\"{color}\" stroke-width=\"2\""));
    }

    /// A dashed line over the whole height.
    pub fn divide(&self, to: &mut Drawing, x: f64) {
        let x = self.x(x);
        to.line([(x, self.down.0), (x, self.down.1)], "stroke=\"#c3cad3\" stroke-dasharray=\"4 4\"");
    }

    /// An error bar at a horizontal place, pixels.
    pub fn whisker(&self, to: &mut Drawing, x: f64, (low, high): (f64, f64), color: &str) {
        let inside = |value: f64| self.y(value).clamp(self.down.0, self.down.1);
        let (low, high, stroke) = (inside(low), inside(high), format!("stroke=\"{color}\""));
        for ends in [[(x, low), (x, high)], [(x - 4.0, low), (x + 4.0, low)], [(x - 4.0, high), (x + 4.0, high)]] {
            to.line(ends, &stroke);
        }
    }
}
