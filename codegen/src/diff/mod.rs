//! What a revision of a profile means to those who use the drive.
//!
//! Both sides are a [`Listing`]: the rows of a `model.json`, whether a file has it or a profile was compiled to it.
//! [`compare`] gives every difference with its effect, both values and the reason; [`rules`] is the table that decides.
//! [`text`], [`markdown`] and [`json`] show the result. Nothing here knows files or git.

mod axis;
pub mod json;
pub mod markdown;
mod read;
pub mod rules;
mod shape;
mod show;
pub mod text;
mod version;

use std::collections::{BTreeMap, BTreeSet};

pub use read::{Listing, ReadError, Row, Said};
pub use version::{Bump, Level, Verdict, Version};

/// What a difference does to those who use the drive, worst last.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug)]
pub enum Effect {
    /// Texts, citations, reasons.
    Documentation,
    /// Something that was not there, and nothing less than before.
    New,
    /// An axis, or what it tells, may do something else.
    Axis,
    /// Code, a device file or a master's configuration that was right may no longer be.
    Breaking,
}

impl Effect {
    /// Every effect, worst first.
    pub const ALL: [Self; 4] = [Self::Breaking, Self::Axis, Self::New, Self::Documentation];

    /// One word, for programs.
    pub fn word(self) -> &'static str {
        match self {
            Self::Breaking => "breaking",
            Self::Axis => "axis",
            Self::New => "new",
            Self::Documentation => "documentation",
        }
    }

    /// A heading, for people.
    pub fn heading(self) -> &'static str {
        match self {
            Self::Breaking => "Breaking for code",
            Self::Axis => "Changes what an axis does",
            Self::New => "New",
            Self::Documentation => "Documentation",
        }
    }
}

/// What is different.
#[derive(Clone, PartialEq, Debug)]
#[allow(clippy::large_enum_variant, reason = "there are as many as differences, not as many as facts")]
pub enum What {
    /// A row is there that was not.
    Added(Row),
    /// A row is gone.
    Removed(Row),
    /// A value of a row that both have: the old one, the new one.
    Changed(String, Option<Said>, Option<Said>),
}

/// A difference.
#[derive(Clone, PartialEq, Debug)]
pub struct Change {
    /// Key of the list in `model.json`.
    pub table: &'static str,
    /// The row: `object 607D:01`.
    pub key: String,
    /// What is different.
    pub what: What,
    /// What it does.
    pub effect: Effect,
    /// What the row is for an axis, where the difference can make one move, stop or refuse.
    pub axis: Option<&'static str>,
    /// The rule that says so.
    pub rule: &'static str,
    /// Its reason.
    pub why: &'static str,
}

impl Change {
    /// Whether the value is the same, and only who says it is not.
    pub fn is_source(&self) -> bool {
        self.rule == rules::SOURCE.name
    }
}

/// Every difference of two revisions.
#[derive(Clone, PartialEq, Debug)]
pub struct Report {
    /// Name of the generated crate and folder.
    pub package: String,
    /// Version of the crate before; empty when the drive is new.
    pub old: String,
    /// Version of the crate now.
    pub new: String,
    /// The differences, in the order of rows.
    pub changes: Vec<Change>,
    /// Which version the crate needs.
    pub verdict: Verdict,
}

impl Report {
    /// The differences that can make an axis move, stop or refuse.
    pub fn moving(&self) -> impl Iterator<Item = &Change> {
        self.changes.iter().filter(|c| c.axis.is_some())
    }

    /// All other differences of one effect.
    pub fn others(&self, effect: Effect) -> impl Iterator<Item = &Change> {
        self.changes.iter().filter(move |c| c.axis.is_none() && c.effect == effect)
    }

    /// How many differences have an effect.
    pub fn count(&self, effect: Effect) -> usize {
        self.changes.iter().filter(|c| c.effect == effect).count()
    }

    /// The worst effect; `None` without a difference.
    pub fn worst(&self) -> Option<Effect> {
        self.changes.iter().map(|c| c.effect).max()
    }
}

