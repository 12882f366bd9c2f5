//! How the lists of `model.json` become rows: what a row is called, which keys name it, which follow from others.
//!
//! A key that is not named here is a fact of its row like every other one, so that a new key of the format is compared
//! from the day it is there.

/// A list of `model.json` whose items are rows.
pub(super) struct List {
    /// Key of the list.
    pub(super) key: &'static str,
    /// First word of the row's key: `object`, `alarm`.
    pub(super) word: &'static str,
    /// Keys of an item that name it, and what goes before each.
    pub(super) id: &'static [(&'static str, &'static str)],
    /// Keys of an item that repeat others or follow from them.
    pub(super) derived: &'static [&'static str],
    /// Numbers that people write in hexadecimal, with the digits.
    pub(super) hex: &'static [(&'static str, usize)],
    /// The list in each item whose items are rows, too.
    pub(super) inner: Option<&'static List>,
}

const PLAIN: List = List { key: "", word: "", id: &[("id", "")], derived: &[], hex: &[], inner: None };

const ENTRIES: List =
    List { key: "entries", id: &[("at", "")], derived: &["index", "sub", "width"], ..PLAIN };
const VALUES: List = List { key: "values", id: &[("value", " ")], ..PLAIN };
const FIELDS: List = List { key: "fields", id: &[("bit", " "), ("mode", " mode ")], ..PLAIN };
const MAPPED: List =
    List { key: "entries", id: &[("position", " ")], derived: &["index", "sub", "bit"], ..PLAIN };
const CASES: List = List { key: "cases", id: &[("number", ".")], ..PLAIN };
const MASKED: &[(&str, usize)] = &[("mask", 4), ("value", 4)];

/// Every list of `model.json`, in the order of reports. `format`, `about` and `identity` say what others say, too.
pub(super) const LISTS: &[List] = &[
    List { key: "manuals", word: "manual", ..PLAIN },
    List {
        key: "objects",
        word: "object",
        id: &[("at", "")],
        derived: &["index"],
        inner: Some(&ENTRIES),
        ..PLAIN
    },
    List { key: "enums", word: "enum", id: &[("name", "")], inner: Some(&VALUES), ..PLAIN },
    List { key: "bits", word: "bits", id: &[("name", "")], inner: Some(&FIELDS), ..PLAIN },
    List {
        key: "pdos",
        word: "pdo",
        id: &[("at", "")],
        derived: &["index", "bits"],
        inner: Some(&MAPPED),
        ..PLAIN
    },
    List {
        key: "alarms",
        word: "alarm",
        id: &[("key", "")],
        derived: &["display"],
        hex: &[("number", 2), ("code", 4), ("aux", 4), ("al_status", 4)],
        ..PLAIN
    },
    List { key: "homing", word: "homing", id: &[("number", "")], inner: Some(&CASES), ..PLAIN },
    List { key: "modes", word: "mode", id: &[("number", "")], ..PLAIN },
    List { key: "states", word: "state", id: &[("name", "")], hex: MASKED, ..PLAIN },
    List { key: "commands", word: "command", id: &[("name", "")], hex: MASKED, ..PLAIN },
    List { key: "aborts", word: "abort", id: &[("at", "")], derived: &["code"], ..PLAIN },
    List { key: "terminals", word: "terminal", id: &[("name", "")], ..PLAIN },
    List { key: "sync_managers", word: "sync manager", id: &[("number", "")], ..PLAIN },
    List { key: "fmmus", word: "fmmu", id: &[("number", "")], ..PLAIN },
    List { key: "coe", word: "coe", id: &[("feature", "")], ..PLAIN },
    List { key: "dc_modes", word: "dc mode", id: &[("number", "")], ..PLAIN },
    List { key: "startup", word: "startup", id: &[("number", "")], ..PLAIN },
    List { key: "emcy", word: "emcy", id: &[("byte", "")], ..PLAIN },
    List { key: "rules", word: "rule", ..PLAIN },
    List { key: "examples", word: "example", id: &[("id", ""), ("step", ".")], ..PLAIN },
    List { key: "errata", word: "erratum", ..PLAIN },
];

/// Keys of the document that are no lists of rows and no facts of their own.
pub(super) const ASIDE: &[&str] = &["format", "about", "identity", "drive", "ethercat"];

/// Fields in the order of reports; others follow by name.
pub(super) const ORDER: &[&str] = &[
    "name", "handle", "kind", "type", "access", "pdo", "unit", "min", "max", "allow", "default", "values",
    "bits", "effect", "number", "code", "aux", "reset", "status", "when", "moves",
];

/// Where a table stands in reports: the drive and its slave controller first, what this program does not know last.
pub(super) fn place(table: &str) -> usize {
    let lists = LISTS.iter().position(|list| list.key == table).map(|n| n + 1);
    lists.unwrap_or(if ["drive", "ethercat"].contains(&table) { 0 } else { usize::MAX })
}
