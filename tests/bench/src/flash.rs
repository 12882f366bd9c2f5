//! What firmware that uses ten of a thousand objects weighs, beside the same written by hand.

use std::error::Error;
use std::fmt::Write;
use std::fs;
use std::path::Path;
use std::process::Command;

use object::{Object, ObjectSection};

use crate::crates::write;
use crate::synthetic::{self, Entry};
use crate::{child, crates};

/// The microcontroller.
pub const TARGET: &str = "thumbv7em-none-eabihf";
/// Objects that the program uses.
const USED: usize = 10;

/// What both programs have around the access to objects.
const FRAME: &str = r#"#![no_std]
#![no_main]
use core::hint::black_box;
#[inline(never)]
fn send(index: u16, sub: u8, bytes: &[u8]) { black_box((index, sub, bytes)); }
#[inline(never)]
fn receive(index: u16, sub: u8) -> [u8; 4] { black_box([index as u8, sub, 0, 0]) }
#[no_mangle]
pub extern "C" fn _start() -> ! { loop { black_box(all()); } }
#[panic_handler]
fn panic(_: &core::panic::PanicInfo<'_>) -> ! { loop {} }
"#;

/// Bytes in flash of a program by the generated crate, and of one by hand.
pub struct Flash {
    pub ours: u64,
    pub hand: u64,
}

/// Builds and weighs both.
pub fn measure(
    made: &crates::Crate,
    entries: usize,
    scratch: &Path,
    target: &Path,
) -> Result<Flash, Box<dyn Error>> {
    let drive = synthetic::drive(entries);
    let all = drive.objects.iter().flat_map(|o| o.entries.iter().map(move |e| (o.index, e)));
    let used: Vec<(u16, &Entry)> = all.filter(|(_, e)| e.writable && e.table.is_none()).take(USED).collect();
    let depends = format!("{} = {{ path = {:?} }}", made.name, made.folder);
    let size = |name, depends: &str, code| size(name, depends, code, scratch, target);
    Ok(Flash {
        ours: size("flash-ours", &depends, by_handles(&made.name, &used))?,
        hand: size("flash-hand", "", by_hand(&used))?,
    })
}

/// The same for a program that enables an axis and moves it, by the client and by hand.
pub fn enable_and_move(root: &Path, scratch: &Path, target: &Path) -> Result<Flash, Box<dyn Error>> {
    let runtime = format!("drivewright-runtime = {{ path = {:?} }}", root.join("runtime"));
    Ok(Flash {
        ours: size(
            "axis-ours",
            &runtime,
            format!("{FRAME}{}", include_str!("axis/ours.txt")),
            scratch,
            target,
        )?,
        hand: size("axis-hand", "", format!("{FRAME}{}", include_str!("axis/hand.txt")), scratch, target)?,
    })
}

/// Builds a program and weighs it.
fn size(
    name: &str,
    depends: &str,
    code: String,
    scratch: &Path,
    target: &Path,
) -> Result<u64, Box<dyn Error>> {
    let folder = scratch.join(name);
    let manifest = format!(
        "[package]\nname = \"{name}\"\nversion = \"0.0.0\"\nedition = \"2021\"\n[workspace]\n[profile.release]\npanic = \"abort\"\nopt-level = \"s\"\nlto = true\ncodegen-units = 1\n[dependencies]\n{depends}\n"
    );
    write(&folder.join("Cargo.toml"), manifest.as_bytes())?;
    write(&folder.join("src").join("main.rs"), code.as_bytes())?;
    let mut cargo = Command::new("cargo");
    cargo.args(["build", "--release", "--quiet", "--target", TARGET, "--target-dir"]).arg(target);
    child::run(cargo.current_dir(&folder))?;
    weigh(&target.join(TARGET).join("release").join(name))
}

fn by_handles(package: &str, used: &[(u16, &Entry)]) -> String {
    let mut code = format!(
        "{FRAME}use {}::od;\nfn all() -> Option<i64> {{\n    let (mut out, mut sum) = ([0u8; 4], 0i64);\n",
        package.replace('-', "_")
    );
    for (index, entry) in used {
        let handle: String = entry
            .name
            .chars()
            .map(|c| if c.is_ascii_alphanumeric() { c.to_ascii_uppercase() } else { '_' })
            .collect();
        let (ty, sub, bytes) = (primitive(entry), entry.sub, entry.ty.bits / 8);
        let _ = writeln!(
            code,
            "    let n = od::{handle}.encode(black_box(1 as {ty}), &mut out).ok()?;\n    send({index}, {sub}, out.get(..n)?);\n    sum += i64::from(od::{handle}.decode(&receive({index}, {sub})[..{bytes}]).ok()?);"
        );
    }
    code + "    Some(sum)\n}\n"
}

fn by_hand(used: &[(u16, &Entry)]) -> String {
    let mut code = format!("{FRAME}fn all() -> Option<i64> {{\n    let mut sum = 0i64;\n");
    for (index, entry) in used {
        let (ty, sub, bytes) = (primitive(entry), entry.sub, entry.ty.bits / 8);
        let _ = writeln!(
            code,
            "    send({index}, {sub}, &black_box(1 as {ty}).to_le_bytes());\n    let bytes = receive({index}, {sub});\n    sum += i64::from({ty}::from_le_bytes(bytes[..{bytes}].try_into().ok()?));"
        );
    }
    code + "    Some(sum)\n}\n"
}

fn primitive(entry: &Entry) -> String {
    format!("{}{}", if entry.ty.signed { 'i' } else { 'u' }, entry.ty.bits)
}

/// Bytes of an ELF file that are stored on the device: code, constants, first values of variables.
fn weigh(path: &Path) -> Result<u64, Box<dyn Error>> {
    let bytes = fs::read(path)?;
    let file = object::File::parse(bytes.as_slice())?;
    let stored = |s: &object::Section<'_, '_>| {
        use object::SectionKind::{Data, ReadOnlyData, ReadOnlyString, Text};
        matches!(s.kind(), Text | ReadOnlyData | ReadOnlyString | Data)
    };
    Ok(file.sections().filter(stored).map(|s| s.size()).sum())
}
