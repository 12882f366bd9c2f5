//! A trace for programs: every sample as CSV, and what changed as JSON lines.

use std::fmt::Write;

use drivewright_codegen::emit::escape::{json, one_line};
use serde_json::{Value, json};

use super::{Change, Event, Sample, Trace, Units, millis};

/// A line for each sample and each event, with a line of heads. Numbers are in the units that the heads name.
pub(crate) fn csv(trace: &Trace) -> String {
    let units = &trace.units;
    let heads = [
        "time [ms]".to_owned(),
        format!("position [{}]", units.position.symbol),
        format!("speed [{}]", units.speed.symbol),
        format!("{} [{}]", units.force_name, units.force.symbol),
    ];
    let heads: Vec<String> = heads.iter().map(|head| cell(head)).collect();
    let mut out = format!("{},state,mode,6041h,6040h,event,text\n", heads.join(","));
    let mut events = trace.events.iter().peekable();
    for sample in &trace.samples {
        while let Some(event) = events.next_if(|event| event.at < sample.at) {
            event_line(&mut out, event);
        }
        sample_line(&mut out, sample, units);
    }
    events.for_each(|event| event_line(&mut out, event));
    out
}

fn sample_line(out: &mut String, sample: &Sample, units: &Units) {
    // Writing to a String cannot fail.
    let _ = writeln!(
        out,
        "{},{},{},{},{},{},{:04X}h,{:04X}h,,",
        millis(sample.at),
        units.position.show(sample.position),
        units.speed.show(sample.speed),
        units.force.show(sample.force),
        sample.state_word(),
        sample.mode.0,
        sample.status.0,
        sample.control
    );
}

fn event_line(out: &mut String, event: &Event) {
    let _ = writeln!(out, "{},,,,,,,,{},{}", millis(event.at), event.kind.word(), cell(&event.text));
}

/// A text as a cell: in quotes where it has a sign of CSV, and never a formula for a spreadsheet.
fn cell(text: &str) -> String {
    let line = one_line(text);
    let line = if line.starts_with(['=', '+', '-', '@']) { format!("'{line}") } else { line };
    if line.contains(['"', ',']) { format!("\"{}\"", line.replace('"', "\"\"")) } else { line }
}

/// An object a line: the samples in which a word or the mode changed, and the events. Numbers are raw counts, and
/// microseconds.
pub(crate) fn json_lines(trace: &Trace) -> String {
    let line =
        |change: &Change<'_>| format!("{}\n", json(&object(change, trace.units.force_name).to_string()));
    trace.changes().iter().map(line).collect()
}

fn object(change: &Change<'_>, force: &str) -> Value {
    match change {
        Change::Sample { now, .. } => json!({
            "at_us": now.at.micros(),
            "state": now.state_word(),
            "mode": now.mode.0,
            "position": now.position,
            "speed": now.speed,
            force: now.force,
            "statusword": now.status.0,
            "controlword": now.control,
        }),
        Change::Event(event) => {
            json!({ "at_us": event.at.micros(), "event": event.kind.word(), "text": event.text })
        }
    }
}
