//! Proves facts against the text extract of a manual: the cited lines must hold what the profile says they do.
//!
//! A fact is proved when a cited line belongs to its row (index and sub-index, parameter number, display of an alarm) and
//! the right cell of it, or of another cited line, holds the value. A cited line that holds nothing of its row is a
//! finding, and so is a row of a printed table that nothing cites. The audit reads the extract and never the other way
//! round: it can prove that a reading is the manual's, not that the manual is right.

mod behaviour;
mod contradictions;
mod dictionary;
mod ethercat;
mod evidence;
mod number;
mod page;
mod record;
mod words;

pub use contradictions::{Contradiction, Place, contradictions};
pub use record::{Record, facts_hash, text_hash};

use std::collections::{BTreeMap, BTreeSet};

use crate::facts::{FactLine, Table};
use crate::model::{Cite, Class, Erratum, Model};
use crate::rows::Rows;
use page::Page;
use words::{Row, Words};

/// What the audit finds wrong.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug)]
pub enum Kind {
    /// The cited lines do not hold the value.
    Unproved,
    /// A stated fact cites nothing.
    NotCited,
    /// A cited line holds nothing of the row.
    IdleLine,
    /// A row of a printed table that nothing cites.
    Uncited,
    /// An exception of the profile that excepts nothing.
    IdleException,
}

impl Kind {
    /// A few words for lists.
    pub fn word(self) -> &'static str {
        match self {
            Self::Unproved => "unproved",
            Self::NotCited => "not cited",
            Self::IdleLine => "idle line",
            Self::Uncited => "uncited row",
            Self::IdleException => "idle exception",
        }
    }
}

/// One finding of the audit.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Finding {
    /// What is wrong.
    pub kind: Kind,
    /// The row of the profile, or the line of the manual.
    pub at: String,
    /// The key, where one is concerned.
    pub field: String,
    /// What the profile says, or the manual.
    pub what: String,
    /// Why it is accepted; `None`: it is not.
    pub accepted: Option<String>,
}

/// What came of an audit.
#[derive(Clone, Default, Debug)]
pub struct Report {
    /// Facts that the cited lines hold.
    pub proved: usize,
    /// Facts whose words are the profile's own: the audit proves that their lines belong to the row, and a reader the rest.
    pub worded: usize,
    /// What is wrong, accepted or not.
    pub findings: Vec<Finding>,
    /// Rows of printed tables that facts cite.
    pub cited_lines: usize,
    /// Rows of printed tables that none cites, accepted with a reason.
    pub uncited_lines: usize,
}

impl Report {
    /// The findings that nobody accepts.
    pub fn open(&self) -> impl Iterator<Item = &Finding> {
        self.findings.iter().filter(|f| f.accepted.is_none())
    }

    /// The facts that are accepted without proof.
    pub fn accepted(&self) -> usize {
        self.findings.iter().filter(|f| f.kind == Kind::Unproved && f.accepted.is_some()).count()
    }
}

/// Audits `facts` of `model` against the text of `manual`, an id of the profile; `None` if the profile has no such manual.
/// `rows` says how the manual's tables are read and what is excepted.
pub fn audit(model: &Model, facts: &[FactLine<'_>], rows: &Rows, manual: &str, text: &str) -> Option<Report> {
    let only = model.manuals.len() == 1;
    model.manuals.iter().find(|m| m.id == manual)?;
    let page = Page::new(text, rows);
    let mut auditor = Auditor {
        page: &page,
        words: Words::new(rows),
        rows,
        of: Manual { id: manual, only },
        report: Report::default(),
        used: BTreeSet::new(),
    };
    for row in group(facts) {
        auditor.row(&row);
    }
    auditor.errata(model, facts);
    auditor.cited(model, facts);
    auditor.idle_exceptions(&excepted_differences(model, facts, rows, manual, text));
    Some(auditor.report)
}

const NO_LINE: &str = "there is no such line";

/// Which citations belong to the manual that is read.
struct Manual<'a> {
    id: &'a str,
    only: bool,
}

impl Manual<'_> {
    /// The lines of `cite` in this manual.
    fn lines(&self, cite: &Cite) -> Vec<u32> {
        let here = |p: &&crate::model::Place| p.manual.as_deref().map_or(self.only, |m| m == self.id);
        cite.places.iter().filter(here).flat_map(|p| p.lines.iter().copied()).collect()
    }
}

struct Auditor<'a> {
    page: &'a Page,
    words: Words<'a>,
    rows: &'a Rows,
    of: Manual<'a>,
    report: Report,
    /// Exceptions that were needed: rows of `unproved` by place.
    used: BTreeSet<usize>,
}

