//! Reports as one comment of a pull request: a heading a drive, a table a section, long ones folded. What does not fit is
//! counted.

use super::show::{cites, counts, moved, title, values, verdict};
use super::{Change, Effect, Report, What};
use crate::emit::escape::markdown as escape;

/// The most that a code host takes as a comment, in characters, with room for what a poster adds.
pub const COMMENT: usize = 65_000;

/// A section with more rows is folded.
const LONG: usize = 20;

/// The longest text of a cell, in characters.
const CELL: usize = 400;

/// Room for the lines that say what is not shown.
const RESERVE: usize = 400;

const TABLE: &str = "| What | Before | Now | Manual | Effect |\n|---|---|---|---|---|\n";

/// The reports as one text of at most `most` bytes. `hint` says how to see all.
pub fn markdown(reports: &[Report], hint: &str, most: usize) -> String {
    let mut out = String::new();
    for (n, report) in reports.iter().enumerate() {
        // What one drive does not need is left to those after it.
        let share = most.saturating_sub(out.len() + RESERVE) / (reports.len() - n);
        if share < 2 * RESERVE {
            out.extend([format!(
                "\n{} more drives differ and do not fit here: {hint}.\n",
                reports.len() - n
            )]);
            break;
        }
        drive(report, hint, out.len() + share, &mut out);
    }
    if reports.is_empty() {
        out.push_str("No drive has changed.\n");
    }
    out
}

fn drive(report: &Report, hint: &str, end: usize, out: &mut String) {
    let versions =
        if report.old.is_empty() { String::new() } else { format!("{} → ", escape(&report.old)) };
    let mark = if report.verdict.enough { "" } else { "⚠️ " };
    out.extend([format!(
        "## {} {versions}{}\n\n{}.\n\n",
        escape(&report.package),
        escape(&report.new),
        escape(&counts(report))
    )]);
    if report.changes.is_empty() {
        return;
    }
    out.extend([format!("{mark}**SemVer**: {}.\n\n", escape(&verdict(report)))]);
    let mut left = section("Values that move axes", &report.moving().collect::<Vec<_>>(), end, out);
    for effect in Effect::ALL {
        let changes: Vec<&Change> = report.others(effect).filter(|c| !c.is_source()).collect();
        left += section(effect.heading(), &changes, end, out);
    }
    let sources = report.changes.iter().filter(|c| c.is_source()).count();
    if sources > 0 {
        out.extend([format!("{}.\n\n", escape(&moved(sources)))]);
    }
    if left > 0 {
        out.extend([format!("**{left} differences do not fit here**: {hint}.\n\n")]);
    }
}

/// Writes what fits before `end`, and gives the number of rows that do not.
fn section(head: &str, changes: &[&Change], end: usize, out: &mut String) -> usize {
    if changes.is_empty() {
        return 0;
    }
    // What moves an axis or breaks code is never behind a fold.
    let folded =
        changes.len() > LONG && changes.iter().all(|c| c.axis.is_none() && c.effect != Effect::Breaking);
    let (open, close) = if folded {
        (format!("<details><summary>{head} ({})</summary>\n\n{TABLE}", changes.len()), "\n</details>\n\n")
    } else {
        (format!("### {head} ({})\n\n{TABLE}", changes.len()), "\n")
    };
    if out.len() + open.len() + close.len() > end {
        return changes.len();
    }
    out.push_str(&open);
    let mut shown = 0;
    for change in changes {
        let line = line(change);
        if out.len() + line.len() + close.len() > end {
            break;
        }
        out.push_str(&line);
        shown += 1;
    }
    out.push_str(close);
    changes.len() - shown
}

fn line(change: &Change) -> String {
    let (old, new) = values(change);
    let (was, is) = cites(change);
    let sign = match change.what {
        What::Added(_) => "➕ ",
        What::Removed(_) => "➖ ",
        What::Changed(..) => "",
    };
    let manual = match (was, is) {
        (Some(was), Some(is)) if was != is => format!("{} → {}", cell(Some(&was)), cell(Some(&is))),
        (was, is) => cell(is.or(was).as_deref()),
    };
    let group = change.axis.map_or_else(String::new, |group| format!(" ({group})"));
    let effect = change.effect.word();
    format!(
        "| {sign}{} | {} | {} | {manual} | **{effect}**{group}: {} |\n",
        cell(Some(&title(change))),
        cell(old.as_deref()),
        cell(new.as_deref()),
        escape(change.why)
    )
}

fn cell(text: Option<&str>) -> String {
    let Some(text) = text else { return String::new() };
    match text.char_indices().nth(CELL) {
        Some((at, _)) => format!("{} …", escape(&text[..at])),
        None => escape(text),
    }
}
