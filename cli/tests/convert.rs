//! `drivewright convert` and the XSD, as a user calls them.

#![allow(clippy::expect_used, clippy::disallowed_methods, reason = "a test runs the program on files")]

use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};

const OBJECTS: &str = "\
# Chapter 6.
objects = [
  # The first one.
  { at = \"2000:00\", name = \"Speed\", type = \"u16\", access = \"rw\", pdo = \"no\", max = 0x0_10, src = \"1 L2\" }, # really
]
";

fn folder(name: &str) -> PathBuf {
    let path = Path::new(env!("CARGO_TARGET_TMPDIR")).join("convert").join(name);
    let _ = fs::remove_dir_all(&path);
    fs::create_dir_all(path.join("x1")).expect("a folder");
    fs::write(path.join("x1/objects.toml"), OBJECTS).expect("a file");
    fs::write(path.join("x1/drive.toml"), include_str!("../../codegen/tests/fixtures/drive.toml"))
        .expect("a file");
    path
}

fn run(at: &Path, arguments: &str) -> Output {
    let mut program = Command::new(env!("CARGO_BIN_EXE_drivewright"));
    program.current_dir(at).args(arguments.split(' ')).output().expect("the program runs")
}

fn texts(output: &Output) -> (i32, String, String) {
    let text = |bytes: &[u8]| String::from_utf8_lossy(bytes).into_owned();
    (output.status.code().expect("an exit code"), text(&output.stdout), text(&output.stderr))
}

#[test]
fn a_file_goes_there_and_back() {
    let at = folder("file");
    let (code, xml, said) = texts(&run(&at, "convert x1/objects.toml --to xml"));
    assert_eq!((code, said.as_str()), (0, ""));
    assert!(
        xml.contains("<!-- The first one. -->")
            && xml.contains("max=\"0x0_10\"")
            && xml.contains("/> <!-- really -->"),
        "{xml}"
    );
    assert_eq!(texts(&run(&at, "convert x1/objects.toml --to xml --out -")).1, xml);
    assert_eq!(
        texts(&run(&at, "convert x1/objects.toml --to xml --out o.xml")),
        (0, "1 file written\n".into(), String::new())
    );
    assert_eq!(fs::read_to_string(at.join("o.xml")).expect("a file"), xml);
    assert_eq!(texts(&run(&at, "convert o.xml --to toml")).1, OBJECTS);
}

#[test]
fn a_profile_of_xml_is_checked_and_built_like_one_of_toml() {
    let at = folder("profile");
    assert_eq!(
        texts(&run(&at, "convert x1 --to xml --out x2")),
        (0, "2 files written\n".into(), String::new())
    );
    assert!(at.join("x2/objects.xml").exists() && at.join("x2/drive.xml").exists());
    let counts = |of: &str| texts(&run(&at, &format!("check {of}"))).1.replace(of, "");
    assert_eq!(counts("x1"), counts("x2"));
    for drive in ["x1", "x2"] {
        assert_eq!(texts(&run(&at, &format!("build {drive} --out o{drive} -q"))).0, 0);
    }
    assert_eq!(texts(&run(&at, "build x2 --out ox1 --prune --check")).0, 0, "other bytes than from TOML");
    let object = at.join("x2/objects.xml");
    let text = fs::read_to_string(&object).expect("a file").replace("0x0_10", "x");
    fs::write(&object, text).expect("a file");
    let (code, _, said) = texts(&run(&at, "check x2"));
    assert!(code == 1 && said.contains("error[E0105]") && said.contains("objects.xml:6:"), "{said}");
}

#[test]
fn nothing_is_replaced_without_being_told() {
    let at = folder("force");
    fs::write(at.join("o.xml"), "mine").expect("a file");
    let (code, _, said) = texts(&run(&at, "convert x1/objects.toml --to xml --out o.xml"));
    assert!(
        code == 2
            && said.contains("--force")
            && fs::read_to_string(at.join("o.xml")).is_ok_and(|t| t == "mine")
    );
    assert_eq!(texts(&run(&at, "convert x1/objects.toml --to xml --out o.xml --force")).0, 0);
    assert!(fs::read_to_string(at.join("o.xml")).is_ok_and(|text| text.starts_with("<?xml")));
    for wrong in [
        "convert x1 --to xml",
        "convert x1 --to xml --out x1",
        "convert x9 --to xml",
        "convert x1/objects.toml",
    ] {
        assert_eq!(texts(&run(&at, wrong)).0, 2, "{wrong}");
    }
    fs::write(at.join("x1/objects.xml"), "<profile/>").expect("a file");
    let (code, _, said) = texts(&run(&at, "convert x1 --to toml --out o"));
    assert!(code == 2 && said.contains("differ in their endings") && !at.join("o").exists(), "{said}");
}

#[test]
fn one_bad_file_and_none_is_written() {
    let at = folder("bad");
    fs::write(at.join("x1/a.xml"), "<profile><objects><row></objects></profile>").expect("a file");
    let (code, _, said) = texts(&run(&at, "convert x1 --to xml --out o"));
    assert!(code == 1 && said.contains("error[E0121]") && said.contains("a.xml:1:24"), "{said}");
    assert!(said.contains("nothing was written") && !at.join("o").exists());
    fs::write(at.join("x1/a.xml"), [0xFF]).expect("a file");
    assert_eq!(texts(&run(&at, "convert x1/a.xml --to toml")).0, 3);
}

#[test]
fn there_is_a_schema_for_each_format() {
    let at = folder("schema");
    assert!(texts(&run(&at, "schema --format xsd")).1.contains("<xs:element name=\"profile\">"));
    assert_eq!(texts(&run(&at, "schema")).1, texts(&run(&at, "schema --format json")).1);
}
