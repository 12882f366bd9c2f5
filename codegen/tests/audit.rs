//! The audit against a small manual of our own: what it proves, and what it must not.

#![allow(clippy::expect_used, clippy::panic, reason = "a test fails by panicking")]

use drivewright_codegen::audit::{Report, audit, contradictions};
use drivewright_codegen::facts::facts;
use drivewright_codegen::source::Source;
use drivewright_codegen::{Compiled, compile};

/// Lines count from 1; the first is empty.
const MANUAL: &str = "
# 2 Objects
Index\tSub\tName\tUnit\tType\tAccess\tMap\tRange\tDefault
2000\t0\tSpeed limit\trpm/10\tU16\tRW\tYES\t0.1~6000.0\t3000.0
2001\t0\tGains\t-\tU8\tRO\tNO\t-\t2
\t1\tGain 1\t-\tS32\tRW\tNO\t-1000~ 1000\t-5
\t2\tGain 2\t-\tS32\tRW\tNO\t-1000~ 1000\t7
2002\t0\tHidden\t-\tU8\tRO\tNO\t-\t-
# 3 Speed
Index\tSub\tName\tUnit\tType\tAccess\tMap\tRange\tDefault
2000\t0\tSpeed limit\trpm/10\tU16\tRW\tYES\t0.1~5000.0\t3000.0
# 5 Faults
Disp\tMeaning\tCode\tNo.\tReset
Er.1\tOver current\t2310h\t01h\tYES
";

const OBJECTS: &str = r#"objects = [
  { at = "2000:00", name = "Speed limit", type = "u16", access = "rw", pdo = "rx tx", unit = "0.1 rpm", min = 1, max = 60000, default = 30000, also = "3 L11", src = "2 L4" },
  { at = "2001:00", name = "Gains", type = "u8", access = "ro", pdo = "no", default = 2, src = "2 L5" },
  { at = "2001:01", name = "Gain 1", type = "i32", access = "rw", pdo = "no", min = -1000, max = 1000, default = -5, src = "2 L6" },
  { at = "2001:02", name = "Gain 2", type = "i32", access = "rw", pdo = "no", min = -1000, max = 1000, default = 7, src = "2 L7" },
]
alarms = [ { display = "Er.1", number = 0x01, code = 0x2310, name = "Over current", reset = "resettable", src = "5 L14" } ]
errata = [ { id = "E1", at = "2000:00", field = "max", was = 60000, seen = "2 L4", by = "3 L11", why = "Two limits are printed.", sure = "low" } ]
"#;

const READING: &str = r#"columns = [
  { header = "Index", field = "index" }, { header = "Sub", field = "sub" }, { header = "Name", field = "name" },
  { header = "Unit", field = "unit" }, { header = "Type", field = "type" }, { header = "Access", field = "access" },
  { header = "Map", field = "pdo" }, { header = "Range", field = "range" }, { header = "Default", field = "default" },
  { header = "Disp", field = "display" }, { header = "Meaning", field = "name" }, { header = "Code", field = "code" },
  { header = "No.", field = "number" }, { header = "Reset", field = "reset" },
]
printed = [
  { field = "type", word = "S32", means = "i32" }, { field = "pdo", word = "YES", means = "rx tx" },
  { field = "unit", word = "rpm/10", means = "0.1 rpm" }, { field = "reset", word = "YES", means = "resettable" },
]
uncited = [ { lines = [8], why = "Hidden from users." } ]
"#;

fn profile(objects: &str, reading: &str) -> Compiled {
    let drive = &include_str!("fixtures/drive.toml").replace("lines = 10", "lines = 40");
    let sources = [("drive.toml", drive.as_str()), ("objects.toml", objects), ("reading.toml", reading)];
    let sources = sources.map(|(path, text)| Source { path: path.into(), text: text.into() });
    let compiled = compile(sources.to_vec());
    assert!(compiled.sound().is_some(), "{:#?}", compiled.diagnostics);
    compiled
}

fn report(compiled: &Compiled, manual: &str) -> Report {
    let model = compiled.sound().expect("sound");
    audit(model, &facts(model), &compiled.rows, "m1", manual).expect("the manual")
}

/// What is open, one line a finding.
fn open(objects: &str, reading: &str, manual: &str) -> Vec<String> {
    let compiled = profile(objects, reading);
    let line = |f: &drivewright_codegen::audit::Finding| format!("{}: {} {}", f.kind.word(), f.at, f.field);
    report(&compiled, manual).open().map(line).collect()
}

#[test]
fn what_the_manual_prints_is_proved() {
    let compiled = profile(OBJECTS, READING);
    let report = report(&compiled, MANUAL);
    assert_eq!(report.open().collect::<Vec<_>>().len(), 0, "{:#?}", report.findings);
    // 8 + 5 + 7 + 7 facts of objects, 4 of the alarm, and what the erratum says is printed.
    assert_eq!((report.proved, report.cited_lines, report.uncited_lines), (8 + 5 + 7 + 7 + 4 + 1, 6, 1));
}

