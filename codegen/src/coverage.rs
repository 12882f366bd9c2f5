//! How much of each table of a drive is known: rows, and how many of them have which keys.

use std::collections::BTreeMap;

use crate::facts::{FactLine, Table};

/// What a row can have, in the order of columns. A key that none of the table's rows can have counts 0.
pub const COLUMNS: &[(&str, &[&str])] = &[
    ("type", &["type"]),
    ("unit", &["unit"]),
    ("range", &["min", "max", "allow", "require"]),
    ("default", &["default"]),
    ("named values", &["values", "bits", "label"]),
    ("description", &["text", "cause 1", "moves"]),
];

/// A table's count.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Count {
    /// The table.
    pub table: Table,
    /// Its rows.
    pub rows: usize,
    /// For each of [`COLUMNS`], how many rows have it.
    pub with: Vec<usize>,
    /// Rows with a citation.
    pub cited: usize,
}

/// What tables are called in reports.
pub fn name(table: Table) -> &'static str {
    match table {
        Table::Drive => "drive",
        Table::Manuals => "manuals",
        Table::Objects => "objects",
        Table::Enums => "named values",
        Table::Bits => "named bits",
        Table::Alarms => "alarms",
        Table::Pdos => "process data",
        Table::Homing => "homing",
        Table::Modes => "modes",
        Table::States => "states",
        Table::Commands => "commands",
        Table::Aborts => "abort codes",
        Table::Terminals => "terminals",
        Table::EtherCat => "EtherCAT",
        Table::Emcy => "emergency message",
        Table::Rules => "rules",
        Table::Examples => "examples",
        Table::Errata => "errata",
    }
}

/// Counts the rows of every table that has any. Indexes as a whole are not rows of objects.
pub fn coverage(facts: &[FactLine<'_>]) -> Vec<Count> {
    let mut tables: BTreeMap<Table, BTreeMap<&str, Vec<&FactLine<'_>>>> = BTreeMap::new();
    for fact in facts.iter().filter(|f| !matches!(f.table, Table::Drive | Table::Manuals)) {
        if fact.table != Table::Objects || fact.key.contains(':') {
            tables.entry(fact.table).or_default().entry(&fact.key).or_default().push(fact);
        }
    }
    tables.into_iter().map(|(table, rows)| count(table, &rows)).collect()
}

fn count(table: Table, rows: &BTreeMap<&str, Vec<&FactLine<'_>>>) -> Count {
    let has = |keys: &[&str]| {
        // The bits of a mapped entry are a length.
        let meant = |f: &&FactLine<'_>| f.field != "bits" || f.table == Table::Objects;
        let row = |facts: &&Vec<&FactLine<'_>>| {
            facts.iter().filter(|f| meant(f)).any(|f| keys.contains(&f.field.as_ref()))
        };
        rows.values().filter(row).count()
    };
    let cited = rows.values().filter(|facts| facts.iter().any(|f| f.cite.is_some())).count();
    Count { table, rows: rows.len(), with: COLUMNS.iter().map(|(_, keys)| has(keys)).collect(), cited }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::source::Source;

    #[test]
    fn rows_are_counted_by_what_they_have() {
        let text = format!(
            "{}\n{}",
            r#"objects = [
  { at = "2000:00", name = "Speed", type = "u16", access = "rw", unit = "rpm", max = 9, default = 5, src = "1 L2" },
  { at = "2001:01..03", name = "Gain", type = "u8", access = "rw", text = "What it does.", src = "1 L2" },
]"#,
            include_str!("../tests/fixtures/drive.toml")
        );
        let compiled = crate::compile(vec![Source { path: "drive.toml".into(), text }]);
        let facts = crate::facts::facts(compiled.model.as_ref().unwrap());
        let counts = coverage(&facts);
        assert_eq!((counts[0].table, counts[0].rows, counts[0].cited), (Table::Objects, 4, 4));
        assert_eq!(counts[0].with, [4, 1, 1, 1, 0, 3]);
    }
}
