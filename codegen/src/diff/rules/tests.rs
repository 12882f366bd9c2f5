//! One small revision for each rule: what it says is written here by hand.

use std::collections::BTreeSet;

use super::*;
use crate::diff::{Listing, Report, What, compare};
use crate::source::Source;

const PROFILE: &str = r#"
manuals = [ { id = "m1", title = "T", version = "1", sha256 = "0000000000000000000000000000000000000000000000000000000000000000", lines = 99 } ]
objects = [
  { at = "1018:00", name = "Identity", type = "u8", access = "ro", default = 1, src = "1 L1" },
  { at = "1018:01", name = "Vendor", type = "u32", access = "ro", default = 7, src = "1 L1" },
  { at = "1600:00", name = "Count", type = "u8", access = "rw", default = 2, src = "1 L2" },
  { at = "1600:01", name = "First word", type = "u32", access = "rw", default = 0x20000010, src = "1 L2" },
  { at = "1600:02", name = "Second word", type = "u32", access = "rw", default = 0x20010008, src = "1 L2" },
  { at = "2000:00", name = "Speed", type = "u16", access = "rw", pdo = "rx", unit = "rpm", min = 1, max = 90, default = 5, parameter = "P1", effect = "at once", text = "Old.", src = "1 L3" },
  { at = "2001:00", name = "Pick", type = "u8", access = "rw", pdo = "rx tx", allow = [1, 2], values = "choice", src = "1 L4" },
  { at = "2002:00", name = "Meter", type = "u16", access = "ro", max = 9, default = 3, src = "1 L5" },
  { at = "607F:00", name = "Highest speed", type = "u32", access = "rw", max = 3000, default = 3000, src = "1 L6" },
  { at = "6502:00", name = "Modes", type = "u32", access = "ro", default = 1, src = "1 L7" },
]
enums = [ { name = "choice", value = 1, label = "one", src = "1 L8" }, { name = "choice", value = 2, label = "two", src = "1 L8" } ]
bits = [ { name = "flags", bit = 2, label = "run", src = "1 L9" }, { name = "flags", bit = 4, width = 2, label = "way", src = "1 L9" } ]
alarms = [ { display = "OF", number = 0x25, code = 0x8611, name = "Following", reset = "resettable", causes = ["a"], src = "1 L10" } ]
pdo = [ { map = 0x1600, dir = "rx", pos = 1, entry = "2000:00", bits = 16, src = "1 L11" }, { map = 0x1600, dir = "rx", pos = 2, entry = "2001:00", bits = 8, src = "1 L11" } ]
homing = [
  { method = 1, case = 1, when = "home off", moves = "- fast until home on; latch", note = "n", src = "1 L12" },
  { method = 1, case = 2, when = "home on", moves = "done", src = "1 L13" },
  { method = 3, status = "reserved", src = "1 L14" },
]
modes = [ { mode = 1, name = "Position", src = "1 L15" }, { mode = 3, name = "Velocity", src = "1 L15" } ]
states = [ { name = "Fault", mask = 0x4F, value = 0x08, src = "1 L16" } ]
commands = [ { name = "Reset", mask = 0x80, value = 0x80, src = "1 L17" } ]
aborts = [ { code = 0x06020000, name = "No such object", src = "1 L18" } ]
io = [ { terminal = "DI1", kind = "input", pin = 1, text = "t", src = "1 L19" }, { terminal = "DI2", kind = "input", pin = 2, src = "1 L19" } ]
sync_managers = [ { number = 0, use = "mailbox out", src = "1 L20" } ]
ethercat = [ { group = "Servos", src = "1 L20" } ]
coe = [ { feature = "complete access", supported = false, src = "1 L20" } ]
dc_modes = [ { number = 1, name = "DC", sync = "sync0", assign_activate = 0x300, src = "1 L20" } ]
startup = [ { number = 1, transition = "PS", write = "2001:00", value = 1, text = "first", src = "1 L20" } ]
emcy = [ { byte = 0, bytes = 2, holds = "error code", text = "t", src = "1 L22" }, { byte = 2, bytes = 6, holds = "reserved", src = "1 L22" } ]
rules = [ { id = "R1", text = "r", require = "2000:00 > 0", src = "1 L23" } ]
[drive]
format = 1
id = "x1"
vendor = "Acme"
vendor_id = "acme"
name = "X1"
crate_version = "0.1.0"
eds_version = 1
eds_revision = 0
date = "2026-01-01"
pdo_bytes = 8
pdo_src = "1 L24"
"#;