/// Compares two revisions of a drive. An empty `old` stands for a drive that is new.
pub fn compare(old: &Listing, new: &Listing) -> Report {
    let (before, now) = (by_key(old), by_key(new));
    let mut changes = Vec::new();
    for table in tables(old, new) {
        for row in new.rows.iter().filter(|row| row.table == table) {
            match before.get(row.key.as_str()) {
                Some(was) => fields(was, row, &mut changes),
                None => changes.push(whole(None, Some(row), &before, &now)),
            }
        }
        let gone = old.rows.iter().filter(|row| row.table == table && !now.contains_key(row.key.as_str()));
        changes.extend(gone.map(|row| whole(Some(row), None, &before, &now)));
    }
    let verdict = version::judge(level(&changes), &old.version, &new.version);
    let package = if new.package.is_empty() { &old.package } else { &new.package };
    Report { package: package.clone(), old: old.version.clone(), new: new.version.clone(), changes, verdict }
}

type Rows<'a> = BTreeMap<&'a str, &'a Row>;

fn by_key(listing: &Listing) -> Rows<'_> {
    listing.rows.iter().map(|row| (row.key.as_str(), row)).collect()
}

/// The tables of both sides, in the order of reports.
fn tables(old: &Listing, new: &Listing) -> Vec<&'static str> {
    let mut seen = BTreeSet::new();
    let all = new.rows.iter().chain(&old.rows).map(|row| row.table);
    let mut tables: Vec<_> = all.filter(|table| seen.insert(*table)).collect();
    tables.sort_by_key(|table| shape::place(table));
    tables
}

fn whole(old: Option<&Row>, new: Option<&Row>, before: &Rows<'_>, now: &Rows<'_>) -> Change {
    let other = if old.is_some() { now } else { before };
    let row = old.or(new);
    let parent = row.and_then(|row| row.parent.as_deref());
    let case = rules::Case {
        row: (old, new),
        field: None,
        said: (None, None),
        parent_stays: parent.is_some_and(|key| other.contains_key(key)),
    };
    let what = match (old, new) {
        (Some(row), _) => What::Removed(row.clone()),
        (_, Some(row)) => What::Added(row.clone()),
        (None, None) => What::Changed(String::new(), None, None),
    };
    judged(&case, what)
}

fn fields(was: &Row, is: &Row, changes: &mut Vec<Change>) {
    let gone = was.facts.iter().filter(|(field, _)| is.fact(field).is_none());
    for (field, _) in is.facts.iter().chain(gone) {
        let (old, new) = (was.fact(field), is.fact(field));
        if old == new {
            continue;
        }
        let case = rules::Case {
            row: (Some(was), Some(is)),
            field: Some(field.as_str()),
            said: (old, new),
            parent_stays: true,
        };
        changes.push(judged(&case, What::Changed(field.clone(), old.cloned(), new.cloned())));
    }
}

fn judged(case: &rules::Case<'_>, what: What) -> Change {
    let rule = rules::of(case);
    let (old, new) = case.row;
    let axis = old.and_then(|row| row.axis).or(new.and_then(|row| row.axis));
    Change {
        table: case.table(),
        key: case.key().to_owned(),
        what,
        effect: rule.effect,
        axis: axis.filter(|_| rule.effect != Effect::Documentation),
        rule: rule.name,
        why: rule.why,
    }
}

/// What a release with these differences is. One after which an axis may do something else counts as breaking: nobody
/// may get it by `cargo update`.
fn level(changes: &[Change]) -> Level {
    let own = |c: &&Change| c.rule != rules::VERSION.name;
    match changes.iter().filter(own).map(|c| c.effect).max() {
        None => Level::Nothing,
        Some(Effect::Documentation) => Level::Texts,
        Some(Effect::New) => Level::Addition,
        Some(Effect::Axis | Effect::Breaking) => Level::Breaking,
    }
}
