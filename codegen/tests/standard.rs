//! The bases against lists that were typed independently of them.

#![allow(clippy::expect_used, clippy::panic, reason = "a test fails by panicking")]

use drivewright_codegen::compile;
use drivewright_codegen::diag::Severity;
use drivewright_codegen::model::{
    Access, Address, Class, Edge, HomingMethod, HomingStart, HomingStatus, Model, Side,
};
use drivewright_codegen::source::Source;

/// Values at sub-index 0 by type, as public device files and the standards agree on them.
const TYPES: &[(&str, &str)] = &[
    ("u16", "603F 6040 6041 6066 6068 606D 606E 606F 6070 6072 6073 60B8 60B9 60E0 60E1 6402"),
    ("u16", "60D5 60D6 60D7 60D8 60EA"),
    ("u8", "607E"),
    ("i8", "6060 6061 6098"),
    ("i16", "605A 605B 605C 605D 605E 6071 6074 6077 6078 6086 6088 60B2 60C0"),
    ("i32", "6062 6063 6064 606B 606C 607A 607C 60B0 60B1 60BA 60BB 60BC 60BD 60F4 60FA 60FF"),
    ("u32", "6065 6067 6075 6076 6079 607F 6080 6081 6082 6083 6084 6085 6087 609A 60C5 60C6 60FD 6502 67FF"),
    ("u32", "60A8 60A9 60AA 60D1 60D2 60D3 60D4"),
    ("u32", "1000 1002 1005 1006 1007 1012 1013 1014"),
    ("u16", "100C 1015 1017"),
    ("u8", "1001 100D 1019"),
    ("string", "1008 1009 100A"),
];

/// Values at other sub-indexes by type.
const MEMBERS: &[(&str, &str)] = &[
    ("u32", "1003:01 1003:FE 1010:01 1010:02 1010:03 1011:01 1011:02 1011:03 1016:01 1016:7F"),
    ("u32", "1018:01 1018:02 1018:03 1018:04 1200:01 1200:02 1400:01 1403:01 1800:01 1803:01"),
    ("u8", "1029:01 1400:02 1403:02 1800:02 1800:06 1803:02 1803:06 1C00:01 1C00:20"),
    ("u16", "1400:05 1403:05 1800:03 1800:05 1803:03 1803:05 1C12:01 1C12:FE 1C13:01 1C13:FE"),
    ("u32", "1600:01 1600:FE 1603:01 1603:FE 1A00:01 1A00:FE 1A03:01 1A03:FE"),
    ("u16", "1C32:01 1C32:04 1C32:08 1C32:0B 1C32:0C 1C32:0D 1C32:0E"),
    ("u16", "1C33:01 1C33:04 1C33:08 1C33:0B 1C33:0C 1C33:0D"),
    ("u32", "1C32:02 1C32:03 1C32:05 1C32:06 1C32:07 1C32:09 1C32:0A 1C32:0F 1C32:10 1C32:11 1C32:12"),
    ("u32", "1C33:02 1C33:03 1C33:05 1C33:06 1C33:07 1C33:09 1C33:0A 1C33:0F 1C33:10 1C33:11 1C33:12"),
    ("bool", "1C32:20 1C33:20"),
    ("i32", "607B:01 607B:02 607D:01 607D:02 60C1:01"),
    (
        "u32",
        "608F:01 608F:02 6090:01 6090:02 6091:01 6091:02 6092:01 6092:02 6096:01 6096:02 6097:01 6097:02",
    ),
    ("u32", "6099:01 6099:02 60C4:01 60C4:02 60FE:01 60FE:02"),
    ("u8", "60C2:01 60C4:03 60C4:05 60C4:06"),
    ("i8", "60C2:02"),
    ("u16", "60C4:04"),
    ("i16", "60D0:01 60D0:02"),
];

/// What a drive can only report, of `TYPES`.
const READ_ONLY: &str = "1000 1001 1002 603F 6041 6061 6062 6063 6064 606B 606C 6074 6077 6078 6079 60B9 60BA 60BB 60BC 60BD \
                         60D1 60D2 60D3 60D4 60D5 60D6 60D7 60D8 60F4 60FA 60FD 6502 67FF";

/// Identifiers of messages, which a device may have fixed.
const ACCESS_OPEN: &str = "1005 1012 1014";

