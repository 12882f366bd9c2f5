//! Marks of events: a numbered disc above the panels, a line through them, and a list of what the numbers mean.

use super::axis::TimeAxis;
use super::draw::{Canvas, text_width};
use super::{LEFT, RIGHT, Trace};
use crate::trace::{Event, Kind, millis};

/// Height of a row of discs, and how near two discs of one row may come.
const ROW: f64 = 20.0;
const NEAR: f64 = 19.0;
const LINE: f64 = 19.0;

fn class(kind: Kind) -> &'static str {
    match kind {
        Kind::Step => "mark-step",
        Kind::Fault => "mark-fault",
        Kind::Reset => "mark-reset",
        Kind::Homed => "mark-homed",
        Kind::Note => "mark-note",
    }
}

/// The place and the row of each disc: the lowest row in which it touches no other.
fn places(trace: &Trace, time: &TimeAxis) -> Vec<(f64, usize)> {
    let mut ends: Vec<f64> = Vec::new();
    let mut places = Vec::new();
    for event in &trace.events {
        let x = time.x(event.at);
        let free = ends.iter().position(|end| end + NEAR <= x).unwrap_or(ends.len());
        if free == ends.len() {
            ends.push(x);
        }
        ends[free] = x;
        places.push((x, free));
    }
    places
}

/// Height of the rows of discs.
#[allow(clippy::cast_precision_loss, reason = "there are few rows")]
pub(super) fn numbers_height(trace: &Trace, time: &TimeAxis) -> f64 {
    let rows = places(trace, time).iter().map(|(_, row)| row + 1).max().unwrap_or(0);
    rows as f64 * ROW + 4.0
}

/// Draws the discs above `top`, and their lines down to `bottom`.
#[allow(clippy::cast_precision_loss, reason = "there are few rows")]
pub(super) fn lines(canvas: &mut Canvas, trace: &Trace, time: &TimeAxis, top: f64, bottom: f64) {
    let places = places(trace, time);
    let level = |row: usize| top - 12.0 - row as f64 * ROW;
    for (event, (x, row)) in trace.events.iter().zip(&places) {
        canvas.line(&format!("line {}", class(event.kind)), (*x, level(*row)), (*x, bottom));
    }
    for (n, (event, (x, row))) in trace.events.iter().zip(&places).enumerate() {
        canvas.disc(class(event.kind), (*x, level(*row)), &(n + 1).to_string());
    }
}

/// Lists the events below `y`, in two columns where their texts allow it; gives where the list ends.
#[allow(clippy::cast_precision_loss, reason = "there are few events")]
pub(super) fn legend(canvas: &mut Canvas, trace: &Trace, y: f64) -> f64 {
    if trace.events.is_empty() {
        return y;
    }
    canvas.text(24.0, y + 14.0, "label", "events");
    let half = (RIGHT - LEFT) / 2.0;
    let narrow = trace.events.iter().all(|event| text_width(&told(event), 12.0) < half - 40.0);
    let columns = if narrow { 2 } else { 1 };
    let rows = trace.events.len().div_ceil(columns);
    for (n, event) in trace.events.iter().enumerate() {
        let (x, line) = (LEFT + (n / rows) as f64 * half, y + (n % rows) as f64 * LINE);
        canvas.disc(class(event.kind), (x + 9.0, line + 10.0), &(n + 1).to_string());
        text(canvas, x + 26.0, line + 14.0, event, if narrow { half - 40.0 } else { RIGHT - LEFT - 26.0 });
    }
    y + rows as f64 * LINE + 8.0
}

fn told(event: &Event) -> String {
    format!("{} ms  {}", millis(event.at), event.text)
}

/// The text, or as much of it as there is room for.
fn text(canvas: &mut Canvas, x: f64, y: f64, event: &Event, room: f64) {
    let whole = told(event);
    let mut text = whole.clone();
    while text_width(&text, 12.0) > room && text.pop().is_some() {}
    if text.len() < whole.len() {
        text.pop();
        text.push('…');
    }
    canvas.text(x, y, "tick", &text);
}
