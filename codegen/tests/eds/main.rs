//! The EDS says what the model says, and says so to a reader that shares no code with its writer.

#![allow(clippy::expect_used, clippy::panic, reason = "tests")]

mod profiles;
mod reader;

use std::collections::BTreeMap;

use drivewright_codegen::backend::eds::Eds;
use drivewright_codegen::backend::rust::Rust;
use drivewright_codegen::diag::Diagnostic;
use drivewright_codegen::emit;
use drivewright_codegen::emit::escape;
use drivewright_codegen::model::{self, Access, Address, Model, ObjectKind, Type, Value};
use profiles::{model, random};
use reader::{Entry, dictionary, get, read, section, whole};

fn eds(model: &Model) -> (String, Vec<Diagnostic>) {
    let (files, diagnostics) = emit(model, &[&Eds]);
    assert_eq!(files.len(), 1);
    let bytes = files.get("eds/acme-x1.eds").expect("the path follows the package");
    (String::from_utf8(bytes.to_vec()).expect("ASCII"), diagnostics)
}

/// Every difference between a file and the model.
fn differences(text: &str, model: &Model) -> Vec<String> {
    let found = match read(text.as_bytes()).and_then(|sections| {
        header(&sections, model)?;
        dictionary(&sections)
    }) {
        Ok(found) => found,
        Err(error) => return vec![error],
    };
    let mut out = Vec::new();
    if found.len() != model.objects.len() {
        out.push(format!("{} objects, the model has {}", found.len(), model.objects.len()));
    }
    for object in model.objects.as_slice() {
        match found.get(&object.index) {
            None => out.push(format!("no {:04X}", object.index)),
            Some(there) => compare(object, there, model, &mut out),
        }
    }
    out
}

fn compare(object: &model::Object, there: &reader::Object, model: &Model, out: &mut Vec<String>) {
    let entries: Vec<&model::Entry> = object.entries.iter().map(|id| &model.entries[*id]).collect();
    let code = match object.kind.value {
        ObjectKind::Array => 8,
        ObjectKind::Record => 9,
        ObjectKind::Var if entries[0].ty.value == Type::Domain => 2,
        ObjectKind::Var => 7,
    };
    let highest = entries.last().map_or(0, |e| e.address.sub);
    if there.1 != code || there.2.len() != entries.len() {
        out.push(format!("{:04X}: kind {} with {} entries", object.index, there.1, there.2.len()));
    }
    for entry in entries {
        let count = (code > 7 && entry.address.sub == 0).then_some(i128::from(highest));
        let wanted = wanted(entry, count);
        if there.2.get(&entry.address.sub) != Some(&wanted) {
            out.push(format!("{}: {:?}, not {wanted:?}", entry.address, there.2.get(&entry.address.sub)));
        }
    }
}

fn wanted(entry: &model::Entry, count: Option<i128>) -> Entry {
    let default = entry.default.as_ref().map_or(count, |d| match d.value {
        Value::Int(n) => Some(n),
        Value::Text(_) => None,
    });
    let access = match entry.access.value {
        Access::Ro => "ro",
        Access::Rw => "rw",
        Access::Wo => "wo",
        Access::Const => "const",
    };
    Entry {
        name: escape::ini(&entry.name.value),
        ty: entry.ty.value.cia301_code(),
        access: access.into(),
        low: entry.min.as_ref().map(|f| f.value),
        high: entry.max.as_ref().map(|f| f.value),
        default,
        mapped: entry.ty.value != Type::Domain && entry.mapping.as_ref().is_some_and(|m| m.value.any()),
    }
}

