//! Shapes as SVG elements. Every text goes through one escaping function, here.

use std::fmt::Write;

use drivewright_codegen::emit::escape::xml;

/// What is drawn so far. Places are in pixels of the picture; they are written with one decimal.
#[derive(Default)]
pub(super) struct Canvas(String);

impl Canvas {
    /// The elements, one a line.
    pub(super) fn body(&self) -> &str {
        &self.0
    }

    /// Text that begins at a place.
    pub(super) fn text(&mut self, x: f64, y: f64, class: &str, text: &str) {
        // Writing to a String cannot fail.
        let _ = writeln!(self.0, "<text class=\"{class}\" x=\"{x:.1}\" y=\"{y:.1}\">{}</text>", xml(text));
    }

    /// Text that ends at a place.
    pub(super) fn text_end(&mut self, x: f64, y: f64, class: &str, text: &str) {
        self.text(x, y, &format!("{class} end"), text);
    }

    /// Text around a place.
    pub(super) fn text_middle(&mut self, x: f64, y: f64, class: &str, text: &str) {
        self.text(x, y, &format!("{class} mid"), text);
    }

    /// A straight line.
    pub(super) fn line(&mut self, class: &str, from: (f64, f64), to: (f64, f64)) {
        let _ = writeln!(
            self.0,
            "<line class=\"{class}\" x1=\"{:.1}\" y1=\"{:.1}\" x2=\"{:.1}\" y2=\"{:.1}\"/>",
            from.0, from.1, to.0, to.1
        );
    }

    /// A box with a text that shows under the pointer.
    pub(super) fn rect(&mut self, class: &str, at: (f64, f64), size: (f64, f64), tip: &str) {
        let (x, y, w, h) = (at.0, at.1, size.0, size.1);
        let place = format!("x=\"{x:.1}\" y=\"{y:.1}\" width=\"{w:.1}\" height=\"{h:.1}\"");
        let _ = match tip {
            "" => writeln!(self.0, "<rect class=\"{class}\" {place}/>"),
            tip => writeln!(self.0, "<rect class=\"{class}\" {place}><title>{}</title></rect>", xml(tip)),
        };
    }

    /// A line through points.
    pub(super) fn path(&mut self, class: &str, points: &[(f64, f64)]) {
        let mut data = String::new();
        for (x, y) in points {
            let _ = write!(data, "{}{x:.1} {y:.1}", if data.is_empty() { "M" } else { "L" });
        }
        let _ = writeln!(self.0, "<path class=\"{class}\" d=\"{data}\"/>");
    }

    /// A number in a disc.
    pub(super) fn disc(&mut self, class: &str, at: (f64, f64), text: &str) {
        let _ = writeln!(self.0, "<circle class=\"{class}\" cx=\"{:.1}\" cy=\"{:.1}\" r=\"9\"/>", at.0, at.1);
        self.text_middle(at.0, at.1 + 4.0, "number", text);
    }
}

/// How wide a text is in a font of `size` pixels, generously.
pub(super) fn text_width(text: &str, size: f64) -> f64 {
    let of = |c: char| match c {
        'i' | 'j' | 'l' | 'I' | '.' | ',' | ':' | ';' | '|' | '\'' | ' ' | 't' | 'f' | 'r' => 0.36,
        'm' | 'w' | 'M' | 'W' => 0.88,
        c if c.is_ascii_uppercase() => 0.70,
        c if c.is_ascii() => 0.58,
        _ => 1.0,
    };
    text.chars().map(of).sum::<f64>() * size
}