/// Facts by their row, in order. The cases of a homing method are one row with it.
fn group<'f>(facts: &'f [FactLine<'f>]) -> Vec<Row<'f>> {
    let mut rows: Vec<Row<'f>> = Vec::new();
    for fact in facts {
        let key = match fact.table {
            Table::Homing => fact.key.split('.').next().unwrap_or(&fact.key),
            _ => fact.key.as_str(),
        };
        match rows.last_mut() {
            Some(row) if row.key == key => row.facts.push(fact),
            _ => rows.push(Row { table: fact.table, key, facts: vec![fact] }),
        }
    }
    rows
}

impl Auditor<'_> {
    fn row(&mut self, row: &Row<'_>) {
        if matches!(row.table, Table::Errata | Table::Manuals) {
            return;
        }
        let (mut lines, mut twice) = (BTreeMap::<u32, bool>::new(), BTreeSet::new());
        for fact in &row.facts {
            let Some(Class::Stated | Class::Inferred(_)) = fact.class else { continue };
            let cited = fact.cite.map(|c| self.of.lines(c)).unwrap_or_default();
            for (place, line) in cited.iter().enumerate() {
                if cited[..place].contains(line) {
                    twice.insert(*line);
                }
                let helps = self.helps(row, fact, *line, &cited);
                *lines.entry(*line).or_insert(false) |= helps;
            }
            if matches!(fact.class, Some(Class::Stated)) {
                self.fact(row, fact, &cited);
            }
        }
        for line in twice {
            self.finding(Kind::IdleLine, row.key, &format!("L{line}"), "the citation names the line twice");
        }
        for line in lines.into_iter().filter(|(_, helps)| !helps).map(|(line, _)| line) {
            let text = self.page.line(line).map_or(NO_LINE, |l| l.text.as_str());
            self.finding(Kind::IdleLine, row.key, &format!("L{line}"), text);
        }
    }

    /// Whether the line has to do with the row: it belongs to it, or shows a value that is not the same everywhere.
    fn helps(&self, row: &Row<'_>, fact: &FactLine<'_>, line: u32, cited: &[u32]) -> bool {
        let Some(found) = self.page.line(line) else { return false };
        // A row of another object may share a cell with this one; its default, mostly 0, says nothing of this one.
        let telling = match fact.field.as_ref() {
            "type" | "access" | "pdo" | "unit" => false,
            "default" => found.index().is_none(),
            _ => true,
        };
        self.words.anchors(row, found)
            || evidence::corrects(fact, found)
            || telling && self.words.shows(row, fact, found)
            || self.is_part(row, fact, found, cited)
    }

    /// Whether the line has a part of a cell that the cited lines show together.
    fn is_part(&self, row: &Row<'_>, fact: &FactLine<'_>, line: &page::Line, cited: &[u32]) -> bool {
        let lines: Vec<&page::Line> = cited.iter().filter_map(|l| self.page.line(*l)).collect();
        line.cell("range").or_else(|| line.cell("default")).is_some()
            && dictionary::shows_split(&self.words, row, fact, &lines)
    }

    fn fact(&mut self, row: &Row<'_>, fact: &FactLine<'_>, cited: &[u32]) {
        if fact.cite.is_none() {
            self.finding(Kind::NotCited, row.key, &fact.field, &fact.value);
        } else if cited.is_empty() {
            // Another manual says it.
        } else if evidence::is_worded(fact) {
            let lines: Vec<&page::Line> = cited.iter().filter_map(|l| self.page.line(*l)).collect();
            let fits = lines.iter().any(|l| self.words.anchors(row, l)) && behaviour::allows(fact, &lines);
            self.settle(row, fact, fits, true);
        } else {
            let proved = self.words.proves(row, fact, self.page, cited);
            self.settle(row, fact, proved, false);
        }
    }

    fn settle(&mut self, row: &Row<'_>, fact: &FactLine<'_>, proved: bool, worded: bool) {
        match (proved, worded) {
            (true, false) => self.report.proved += 1,
            (true, true) => self.report.worded += 1,
            (false, _) => self.finding(Kind::Unproved, row.key, &fact.field, &fact.value),
        }
    }

    fn finding(&mut self, kind: Kind, at: &str, field: &str, what: &str) {
        let accepted = self.exception(kind, at, field).filter(|_| kind != Kind::IdleException);
        let accepted = accepted.map(|place| {
            self.used.insert(place);
            self.rows.unproved[place].why.value.0.clone()
        });
        let (at, field, what) = (at.to_owned(), field.to_owned(), what.to_owned());
        self.report.findings.push(Finding { kind, at, field, what, accepted });
    }

    /// The exception of the profile for a row and key. One without a key excepts values, and none excepts every row.
    fn exception(&self, kind: Kind, at: &str, field: &str) -> Option<usize> {
        self.rows.unproved.iter().position(|row| {
            let named = &row.at.value.0;
            let same = named.strip_suffix('*').map_or(named == at, |start| at.starts_with(start));
            let here = row.field.as_ref().map_or(kind == Kind::Unproved, |f| f.value.0 == field);
            named != "*" && same && here
        })
    }

    /// What an erratum says is printed must be printed where it says.
    fn errata(&mut self, model: &Model, facts: &[FactLine<'_>]) {
        let rows = group(facts);
        for erratum in model.errata.as_slice() {
            let key = format!("erratum {}", erratum.id);
            let named: Vec<&Row<'_>> =
                rows.iter().filter(|row| evidence::names(&erratum.at, row.key)).collect();
            if named.is_empty() {
                if !self.rows.left_out.contains(&erratum.at) {
                    self.finding(Kind::Unproved, &key, "at", &erratum.at);
                }
                continue;
            }
            self.not_blank(&key, std::iter::once(&erratum.seen).chain(&erratum.by));
            for line in self.of.lines(&erratum.seen) {
                if named.iter().any(|row| self.is_printed(row, erratum, line)) {
                    self.report.proved += 1;
                } else {
                    self.finding(Kind::Unproved, &key, &format!("was L{line}"), &erratum.was);
                }
            }
        }
    }

    /// Whether the line prints what the erratum says of the row.
    fn is_printed(&self, row: &Row<'_>, erratum: &Erratum, line: u32) -> bool {
        let fact = evidence::printed(row, erratum);
        self.page.line(line).is_some_and(|l| {
            if evidence::is_worded(&fact) {
                self.words.anchors(row, l)
            } else {
                self.words.shows(row, &fact, l)
            }
        })
    }

    /// A citation that hits a blank line is off by some.
    fn not_blank<'c>(&mut self, at: &str, cites: impl Iterator<Item = &'c Cite>) {
        let lines: Vec<u32> = cites.flat_map(|cite| self.of.lines(cite)).collect();
        for line in lines {
            if self.page.line(line).is_none_or(|l| l.text.trim().is_empty()) {
                self.finding(Kind::IdleLine, at, &format!("L{line}"), "the line is blank");
            }
        }
    }

    /// Lines that print an object again; a line of another row is none, and is a finding.
    fn also(&mut self, model: &Model, facts: &[FactLine<'_>]) -> Vec<u32> {
        let mut found = Vec::new();
        for row in group(facts).iter().filter(|row| row.table == Table::Objects) {
            let also = contradictions::entry(row, model).and_then(|e| e.also.as_ref());
            for number in also.map(|cite| self.of.lines(cite)).unwrap_or_default() {
                match self.page.line(number) {
                    Some(line) if self.words.anchors(row, line) => found.push(number),
                    line => {
                        let text = line.map_or(NO_LINE, |l| l.text.as_str());
                        self.finding(Kind::IdleLine, row.key, &format!("also L{number}"), text);
                    }
                }
            }
        }
        found
    }

    /// Rows of printed tables that nothing cites.
    fn cited(&mut self, model: &Model, facts: &[FactLine<'_>]) {
        let mut cited: BTreeSet<u32> = BTreeSet::new();
        let places = facts.iter().filter_map(|f| f.cite);
        cited.extend(self.also(model, facts));
        let errata = model.errata.as_slice().iter().flat_map(|e| std::iter::once(&e.seen).chain(&e.by));
        for cite in places.chain(errata) {
            cited.extend(self.of.lines(cite));
        }
        let excepted: BTreeMap<u32, usize> = self
            .rows
            .uncited
            .iter()
            .enumerate()
            .flat_map(|(place, row)| row.lines.value.iter().map(move |line| (*line, place)))
            .collect();
        for (number, line) in self.page.lines().filter(|(_, line)| line.is_row()) {
            match (cited.contains(&number), excepted.get(&number)) {
                (true, None) => self.report.cited_lines += 1,
                (false, Some(_)) => self.report.uncited_lines += 1,
                (false, None) => self.finding(Kind::Uncited, &format!("L{number}"), "", &line.text),
                (true, Some(_)) => {
                    self.finding(Kind::IdleException, &format!("L{number}"), "", "a fact cites the line");
                }
            }
        }
    }

    /// Exceptions that except nothing. `also` says which rows except a difference between places.
    fn idle_exceptions(&mut self, also: &BTreeSet<usize>) {
        for (place, row) in self.rows.unproved.iter().enumerate() {
            let field = row.field.as_ref().map_or("", |f| f.value.0.as_str());
            if !self.used.contains(&place) && !also.contains(&place) {
                self.finding(Kind::IdleException, &row.at.value.0, field, &row.why.value.0);
            }
        }
        for number in self.rows.uncited.iter().flat_map(|row| &row.lines.value) {
            if !self.page.line(*number).is_some_and(page::Line::is_row) {
                self.finding(Kind::IdleException, &format!("L{number}"), "", "the line is no row of a table");
            }
        }
    }
}

/// Places of the exceptions that settle a difference between places.
fn excepted_differences(
    model: &Model,
    facts: &[FactLine<'_>],
    rows: &Rows,
    manual: &str,
    text: &str,
) -> BTreeSet<usize> {
    let also = |row: &crate::rows::tables::UnprovedRow| {
        row.field.as_ref().is_some_and(|f| f.value.0.starts_with("also "))
    };
    if !rows.unproved.iter().any(also) {
        return BTreeSet::new();
    }
    contradictions(model, facts, rows, manual, text).iter().filter_map(|c| c.exception).collect()
}
