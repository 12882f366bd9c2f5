//! Panels of measured values.

use super::axis::{TimeAxis, ValueAxis};
use super::draw::Canvas;
use super::{LEFT, RIGHT, Trace};
use crate::trace::{Sample, Unit};

/// A panel: what is drawn in it.
struct Panel {
    class: &'static str,
    height: f64,
    value: fn(&Sample) -> i64,
}

const PANELS: &[Panel] = &[
    Panel { class: "position", height: 170.0, value: |s| s.position },
    Panel { class: "speed", height: 130.0, value: |s| s.speed },
    Panel { class: "force", height: 110.0, value: |s| s.force },
];

const GAP: f64 = 24.0;

/// Height of all panels.
pub(super) fn height() -> f64 {
    PANELS.iter().map(|panel| panel.height + GAP).sum()
}

/// Draws the panels below `y`; gives where the next thing may be drawn.
pub(super) fn panels(canvas: &mut Canvas, trace: &Trace, time: &TimeAxis, mut y: f64) -> f64 {
    let units = &trace.units;
    let named = [("position", &units.position), ("speed", &units.speed), (units.force_name, &units.force)];
    for (panel, (name, unit)) in PANELS.iter().zip(named) {
        canvas.text(24.0, y + 14.0, "label", name);
        draw(canvas, trace, time, panel, unit, y);
        y += panel.height + GAP;
    }
    y
}

fn draw(canvas: &mut Canvas, trace: &Trace, time: &TimeAxis, panel: &Panel, unit: &Unit, top: f64) {
    let value = |s: &Sample| unit.value((panel.value)(s));
    let axis = ValueAxis::new(trace.samples.iter().map(value));
    let bottom = top + panel.height;
    for (tick, text) in axis.ticks() {
        let y = axis.y(tick, top, bottom);
        canvas.line(if tick == 0.0 { "zero" } else { "grid" }, (LEFT, y), (RIGHT, y));
        canvas.text_end(LEFT - 8.0, y + 4.0, "tick", &text);
    }
    canvas.text(24.0, top + 30.0, "tick", &format!("[{}]", unit.symbol));
    let points: Vec<(f64, f64)> =
        trace.samples.iter().map(|s| (time.x(s.at), axis.y(value(s), top, bottom))).collect();
    canvas.path(panel.class, &thinned(&points));
}

/// Width of a column in which [`thinned`] keeps four points.
const COLUMN: f64 = 2.0;

/// Of each narrow column the first, the lowest, the highest and the last point: it looks the same and is a hundredth as
/// long. Of points on one level only the first and the last.
fn thinned(points: &[(f64, f64)]) -> Vec<(f64, f64)> {
    let mut kept: Vec<(f64, f64)> = Vec::new();
    for column in points.chunk_by(|a, b| whole(a.0 / COLUMN) == whole(b.0 / COLUMN)) {
        for n in extremes(column) {
            add(&mut kept, column[n]);
        }
    }
    kept
}

/// Places of the first, lowest, highest and last point, in their order and each once.
fn extremes(column: &[(f64, f64)]) -> Vec<usize> {
    let by = |a: &usize, b: &usize| column[*a].1.total_cmp(&column[*b].1);
    let all = 0..column.len();
    let (low, high) = (all.clone().min_by(by), all.clone().max_by(by));
    let mut places: Vec<usize> = [all.clone().next(), low, high, all.last()].into_iter().flatten().collect();
    places.sort_unstable();
    places.dedup();
    places
}

#[allow(clippy::cast_possible_truncation, reason = "a place in a picture")]
fn whole(place: f64) -> i64 {
    place.floor() as i64
}

/// Adds a point; of three on one level the middle one goes.
fn add(kept: &mut Vec<(f64, f64)>, point: (f64, f64)) {
    let level = |y: f64| whole(y * 10.0);
    if let [.., a, b] = kept.as_slice()
        && level(a.1) == level(b.1)
        && level(b.1) == level(point.1)
    {
        kept.pop();
    }
    kept.push(point);
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn thinning_keeps_peaks_and_ends() {
        // A peak of one sample among a thousand in twenty pixels.
        let points: Vec<(f64, f64)> =
            (0..1000).map(|n| (f64::from(n) / 50.0, if n == 517 { 3.0 } else { 90.0 })).collect();
        let kept = thinned(&points);
        assert!(kept.len() < 12, "{kept:?}");
        assert!(kept.contains(&(10.34, 3.0)));
        assert_eq!((kept.first(), kept.last()), (points.first(), points.last()));
    }
}