fn header(sections: &BTreeMap<String, reader::Keys>, model: &Model) -> Result<(), String> {
    let (file, device) = (section(sections, "FileInfo")?, section(sections, "DeviceInfo")?);
    let wanted = [
        ("FileName", "acme-x1.eds"),
        ("FileVersion", "3"),
        ("FileRevision", "7"),
        ("EDSVersion", "4.0"),
        ("CreationDate", "01-31-2026"),
        ("ModificationDate", "01-31-2026"),
        ("CreationTime", "12:00AM"),
    ];
    for (key, value) in wanted {
        if get(file, key, "FileInfo")? != value {
            return Err(format!("{key} is not {value}"));
        }
    }
    for (sub, key) in [(1, "VendorNumber"), (2, "ProductNumber"), (3, "RevisionNumber")] {
        let number: i128 = whole(get(device, key, "DeviceInfo")?)?;
        if number != model.default_int(Address::new(0x1018, sub)).unwrap_or(0) {
            return Err(format!("{key} is not that of 1018h"));
        }
    }
    let comments = section(sections, "Comments")?;
    let lines: usize = whole(get(comments, "Lines", "Comments")?)?;
    let all = comments.len() == lines + 1 && (1..=lines).all(|n| comments.contains_key(&format!("Line{n}")));
    if all { Ok(()) } else { Err("comments are miscounted".into()) }
}

#[test]
fn every_fact_comes_back() {
    for seed in 0..150 {
        let model = random(seed);
        let (text, _) = eds(&model);
        assert_eq!(differences(&text, &model), Vec::<String>::new(), "seed {seed}\n{text}");
    }
}

#[test]
fn a_changed_fact_is_seen() {
    let rows = r#"
{ at = "1018:00", name = "Identity", type = "u8", access = "ro", default = 1, src = "1 L1" },
{ at = "1018:01", name = "Vendor", type = "u32", access = "ro", default = 0x7E6, src = "1 L1" },
{ at = "6040:00", name = "Controlword", type = "u16", access = "rw", pdo = "rx", min = 1, max = 90, default = 5, src = "1 L1" },"#;
    let model = model(rows, "");
    let (text, _) = eds(&model);
    assert_eq!(differences(&text, &model), Vec::<String>::new());
    let changes = [
        ("DataType=0x0006", "DataType=0x0003"),
        ("AccessType=rw", "AccessType=ro"),
        ("LowLimit=1\r", "LowLimit=2\r"),
        ("HighLimit=90", "HighLimit=91"),
        ("DefaultValue=5", "DefaultValue=6"),
        ("DefaultValue=5", "DefaultValue="),
        ("PDOMapping=1", "PDOMapping=0"),
        ("ParameterName=Controlword", "ParameterName=Controlwort"),
        ("SubNumber=2", "SubNumber=3"),
        ("ObjectType=0x8", "ObjectType=0x9"),
        ("SupportedObjects=1", "SupportedObjects=2"),
        ("VendorNumber=0x7E6", "VendorNumber=0x7E7"),
        ("1=0x6040", "1=0x2040"),
        ("[6040]", "[6041]"),
        ("[6040]\r", "[6040] \r"),
        ("[6040]\r\n", "[6040]\n"),
        ("PDOMapping=1\r\n", "PDOMapping=1\r\nUnit=rpm\r\n"),
        ("Lines=", "Lines=1"),
    ];
    for (from, to) in changes {
        assert!(text.contains(from), "{from}\n{text}");
        assert_ne!(differences(&text.replacen(from, to, 1), &model), Vec::<String>::new(), "{from} -> {to}");
    }
}

