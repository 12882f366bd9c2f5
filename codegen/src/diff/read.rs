//! Makes a flat list of rows of `model.json`: profiles are compared in that form, too, so that every way to name a side
//! compares the same.

use std::collections::{BTreeMap, BTreeSet};
use std::fmt;

use serde_json::{Map, Value};

use super::axis;
use super::shape::{ASIDE, LISTS, List, ORDER};
use crate::backend::json;
use crate::model::Model;

/// A value and who says it.
#[derive(Clone, PartialEq, Debug)]
pub struct Said {
    /// The value as `model.json` has it.
    pub value: Value,
    /// The same as people write it.
    pub text: String,
    /// `stated`, `inferred`, `standard`, `assumed`, or `own` for what is no fact of a manual.
    pub class: String,
    /// The rule, base or reason that comes with the class.
    pub detail: Option<String>,
    /// Where a manual says it.
    pub cite: Option<String>,
    /// The erratum that set it or that explains it.
    pub erratum: Option<String>,
}

impl Said {
    /// The value as a whole number.
    pub(super) fn number(&self) -> Option<i128> {
        match &self.value {
            Value::Number(n) => n.as_i64().map(i128::from),
            Value::String(text) => text.parse().ok(),
            _ => None,
        }
    }
}

/// A row: an entry, an alarm, a case of a homing method.
#[derive(Clone, PartialEq, Debug)]
pub struct Row {
    /// Key of its list in `model.json`: `objects`.
    pub table: &'static str,
    /// What it is called, unique: `object 607D:01`.
    pub key: String,
    /// The row that it is a part of.
    pub parent: Option<String>,
    /// What it is for an axis, if it is anything.
    pub axis: Option<&'static str>,
    /// Index of the dictionary, of objects.
    pub index: Option<u16>,
    /// Its values, each field once.
    pub facts: Vec<(String, Said)>,
}

impl Row {
    /// The value of a field.
    pub fn fact(&self, field: &str) -> Option<&Said> {
        self.facts.iter().find(|(name, _)| name == field).map(|(_, said)| said)
    }
}

/// Every row of a drive.
#[derive(Clone, Default, PartialEq, Debug)]
pub struct Listing {
    /// Name of the generated crate and folder.
    pub package: String,
    /// Version of the generated crate.
    pub version: String,
    /// The rows, in the order of reports.
    pub rows: Vec<Row>,
}

/// Why a text is no `model.json` that can be compared.
#[derive(Clone, PartialEq, Eq, Debug)]
pub enum ReadError {
    /// It is no JSON.
    Json(String),
    /// It is of another version of the format.
    Format(String),
    /// Something is missing or of another kind.
    Shape(String),
    /// Two rows have this key.
    Twice(String),
}

impl fmt::Display for ReadError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Json(error) => write!(f, "this is no JSON: {error}"),
            Self::Format(found) => write!(f, "`format` is {found}, and this program reads {}", json::FORMAT),
            Self::Shape(what) => write!(f, "{what}: this is no model.json"),
            Self::Twice(key) => write!(f, "`{key}` is there twice"),
        }
    }
}

impl std::error::Error for ReadError {}

impl Listing {
    /// The rows of a model.
    pub fn of(model: &Model) -> Result<Self, ReadError> {
        Self::of_value(&json::value(model))
    }

    /// The rows of a `model.json`.
    pub fn parse(text: &str) -> Result<Self, ReadError> {
        let value = serde_json::from_str(text).map_err(|e| ReadError::Json(e.to_string()))?;
        Self::of_value(&value)
    }

    fn of_value(value: &Value) -> Result<Self, ReadError> {
        let document = value.as_object().ok_or_else(|| ReadError::Shape("not an object".to_owned()))?;
        match document.get("format") {
            Some(format) if format.as_u64() == Some(u64::from(json::FORMAT)) => {}
            other => return Err(ReadError::Format(other.map_or("missing".to_owned(), Value::to_string))),
        }
        let drive = map(document.get("drive"), "drive")?;
        let word =
            |key| text_of(drive.get(key)).ok_or_else(|| ReadError::Shape(format!("drive has no `{key}`")));
        let (package, version) = (word("package")?, word("crate_version")?);
        let mut rows = vec![row("drive", "drive".to_owned(), drive, &[], &[])];
        if let Some(ethercat) = document.get("ethercat").and_then(Value::as_object) {
            rows.push(row("ethercat", "ethercat".to_owned(), ethercat, &[], &[]));
        }
        for list in LISTS {
            read_list(document, list, list.key, None, &mut rows)?;
        }
        for (key, value) in document.iter().filter(|(key, _)| !known(key)) {
            rows.push(unknown(key, value));
        }
        mark_tables(&mut rows);
        unique(&rows)?;
        Ok(Self { package, version, rows })
    }
}

