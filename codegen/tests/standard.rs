//! The bases against lists that were typed independently of them.

#![allow(clippy::expect_used, clippy::panic, reason = "a test fails by panicking")]

use drivewright_codegen::compile;
use drivewright_codegen::diag::Severity;
use drivewright_codegen::model::{Access, Address, Class};
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
    let mut rows = String::new();
    for (_, at, row) in base_rows() {
        let missing = |key: &str, value: &str| {
            if row.contains(&format!(" {key} = ")) { String::new() } else { format!("{key} = \"{value}\", ") }
        };
        let rest = missing("type", "u16") + &missing("access", "rw");
        for address in addresses(at).into_iter().filter(|a| take(*a)) {
            rows += &format!("  {{ at = \"{address}\", {rest}src = \"1 L1\" }},\n");
        }
    }
    rows
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