#[test]
fn a_section_reads_like_this() {
    let rows = r#"
{ at = "607D:00", name = "Software position limit", type = "u8", access = "ro", default = 2, src = "1 L1" },
{ at = "607D:01", name = "Min position limit", type = "i32", access = "rw", pdo = "rx tx", min = -2000000000, max = 2000000000, default = -2000000000, src = "1 L1" },
{ at = "607D:02", name = "Max position limit", type = "i32", access = "rw", pdo = "rx tx", src = "1 L1" },"#;
    let wanted = "
[OptionalObjects]
SupportedObjects=1
1=0x607D

[607D]
ParameterName=Software position limit
ObjectType=0x8
SubNumber=3

[607Dsub0]
ParameterName=Software position limit
ObjectType=0x7
DataType=0x0005
AccessType=ro
DefaultValue=0x2
PDOMapping=0

[607Dsub1]
ParameterName=Min position limit
ObjectType=0x7
DataType=0x0004
AccessType=rw
LowLimit=-2000000000
HighLimit=2000000000
DefaultValue=-2000000000
PDOMapping=1

[607Dsub2]
ParameterName=Max position limit
ObjectType=0x7
DataType=0x0004
AccessType=rw
DefaultValue=
PDOMapping=1
";
    let (text, _) = eds(&model(rows, ""));
    assert!(text.contains(&wanted.replace('\n', "\r\n")), "{text}");
}

#[test]
fn no_name_opens_a_section() {
    let mut model = random(1);
    let before = read(eds(&model).0.as_bytes()).expect("well formed");
    let hostile = [
        "a\r\n[6040]\r\nDataType=0x0001",
        "\n[6040]",
        "[6040]",
        ";[6040]",
        "#",
        "\0",
        "\u{202E}drow\u{2066}",
        "\u{2028}[6040]\u{85}[6041]",
        "\\\n",
        "\"unclosed",
        "'unclosed",
        " ",
        "",
        "x=y\tz",
    ];
    model.drive.vendor = hostile.concat().repeat(40);
    model.drive.name = hostile[0].into();
    model.manuals[0].title = hostile.join("\r\n");
    for (n, entry) in model.entries.as_mut_slice().iter_mut().enumerate() {
        entry.name.value = hostile[n % hostile.len()].into();
        entry.name.origin.class = model::Class::Assumed(hostile.join("\n"));
    }
    let (text, diagnostics) = eds(&model);
    let after = read(text.as_bytes()).expect("well formed");
    dictionary(&after).expect("the same objects");
    assert!(before.keys().eq(after.keys()), "{:?}", after.keys());
    for (name, keys) in after.iter().filter(|(name, _)| *name != "Comments") {
        assert!(before[name].keys().eq(keys.keys()), "[{name}] {keys:?}");
        assert!(keys.get("ParameterName").is_none_or(|v| !v.is_empty()), "[{name}] has no name");
    }
    let codes: Vec<&str> = diagnostics.iter().map(|d| d.code.id()).collect();
    assert!(codes.contains(&"W1005"), "{codes:?}");
}

#[test]
fn a_default_mapping_becomes_the_default_of_its_object() {
    let rows = r#"
{ at = "1600:00", name = "Number of mapped", type = "u8", access = "rw", src = "1 L1" },
{ at = "1600:01", name = "First mapped", type = "u32", access = "rw", src = "1 L1" },
{ at = "1600:02", name = "Second mapped", type = "u32", access = "rw", src = "1 L1" },
{ at = "6040:00", name = "Controlword", type = "u16", access = "rw", pdo = "rx", src = "1 L1" },"#;
    let pdo =
        r#"pdo = [ { map = 0x1600, dir = "rx", pos = 1, entry = "6040:00", bits = 16, src = "1 L1" } ]"#;
    let (text, _) = eds(&model(rows, pdo));
    let sections = read(text.as_bytes()).expect("well formed");
    assert_eq!(sections["1600sub0"]["DefaultValue"], "0x1");
    assert_eq!(sections["1600sub1"]["DefaultValue"], "0x60400010");
    assert_eq!(sections["1600sub2"]["DefaultValue"], "");
    assert_eq!(sections["DeviceInfo"]["Granularity"], "8");
    assert_eq!(sections["DeviceInfo"]["NrOfRXPDO"], "1");
    assert_eq!(sections["DeviceInfo"]["NrOfTXPDO"], "0");
}

