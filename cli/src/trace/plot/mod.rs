//! A trace as a picture: panels of position, speed and torque, bands of state and mode, tracks of bits, and numbered
//! marks of events, over one axis of time. SVG, with colours for light and dark screens and for paper.
//!
//! Nothing is measured in the fonts of a machine: widths of texts are estimated, so that the same trace gives the same
//! bytes everywhere.

mod axis;
mod band;
mod draw;
mod line;
mod marks;
mod style;

use drivewright_codegen::emit::escape::xml;

use super::Trace;
use axis::TimeAxis;
use draw::Canvas;

/// Width of the picture, and where the panels begin and end in it.
const WIDTH: f64 = 1100.0;
const LEFT: f64 = 176.0;
const RIGHT: f64 = WIDTH - 24.0;

/// The picture.
pub(crate) fn svg(trace: &Trace) -> String {
    let time = TimeAxis::new(trace);
    let mut canvas = Canvas::default();
    canvas.text(24.0, 30.0, "title", &trace.title);
    let top = marks::numbers_height(trace, &time) + 44.0;
    let bottom = top + line::height() + band::height(trace);
    time.draw(&mut canvas, top, bottom);
    let y = line::panels(&mut canvas, trace, &time, top);
    let y = band::bands(&mut canvas, trace, &time, y);
    band::tracks(&mut canvas, trace, &time, y);
    marks::lines(&mut canvas, trace, &time, top, bottom);
    let mut y = band::legend(&mut canvas, trace, bottom + axis::TIME_HEIGHT);
    y = marks::legend(&mut canvas, trace, y);
    whole(trace, &canvas, y + 16.0)
}

fn whole(trace: &Trace, canvas: &Canvas, height: f64) -> String {
    format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {WIDTH} {height:.0}\" width=\"{WIDTH}\" \
         height=\"{height:.0}\" role=\"img\">\n<title>{}</title>\n<style>\n{}</style>\n\
         <rect class=\"page\" width=\"100%\" height=\"100%\"/>\n{}</svg>\n",
        xml(&trace.title),
        style::sheet(),
        canvas.body()
    )
}
