//! What a profile does not state yet, by what it is needed for. A view of the facts: nothing here is made up, and a drive
//! may well not have what is missing.

use std::collections::{BTreeMap, BTreeSet};

use crate::facts::{FactLine, Table};

/// What something is needed for.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug)]
pub enum Priority {
    /// To enable the drive and to move it.
    Enable,
    /// To commission an axis: limits, stops, gear, homing.
    Commission,
    /// All else.
    Nice,
}

impl Priority {
    /// Every priority, most urgent first.
    pub const ALL: [Self; 3] = [Self::Enable, Self::Commission, Self::Nice];

    /// What it is called in reports.
    pub fn word(self) -> &'static str {
        match self {
            Self::Enable => "to enable",
            Self::Commission => "to commission",
            Self::Nice => "nice",
        }
    }
}

/// Something that is not stated.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Item {
    /// What it is needed for.
    pub priority: Priority,
    /// What is missing: `6040h Controlword`, `607Fh Max profile velocity: max, unit`.
    pub what: String,
    /// What it is for.
    pub why: &'static str,
}

/// What is looked for.
enum Need {
    /// Rows of a table of the format.
    Rows(Table, &'static str),
    /// A field of every row of a table.
    Field(Table, &'static str, &'static str),
    /// Objects of CiA 402 or CiA 301, with the fields that each entry should have.
    Objects(&'static [(u16, &'static str)], &'static [&'static str]),
}

use Need::{Field, Objects, Rows};
use Priority::{Commission, Enable, Nice};

#[rustfmt::skip]
const NEEDS: &[(Priority, &str, Need)] = &[
    (Enable, "facts cite it", Rows(Table::Manuals, "manuals")),
    (Enable, "a master knows the drive by it", Objects(&[(0x1000, "Device type"), (0x1018, "Identity")], &["default"])),
    (Enable, "they carry the state machine", Objects(&[(0x6040, "Controlword"), (0x6041, "Statusword")], &["bits"])),
    (Enable, "the mode is chosen and read back there", Objects(&[(0x6060, "Modes of operation"), (0x6061, "Modes of operation display")], &[])),
    (Enable, "it says which modes there are", Objects(&[(0x6502, "Supported drive modes")], &["default"])),
    (Enable, "which modes there are, and which objects each uses", Rows(Table::Modes, "modes")),
    (Enable, "how a state is told in the statusword", Rows(Table::States, "states")),
    (Enable, "how a command is given in the controlword", Rows(Table::Commands, "commands")),
    (Enable, "the cyclic data as the drive ships", Rows(Table::Pdos, "pdo")),
    (Enable, "targets and where the axis is", Objects(&[
        (0x607A, "Target position"), (0x60FF, "Target velocity"), (0x6071, "Target torque"),
        (0x6064, "Position actual value"), (0x606C, "Velocity actual value"), (0x6077, "Torque actual value")], &["unit"])),
    (Enable, "why the drive is in Fault", Objects(&[(0x1001, "Error register"), (0x603F, "Error code")], &[])),
    (Commission, "what a fault means", Rows(Table::Alarms, "alarms")),
    (Commission, "whether a fault can be reset", Field(Table::Alarms, "alarms", "reset")),
    (Commission, "how the axis stops", Objects(&[
        (0x605A, "Quick stop option code"), (0x605B, "Shutdown option code"), (0x605C, "Disable operation option code"),
        (0x605D, "Halt option code"), (0x605E, "Fault reaction option code")], &["default", "values"])),
    (Commission, "how far, fast and hard the axis may go", Objects(&[
        (0x6065, "Following error window"), (0x6072, "Max torque"), (0x607D, "Software position limit"),
        (0x607F, "Max profile velocity"), (0x6080, "Max motor speed"), (0x60E0, "Positive torque limit value"),
        (0x60E1, "Negative torque limit value")], &["unit", "max", "default"])),
    (Commission, "how the axis speeds up and slows down", Objects(&[
        (0x6081, "Profile velocity"), (0x6083, "Profile acceleration"), (0x6084, "Profile deceleration"),
        (0x6085, "Quick stop deceleration")], &["unit", "max", "default"])),
    (Commission, "how user units come from counts", Objects(&[
        (0x608F, "Position encoder resolution"), (0x6091, "Gear ratio"), (0x6092, "Feed constant")], &["default"])),
    (Commission, "how home is searched", Rows(Table::Homing, "homing")),
    (Commission, "how home is searched", Objects(&[
        (0x6098, "Homing method"), (0x6099, "Homing speeds"), (0x609A, "Homing acceleration"), (0x607C, "Home offset")], &["default"])),
    (Commission, "the cycle of set-points", Objects(&[(0x60C2, "Interpolation time period")], &["default"])),
    (Nice, "what may have caused a fault", Field(Table::Alarms, "alarms", "cause 1")),
    (Nice, "what to do after a fault", Field(Table::Alarms, "alarms", "remedy 1")),
    (Nice, "what is wired where", Rows(Table::Terminals, "io")),
    (Nice, "why a transfer was refused", Rows(Table::Aborts, "aborts")),
    (Nice, "what an emergency message holds", Rows(Table::Emcy, "emcy")),
    (Nice, "what must hold between values", Rows(Table::Rules, "rules")),
    (Nice, "worked examples are tests", Rows(Table::Examples, "examples")),
    (Nice, "what the drive does when the bus is lost", Objects(&[(0x6007, "Abort connection option code")], &["default", "values"])),
    (Nice, "direction, inputs, outputs and touch probes", Objects(&[
        (0x607E, "Polarity"), (0x60B8, "Touch probe function"), (0x60FD, "Digital inputs"), (0x60FE, "Digital outputs")], &[])),
    (Nice, "which device and firmware answers", Objects(&[
        (0x1008, "Device name"), (0x1009, "Hardware version"), (0x100A, "Software version")], &[])),
];