/// Objects of CiA 402 that a cycle carries to the drive, and from it.
const RX: &str = "6040 6060 6071 607A 60B0 60B1 60B2 60B8 60C1:01 60EA 60FE:01 60FF";
const TX: &str = "603F 6041 6061 6062 6063 6064 606B 606C 6074 6077 6078 6079 60B9 60BA 60BB 60BC 60BD 60D1 60D2 60D3 60D4 60D5 \
                  60D6 60D7 60D8 60F4 60FA 60FD";

fn drive(rows: &str) -> Vec<Source> {
    let head = include_str!("fixtures/drive.toml")
        .replace("eds_version", "bases = [\"cia301\", \"cia402\", \"coe\"]\neds_version");
    vec![Source { path: "drive.toml".into(), text: format!("objects = [\n{rows}]\n{head}") }]
}

fn address(text: &str) -> Address {
    let (index, sub) = text.split_once(':').unwrap_or((text, "00"));
    let number = |text| u16::from_str_radix(text, 16).expect("a number");
    Address::new(number(index), u8::try_from(number(sub)).expect("a sub-index"))
}

/// Every address of a list by type.
fn listed(list: &[(&'static str, &'static str)]) -> Vec<(&'static str, &'static str)> {
    list.iter().flat_map(|(ty, items)| items.split(' ').map(move |item| (*ty, item))).collect()
}

#[test]
fn types_are_those_of_the_standard() {
    let indexes = listed(TYPES);
    let open = |index: &str| ACCESS_OPEN.split(' ').any(|i| i == index);
    let row = |(_, index): &(&str, &str)| {
        let access = if open(index) { "access = \"rw\", " } else { "" };
        format!("  {{ at = \"{index}:00\", {access}src = \"1 L1\" }},\n")
    };
    let compiled = compile(drive(&indexes.iter().map(row).collect::<String>()));
    let model = compiled.model.expect("a model");
    assert!(indexes.len() >= 64 + 13 + 13 + 6);
    for (ty, index) in indexes {
        let (_, entry) = model.entry(address(index)).unwrap_or_else(|| panic!("no base has {index}"));
        assert_eq!(entry.ty.value.word(), ty, "{index}");
        assert!(matches!(entry.ty.origin.class, Class::Standard(_)));
        assert_eq!(
            matches!(entry.access.origin.class, Class::Standard(_)),
            !open(index),
            "access of {index}"
        );
        let read_only = READ_ONLY.split(' ').any(|i| i == index) || ty == "string";
        let found = matches!(entry.access.value, Access::Ro | Access::Const);
        assert_eq!(found, read_only, "access of {index} is {}", entry.access.value.word());
    }
}

#[test]
fn members_have_the_types_of_the_standard() {
    let compiled = compile(drive(&nameless(&|_| true)));
    let model = compiled.model.expect("a model");
    for (ty, at) in listed(MEMBERS) {
        let (_, entry) = model.entry(address(at)).unwrap_or_else(|| panic!("no base has {at}"));
        assert_eq!(entry.ty.value.word(), ty, "{at}");
        assert!(matches!(entry.ty.origin.class, Class::Standard(_)), "{at}");
    }
}

/// The `objects` of every base as text: base, address, row.
fn base_rows() -> Vec<(&'static str, &'static str, &'static str)> {
    let bases = drivewright_standard::bases().iter();
    let objects = bases
        .flat_map(|b| b.files.iter().map(|f| (b.name, *f)))
        .filter(|(_, f)| f.0.ends_with("objects.toml"));
    objects
        .flat_map(|(base, file)| file.1.lines().map(move |line| (base, line)))
        .filter_map(|(base, line)| {
            let (_, rest) = line.split_once("{ at = \"")?;
            Some((base, rest.split_once('"')?.0, line))
        })
        .collect()
}

/// The addresses of a row: none for an index as a whole.
fn addresses(at: &str) -> Vec<Address> {
    let Some((index, subs)) = at.split_once(':') else { return Vec::new() };
    let (first, last) = subs.split_once("..").unwrap_or((subs, subs));
    let end = |sub: &str| address(&format!("{index}:{sub}"));
    (end(first).sub..=end(last).sub).map(|sub| Address::new(end(first).index, sub)).collect()
}

/// A row for each address of the bases that `take` takes, with nothing but what the base leaves to drives.
fn nameless(take: &dyn Fn(Address) -> bool) -> String {
    let rows = base_rows().into_iter().flat_map(|(_, at, row)| {
        let states = |key: &str| row.contains(&format!(" {key} = "));
        let ty = if states("type") { "" } else { "type = \"u16\", " };
        let access = if states("access") { "" } else { "access = \"rw\", " };
        let taken = addresses(at).into_iter().filter(|a| take(*a));
        taken
            .map(move |at| format!("  {{ at = \"{at}\", {ty}{access}src = \"1 L1\" }},\n"))
            .collect::<Vec<_>>()
    });
    rows.collect()
}

