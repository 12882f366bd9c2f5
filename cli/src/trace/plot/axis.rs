//! Axes: ticks at round numbers, and where a value lies in the picture.

use drivewright_runtime::time::Instant;

use super::draw::Canvas;
use super::{LEFT, RIGHT, Trace};

/// Height of the numbers below the axis of time.
pub(super) const TIME_HEIGHT: f64 = 44.0;

/// The axis of time, from the first sample or event to the last.
pub(super) struct TimeAxis {
    start: f64,
    end: f64,
}

impl TimeAxis {
    pub(super) fn new(trace: &Trace) -> Self {
        let times = || trace.samples.iter().map(|s| s.at).chain(trace.events.iter().map(|e| e.at));
        let start = times().min().unwrap_or_default();
        let end = times().max().unwrap_or_default();
        Self { start: seconds(start), end: seconds(end).max(seconds(start) + 1e-3) }
    }

    /// Where a moment lies, from left to right.
    pub(super) fn x(&self, at: Instant) -> f64 {
        self.place(seconds(at))
    }

    fn place(&self, seconds: f64) -> f64 {
        LEFT + (seconds - self.start) / (self.end - self.start) * (RIGHT - LEFT)
    }

    /// Draws the ticks below `bottom` and lines up to `top`.
    pub(super) fn draw(&self, canvas: &mut Canvas, top: f64, bottom: f64) {
        let step = round_step((self.end - self.start) / 10.0);
        // Below two seconds the numbers are easier to read as milliseconds.
        let (factor, unit) = if self.end - self.start < 2.0 { (1e3, "ms") } else { (1.0, "s") };
        for tick in ticks(self.start, self.end, step) {
            let x = self.place(tick);
            canvas.line("grid", (x, top), (x, bottom));
            canvas.text_middle(x, bottom + 16.0, "tick", &number(tick * factor, step * factor));
        }
        canvas.text_middle(f64::midpoint(LEFT, RIGHT), bottom + 34.0, "label", &format!("time [{unit}]"));
    }
}

#[allow(clippy::cast_precision_loss, reason = "a plot is a picture")]
fn seconds(at: Instant) -> f64 {
    at.micros() as f64 / 1e6
}

/// An axis of values.
pub(super) struct ValueAxis {
    low: f64,
    high: f64,
    pub(super) step: f64,
}

impl ValueAxis {
    /// An axis whose ends are ticks and which holds all values, and 0 where that is near.
    pub(super) fn new(values: impl Iterator<Item = f64>) -> Self {
        let (low, high) = values.fold((f64::MAX, f64::MIN), |(low, high), v| (low.min(v), high.max(v)));
        let (low, high) = if low > high { (0.0, 0.0) } else { (low, high) };
        // A flat line needs a height; 0 belongs to it where the values are not far from it.
        let (near, flat) = ((high - low) * 2.0, high <= low);
        let low = if low < near || flat { low.min(0.0) } else { low };
        let high = if -high < near || flat { high.max(0.0) } else { high };
        let (low, high) = if high <= low { (low - 1.0, high + 1.0) } else { (low, high) };
        let step = round_step((high - low) / 4.0);
        Self { low: (low / step).floor() * step, high: (high / step).ceil() * step, step }
    }

    /// Where a value lies between `top` and `bottom`.
    pub(super) fn y(&self, value: f64, top: f64, bottom: f64) -> f64 {
        bottom - (value - self.low) / (self.high - self.low) * (bottom - top)
    }

    /// The ticks and how they are written.
    pub(super) fn ticks(&self) -> impl Iterator<Item = (f64, String)> + '_ {
        ticks(self.low, self.high, self.step).map(|tick| (tick, number(tick, self.step)))
    }
}

/// 1, 2 or 5 times a power of ten, at least `rough`.
pub(super) fn round_step(rough: f64) -> f64 {
    // Not with a logarithm, whose last digit depends on the machine.
    let mut power = 1e-6;
    while power * 10.0 <= rough && power < 1e18 {
        power *= 10.0;
    }
    [1.0, 2.0, 5.0, 10.0].into_iter().map(|n| n * power).find(|step| *step >= rough).unwrap_or(power * 10.0)
}

/// Multiples of `step` from `low` to `high`.
fn ticks(low: f64, high: f64, step: f64) -> impl Iterator<Item = f64> {
    let first = (low / step - 1e-9).ceil();
    // An axis has ten or so.
    (0..64_u32)
        .map(move |n| (first + f64::from(n)) * step)
        .take_while(move |tick| *tick <= high + step * 1e-9)
}

/// A number with as many decimals as its step has, and a blank between thousands.
fn number(value: f64, step: f64) -> String {
    let decimals = (0..6_i32).find(|n| {
        let scaled = step * 10_f64.powi(*n);
        (scaled - scaled.round()).abs() < 1e-6 * scaled
    });
    let text = format!("{value:.0$}", decimals.unwrap_or(0).unsigned_abs() as usize);
    // Rounding may leave a sign before nothing.
    let text = if text.trim_matches(['-', '0', '.']).is_empty() { text.replace('-', "") } else { text };
    grouped(&text.replace('-', "\u{2212}"))
}

/// `1 234 567` with narrow blanks; numbers of four digits stay as they are.
fn grouped(text: &str) -> String {
    let (whole, part) = text.split_once('.').map_or((text, None), |(whole, part)| (whole, Some(part)));
    let digits = whole.chars().filter(char::is_ascii_digit).count();
    let mut out = String::new();
    let mut left = digits;
    for c in whole.chars() {
        if c.is_ascii_digit() {
            if left != digits && left % 3 == 0 && digits > 4 {
                out.push('\u{2009}');
            }
            left -= 1;
        }
        out.push(c);
    }
    part.map_or(out.clone(), |part| format!("{out}.{part}"))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ticks_are_round_numbers() {
        for (rough, step) in [(0.3, 0.5), (1.0, 1.0), (1.1, 2.0), (260.0, 500.0), (5000.1, 10_000.0)] {
            assert!((round_step(rough) / step - 1.0).abs() < 1e-9, "{rough}");
        }
        let axis = ValueAxis::new([-120.0, 300.0].into_iter());
        let shown: Vec<String> = axis.ticks().map(|(_, text)| text).collect();
        assert_eq!(shown, ["\u{2212}200", "0", "200", "400"]);
    }

    #[test]
    fn numbers_have_the_decimals_of_their_step() {
        assert_eq!(number(0.1 + 0.2, 0.1), "0.3");
        assert_eq!(number(-0.0, 0.5), "0.0");
        assert_eq!(number(1_250_000.0, 50_000.0), "1\u{2009}250\u{2009}000");
        assert_eq!(number(-2500.0, 500.0), "\u{2212}2500");
        assert_eq!(number(1.25, 0.25), "1.25");
    }

    #[test]
    fn an_axis_has_a_height() {
        for values in [vec![], vec![0.0], vec![7.0, 7.0], vec![-3.0]] {
            let axis = ValueAxis::new(values.clone().into_iter());
            assert!(axis.high > axis.low, "{values:?}");
            for value in values {
                let y = axis.y(value, 0.0, 100.0);
                assert!((0.0..=100.0).contains(&y), "{value} at {y}");
            }
        }
    }
}