#[test]
fn one_print_for_many_becomes_many_names() {
    let rows = r#"
{ at = "3000:00", name = "Count", type = "u8", access = "ro", src = "1 L1" },
{ at = "3000:01..0A", name = "Servo parameter", type = "i32", access = "rw", src = "1 L1" },"#;
    let (text, _) = eds(&model(rows, ""));
    let sections = read(text.as_bytes()).expect("well formed");
    assert_eq!(sections["3000sub1"]["ParameterName"], "Servo parameter 1");
    assert_eq!(sections["3000subA"]["ParameterName"], "Servo parameter 10");
    // Nobody states the count: the highest sub-index, and in hexadecimal, since one reader takes it for that.
    assert_eq!(sections["3000sub0"]["DefaultValue"], "0xA");
    assert!(sections["Comments"].values().any(|line| line.ends_with("3000:00")), "{text}");
}

#[test]
fn names_that_grow_keep_their_line_and_stay_apart() {
    let long = "Gain#".repeat(40);
    let other = "Gain#".repeat(39) + "Gain;";
    let rows = format!(
        r#"
{{ at = "2000:00", name = "{long}", rename = "First", type = "u16", access = "rw", src = "1 L1" }},
{{ at = "2001:00", name = "{other}", rename = "Second", type = "u16", access = "rw", src = "1 L1" }},
{{ at = "3000", name = "Groß#", kind = "array", src = "1 L1" }},
{{ at = "3000:00", name = "Count", type = "u8", access = "ro", src = "1 L1" }},
{{ at = "3000:01", name = "A#", type = "i32", access = "rw", src = "1 L1" }},
{{ at = "3000:02", name = "ANo.", type = "i32", access = "rw", src = "1 L1" }},"#
    );
    let (text, diagnostics) = eds(&model(&rows, ""));
    let sections = read(text.as_bytes()).expect("no line is too long");
    let names = ["2000", "2001", "3000", "3000sub1", "3000sub2"].map(|s| &sections[s]["ParameterName"]);
    assert_eq!((names[0].len(), names[1].len()), (241, 241));
    assert!(names[0].ends_with(" 2000h") && names[1].ends_with(" 2001h"), "{names:?}");
    assert_eq!(names[2..], ["Gro?No.", "ANo. 1", "ANo. 2"]);
    let lost: Vec<&str> =
        diagnostics.iter().filter(|d| d.code.id() == "W1005").map(|d| d.message.as_str()).collect();
    assert_eq!(lost, ["EDS: a name is not written as printed: 2000:00, 2001:00, 3000:00..01"]);
}

#[test]
fn what_is_lost_is_said_once_a_kind_and_in_the_file() {
    let rows = r#"
{ at = "0005:00", name = "Data type", type = "u8", access = "ro", src = "1 L1" },
{ at = "1008:00", name = "Device name", type = "string", access = "ro", default = "X1", src = "1 L1" },
{ at = "1009:00", name = "Hardware", type = "string", access = "ro", default = "1.0", src = "1 L1" },
{ at = "2000:00", name = "Gain", type = "f32", access = "rw", min = 0, default = 1, src = "1 L1" },
{ at = "2001:00", name = "File", type = "domain", access = "rw", pdo = "rx", src = "1 L1" },
{ at = "2002:00", name = "Many", type = "u8", access = "ro", src = "1 L1" },
{ at = "2002:FF", name = "Structure", type = "u32", access = "ro", src = "1 L1" },
{ at = "2003:00", name = "Angle °", type = "u16", access = "rw", default = 5, assumed = ["default: nobody prints it"], src = "1 L1" },"#;
    let (text, diagnostics) = eds(&model(rows, ""));
    let found: Vec<String> = diagnostics.iter().map(|d| format!("{} {}", d.code.id(), d.message)).collect();
    let wanted = [
        "W1001 EDS: a DOMAIN is not marked as mappable: 2001:00",
        "W1001 EDS: limits of a type that is no integer are left out: 2000:00",
        "W1001 EDS: the default has no form that every reader takes and is left out: 2000:00",
        "W1001 EDS: the default is text and is left out: 1008:00, 1009:00",
        "W1003 EDS: the entry is left out: 2002:FF",
        "W1003 EDS: the object is left out: 0005:00",
        "W1004 EDS: a mandatory object is missing, and some readers refuse that: 1000:00, 1001:00, 1018:00",
        "W1005 EDS: a name is not written as printed: 2003:00",
    ];
    assert_eq!(sorted(found), wanted);
    let sections = read(text.as_bytes()).expect("well formed");
    dictionary(&sections).expect("the rest is there");
    let comments: Vec<&str> = sections["Comments"].values().map(String::as_str).collect();
    for line in [
        "The default is text and is left out: 1008:00, 1009:00",
        "Assumed default (nobody prints it): 2003:00",
    ] {
        assert!(comments.contains(&line), "{line}\n{comments:#?}");
    }
    assert!(diagnostics.iter().all(|d| !d.why.is_empty() && !d.help.is_empty()));
}

