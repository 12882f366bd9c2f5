//! The bases against lists that were typed independently of them.

#![allow(clippy::expect_used, clippy::panic, reason = "a test fails by panicking")]

use drivewright_codegen::compile;
use drivewright_codegen::model::{Access, Address, Class};
use drivewright_codegen::source::Source;

/// Objects of CiA 402 by type, as public device files and the standard agree on them.
const TYPES: &[(&str, &str)] = &[
    ("u16", "603F 6040 6041 6066 6068 606D 606E 606F 6070 6072 6073 60B8 60B9 60E0 60E1 6402"),
    ("u8", "607E"),
    ("i8", "6060 6061 6098"),
    ("i16", "605A 605B 605C 605D 605E 6071 6074 6077 6078 6086 6088 60B2"),
    ("i32", "6062 6063 6064 606B 606C 607A 607C 60B0 60B1 60BA 60F4 60FA 60FF"),
    ("u32", "6065 6067 6075 6076 6079 607F 6080 6081 6082 6083 6084 6085 6087 609A 60C5 60C6 60FD 6502 67FF"),
    ("u32", "1000 1005 1006 1007 1014"),
    ("u16", "100C 1015 1017"),
    ("u8", "1001 100D"),
    ("string", "1008 1009 100A"),
];

/// What a drive can only report.
const READ_ONLY: &str = "1000 1001 603F 6041 6061 6062 6063 6064 606B 606C 6074 6077 6078 6079 60B9 60BA 60BB 60F4 60FA 60FD 6502 67FF";

fn drive(rows: &str) -> Vec<Source> {
    let head = include_str!("fixtures/drive.toml")
        .replace("eds_version", "bases = [\"cia301\", \"cia402\", \"coe\"]\neds_version");
    vec![Source { path: "drive.toml".into(), text: format!("objects = [\n{rows}]\n{head}") }]
}

#[test]
fn types_are_those_of_the_standard() {
    let indexes: Vec<(&str, &str)> =
        TYPES.iter().flat_map(|(ty, list)| list.split(' ').map(move |i| (*ty, i))).collect();
    let row = |(_, index): &(&str, &str)| format!("  {{ at = \"{index}:00\", src = \"1 L1\" }},\n");
    let compiled = compile(drive(&indexes.iter().map(row).collect::<String>()));
    let model = compiled.model.expect("a model");
    assert!(indexes.len() >= 64 + 13);
    for (ty, index) in indexes {
        let address = Address::new(u16::from_str_radix(index, 16).expect("an index"), 0);
        let (_, entry) = model.entry(address).unwrap_or_else(|| panic!("no base has {index}"));
        assert_eq!(entry.ty.value.word(), ty, "{index}");
        assert!(matches!(entry.ty.origin.class, Class::Standard(_)));
        let read_only = READ_ONLY.split(' ').any(|i| i == index) || ty == "string";
        let found = matches!(entry.access.value, Access::Ro | Access::Const);
        assert_eq!(found, read_only, "access of {index} is {}", entry.access.value.word());
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
