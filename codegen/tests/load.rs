//! The loader against a real disk.

#![allow(clippy::expect_used, clippy::panic, clippy::disallowed_methods, reason = "a test works on files")]

use std::fs;
use std::path::{Path, PathBuf};

use drivewright_codegen::{limits, load};

fn folder(name: &str, files: &[(&str, &[u8])]) -> PathBuf {
    let path = Path::new(env!("CARGO_TARGET_TMPDIR")).join("load").join(name);
    let _ = fs::remove_dir_all(&path);
    fs::create_dir_all(&path).expect("a folder");
    for (name, bytes) in files {
        fs::write(path.join(name), bytes).expect("a file");
    }
    path
}

fn codes(loaded: &load::Loaded) -> Vec<&'static str> {
    loaded.diagnostics.iter().map(|d| d.code.id()).collect()
}

#[test]
fn reads_toml_files_in_name_order_and_names_what_it_read() {
    let folder = folder(
        "order",
        &[("b.toml", b"x = 1\r\n"), ("a.toml", b""), ("notes.md", b"\xFF"), ("c.toml.orig", b"")],
    );
    fs::create_dir(folder.join("deeper.toml")).expect("a folder that looks like a file");
    let loaded = load::folder(&folder);
    assert_eq!(codes(&loaded), Vec::<&str>::new());
    let paths: Vec<&str> = loaded.sources.iter().map(|s| s.path.as_str()).collect();
    assert_eq!(paths, ["a.toml", "b.toml"]);
    assert_eq!(loaded.read, [folder.clone(), folder.join("a.toml"), folder.join("b.toml")]);
}

#[test]
fn what_cannot_be_read_is_a_finding() {
    assert_eq!(codes(&load::folder(&folder("x", &[]).join("not-there"))), ["E0001"]);
    assert_eq!(codes(&load::folder(&folder("empty", &[]))), ["E0001"]);
    let loaded = load::folder(&folder("bytes", &[("a.toml", b"a = \"\xFC\""), ("b.toml", b"")]));
    assert_eq!(codes(&loaded), ["E0003"]);
    assert!(loaded.diagnostics[0].message.contains("byte 5"), "{}", loaded.diagnostics[0].message);
    assert_eq!(loaded.sources.len(), 1, "the other file is still read");
}

/// Reading a pipe that nobody writes to would wait for ever.
#[cfg(unix)]
#[test]
fn what_is_no_file_is_refused() {
    let folder = folder("pipe", &[("b.toml", b"")]);
    let made = std::process::Command::new("mkfifo").arg(folder.join("a.toml")).status();
    assert!(made.expect("mkfifo").success());
    let loaded = load::folder(&folder);
    assert_eq!(codes(&loaded), ["E0009"]);
    assert_eq!(loaded.sources.len(), 1, "the other file is still read");
}

#[test]
fn a_file_that_is_too_large_is_not_read() {
    let folder = folder("large", &[]);
    let file = fs::File::create(folder.join("a.toml")).expect("a file");
    file.set_len(u64::try_from(limits::FILE_BYTES).expect("a length") + 1).expect("a length");
    let loaded = load::folder(&folder);
    assert_eq!(codes(&loaded), ["E0002"]);
    assert!(loaded.sources.is_empty());
}

#[test]
fn too_many_files_are_refused() {
    let folder = folder("many", &[]);
    for n in 0..=limits::FILES {
        fs::write(folder.join(format!("{n}.toml")), "").expect("a file");
    }
    assert_eq!(codes(&load::folder(&folder)), ["E0004"]);
}

#[cfg(unix)]
#[test]
fn links_that_lead_out_are_refused_and_those_that_stay_are_not() {
    let (folder, outside) =
        (folder("links", &[("a.toml", b"")]), folder("outside", &[("secret.toml", b"x = 1")]));
    std::os::unix::fs::symlink(outside.join("secret.toml"), folder.join("b.toml")).expect("a link");
    std::os::unix::fs::symlink(folder.join("a.toml"), folder.join("c.toml")).expect("a link");
    std::os::unix::fs::symlink(folder.join("nowhere"), folder.join("d.toml")).expect("a link");
    let loaded = load::folder(&folder);
    assert_eq!(codes(&loaded), ["E0005", "E0001"]);
    assert_eq!(loaded.sources.len(), 2);
}
