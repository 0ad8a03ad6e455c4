//! An SVG picture as text, element by element.

use crate::page::escaped;
use std::fmt::{Display, Write};

/// Where a text begins, relative to its place.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Anchor {
    /// It begins there.
    Start,
    /// Its middle is there.
    Middle,
    /// It ends there.
    End,
}

/// A picture that is being drawn. Coordinates are pixels of the picture, from its upper left corner.
#[derive(Debug, Clone, PartialEq)]
pub struct Drawing {
    svg: String,
}

impl Drawing {
    /// An empty picture, named for readers who cannot see it.
    pub fn new(width: f64, height: f64, name: &str) -> Self {
        let mut svg = String::new();
        // Writing to a string cannot fail, here and below.
        let _ = writeln!(
            svg,
            "<svg class=\"plot\" viewBox=\"0 0 {width:.0} {height:.0}\" role=\"img\" aria-label=\"{}\" \
             font-size=\"12\" fill=\"#5b6675\">",
            escaped(name)
        );
        Drawing { svg }
    }

    /// A text at a place; any characters are allowed.
    pub fn text(&mut self, (x, y): (f64, f64), anchor: Anchor, text: impl Display) {
        let anchor = anchor.attribute();
        let _ = writeln!(self.svg, "<text x=\"{x:.1}\" y=\"{y:.1}\"{anchor}>{}</text>", escaped(&text.to_string()));
    }

    /// A text that reads upwards, with its middle at a place.
    pub fn upward_text(&mut self, (x, y): (f64, f64), text: impl Display) {
        let text = escaped(&text.to_string());
        let _ = writeln!(
            self.svg,
            "<text text-anchor=\"middle\" transform=\"translate({x:.1} {y:.1}) rotate(-90)\">{text}</text>"
        );
    }

    /// A line through points; its attributes are SVG, such as its stroke.
    pub fn line(&mut self, points: impl IntoIterator<Item = (f64, f64)>, attributes: &str) {
        let mut path = String::new();
        for (x, y) in points {
            let _ = write!(path, "{}{x:.1} {y:.1}", if path.is_empty() { 'M' } else { 'L' });
        }
        let _ = writeln!(self.svg, "<path d=\"{path}\" fill=\"none\" {attributes}/>");
    }

    /// A filled rectangle with this upper left corner and these sides.
    pub fn rectangle(&mut self, (x, y): (f64, f64), (width, height): (f64, f64), color: &str) {
        let _ = writeln!(
            self.svg,
            "<rect x=\"{x:.1}\" y=\"{y:.1}\" width=\"{width:.1}\" height=\"{height:.1}\" fill=\"{color}\"/>"
        );
    }

    /// A filled circle.
    pub fn disc(&mut self, (x, y): (f64, f64), radius: f64, color: &str) {
        let _ = writeln!(self.svg, "<circle cx=\"{x:.1}\" cy=\"{y:.1}\" r=\"{radius}\" fill=\"{color}\"/>");
    }

    /// The picture as an `svg` element.
    pub fn finish(mut self) -> String {
        self.svg.push_str("</svg>\n");
        self.svg
    }
}

impl Anchor {
    fn attribute(self) -> &'static str {
        match self {
            Anchor::Start => "",
            Anchor::Middle => " text-anchor=\"middle\"",
            Anchor::End => " text-anchor=\"end\"",
        }
    }
}

/// A picture of [`Drawing::finish`] as a file of its own: with its size, a white ground and a font.
pub fn standalone(svg: &str) -> String {
    // `viewBox` is `0 0 width height`.
    let size = svg.split_once("viewBox=\"0 0 ").and_then(|(_, rest)| rest.split_once('"')).map_or("", |(size, _)| size);
    let (width, height) = size.split_once(' ').unwrap_or(("860", "190"));
    let own = format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{width}\" height=\"{height}\" font-family=\"sans-serif\""
    );
    let ground = format!("><rect width=\"{width}\" height=\"{height}\" fill=\"#fff\"/>");
    svg.replacen("<svg class=\"plot\"", &own, 1).replacen('>', &ground, 1)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn no_text_leaves_its_element_and_a_file_has_a_size() {
        let mut drawing = Drawing::new(20.0, 10.0, "a \"b\" <c>");
        drawing.text((1.0, 2.0), Anchor::End, "</text><script>");
        drawing.upward_text((1.0, 2.0), "&lt;");
        let svg = drawing.finish();
        assert!(svg.contains("a &quot;b&quot; &lt;c&gt;") && svg.contains("&lt;/text&gt;&lt;script&gt;"), "{svg}");
        assert!(svg.contains(">&amp;lt;<"), "{svg}");
        let file = standalone(&svg);
        assert!(file.starts_with("<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"20\" height=\"10\""), "{file}");
        assert_eq!(file.matches("<rect").count(), 1, "{file}");
    }
}
