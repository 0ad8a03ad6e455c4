//! Plots as SVG text, for the report of a match, of a study and of the experiments: scales with round ticks, frames with
//! axes, marks, and charts of series.
//!
//! No plotting library is used: few kinds of plot are needed, the text must use the fonts of the page, and equal numbers
//! must give equal bytes. Colors and anchors are attributes, not styles: the policy of the pages allows no style
//! attributes, and a plot saved as a file ([`standalone`]) looks the same.

mod chart;
mod drawing;
mod frame;
mod scale;

pub use chart::{Axis, Plot, PlotKind, PlotPoint, Series};
pub use drawing::{Anchor, Drawing, standalone};
pub use frame::Frame;
pub use scale::{Scale, tick_label};

/// Colors distinguishable with most kinds of color vision (Okabe, Ito 2008), without yellow, which is hard to see on
/// white; then three that differ in lightness, for plots of many series.
pub const COLORS: [&str; 10] =
    ["#0072b2", "#d55e00", "#009e73", "#cc79a7", "#56b4e9", "#e69f00", "#444444", "#7b3294", "#8c510a", "#a0a0a0"];
