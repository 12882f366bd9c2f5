//! A report for people at a terminal.

use super::show::{cites, counts, moved, title, values, verdict};
use super::{Change, Effect, Report, What};
use crate::diag::render::Style;
use crate::emit::escape::plain_line;

/// The report as text. Values that move axes come first.
pub fn text(report: &Report, style: Style) -> String {
    let paint = Paint { on: style.colour };
    let versions =
        if report.old.is_empty() { String::new() } else { format!("{} -> ", plain_line(&report.old)) };
    let head = format!("{} {versions}{}", plain_line(&report.package), plain_line(&report.new));
    let mut out = format!("{}: {}\n", paint.bold(&head), counts(report));
    if report.changes.is_empty() {
        return out;
    }
    out.extend([plain_line(&verdict(report)).as_str(), "\n"]);
    section("Values that move axes", report.moving(), paint, &mut out);
    for effect in Effect::ALL {
        section(effect.heading(), report.others(effect).filter(|c| !c.is_source()), paint, &mut out);
    }
    let sources = report.changes.iter().filter(|c| c.is_source()).count();
    if sources > 0 {
        out.extend(["\n", &moved(sources), "; --format json lists them\n"]);
    }
    out
}

fn section<'r>(head: &str, changes: impl Iterator<Item = &'r Change>, paint: Paint, out: &mut String) {
    let changes: Vec<&Change> = changes.collect();
    if changes.is_empty() {
        return;
    }
    out.extend(["\n", &paint.bold(&format!("{head} ({})", changes.len())), "\n"]);
    for change in changes {
        item(change, paint, out);
    }
}

fn item(change: &Change, paint: Paint, out: &mut String) {
    let (old, new) = values(change);
    let sign = match change.what {
        What::Added(_) => "+",
        What::Removed(_) => "-",
        What::Changed(..) => "~",
    };
    let values = match (old, new) {
        (Some(old), Some(new)) => format!("{} -> {}", plain_line(&old), plain_line(&new)),
        (one, other) => plain_line(&one.or(other).unwrap_or_default()),
    };
    let colon = if values.is_empty() { "" } else { ": " };
    let group = change.axis.map_or_else(String::new, |group| format!(", {group}"));
    let effect = paint.effect(change.effect);
    out.extend([format!("  {sign} {}{colon}{values}\n", plain_line(&title(change)))]);
    out.extend([format!("      {effect}{group}: {} ({})\n", change.why, change.rule)]);
    if let Some(line) = places(change) {
        out.extend([format!("      manual: {line}\n")]);
    }
}

fn places(change: &Change) -> Option<String> {
    let none = || "none".to_owned();
    let (old, new) = cites(change);
    match change.what {
        What::Changed(..) if old.is_none() && new.is_none() => None,
        What::Changed(..) => Some(format!(
            "{} -> {}",
            plain_line(&old.unwrap_or_else(none)),
            plain_line(&new.unwrap_or_else(none))
        )),
        What::Added(_) | What::Removed(_) => old.or(new).map(|cite| plain_line(&cite)),
    }
}

#[derive(Clone, Copy)]
struct Paint {
    on: bool,
}

impl Paint {
    fn wrap(self, code: &str, text: &str) -> String {
        if self.on { format!("\u{1b}[{code}m{text}\u{1b}[0m") } else { text.to_owned() }
    }

    fn bold(self, text: &str) -> String {
        self.wrap("1", text)
    }

    fn effect(self, effect: Effect) -> String {
        let code = match effect {
            Effect::Breaking => "31",
            Effect::Axis => "33",
            Effect::New => "32",
            Effect::Documentation => "2",
        };
        self.wrap(code, effect.word())
    }
}
