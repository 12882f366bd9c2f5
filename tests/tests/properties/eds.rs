//! An EDS says what the rows of its profile say: read back, every entry is there with its type, access, limits, default
//! and mapping.
//!
//! What is expected is made from the rows, not from the model, and its type codes are written here once more.

use std::collections::BTreeMap;
use std::fmt::Write;

use canopen_host::canopen_rs::datatypes::DataType;
use proptest::collection::btree_map;
use proptest::option;
use proptest::prelude::*;
use proptest::sample::{Index, select};

use super::{DRIVE, cases, reader, run, source};

/// Words of a profile with the codes of CiA 301.
const TYPES: [(&str, u16); 25] = [
    ("bool", 0x01),
    ("i8", 0x02),
    ("i16", 0x03),
    ("i32", 0x04),
    ("u8", 0x05),
    ("u16", 0x06),
    ("u32", 0x07),
    ("f32", 0x08),
    ("string", 0x09),
    ("octets", 0x0A),
    ("unicode", 0x0B),
    ("time", 0x0C),
    ("time_difference", 0x0D),
    ("domain", 0x0F),
    ("i24", 0x10),
    ("f64", 0x11),
    ("i40", 0x12),
    ("i48", 0x13),
    ("i56", 0x14),
    ("i64", 0x15),
    ("u24", 0x16),
    ("u40", 0x18),
    ("u48", 0x19),
    ("u56", 0x1A),
    ("u64", 0x1B),
];

/// Names as printed and as ASCII without signs that a reader takes for something else.
const NAMES: [(&str, &str); 8] = [
    ("Gain", "Gain"),
    ("[6040]", "[6040]"),
    ("A;B", "A,B"),
    ("100 % \u{2030}", "100 % ?"),
    ("=x=", "=x="),
    ("'q'", "q'"),
    ("C:\\x #1", "C:/x No.1"),
    ("\u{B5}s", "us"),
];

