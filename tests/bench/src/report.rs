//! What was measured, as a table to read, as JSON, and as the table of the README.

use std::fmt::Write;

use serde_json::{Value, json};

/// The other compilers, in the order of columns.
pub const PEERS: [&str; 2] = ["svd2rust", "zencan"];

/// A figure beside those of others and its budget. The smaller, the better.
pub struct Row {
    pub what: String,
    pub unit: Unit,
    pub ours: f64,
    /// The most that it may be.
    pub budget: Option<f64>,
    pub peers: [Option<f64>; PEERS.len()],
    /// Stands in the README.
    pub headline: bool,
}

/// What a figure counts.
#[derive(Clone, Copy, PartialEq, Eq)]
pub enum Unit {
    Seconds,
    Bytes,
    Ratio,
}

/// All figures of one run.
#[derive(Default)]
pub struct Report {
    pub machine: String,
    pub rows: Vec<Row>,
    pub skipped: Vec<String>,
}

impl Row {
    pub fn new(what: impl Into<String>, unit: Unit, ours: f64) -> Self {
        Self { what: what.into(), unit, ours, budget: None, peers: [None; PEERS.len()], headline: false }
    }

    /// With the most that it may be; such a row stands in the README.
    pub fn budget(self, most: f64) -> Self {
        Self { budget: Some(most), headline: true, ..self }
    }

    /// In the README without a budget.
    pub fn headline(self) -> Self {
        Self { headline: true, ..self }
    }

    /// Beside those of others.
    pub fn beside(self, peers: [Option<f64>; PEERS.len()]) -> Self {
        Self { peers, ..self }
    }

    fn within(&self) -> Option<bool> {
        self.budget.map(|most| self.ours <= most)
    }
}

impl Unit {
    pub fn text(self, n: f64) -> String {
        match self {
            Self::Seconds if n < 1e-6 => format!("{:.0} ns", n * 1e9),
            Self::Seconds if n < 1e-3 => format!("{:.1} us", n * 1e6),
            Self::Seconds if n < 0.1 => format!("{:.1} ms", n * 1e3),
            Self::Seconds => format!("{n:.2} s"),
            Self::Bytes if n < 1e4 => format!("{n:.0} B"),
            Self::Bytes if n < 1e6 => format!("{:.1} kB", n / 1e3),
            Self::Bytes => format!("{:.1} MB", n / 1e6),
            Self::Ratio => format!("{n:.2}"),
        }
    }
}

/// Cells of a row: what, ours, budget, peers.
fn cells(row: &Row) -> Vec<String> {
    let verdict = match row.within() {
        Some(true) => "within",
        Some(false) => "OVER",
        None => "",
    };
    let budget = row.budget.map_or_else(String::new, |most| format!("{verdict} {}", row.unit.text(most)));
    let peer = |n: &Option<f64>| {
        n.map_or_else(String::new, |n| format!("{} (x{:.1})", row.unit.text(n), n / row.ours))
    };
    let mut cells = vec![row.what.clone(), row.unit.text(row.ours), budget];
    cells.extend(row.peers.iter().map(peer));
    cells
}

/// To read.
pub fn text(report: &Report) -> String {
    let mut out = format!("{}\n", report.machine);
    let head = ["", "drivewright", "budget"].iter().chain(&PEERS).map(|s| (*s).to_owned()).collect();
    for cells in [head].into_iter().chain(report.rows.iter().map(cells)) {
        let [what, rest @ ..] = cells.as_slice() else { continue };
        let _ = write!(out, "{what:<66}");
        rest.iter().for_each(|cell| out += &format!(" {cell:>18}"));
        out = out.trim_end().to_owned() + "\n";
    }
    report.skipped.iter().for_each(|why| out += &format!("skipped: {why}\n"));
    out
}

/// For programs.
pub fn json(report: &Report) -> Value {
    let row = |row: &Row| {
        let unit = match row.unit {
            Unit::Seconds => "seconds",
            Unit::Bytes => "bytes",
            Unit::Ratio => "ratio",
        };
        let peers: serde_json::Map<String, Value> = PEERS
            .iter()
            .zip(row.peers)
            .filter_map(|(name, n)| Some(((*name).to_owned(), n?.into())))
            .collect();
        json!({ "what": row.what, "unit": unit, "drivewright": row.ours, "budget": row.budget, "within": row.within(), "peers": peers })
    };
    let rows: Vec<Value> = report.rows.iter().map(row).collect();
    json!({ "machine": report.machine, "rows": rows, "skipped": report.skipped })
}

const BEGIN: &str = "<!-- cargo xtask bench --update-readme: from here -->";
const END: &str = "<!-- to here -->";

/// `readme` with the table between its two marks; `None` where they are missing.
pub fn in_readme(report: &Report, readme: &str) -> Option<String> {
    let (before, rest) = readme.split_once(BEGIN)?;
    let (_, after) = rest.split_once(END)?;
    Some(format!("{before}{BEGIN}\n{}{END}{after}", markdown(report)))
}

fn markdown(report: &Report) -> String {
    let mut out = format!("\n| | drivewright | Budget | {} |\n|---|---|---|---|---|\n", PEERS.join(" | "));
    for row in report.rows.iter().filter(|r| r.headline) {
        let _ = writeln!(out, "| {} |", cells(row).join(" | "));
    }
    let _ = writeln!(out, "\nMeasured with {}. In brackets: times drivewright's figure.\n", report.machine);
    out
}

#[cfg(test)]
mod tests {
    use super::*;

    fn report() -> Report {
        let row = Row::new("compile", Unit::Seconds, 0.2).budget(0.3).beside([Some(2.0), None]);
        let over = Row::new("memory", Unit::Bytes, 2e6).budget(1e6);
        Report { machine: "2 cores".into(), rows: vec![row, over], skipped: vec!["a: why".into()] }
    }

    #[test]
    fn a_figure_over_its_budget_says_so() {
        let text = text(&report());
        assert!(text.contains("within 0.30 s") && text.contains("2.00 s (x10.0)"), "{text}");
        assert!(text.contains("OVER 1.0 MB") && text.ends_with("skipped: a: why\n"), "{text}");
        assert_eq!(json(&report())["rows"][1]["within"], false);
    }

    #[test]
    fn the_readme_keeps_what_is_around_the_table() {
        let readme = format!("a\n{BEGIN}\nold\n{END}\nb\n");
        let new = in_readme(&report(), &readme).unwrap();
        assert!(new.starts_with(&format!("a\n{BEGIN}\n")) && new.ends_with(&format!("{END}\nb\n")));
        assert!(
            !new.contains("old") && new.contains("| compile | 0.20 s | within 0.30 s | 2.00 s (x10.0) |  |")
        );
        assert_eq!(in_readme(&report(), &new).unwrap(), new);
        assert_eq!(in_readme(&report(), "no marks"), None);
    }
}