#[test]
fn every_address_can_be_used_without_a_name_of_its_own() {
    let compiled = compile(drive(&nameless(&|_| true)));
    let errors: Vec<String> = compiled
        .diagnostics
        .iter()
        .filter(|d| d.severity() == Severity::Error)
        .map(|d| format!("{}: {}", d.code.id(), d.message))
        .collect();
    assert!(errors.is_empty(), "{errors:#?}");
    let model = compiled.model.expect("a model");
    let handle = |at| model.entry(address(at)).map(|(_, e)| e.handle.words().join(" ")).unwrap_or_default();
    assert!(model.entries.len() > 2_500, "{}", model.entries.len());
    assert_eq!(handle("6091:01"), "gear ratio motor revolutions");
    assert_eq!(handle("1018:00"), "identity highest sub index");
    assert_eq!(handle("1003:02"), "standard error field 2");
}

#[test]
fn no_address_is_of_two_bases() {
    let mut seen = std::collections::BTreeMap::new();
    for (base, at, _) in base_rows() {
        let keys: Vec<String> = match addresses(at).as_slice() {
            [] => vec![at.to_owned()],
            all => all.iter().map(ToString::to_string).collect(),
        };
        for key in keys {
            assert_eq!(seen.insert(key.clone(), base), None, "{key}");
        }
    }
}

#[test]
fn a_cycle_carries_commands_set_points_and_actual_values() {
    let compiled = compile(drive(&nameless(&|a| a.index >= 0x6000)));
    let model = compiled.model.expect("a model");
    let is_in = |list: &str, at: Address| list.split(' ').any(|item| address(item) == at);
    for (_, entry) in model.entries.iter() {
        let at = entry.address;
        let found = entry.mapping.as_ref().map(|m| m.value.word());
        let expected = is_in(RX, at).then_some("rx").or(is_in(TX, at).then_some("tx"));
        assert_eq!(found, expected, "{at}");
    }
}