/// A change of the profile, and what must be found.
const CHANGES: &[(&str, &str, &str)] = &[
    ("max = 1000, default = -5", "max = 1001, default = -5", "unproved: object 2001:01 max"),
    ("default = -5", "default = 5", "unproved: object 2001:01 default"),
    ("default = 7", "default = -5", "unproved: object 2001:02 default"),
    ("default = 30000", "default = 3000", "unproved: object 2000:00 default"),
    ("min = 1, max", "min = 10, max", "unproved: object 2000:00 min"),
    ("name = \"Gain 2\"", "name = \"Gain 3\"", "unproved: object 2001:02 name"),
    ("\"u8\", access = \"ro\"", "\"u8\", access = \"rw\"", "unproved: object 2001:00 access"),
    ("unit = \"0.1 rpm\", ", "unit = \"0.01 rpm\", ", "unproved: object 2000:00 unit"),
    ("code = 0x2310", "code = 0x2311", "unproved: alarm Er.1 0x01 code"),
    ("reset = \"resettable\"", "reset = \"not resettable\"", "unproved: alarm Er.1 0x01 reset"),
    ("src = \"2 L7\"", "src = \"2 L6\"", "unproved: object 2001:02 name"),
    ("src = \"2 L6\"", "src = \"2 L6 L8\"", "idle line: object 2001:01 L8"),
    ("src = \"2 L6\"", "src = \"2 L6 L6\"", "idle line: object 2001:01 L6"),
    // Another line shows it, but the row has a cell of its own.
    ("default = 7, src = \"2 L7\"", "default = -5, src = \"2 L6 L7\"", "unproved: object 2001:02 default"),
    // Two whole numbers do not join.
    ("default = 7, src = \"2 L7\"", "default = 27, src = \"2 L5 L7\"", "unproved: object 2001:02 default"),
    ("also = \"3 L11\"", "also = \"3 L11 L6\"", "idle line: object 2000:00 also L6"),
    ("seen = \"2 L4\"", "seen = \"3 L11\"", "unproved: erratum E1 was L11"),
];

#[test]
fn each_change_of_the_profile_is_found() {
    for (from, to, expected) in CHANGES {
        assert!(OBJECTS.contains(from), "{from}");
        let found = open(&OBJECTS.replacen(from, to, 1), READING, MANUAL);
        assert!(found.iter().any(|f| f == expected), "{from} -> {to}: {found:#?}");
    }
}

#[test]
fn rows_that_nothing_cites_and_idle_exceptions_are_found() {
    let without = READING.replace("uncited = [ { lines = [8], why = \"Hidden from users.\" } ]", "");
    assert_eq!(open(OBJECTS, &without, MANUAL), ["uncited row: L8 "]);
    let cited = READING.replace("lines = [8]", "lines = [7, 8]");
    assert_eq!(open(OBJECTS, &cited, MANUAL), ["idle exception: L7 "]);
    let excepted =
        format!("{READING}unproved = [ {{ at = \"object 2001:01\", field = \"max\", why = \"w\" }} ]\n");
    assert_eq!(open(OBJECTS, &excepted, MANUAL), ["idle exception: object 2001:01 max"]);
    let wrong = OBJECTS.replace("max = 1000, default = -5", "max = 1001, default = -5");
    assert_eq!(open(&wrong, &excepted, MANUAL), [""; 0], "the exception holds for this fact");
}

#[test]
fn exceptions_except_what_they_name() {
    let none = READING.replace("lines = [8]", "lines = [8, 12, 99]");
    assert_eq!(open(OBJECTS, &none, MANUAL), ["idle exception: L12 ", "idle exception: L99 "]);
    let idle = |row: &str| format!("{READING}unproved = [ {{ {row}, why = \"w\" }} ]\n");
    let also = idle("at = \"object 2000:00\", field = \"also min\"");
    assert_eq!(open(OBJECTS, &also, MANUAL), ["idle exception: object 2000:00 also min"]);
    let also = idle("at = \"object 2000:00\", field = \"also max\"");
    assert_eq!(open(OBJECTS, &also, MANUAL), [""; 0]);
    // Without a key, lines are not excepted; and no row excepts all.
    let moved = OBJECTS.replace("src = \"2 L6\"", "src = \"2 L6 L8\"");
    let found = open(&moved, &idle("at = \"object 2001:01\""), MANUAL);
    assert!(found.iter().any(|f| f == "idle line: object 2001:01 L8"), "{found:#?}");
    let wrong = OBJECTS.replace("default = 7", "default = -5");
    let found = open(&wrong, &idle("at = \"*\""), MANUAL);
    assert!(found.iter().any(|f| f == "unproved: object 2001:02 default"), "{found:#?}");
}

#[test]
fn cells_out_of_place_are_read_where_the_profile_says() {
    let shifted = MANUAL.replace("\t2\tGain 2\t-", "2\tGain 2\t-");
    assert!(!open(OBJECTS, READING, &shifted).is_empty());
    let fields = ["sub", "name", "unit", "type", "access", "pdo", "range", "default"];
    let reading = format!("{READING}shifted = [ {{ lines = [7], fields = {fields:?}, why = \"w\" }} ]\n");
    assert_eq!(open(OBJECTS, &reading, &shifted), [""; 0]);
}