#[test]
fn what_is_assumed_stands_in_the_file_and_in_the_readme() {
    let rows = r#"
{ at = "1600:00", name = "Number of mapped", type = "u8", access = "rw", default = 1, src = "1 L1" },
{ at = "1600:01..02", name = "Mapped", type = "u32", access = "rw", src = "1 L1" },
{ at = "2003:00", name = "Angle", type = "u16", access = "rw", default = 5, assumed = ["default: nobody prints it"], src = "1 L1" },"#;
    let (files, _) = emit(&model(rows, ""), &[&Eds, &Rust]);
    let text = |path: &str| String::from_utf8(files.get(path).expect(path).to_vec()).expect("UTF-8");
    let sections = read(text("eds/acme-x1.eds").as_bytes()).expect("well formed");
    let comments = &sections["Comments"];
    assert!(comments.values().all(|line| !line.is_empty()), "{comments:?}");
    let lines = (1..comments.len()).map(|n| comments[&format!("Line{n}")].as_str());
    let comments = lines.collect::<Vec<_>>().join(" ");
    let readme = text("README.md").replace('\\', "");
    let (_, list) = readme.split_once("## Assumed").expect("a section");
    let (list, _) = list.split_once("\n## ").expect("another one");
    let sentences: Vec<&str> = list.lines().filter_map(|l| l.strip_prefix("- ")).collect();
    for sentence in &sentences {
        assert!(comments.contains(sentence), "{sentence}\n{comments}");
    }
    for word in
        ["12:00AM", "BaudRate", "Granularity is 8", "NrOfRXPDO", "VendorNumber", "nobody prints it): 2003:00"]
    {
        assert!(sentences.iter().any(|s| s.contains(word)), "{word}\n{list}");
    }
    assert!(comments.contains("is not the highest sub-index: 1600:00"), "{comments}");
}

fn sorted(mut lines: Vec<String>) -> Vec<String> {
    lines.sort();
    lines
}

#[test]
fn findings_that_a_profile_allows_do_not_break_the_file() {
    let mut model = random(2);
    for entry in model.entries.as_mut_slice().iter_mut().filter(|e| e.ty.value.range().is_some()) {
        entry.default = Some(model::Fact::new(Value::Int(i128::MAX), entry.name.origin.clone()));
        entry.min = Some(model::Fact::new(i128::MIN, entry.name.origin.clone()));
    }
    let (text, diagnostics) = eds(&model);
    dictionary(&read(text.as_bytes()).expect("well formed")).expect("the same objects");
    assert!(!text.contains(&i128::MAX.to_string()) && !text.contains(&i128::MIN.to_string()));
    assert_eq!(diagnostics.iter().filter(|d| d.message.contains("no value of the type")).count(), 2);
}
