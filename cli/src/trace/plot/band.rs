//! Bands of state and mode, tracks of bits, and what the colours mean.

use drivewright_runtime::cia402::{Mode, State};

use super::axis::TimeAxis;
use super::draw::{Canvas, text_width};
use super::{LEFT, RIGHT, Trace, style};
use crate::trace::text::mode_name;
use crate::trace::{Sample, bits};

const BAND: f64 = 26.0;
const TRACK: f64 = 16.0;
const GAP: f64 = 6.0;

/// A stretch of time in which something is the same.
struct Stretch<T> {
    from: f64,
    to: f64,
    is: T,
}

/// Stretches of `of`, from the first sample to the end of the axis.
fn stretches<T: PartialEq>(trace: &Trace, time: &TimeAxis, of: impl Fn(&Sample) -> T) -> Vec<Stretch<T>> {
    let mut found: Vec<Stretch<T>> = Vec::new();
    for sample in &trace.samples {
        let (x, is) = (time.x(sample.at), of(sample));
        if let Some(last) = found.last_mut() {
            last.to = x;
            if last.is == is {
                continue;
            }
        }
        found.push(Stretch { from: x, to: RIGHT, is });
    }
    if let Some(last) = found.last_mut() {
        last.to = RIGHT;
    }
    found
}

/// Draws the bands of state and mode below `y`; gives where the next thing may be drawn.
pub(super) fn bands(canvas: &mut Canvas, trace: &Trace, time: &TimeAxis, y: f64) -> f64 {
    canvas.text(24.0, y + 17.0, "label", "state");
    for part in stretches(trace, time, Sample::state) {
        named(canvas, &part, y, style::state_class(part.is), part.is.map_or("no state", State::word));
    }
    let y = y + BAND + 8.0;
    canvas.text(24.0, y + 17.0, "label", "mode");
    for part in stretches(trace, time, |s| s.mode).iter().filter(|part| part.is != Mode::NONE) {
        named(canvas, part, y, "mode", &mode_name(part.is));
    }
    y + BAND + 14.0
}

/// A part of a band, with its name where it fits, or the first letters of its words where those do.
fn named<T>(canvas: &mut Canvas, part: &Stretch<T>, y: f64, class: &str, name: &str) {
    // What lasts for less than a pixel can be seen all the same.
    let width = (part.to - part.from).max(1.0);
    canvas.rect(class, (part.from, y), (width, BAND), name);
    let fits = |text: &str| text_width(text, 12.0) + 6.0 < width;
    let middle = f64::midpoint(part.from, part.to);
    if let Some(text) = [name.to_owned(), initials(name)].into_iter().find(|text| fits(text)) {
        canvas.text_middle(middle, y + 17.0, "band", &text);
    }
}

/// `PP` for `profile position`.
fn initials(name: &str) -> String {
    name.split_whitespace().filter_map(|word| word.chars().next()).collect::<String>().to_uppercase()
}

/// The bits that change: each has a track.
fn shown(trace: &Trace) -> impl Iterator<Item = &'static (u16, &'static str)> + '_ {
    bits::PLAIN.iter().filter(|(bit, _)| changes(trace, *bit))
}

/// Height of bands and tracks.
pub(super) fn height(trace: &Trace) -> f64 {
    shown(trace).map(|_| TRACK + GAP).sum::<f64>() + 2.0 * BAND + 24.0
}

/// Draws a track for each bit that changes, below `y`. Where its name depends on the mode, the name stands in the track.
pub(super) fn tracks(canvas: &mut Canvas, trace: &Trace, time: &TimeAxis, mut y: f64) {
    for (bit, plain) in shown(trace) {
        canvas.text(24.0, y + 12.0, "tick", plain);
        let mut points = Vec::new();
        for part in stretches(trace, time, |s| (s.status.0 & bit != 0, s.mode)) {
            let (set, mode) = part.is;
            let level = if set { y + 2.0 } else { y + TRACK - 2.0 };
            points.extend([(part.from, level), (part.to, level)]);
            let width = part.to - part.from;
            if set {
                canvas.rect("set", (part.from, y + 2.0), (width.max(1.0), TRACK - 4.0), "");
            }
            let name = trace.bits.name(*bit, plain, mode);
            if set && name != *plain && text_width(name, 10.0) + 4.0 < width {
                canvas.text_middle(f64::midpoint(part.from, part.to), y + 11.5, "small", name);
            }
        }
        canvas.path("bit", &points);
        y += TRACK + GAP;
    }
}

fn changes(trace: &Trace, bit: u16) -> bool {
    trace.samples.windows(2).any(|pair| (pair[0].status.0 ^ pair[1].status.0) & bit != 0)
}

/// The states that were seen, with their colours; and what bits 12 and 13 mean.
pub(super) fn legend(canvas: &mut Canvas, trace: &Trace, y: f64) -> f64 {
    let (mut x, mut y) = (LEFT, y + 8.0);
    canvas.text(24.0, y + 11.0, "label", "states");
    for state in
        State::ALL.iter().copied().filter(|s| trace.samples.iter().any(|one| one.state() == Some(*s)))
    {
        let width = 18.0 + text_width(state.word(), 12.0) + 18.0;
        if x + width > RIGHT {
            (x, y) = (LEFT, y + 20.0);
        }
        canvas.rect(style::state_class(Some(state)), (x, y), (12.0, 12.0), "");
        canvas.text(x + 18.0, y + 11.0, "tick", state.word());
        x += width;
    }
    y + 32.0
}