#[test]
fn places_that_print_something_else_need_an_erratum() {
    let found = |objects: &str| {
        let compiled = profile(objects, READING);
        let model = compiled.sound().expect("sound");
        contradictions(model, &facts(model), &compiled.rows, "m1", MANUAL)
    };
    let with = found(OBJECTS);
    assert_eq!(with.len(), 1, "{with:#?}");
    assert!(with[0].settled() && with[0].errata == ["E1"] && with[0].places[0].line == 11);
    let without = OBJECTS.split("errata =").next().expect("objects");
    assert!(found(without).iter().any(|c| !c.settled() && c.field == "max"));
}

/// A section more, from line 15 on.
const PANEL: &str = "1) Overcurrent
Er.2\tOver voltage\t3210h\t1Fh\tYES
# 7 Panel
Para\tName\tUnit\tRange\tDefault
*P1.01\tDisplay\t-\t0~12 0: Off 1: Slow mode 11: Fast mode 12: Fast\t1
P2.01\tRamp\trpm/10*\t0.1~0.9\t0.3
";

const PANEL_ROWS: &str = r#"objects = [
  { at = "2010:00", name = "Display", parameter = "P1.01", effect = "power cycle", min = 0, max = 12, default = 1, values = "display", type = "u16", access = "rw", pdo = "no", inferred = ["at: x", "type: x", "access: x", "pdo: x"], src = "7 L19" },
  { at = "2011:00", name = "Ramp", parameter = "P2.01", unit = "0.1 rpm", min = 1, max = 9, default = 3, type = "u16", access = "rw", pdo = "no", inferred = ["at: x", "type: x", "access: x", "pdo: x"], src = "7 L20" },
]
enums = [
  { name = "display", value = 0, label = "Off", src = "7 L19" },
  { name = "display", value = 1, label = "Slow mode", src = "7 L19" },
  { name = "display", value = 11, label = "Fast mode", src = "7 L19" },
]
alarms = [
  { display = "Er.1", number = 0x01, code = 0x2310, name = "Over current", reset = "resettable", src = "5 L14" },
  { display = "Er.2", number = 0x1F, code = 0x3210, name = "Over voltage", reset = "resettable", src = "5 L16" },
]
errata = [
  { id = "E1", at = "alarm Er.1", field = "name", was = "Over current", set = "Overcurrent", seen = "5 L14", by = "5 L15", why = "w", sure = "low" },
  { id = "E2", at = "alarm Er.2 0x1f", field = "code", was = 0x3210, seen = "5 L16", why = "w", sure = "low" },
]
"#;

const PANEL_READING: &str = r#"columns = [
  { header = "Para", field = "parameter" }, { header = "Name", field = "name" }, { header = "Unit", field = "unit" },
  { header = "Range", field = "range" }, { header = "Default", field = "default" }, { header = "Disp", field = "display" },
  { header = "Meaning", field = "name" }, { header = "Code", field = "code" }, { header = "No.", field = "number" },
  { header = "Reset", field = "reset" },
]
printed = [
  { field = "unit", word = "rpm/10*", means = "0.1 rpm" }, { field = "reset", word = "YES", means = "resettable" },
  { field = "effect", word = "*", means = "power cycle" },
]
shifted = [ { lines = [16], fields = ["display", "name", "code", "number", "reset"], why = "w" } ]
uncited = [ { lines = [3, 4, 5, 6, 7, 8, 10, 11], why = "Another profile." } ]
"#;

/// What is open with the section more.
fn open_panel(rows: &str) -> Vec<String> {
    open(rows, PANEL_READING, &format!("{MANUAL}{PANEL}"))
}

const PANEL_CHANGES: &[(&str, &str, &str)] = &[
    ("\"Fast mode\"", "\"Fast\"", "unproved: enum display 11 label"),
    ("value = 11, label = \"Fast mode\"", "value = 2, label = \"Fast\"", "unproved: enum display 2 label"),
    // The star is that of the unit.
    (
        "parameter = \"P2.01\",",
        "parameter = \"P2.01\", effect = \"power cycle\",",
        "unproved: object 2011:00 effect",
    ),
    ("set = \"Overcurrent\"", "set = \"current\"", "unproved: alarm Er.1 0x01 name"),
    ("was = 0x3210, seen = \"5 L16\"", "was = 0x3210, seen = \"5 L14\"", "unproved: erratum E2 was L14"),
];

#[test]
fn each_change_of_a_panel_is_found() {
    assert_eq!(open_panel(PANEL_ROWS), [""; 0]);
    for (from, to, expected) in PANEL_CHANGES {
        assert!(PANEL_ROWS.contains(from), "{from}");
        let found = open_panel(&PANEL_ROWS.replacen(from, to, 1));
        assert!(found.iter().any(|f| f == expected), "{from} -> {to}: {found:#?}");
    }
}