fn known(key: &str) -> bool {
    ASIDE.contains(&key) || LISTS.iter().any(|list| list.key == key)
}

/// A key of the document that this program does not know: one row with one value, so that a difference is seen.
fn unknown(key: &str, value: &Value) -> Row {
    let facts = vec![("value".to_owned(), own(value, value.to_string()))];
    Row { table: "other", key: format!("other {key}"), parent: None, axis: None, index: None, facts }
}

fn map<'v>(value: Option<&'v Value>, what: &str) -> Result<&'v Map<String, Value>, ReadError> {
    value.and_then(Value::as_object).ok_or_else(|| ReadError::Shape(format!("`{what}` is no object")))
}

fn read_list(
    from: &Map<String, Value>,
    list: &'static List,
    table: &'static str,
    parent: Option<&Row>,
    rows: &mut Vec<Row>,
) -> Result<(), ReadError> {
    // A list that a reader does not find is empty: files of before it came have none.
    let Some(items) = from.get(list.key) else { return Ok(()) };
    let items = items.as_array().ok_or_else(|| ReadError::Shape(format!("`{}` is no list", list.key)))?;
    for item in items {
        read_item(map(Some(item), list.key)?, list, table, parent, rows)?;
    }
    Ok(())
}

fn read_item(
    item: &Map<String, Value>,
    list: &'static List,
    table: &'static str,
    parent: Option<&Row>,
    rows: &mut Vec<Row>,
) -> Result<(), ReadError> {
    let mut skip: Vec<&str> =
        list.id.iter().map(|(key, _)| *key).chain(list.derived.iter().copied()).collect();
    skip.extend(list.inner.map(|inner| inner.key));
    let mut this = row(table, key_of(item, list, parent)?, item, &skip, list.hex);
    this.parent = parent.map(|p| p.key.clone());
    this.index = item.get("index").and_then(Value::as_u64).and_then(|n| u16::try_from(n).ok());
    this.axis =
        axis::table(table).or_else(|| this.index.filter(|_| table == "objects").and_then(axis::object));
    let at = rows.len();
    rows.push(this.clone());
    if let Some(inner) = list.inner {
        read_list(item, inner, table, Some(&this), rows)?;
    }
    if table == "objects" && parent.is_none() {
        fold_variable(at, rows);
    }
    Ok(())
}

/// An index with sub-index 0 alone is one thing for the reader: its row and that of its entry become one.
fn fold_variable(at: usize, rows: &mut Vec<Row>) {
    let [object, entry] = &rows[at..] else { return };
    if !entry.key.ends_with(":00") {
        return;
    }
    let mut folded = entry.clone();
    folded.parent = None;
    for (field, said) in &object.facts {
        match field.as_str() {
            "name" if entry.fact("name") == Some(said) => {}
            "name" => folded.facts.push(("object name".to_owned(), said.clone())),
            _ => folded.facts.push((field.clone(), said.clone())),
        }
    }
    sort(&mut folded.facts);
    rows.truncate(at);
    rows.push(folded);
}

fn key_of(item: &Map<String, Value>, list: &List, parent: Option<&Row>) -> Result<String, ReadError> {
    // Addresses of entries are whole; other parts go on from what they are a part of.
    let start = match parent {
        Some(parent) if list.id[0].1.is_empty() => parent.key.split(' ').next().unwrap_or_default(),
        Some(parent) => &parent.key,
        None => list.word,
    };
    let mut key = if list.id[0].1.is_empty() { format!("{start} ") } else { start.to_owned() };
    for (n, (part, before)) in list.id.iter().enumerate() {
        match text_of(item.get(*part)) {
            Some(text) => key.extend([before, text.as_str()]),
            None if n > 0 => {}
            None => return Err(ReadError::Shape(format!("an item of `{}` has no `{part}`", list.key))),
        }
    }
    Ok(key)
}

fn row(
    table: &'static str,
    key: String,
    item: &Map<String, Value>,
    skip: &[&str],
    hex: &[(&str, usize)],
) -> Row {
    let mut facts = Vec::new();
    for (field, value) in item.iter().filter(|(field, _)| !skip.contains(&field.as_str())) {
        let digits = hex.iter().find(|(name, _)| name == field).map(|(_, digits)| *digits);
        read_fact(field, value, digits, &mut facts);
    }
    // The name in code has no place of its own: it comes from the printed one.
    let name = facts.iter().find(|(field, _)| field == "name").map(|(_, said): &(String, Said)| said.clone());
    if let (Some(name), Some((_, handle))) = (name, facts.iter_mut().find(|(field, _)| field == "handle")) {
        (handle.cite, handle.erratum) = (name.cite, name.erratum);
    }
    if table == "errata" {
        cite_errata(&mut facts);
    }
    sort(&mut facts);
    Row { table, key, parent: None, axis: None, index: None, facts }
}