/// What `facts` do not state, most urgent first.
pub fn todo(facts: &[FactLine<'_>]) -> Vec<Item> {
    let mut rows: BTreeMap<(Table, &str), BTreeSet<&str>> = BTreeMap::new();
    for fact in facts {
        rows.entry((fact.table, &fact.key)).or_default().insert(&fact.field);
    }
    let mut items = Vec::new();
    for (priority, why, need) in NEEDS {
        let found = missing(need, &rows);
        items.extend(found.into_iter().map(|what| Item { priority: *priority, what, why }));
    }
    // Stable: within a priority the order is that of the list.
    items.sort_by_key(|item| item.priority);
    items
}

type FieldsOfRows<'a> = BTreeMap<(Table, &'a str), BTreeSet<&'a str>>;

fn missing(need: &Need, rows: &FieldsOfRows<'_>) -> Vec<String> {
    match need {
        Rows(table, name) => {
            let there = rows.keys().any(|(found, _)| found == table);
            (!there).then(|| format!("table `{name}`")).into_iter().collect()
        }
        Field(table, name, field) => {
            let of: Vec<_> = rows.iter().filter(|((found, _), _)| found == table).collect();
            let without = of.iter().filter(|(_, fields)| !fields.contains(field)).count();
            let text = format!("table `{name}`: {without} of {} rows have no {field}", of.len());
            (without > 0).then_some(text).into_iter().collect()
        }
        Objects(objects, fields) => {
            objects.iter().filter_map(|(index, name)| object(*index, name, fields, rows)).collect()
        }
    }
}

fn object(index: u16, name: &str, fields: &[&str], rows: &FieldsOfRows<'_>) -> Option<String> {
    let start = format!("object {index:04X}:");
    let mut entries: Vec<_> = rows.iter().filter(|((_, key), _)| key.starts_with(&start)).collect();
    if entries.is_empty() {
        return Some(format!("{index:04X}h {name}"));
    }
    // Sub-index 0 of a record or an array counts the others.
    if entries.len() > 1 {
        entries.retain(|((_, key), _)| !key.ends_with(":00"));
    }
    let lacks = |field: &&&str| entries.iter().any(|(_, has)| !has.contains(**field));
    let lacking: Vec<&str> = fields.iter().filter(lacks).copied().collect();
    (!lacking.is_empty()).then(|| format!("{index:04X}h {name}: {}", lacking.join(", ")))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::source::Source;

    fn items(rows: &str) -> Vec<String> {
        let text = format!("{rows}\n{}", include_str!("../tests/fixtures/drive.toml"));
        let compiled = crate::compile(vec![Source { path: "drive.toml".into(), text }]);
        let facts = crate::facts::facts(compiled.model.as_ref().unwrap());
        todo(&facts).into_iter().map(|item| format!("{}: {}", item.priority.word(), item.what)).collect()
    }

    #[test]
    fn what_is_not_there_is_listed_and_what_is_there_is_not() {
        let all = items("");
        assert!(all.contains(&"to enable: 6040h Controlword".to_owned()), "{all:#?}");
        assert!(all.contains(&"to commission: table `homing`".to_owned()), "{all:#?}");
        assert!(!all.contains(&"to enable: table `manuals`".to_owned()), "it is in the fixture");
        let order: Vec<_> = all.iter().map(|line| line.split(':').next().unwrap()).collect();
        assert!(order.is_sorted_by_key(|word| Priority::ALL.iter().position(|p| p.word() == *word)));
        let row = |more: &str| {
            format!(
                r#"objects = [ {{ at = "607F:00", name = "Max", type = "u32", access = "rw", max = 9, src = "1 L2"{more} }} ]"#
            )
        };
        let some = items(&row(""));
        assert!(
            some.contains(&"to commission: 607Fh Max profile velocity: unit, default".to_owned()),
            "{some:#?}"
        );
        let whole = items(&row(r#", unit = "rpm", default = 9"#));
        assert_eq!(whole.len(), some.len() - 1);
        assert!(!whole.iter().any(|line| line.contains("607Fh")), "{whole:#?}");
    }

    #[test]
    fn rows_without_a_field_are_counted() {
        let alarm = r#"{ display = "A", number = 1, code = 1, name = "A", src = "1 L2" }"#;
        let all = items(&format!("alarms = [ {alarm} ]"));
        assert!(
            all.contains(&"to commission: table `alarms`: 1 of 1 rows have no reset".to_owned()),
            "{all:#?}"
        );
    }
}