#[test]
fn a_row_that_contradicts_the_standard_needs_a_reason() {
    let codes = |row: &str| -> Vec<&str> {
        compile(drive(row)).diagnostics.iter().map(|d| d.code.id()).filter(|c| *c != "W0504").collect()
    };
    assert_eq!(codes(r#"{ at = "6060:00", type = "u8", src = "1 L1" },"#), ["E0207"]);
    assert_eq!(codes(r#"{ at = "6041:00", access = "rw", src = "1 L1" },"#), ["E0207"]);
    assert_eq!(
        codes(r#"{ at = "6060:00", type = "u8", deviation = "printed so three times", src = "1 L1" },"#),
        [""; 0]
    );
    assert_eq!(codes(r#"{ at = "6060:00", type = "i8", deviation = "none", src = "1 L1" },"#), ["E0208"]);
}

#[test]
fn the_kinds_of_standard_objects_are_known() {
    let rows = r#"
  { at = "607D:00", src = "1 L1" },
  { at = "607D:01", src = "1 L1" },
  { at = "1018:00", src = "1 L1" },
  { at = "1018:01", src = "1 L1" },
"#;
    let compiled = compile(drive(rows));
    let model = compiled.model.expect("a model");
    let kind = |index| format!("{:?}", model.object(index).expect("an object").kind.value);
    assert_eq!((kind(0x607D), kind(0x1018)), ("Array".to_owned(), "Record".to_owned()));
}

/// The tables of a base that no drive inherits yet, compiled as if a drive had written them, so that every check of such
/// rows sees them.
fn tables(base: &str) -> Model {
    let base = drivewright_standard::bases().iter().find(|b| b.name == base).expect("a base");
    let inherited = ["objects.toml", "enums.toml", "bits.toml"];
    let own = base.files.iter().filter(|f| !inherited.iter().any(|name| f.0.ends_with(name)));
    let mut profile = drive("");
    let cited = |text: &str| text.replace(" },\n", ", src = \"1 L1\" },\n");
    profile.extend(own.map(|f| Source { path: f.0.into(), text: cited(f.1) }));
    let compiled = compile(profile);
    let errors = compiled.diagnostics.iter().filter(|d| d.severity() == Severity::Error);
    assert_eq!(errors.map(|d| d.message.clone()).collect::<Vec<_>>(), [""; 0]);
    compiled.model.expect("a model")
}

#[test]
fn states_are_told_by_the_bits_of_the_standard() {
    // Bits 6 to 0 of the statusword, x where a bit does not matter.
    let patterns = [
        ("Not ready to switch on", "x0xx0000"),
        ("Switch on disabled", "x1xx0000"),
        ("Ready to switch on", "x01x0001"),
        ("Switched on", "x01x0011"),
        ("Operation enabled", "x01x0111"),
        ("Quick stop active", "x00x0111"),
        ("Fault reaction active", "x0xx1111"),
        ("Fault", "x0xx1000"),
    ];
    let model = tables("cia402");
    assert_eq!(model.states.len(), patterns.len());
    for (name, bits) in patterns {
        let state = model.states.iter().find(|s| s.name.value.original() == name).expect(name);
        assert_eq!(word(state.mask.value, state.value.value), bits, "{name}");
    }
    for word in 0..=u16::MAX {
        let matching = model.states.iter().filter(|s| word & s.mask.value == s.value.value).count();
        assert!(matching <= 1, "{word:04X} is {matching} states");
    }
}

/// The low eight bits of a word, x where the mask has none.
fn word(mask: u16, value: u16) -> String {
    let bit = |n: u16| match (mask >> n & 1, value >> n & 1) {
        (0, _) => 'x',
        (_, 0) => '0',
        _ => '1',
    };
    (0..8).rev().map(bit).collect()
}

#[test]
fn commands_are_those_of_the_standard() {
    // Bits 7 to 0 of the controlword, and the transitions.
    let patterns: [(&str, &str, &[u8]); 7] = [
        ("Shutdown", "0xxxx110", &[2, 6, 8]),
        ("Switch on", "0xxx0111", &[3]),
        ("Disable voltage", "0xxxxx0x", &[7, 9, 10, 12]),
        ("Quick stop", "0xxxx01x", &[7, 10, 11]),
        ("Disable operation", "0xxx0111", &[5]),
        ("Enable operation", "0xxx1111", &[4, 16]),
        ("Fault reset", "1xxxxxxx", &[15]),
    ];
    let model = tables("cia402");
    assert_eq!(model.commands.len(), patterns.len());
    for (name, bits, transitions) in patterns {
        let command = model.commands.iter().find(|c| c.name.value.original() == name).expect(name);
        assert_eq!(word(command.mask.value, command.value.value), bits, "{name}");
        assert_eq!(command.transitions.as_ref().map(|t| t.value.as_slice()), Some(transitions), "{name}");
        assert_eq!(command.edge.as_ref().is_some_and(|e| e.value), name == "Fault reset", "{name}");
    }
}

#[test]
fn modes_have_one_name_everywhere() {
    let names: [(i128, &str); 10] = [
        (1, "Profile position"),
        (2, "Velocity"),
        (3, "Profile velocity"),
        (4, "Profile torque"),
        (6, "Homing"),
        (7, "Interpolated position"),
        (8, "Cyclic synchronous position"),
        (9, "Cyclic synchronous velocity"),
        (10, "Cyclic synchronous torque"),
        (11, "Cyclic synchronous torque with commutation angle"),
    ];
    let stated = tables("cia402").modes;
    let found: Vec<(i128, &str)> =
        stated.iter().map(|m| (m.number.into(), m.name.value.original())).collect();
    assert_eq!((found[0], &found[1..]), ((0, "No mode"), &names[..]));
    let model = compile(drive(&nameless(&|a| [0x6060, 0x6502].contains(&a.index)))).model.expect("a model");
    let values = &model.enums.as_slice()[0].values;
    assert_eq!(values[1..].iter().map(|v| (v.value, v.printed.as_str())).collect::<Vec<_>>(), names);
    let fields = &model.bits.as_slice()[0].fields;
    let bits: Vec<(i128, &str)> =
        fields.iter().map(|f| (i128::from(f.bit) + 1, f.printed.as_str())).collect();
    assert_eq!(bits, names);
}

#[test]
fn only_modes_with_a_target_have_halt_and_target_reached() {
    let model = compile(drive(&nameless(&|a| [0x6040, 0x6041].contains(&a.index)))).model.expect("a model");
    let with = |label: &str| -> Vec<Option<i8>> {
        let fields = model.bits.iter().flat_map(|(_, b)| &b.fields);
        fields.filter(|f| f.printed == label).map(|f| f.mode).collect()
    };
    assert_eq!(with("Halt"), [1, 3, 4, 6, 7].map(Some));
    assert_eq!(with("Target reached"), [1, 2, 3, 4, 6, 7].map(Some));
}

#[test]
fn abort_codes_are_those_of_the_standard() {
    let cia301 = "05030000 05040000 05040001 05040002 05040003 05040004 05040005 06010000 06010001 06010002 06020000 \
                  06040041 06040042 06040043 06040047 06060000 06070010 06070012 06070013 06090011 06090030 06090031 \
                  06090032 06090036 060A0023 08000000 08000020 08000021 08000022 08000023 08000024";
    let coe = "06010003 06010004 06010005 06010006";
    for (base, codes) in [("cia301", cia301), ("coe", coe)] {
        let found: Vec<String> =
            tables(base).aborts.iter().map(|a| format!("{:08X}", a.code.value)).collect();
        assert_eq!(found.join(" "), codes);
    }
}

/// Where each homing method finds home: direction of the last move over the edge, and the edge. The index of methods 1 to
/// 14 is the next one in that direction; 16 further is the edge itself.
const HOMES: &[(i8, &str, &str)] = &[
    (1, "+", "negative_limit off"),
    (2, "-", "positive_limit off"),
    (3, "-", "home off"),
    (4, "+", "home on"),
    (5, "+", "home off"),
    (6, "-", "home on"),
    (7, "-", "home off"),
    (8, "+", "home on"),
    (9, "-", "home on"),
    (10, "+", "home off"),
    (11, "+", "home off"),
    (12, "-", "home on"),
    (13, "+", "home on"),
    (14, "-", "home off"),
];

#[test]
fn homing_methods_find_the_home_of_the_standard() {
    let model = tables("cia402");
    let method =
        |n: i8| model.homing.iter().find(|m| m.number == n).unwrap_or_else(|| panic!("no method {n}"));
    for &(n, sign, edge) in HOMES {
        let over = format!("{sign} slow until {edge}; ");
        homes_at(method(n), &format!("{over}{sign} slow until index; latch"), sign, edge);
        homes_at(method(n + 16), &format!("{over}latch"), sign, edge);
        assert_eq!(method(n).reference.as_ref().map(|r| r.value.word()), Some("index"));
        let switch = edge.split_once(' ').map(|e| e.0);
        assert_eq!(method(n + 16).reference.as_ref().map(|r| r.value.word()), switch, "{n}");
        assert_eq!(method(n).approach.as_ref().map(|r| r.value.word()), switch, "{n}");
    }
    let reserved = model.homing.iter().filter(|m| m.status.value == HomingStatus::Reserved).map(|m| m.number);
    assert_eq!(reserved.collect::<Vec<_>>(), [15, 16, 31, 32]);
    let first = |n: i8| method(n).cases[0].moves.value.to_string();
    assert_eq!(
        [33, 34, 35, 37].map(first),
        ["- slow until index; latch", "+ slow until index; latch", "latch", "latch"]
    );
}

/// Every case of a method ends in `end`, and what the table says of it agrees.
fn homes_at(method: &HomingMethod, end: &str, sign: &str, edge: &str) {
    let number = method.number;
    let cases = if (7..=14).contains(&(number % 16)) { 3 } else { 2 };
    assert_eq!(method.cases.len(), cases, "{number}");
    for case in &method.cases {
        let moves = case.moves.value.to_string();
        assert!(moves.ends_with(end), "{number}: `{moves}` does not end in `{end}`");
    }
    let side = if sign == "+" { Side::Positive } else { Side::Negative };
    let change = if edge.ends_with("on") { Edge::Rising } else { Edge::Falling };
    assert_eq!(method.side.as_ref().map(|s| s.value), Some(side), "{number}");
    assert_eq!(method.edge.as_ref().map(|s| s.value), Some(change), "{number}");
    let start = match number % 16 {
        1 | 11..=14 => HomingStart::Negative,
        2 | 7..=10 => HomingStart::Positive,
        _ => HomingStart::BySwitch,
    };
    assert_eq!(method.start.as_ref().map(|s| s.value), Some(start), "{number}");
    let first = method.cases[0].moves.value.to_string();
    let away = if start == HomingStart::Negative { "- fast" } else { "+ fast" };
    assert!(start == HomingStart::BySwitch || first.starts_with(away), "{number}: `{first}`");
}