/// What is in the profile, what stands there in the revision, and each difference: row and field, effect, what it is for
/// an axis, rule. Fields that follow from others (`byte` of an entry behind) are differences, too.
type Case = (&'static str, &'static str, &'static [(&'static str, &'static str, &'static str, &'static str)]);

const VALUE_OF_2: &str = r#", { name = "choice", value = 2, label = "two", src = "1 L8" }"#;
const SECOND_BIT: &str = r#", { name = "flags", bit = 4, width = 2, label = "way", src = "1 L9" }"#;
const ALARM: &str = r#"{ display = "OF", number = 0x25, code = 0x8611, name = "Following", reset = "resettable", causes = ["a"], src = "1 L10" } ]"#;
const SECOND_ENTRY: &str =
    r#", { map = 0x1600, dir = "rx", pos = 2, entry = "2001:00", bits = 8, src = "1 L11" }"#;
const PDO: &str = r#"pdo = [ { map = 0x1600, dir = "rx", pos = 1, entry = "2000:00", bits = 16, src = "1 L11" }, { map = 0x1600, dir = "rx", pos = 2, entry = "2001:00", bits = 8, src = "1 L11" } ]"#;
const METER: &str = r#"  { at = "2002:00", name = "Meter", type = "u16", access = "ro", max = 9, default = 3, src = "1 L5" },"#;
const SECOND_CASE: &str = r#"  { method = 1, case = 2, when = "home on", moves = "done", src = "1 L13" },"#;
const METHOD_3: &str = r#"  { method = 3, status = "reserved", src = "1 L14" },"#;
const METHOD_5: &str = r#"  { method = 3, status = "reserved", src = "1 L14" }, { method = 5, status = "reserved", src = "1 L14" },"#;
const MODE_3: &str = r#", { mode = 3, name = "Velocity", src = "1 L15" }"#;
const STATE: &str = r#"states = [ { name = "Fault", mask = 0x4F, value = 0x08, src = "1 L16" } ]"#;
const TERMINAL_2: &str = r#", { terminal = "DI2", kind = "input", pin = 2, src = "1 L19" }"#;
const RULE: &str = r#"rules = [ { id = "R1", text = "r", require = "2000:00 > 0", src = "1 L23" } ]"#;

#[rustfmt::skip]
const CASES: &[Case] = &[
    // Objects.
    (METER, "", &[("object 2002:00", "breaking", "", "entry_removed")]),
    ("", METER, &[("object 2002:00", "new", "", "entry_added")]),
    (r#"name = "Speed""#, r#"name = "Pace""#, &[("object 2000:00 name", "documentation", "", "wording"), ("object 2000:00 handle", "breaking", "", "handle_renamed")]),
    (r#"name = "Speed""#, r#"name = "speed""#, &[("object 2000:00 name", "documentation", "", "wording")]),
    (r#"name = "Speed", type = "u16""#, r#"name = "Speed", type = "i16""#, &[("object 2000:00 type", "breaking", "", "type_changed")]),
    (r#"type = "u16", access = "rw""#, r#"type = "u16", access = "ro""#, &[("object 2000:00 access", "breaking", "", "access_narrowed")]),
    (r#"type = "u16", access = "rw""#, r#"type = "u16", access = "wo""#, &[("object 2000:00 access", "breaking", "", "access_narrowed")]),
    (r#"access = "ro", max = 9"#, r#"access = "rw", max = 9"#, &[("object 2002:00 access", "new", "", "access_widened")]),
    (r#"pdo = "rx tx""#, r#"pdo = "rx""#, &[("object 2001:00 pdo", "breaking", "", "mapping_removed")]),
    (r#"pdo = "rx tx", "#, "", &[("object 2001:00 pdo", "breaking", "", "mapping_removed")]),
    (r#"pdo = "rx", unit"#, r#"pdo = "rx tx", unit"#, &[("object 2000:00 pdo", "new", "", "mapping_added")]),
    (r#"unit = "rpm""#, r#"unit = "0.1 rpm""#, &[("object 2000:00 unit", "breaking", "", "unit_changed")]),
    (r#"unit = "rpm", "#, "", &[("object 2000:00 unit", "breaking", "", "unit_changed")]),
    ("min = 1", "min = 2", &[("object 2000:00 min", "breaking", "", "range_narrowed")]),
    ("min = 1, ", "", &[("object 2000:00 min", "axis", "", "range_widened")]),
    ("max = 90", "max = 89", &[("object 2000:00 max", "breaking", "", "range_narrowed")]),
    ("max = 90", "max = 91", &[("object 2000:00 max", "axis", "", "range_widened")]),
    ("max = 3000", "max = 2000", &[("object 607F:00 max", "breaking", "limit", "range_narrowed")]),
    ("max = 3000", "max = 4000", &[("object 607F:00 max", "axis", "limit", "range_widened")]),
    ("allow = [1, 2]", "allow = [1]", &[("object 2001:00 allow", "breaking", "", "range_narrowed")]),
    ("allow = [1, 2], ", "", &[("object 2001:00 allow", "axis", "", "range_widened")]),
    ("allow = [1, 2]", "allow = [1, 2, 3]", &[("object 2001:00 allow", "axis", "", "range_widened")]),
    ("max = 9, default", "max = 8, default", &[("object 2002:00 max", "documentation", "", "range_of_a_read_value")]),
    (r#", values = "choice""#, "", &[("object 2001:00 values", "breaking", "", "names_of_values_changed")]),
    ("default = 7", "default = 8", &[("object 1018:01 default", "breaking", "", "identity_changed")]),
    ("default = 0x20000010", "default = 0", &[("object 1600:01 default", "breaking", "", "default_mapping_changed")]),
    ("default = 5", "default = 6", &[("object 2000:00 default", "axis", "", "default_changed")]),
    ("default = 3000", "default = 2999", &[("object 607F:00 default", "axis", "limit", "default_changed")]),
    ("default = 1, src = \"1 L7\"", "default = 3, src = \"1 L7\"", &[("object 6502:00 default", "axis", "mode", "capability_changed")]),
    ("default = 3,", "default = 4,", &[("object 2002:00 default", "documentation", "", "default_of_a_read_value")]),
    (r#"effect = "at once""#, r#"effect = "at stop""#, &[("object 2000:00 effect", "axis", "", "effect_changed")]),
    ("Old.", "New.", &[("object 2000:00 text", "documentation", "", "wording")]),
    ("1 L3", "2 L33", &[
        ("object 2000:00 name", "documentation", "", "source_differs"), ("object 2000:00 handle", "documentation", "", "source_differs"),
        ("object 2000:00 type", "documentation", "", "source_differs"), ("object 2000:00 access", "documentation", "", "source_differs"),
        ("object 2000:00 pdo", "documentation", "", "source_differs"), ("object 2000:00 unit", "documentation", "", "source_differs"),
        ("object 2000:00 min", "documentation", "", "source_differs"), ("object 2000:00 max", "documentation", "", "source_differs"),
        ("object 2000:00 default", "documentation", "", "source_differs"), ("object 2000:00 effect", "documentation", "", "source_differs"),
        ("object 2000:00 parameter", "documentation", "", "source_differs"),
    ]),
    // Tables of values and bits.
    (VALUE_OF_2, "", &[("enum choice 2", "breaking", "", "value_removed")]),
    ("", VALUE_OF_2, &[("enum choice 2", "new", "", "value_added")]),
    (r#"label = "two""#, r#"label = "both""#, &[("enum choice 2 name", "documentation", "", "wording"), ("enum choice 2 handle", "breaking", "", "value_renamed")]),
    (SECOND_BIT, "", &[("bits flags 4", "breaking", "", "bit_removed")]),
    ("", SECOND_BIT, &[("bits flags 4", "new", "", "bit_added")]),
    (r#"label = "way""#, r#"label = "path""#, &[("bits flags 4 name", "documentation", "", "wording"), ("bits flags 4 handle", "breaking", "", "bit_renamed")]),
    ("width = 2", "width = 3", &[("bits flags 4 width", "breaking", "", "bits_wider_or_narrower")]),
    // Process data.
    ("", PDO, &[("pdo 1600", "new", "", "pdo_added"), ("pdo 1600 1", "new", "", "pdo_added"), ("pdo 1600 2", "new", "", "pdo_added")]),
    (PDO, "", &[("pdo 1600", "breaking", "", "pdo_removed"), ("pdo 1600 1", "breaking", "", "pdo_removed"), ("pdo 1600 2", "breaking", "", "pdo_removed")]),
    (SECOND_ENTRY, "", &[("pdo 1600 bytes", "breaking", "", "layout_changed"), ("pdo 1600 2", "breaking", "", "layout_changed")]),
    ("", SECOND_ENTRY, &[("pdo 1600 bytes", "breaking", "", "layout_changed"), ("pdo 1600 2", "breaking", "", "layout_changed")]),
    // EtherCAT.
    (r#"group = "Servos""#, r#"group = "Axes""#, &[("ethercat group", "breaking", "", "bus_changed")]),
    ("supported = false", "supported = true", &[("coe complete access supported", "breaking", "", "bus_changed")]),
    ("0x300", "0x700", &[("dc mode 1 assign_activate", "breaking", "", "bus_changed")]),
    (r#"transition = "PS""#, r#"transition = "SO""#, &[("startup 1 transition", "axis", "", "startup_changed")]),
    ("first", "second", &[("startup 1 text", "documentation", "", "wording")]),
    ("pdo_bytes = 8", "note = \"n\"\npdo_bytes = 8", &[("drive note", "documentation", "", "wording")]),
    // Alarms.
    ("alarms = [ ", "alarms = [ { display = \"OS\", number = 0x26, code = 0x8400, name = \"Speed\", src = \"1 L10\" }, ", &[("alarm OS 0x26", "new", "", "alarm_added")]),
    (ALARM, "]", &[("alarm OF 0x25", "breaking", "", "alarm_removed")]),
    ("code = 0x8611", "code = 0x8612", &[("alarm OF 0x25 code", "breaking", "", "alarm_code_changed")]),
    (r#"reset = "resettable""#, r#"reset = "not resettable""#, &[("alarm OF 0x25 reset", "axis", "", "alarm_reaction_changed")]),
    (r#"name = "Following""#, r#"name = "Lag""#, &[("alarm OF 0x25 name", "documentation", "", "alarm_renamed"), ("alarm OF 0x25 handle", "documentation", "", "alarm_renamed")]),
    (r#"causes = ["a"]"#, r#"causes = ["b"]"#, &[("alarm OF 0x25 cause 1", "documentation", "", "wording")]),
    // Homing, modes, states.
    (METHOD_3, METHOD_5, &[("homing 5", "new", "homing", "homing_method_added")]),
    (METHOD_3, "", &[("homing 3", "breaking", "homing", "homing_method_removed")]),
    (SECOND_CASE, "", &[("homing 1.2", "axis", "homing", "homing_case_differs")]),
    ("- fast until home on; latch", "+ fast until home on; latch", &[("homing 1.1 moves", "axis", "homing", "homing_changed")]),
    (r#"note = "n""#, r#"note = "m""#, &[("homing 1 note", "documentation", "", "wording")]),
    (MODE_3, "", &[("mode 3", "axis", "mode", "mode_removed")]),
    ("", MODE_3, &[("mode 3", "new", "mode", "mode_added")]),
    (r#"name = "Velocity""#, r#"name = "Speed mode""#, &[("mode 3 name", "documentation", "", "wording")]),
    ("mask = 0x4F", "mask = 0x6F", &[("state Fault mask", "axis", "state machine", "state_machine_changed")]),
    (STATE, "", &[("state Fault", "axis", "state machine", "state_machine_changed")]),
    ("", STATE, &[("state Fault", "new", "state machine", "state_machine_added")]),
    // Terminals, the bus, rules, the drive, and what is text.
    (TERMINAL_2, "", &[("terminal DI2", "axis", "", "wiring_changed")]),
    ("", TERMINAL_2, &[("terminal DI2", "new", "", "terminal_added")]),
    ("pin = 1, text = \"t\"", "pin = 3, text = \"u\"", &[("terminal DI1 pin", "axis", "", "wiring_changed"), ("terminal DI1 text", "documentation", "", "wording")]),
    (r#"use = "mailbox out""#, r#"use = "mailbox in""#, &[("sync manager 0 use", "breaking", "", "bus_changed")]),
    ("", r#"{ feature = "complete access", supported = false, src = "1 L20" }"#, &[("coe complete access", "new", "", "bus_told")]),
    (r#"holds = "error code", text = "t""#, r#"holds = "error code", text = "u""#, &[("emcy 0 text", "documentation", "", "wording")]),
    (r#"require = "2000:00 > 0""#, r#"require = "2000:00 > 1""#, &[("rule R1 require", "axis", "", "demand_changed")]),
    (r#"text = "r""#, r#"text = "s""#, &[("rule R1 text", "documentation", "", "wording")]),
    (RULE, "", &[("rule R1", "axis", "", "demand_changed")]),
    ("pdo_bytes = 8", "pdo_bytes = 7", &[("drive pdo_bytes", "breaking", "", "pdo_limits_lowered")]),
    ("pdo_bytes = 8", "pdo_bytes = 9", &[("drive pdo_bytes", "new", "", "pdo_limits_raised")]),
    (r#"id = "x1""#, r#"id = "x2""#, &[("drive id", "breaking", "", "crate_renamed"), ("drive package", "breaking", "", "crate_renamed")]),
    (r#"name = "X1""#, r#"name = "X One""#, &[("drive name", "documentation", "", "wording")]),
    ("0.1.0", "0.2.0", &[("drive crate_version", "documentation", "", "versions")]),
    (r#"title = "T""#, r#"title = "U""#, &[("manual m1 title", "documentation", "", "sources_and_reasons")]),
    (r#"name = "No such object""#, r#"name = "Object missing""#, &[("abort 06020000 name", "documentation", "", "sources_and_reasons")]),
];

fn listing(text: &str) -> Listing {
    let compiled = crate::compile(vec![Source { path: "a.toml".into(), text: text.into() }]);
    let model = compiled.model.unwrap_or_else(|| panic!("{:#?}", compiled.diagnostics));
    Listing::of(&model).unwrap()
}

/// The profile before and after. Where the case names nothing of before, the revision is what the profile has.
fn revision(old: &str, new: &str) -> Report {
    let whole = listing(PROFILE);
    if old.is_empty() {
        assert_eq!(PROFILE.matches(new).count(), 1, "{new}");
        return compare(&listing(&PROFILE.replace(new, "")), &whole);
    }
    assert!(PROFILE.contains(old), "{old}");
    compare(&whole, &listing(&PROFILE.replacen(old, new, 1)))
}

#[test]
fn each_rule_says_what_it_should() {
    for (old, new, wanted) in CASES {
        let report = revision(old, new);
        let found: Vec<_> = report
            .changes
            .iter()
            .map(|c| {
                let field = match &c.what {
                    What::Changed(field, ..) => format!(" {field}"),
                    _ => String::new(),
                };
                (format!("{}{field}", c.key), c.effect.word(), c.axis.unwrap_or(""), c.rule)
            })
            .collect();
        let wanted: Vec<_> =
            wanted.iter().map(|(at, e, axis, r)| ((*at).to_owned(), *e, *axis, *r)).collect();
        assert_eq!(found, wanted, "{old} -> {new}");
    }
}

fn all() -> impl Iterator<Item = &'static Rule> {
    let tables = [
        "drive",
        "objects",
        "enums",
        "bits",
        "pdos",
        "alarms",
        "homing",
        "modes",
        "states",
        "terminals",
        "emcy",
        "startup",
        "rules",
        "manuals",
    ];
    tables.into_iter().flat_map(rules).chain([&SOURCE])
}

/// Two rules are of whole drives: `a_drive_comes_and_goes` of the tests of reports has them.
#[test]
fn each_rule_has_a_case() {
    let tried: BTreeSet<&str> = CASES.iter().flat_map(|(.., wanted)| wanted.iter().map(|w| w.3)).collect();
    let untried: Vec<&str> = all().map(|rule| rule.name).filter(|name| !tried.contains(name)).collect();
    assert_eq!(untried, ["drive_added", "drive_removed"]);
}

#[test]
fn reasons_are_sentences() {
    for rule in all().chain([&UNKNOWN]) {
        assert!(
            rule.why.ends_with('.') && rule.name.bytes().all(|b| b.is_ascii_lowercase() || b == b'_'),
            "{}",
            rule.name
        );
    }
}
