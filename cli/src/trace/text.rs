//! A trace for people: a line where the state, the mode or a bit changes, and where something happened.

use drivewright_codegen::emit::escape::one_line;
use drivewright_runtime::cia402::{Mode, Statusword};

use super::{Change, Event, Kind, Sample, Trace, millis};

/// The columns that are aligned; what changed follows them.
const COLUMNS: usize = 7;

/// The trace as a table.
pub(crate) fn text(trace: &Trace) -> String {
    let units = &trace.units;
    let symbol = |unit: &super::Unit| one_line(&unit.symbol);
    let heads = ["time", "state", "mode", "position", "speed", units.force_name, "status"].map(str::to_owned);
    let under = ["ms".into(), String::new(), String::new(), symbol(&units.position), symbol(&units.speed)]
        .into_iter()
        .chain([symbol(&units.force), "6041h".into()]);
    let mut rows = vec![row(&heads, "what changed"), row(&under.collect::<Vec<_>>(), "")];
    rows.extend(trace.changes().iter().map(|change| match change {
        Change::Sample { before, now } => sampled(trace, *before, now),
        Change::Event(event) => Row { cells: vec![millis(event.at)], last: told(event) },
    }));
    aligned(&rows)
}

struct Row {
    /// Of an event, its time alone.
    cells: Vec<String>,
    last: String,
}

fn row(cells: &[String], last: &str) -> Row {
    Row { cells: cells.to_vec(), last: last.to_owned() }
}

fn sampled(trace: &Trace, before: Option<&Sample>, now: &Sample) -> Row {
    let units = &trace.units;
    let cells = vec![
        millis(now.at),
        now.state_word().to_owned(),
        mode_name(now.mode),
        units.position.show(now.position),
        units.speed.show(now.speed),
        units.force.show(now.force),
        format!("{:04X}h", now.status.0),
    ];
    Row { cells, last: what_changed(trace, before, now) }
}

/// The bits that changed, and the controlword where it did.
fn what_changed(trace: &Trace, before: Option<&Sample>, now: &Sample) -> String {
    let known = before.map_or((Statusword(0), now.mode), |b| (b.status, b.mode));
    let bits = trace.bits.changed(known, (now.status, now.mode));
    let control = before.filter(|b| b.control != now.control);
    let control = control.map(|_| format!("6040h = {:04X}h", now.control));
    control.into_iter().chain((!bits.is_empty()).then_some(bits)).collect::<Vec<_>>().join("; ")
}

/// The name of a mode, or its number.
pub(crate) fn mode_name(mode: Mode) -> String {
    if mode == Mode::NONE {
        return "-".to_owned();
    }
    Mode::DESC.name_of(mode.0.into()).map_or_else(|| format!("mode {}", mode.0), str::to_owned)
}

/// Signs that the eye finds in a long table.
fn told(event: &Event) -> String {
    let kind = match event.kind {
        Kind::Step => "== ",
        Kind::Fault => "!! ",
        Kind::Reset | Kind::Homed | Kind::Note => "-- ",
    };
    format!("{kind}{}", one_line(&event.text))
}

/// Numbers to the right, words to the left; an event across all columns, beside its time.
fn aligned(rows: &[Row]) -> String {
    let width = |n: usize| {
        rows.iter().filter_map(|row| row.cells.get(n)).map(|cell| cell.chars().count()).max().unwrap_or(0)
    };
    let widths: Vec<usize> = (0..COLUMNS).map(width).collect();
    rows.iter().map(|row| line(row, &widths)).collect()
}

fn line(row: &Row, widths: &[usize]) -> String {
    let mut out = String::new();
    for (n, (cell, width)) in row.cells.iter().zip(widths).enumerate() {
        let (left, width) = ((1..=2).contains(&n), *width);
        let cell = if left { format!("{cell:<width$}  ") } else { format!("{cell:>width$}  ") };
        out.push_str(&cell);
    }
    out += &row.last;
    format!("{}\n", out.trim_end())
}