/// What a row says of an entry.
#[derive(Clone, Debug)]
struct Row {
    name: (&'static str, &'static str),
    ty: (&'static str, u16),
    access: &'static str,
    pdo: Option<&'static str>,
    low: Option<i128>,
    high: Option<i128>,
    default: Option<i128>,
}

#[derive(Clone, Debug)]
enum Shape {
    Variable(Row),
    /// Entries by sub-index from 1, and whether sub-index 0 states how many.
    Several(BTreeMap<u8, Row>, bool),
}

type Drive = BTreeMap<u16, Shape>;

/// The lowest and highest value of an integer type, from its word.
fn ends(word: &str) -> Option<(i128, i128)> {
    let bits: u32 = word.get(1..)?.parse().ok()?;
    match word.get(..1)? {
        "i" => Some((-(1 << (bits - 1)), (1 << (bits - 1)) - 1)),
        "u" => Some((0, (1 << bits) - 1)),
        _ => None,
    }
}

/// Limits and a default between them, often at the edges of the type.
fn numbers(word: &'static str) -> BoxedStrategy<[Option<i128>; 3]> {
    let Some((least, most)) = ends(word) else {
        let default = if word == "bool" { option::of(0..=1_i128).boxed() } else { Just(None).boxed() };
        return default.prop_map(|n| [None, n, None]).boxed();
    };
    let number = || prop_oneof![Just(least), Just(most), Just(0), least..=most];
    let all = ([number(), number(), number()], any::<[bool; 3]>());
    all.prop_map(|(mut numbers, stated)| {
        numbers.sort_unstable();
        std::array::from_fn(|n| stated[n].then_some(numbers[n]))
    })
    .boxed()
}

fn row() -> impl Strategy<Value = Row> {
    let words = (select(&NAMES[..]), select(&["ro", "rw", "wo", "const"][..]));
    let pdo = option::of(select(&["no", "rx", "tx", "rx tx"][..]));
    let ty = select(&TYPES[..]).prop_flat_map(|ty| (Just(ty), numbers(ty.0)));
    (words, pdo, ty).prop_map(|((name, access), pdo, (ty, [low, default, high]))| Row {
        name,
        ty,
        access,
        pdo,
        low,
        high,
        default,
    })
}

fn drive() -> impl Strategy<Value = Drive> {
    // 1C12h and 1C13h assign PDOs, which these drives do not have.
    let index =
        prop_oneof![0x1000..=0x1C11_u16, 0x1C14..=0x1FFF_u16, 0x2000..=0x5FFF_u16, 0x6000..=0xFFFF_u16];
    let several = (btree_map(1..=0xFE_u8, row(), 1..6), any::<bool>());
    let shape = prop_oneof![row().prop_map(Shape::Variable), several.prop_map(|(m, n)| Shape::Several(m, n))];
    btree_map(index, shape, 1..10)
}

/// The rows of a drive as a profile.
fn profile(drive: &Drive) -> String {
    let mut text = String::from("objects = [\n");
    for (index, shape) in drive {
        match shape {
            Shape::Variable(only) => write_row(&mut text, *index, 0, only),
            Shape::Several(rows, stated) => {
                write_row(&mut text, *index, 0, &count(rows, *stated));
                for (sub, row) in rows {
                    write_row(&mut text, *index, *sub, row);
                }
            }
        }
    }
    text + "]\n" + DRIVE
}

/// The row at sub-index 0 of several.
fn count(rows: &BTreeMap<u8, Row>, stated: bool) -> Row {
    let highest = rows.last_key_value().map(|(sub, _)| i128::from(*sub));
    let (name, ty) = (("Count", "Count"), ("u8", 0x05));
    Row { name, ty, access: "ro", pdo: None, low: None, high: None, default: highest.filter(|_| stated) }
}

fn write_row(text: &mut String, index: u16, sub: u8, row: &Row) {
    let Row { name, ty, access, .. } = row;
    let _ = write!(text, "{{ at = \"{index:04X}:{sub:02X}\", name = '''{} {index} {sub}'''", name.0);
    let _ = write!(text, ", type = \"{}\", access = \"{access}\"", ty.0);
    let _ = row.pdo.map(|pdo| write!(text, ", pdo = \"{pdo}\""));
    for (key, n) in [("min", row.low), ("max", row.high), ("default", row.default)] {
        let _ = n.map(|n| write!(text, ", {key} = {n}"));
    }
    text.push_str(", src = \"1 L1\" },\n");
}

/// What the EDS has to say.
fn wanted(drive: &Drive) -> BTreeMap<u16, reader::Object> {
    let object = |(index, shape): (&u16, &Shape)| match shape {
        Shape::Variable(row) => {
            let entry = entry(*index, 0, row);
            let code = if row.ty.0 == "domain" { 2 } else { 7 };
            (*index, (entry.name.clone(), code, BTreeMap::from([(0, entry)])))
        }
        Shape::Several(rows, _) => {
            let mut types = rows.values().map(|row| row.ty.0);
            let first = types.next();
            let code = if types.all(|ty| Some(ty) == first) { 8 } else { 9 };
            // Where nobody states how many there are, the highest sub-index is.
            let count = entry(*index, 0, &count(rows, true));
            let members = rows.iter().map(|(sub, row)| (*sub, entry(*index, *sub, row)));
            (*index, (count.name.clone(), code, members.chain([(0, count.clone())]).collect()))
        }
    };
    drive.iter().map(object).collect()
}

fn entry(index: u16, sub: u8, row: &Row) -> reader::Entry {
    reader::Entry {
        name: format!("{} {index} {sub}", row.name.1),
        ty: row.ty.1,
        access: row.access.into(),
        low: row.low,
        high: row.high,
        default: row.default,
        // A DOMAIN has no fixed length, which a PDO needs.
        mapped: row.ty.0 != "domain" && row.pdo.is_some_and(|pdo| pdo != "no"),
    }
}

fn eds(drive: &Drive) -> String {
    let result = run(vec![source("x1.toml", profile(drive))]);
    let bytes = result.files.get("eds/acme-x1.eds").unwrap_or_else(|| panic!("{:#?}", result.findings));
    String::from_utf8(bytes.to_vec()).expect("ASCII")
}

fn read(text: &str) -> Result<BTreeMap<u16, reader::Object>, String> {
    reader::read(text.as_bytes()).and_then(|sections| reader::dictionary(&sections))
}

/// Index, sub-index, access and whether a PDO can carry it.
type Short = (u16, u8, String, bool);

/// What a foreign reader finds, of the types that it knows.
fn foreign(text: &str) -> Vec<Short> {
    let read = canopen_host::eds::Eds::parse(text).expect("an EDS");
    let short = |o: &canopen_host::eds::ObjectDescription| {
        (o.address.index, o.address.subindex, format!("{:?}", o.access).to_lowercase(), o.pdo_mappable)
    };
    read.objects.iter().map(short).collect()
}

fn short(wanted: &BTreeMap<u16, reader::Object>) -> Vec<Short> {
    let entries = wanted.iter().flat_map(|(index, o)| o.2.iter().map(move |(sub, e)| (*index, *sub, e)));
    let known = entries.filter(|(_, _, e)| DataType::from_index(e.ty).is_some());
    known.map(|(index, sub, e)| (index, sub, e.access.clone(), e.mapped)).collect()
}

proptest! {
    #![proptest_config(cases(150))]

    #[test]
    fn every_row_comes_back(drive in drive()) {
        let text = eds(&drive);
        prop_assert_eq!(read(&text), Ok(wanted(&drive)));
        prop_assert_eq!(foreign(&text), short(&wanted(&drive)));
    }

    /// The comparison above sees each line of the dictionary that says something.
    #[test]
    fn a_lost_line_is_seen(drive in drive(), place in any::<Index>()) {
        let text = eds(&drive);
        let (head, body) = text.split_at(text.find("[MandatoryObjects]").expect("the first list"));
        let mut lines: Vec<&str> = body.lines().collect();
        let says = |line: &&str| !["", "DefaultValue=", "PDOMapping=0"].contains(line);
        let saying: Vec<usize> = (0..lines.len()).filter(|n| says(&lines[*n])).collect();
        let lost = lines.remove(*place.get(&saying));
        let found = read(&format!("{head}{}\r\n", lines.join("\r\n")));
        prop_assert!(found != Ok(wanted(&drive)), "{} is not missed", lost);
    }
}