/// The values of an erratum are printed at the places that the row itself names.
fn cite_errata(facts: &mut [(String, Said)]) {
    for (value, place) in [("was", "seen"), ("set", "by")] {
        let cite = facts.iter().find(|(field, _)| field == place).map(|(_, said)| said.text.clone());
        if let Some((_, said)) = facts.iter_mut().find(|(field, _)| field == value) {
            said.cite = cite;
        }
    }
}

fn sort(facts: &mut [(String, Said)]) {
    let place = |field: &str| ORDER.iter().position(|o| *o == field).unwrap_or(ORDER.len());
    facts.sort_by(|(a, _), (b, _)| (place(a), a).cmp(&(place(b), b)));
}

/// A list of texts with a source each is numbered: `cause 1`.
fn read_fact(field: &str, value: &Value, hex: Option<usize>, facts: &mut Vec<(String, Said)>) {
    let word = match field {
        "causes" => "cause",
        "remedies" => "remedy",
        // A default is a number or a text: two keys of the file, one value of the drive.
        "default_text" => "default",
        other => other,
    };
    match value.as_array() {
        Some(items) if !items.is_empty() && items.iter().all(is_known) => {
            facts.extend(
                items.iter().enumerate().map(|(n, item)| (format!("{word} {}", n + 1), said(item, hex))),
            );
        }
        Some(items) if items.is_empty() => {}
        _ => facts.push((word.to_owned(), said(value, hex))),
    }
}

fn is_known(value: &Value) -> bool {
    value.as_object().is_some_and(|o| o.contains_key("value") && o.contains_key("class"))
}

fn said(value: &Value, hex: Option<usize>) -> Said {
    let Some(fact) = value.as_object().filter(|_| is_known(value)) else {
        return own(value, shown(value, hex));
    };
    let text = |key: &str| text_of(fact.get(key));
    let inner = &fact["value"];
    Said {
        value: inner.clone(),
        text: shown(inner, hex),
        class: text("class").unwrap_or_default(),
        detail: ["rule", "base", "reason"].iter().find_map(|key| text(key)),
        cite: text("cite"),
        erratum: text("erratum"),
    }
}

fn own(value: &Value, text: String) -> Said {
    Said { value: value.clone(), text, class: "own".to_owned(), detail: None, cite: None, erratum: None }
}

fn shown(value: &Value, hex: Option<usize>) -> String {
    match (value, hex, value.as_u64()) {
        (_, Some(digits), Some(n)) => format!("0x{n:0digits$X}"),
        (Value::Array(items), ..) => items.iter().map(|item| shown(item, hex)).collect::<Vec<_>>().join(" "),
        (Value::Object(fields), ..) => text_of(fields.get("text")).unwrap_or_else(|| value.to_string()),
        _ => text_of(Some(value)).unwrap_or_else(|| value.to_string()),
    }
}

fn text_of(value: Option<&Value>) -> Option<String> {
    match value? {
        Value::String(text) => Some(text.clone()),
        Value::Number(number) => Some(number.to_string()),
        Value::Bool(yes) => Some(yes.to_string()),
        _ => None,
    }
}

/// Tables of names move an axis as the objects do whose values they name.
fn mark_tables(rows: &mut [Row]) {
    let mut tables: BTreeMap<String, &'static str> = BTreeMap::new();
    for row in rows.iter().filter(|row| row.table == "objects") {
        for (field, word) in [("values", "enum"), ("bits", "bits")] {
            if let (Some(group), Some(name)) = (row.axis, row.fact(field)) {
                tables.entry(format!("{word} {}", name.text)).or_insert(group);
            }
        }
    }
    for row in rows.iter_mut().filter(|row| matches!(row.table, "enums" | "bits")) {
        row.axis = tables.get(row.parent.as_ref().unwrap_or(&row.key)).copied();
    }
}

fn unique(rows: &[Row]) -> Result<(), ReadError> {
    let mut seen = BTreeSet::new();
    rows.iter()
        .find(|row| !seen.insert(&row.key))
        .map_or(Ok(()), |row| Err(ReadError::Twice(row.key.clone())))
}
