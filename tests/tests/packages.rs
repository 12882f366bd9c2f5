//! Every publishable crate is packed, unpacked outside of the checkout, and the example driver is built and tested there,
//! both ways, from nothing but the packages and its profile.

#![allow(clippy::expect_used, clippy::panic, clippy::disallowed_methods, reason = "a test works on files")]

use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

/// Crate, and its folder in the checkout.
const PACKAGES: &[(&str, &str)] = &[
    ("drivewright-runtime", "runtime"),
    ("drivewright-standard", "profiles/standard"),
    ("drivewright-codegen", "codegen"),
    ("drivewright", "cli"),
    ("savch-sdv3-e", "generated/savch-sdv3-e"),
];
const EXAMPLE: &str = "examples/sdv3-e-driver";
const PROFILE: &str = "profiles/savch/sdv3-e";

/// A folder outside of the checkout that goes when the test ends well.
struct Outside(PathBuf);

impl Outside {
    fn new() -> Self {
        let folder = std::env::temp_dir().join(format!("drivewright-packages-{}", std::process::id()));
        fs::create_dir_all(&folder).expect("a folder");
        Self(folder)
    }
}

fn checkout() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("..").canonicalize().expect("the checkout")
}

fn succeeds(command: &mut Command) {
    // Flags of the surrounding build would build everything anew.
    command.env_remove("RUSTFLAGS").env_remove("CARGO_ENCODED_RUSTFLAGS").env_remove("CARGO_TARGET_DIR");
    let output = command.output().expect("it starts");
    let said = String::from_utf8_lossy(&output.stderr);
    assert!(output.status.success(), "{command:?}\n{}{said}", String::from_utf8_lossy(&output.stdout));
}

/// Packs every crate; gives the folder of the packages.
fn pack(target: &Path) -> PathBuf {
    let mut cargo = Command::new(env!("CARGO"));
    cargo.args(["package", "--offline", "--no-verify", "--allow-dirty", "--quiet"]);
    cargo.args(PACKAGES.iter().flat_map(|(name, _)| ["-p", name]));
    succeeds(cargo.arg("--target-dir").arg(target).current_dir(checkout()));
    target.join("package")
}

/// Unpacks each crate to its folder below `outside`.
fn unpack(packages: &Path, outside: &Path) {
    for (name, folder) in PACKAGES {
        let place = outside.join(folder);
        fs::create_dir_all(&place).expect("a folder");
        let package = packages.join(format!("{name}-{}.crate", env!("CARGO_PKG_VERSION")));
        succeeds(
            Command::new("tar").arg("xzf").arg(package).args(["--strip-components", "1", "-C"]).arg(place),
        );
    }
}

/// Copies what git would take of a folder of sources: all but cargo's own.
fn copy(from: &Path, to: &Path) {
    fs::create_dir_all(to).expect("a folder");
    for entry in fs::read_dir(from).expect("a folder").map(|e| e.expect("an entry")) {
        let place = to.join(entry.file_name());
        if !entry.path().is_dir() {
            fs::copy(entry.path(), place).expect("a copy");
        } else if entry.file_name() != "target" {
            copy(&entry.path(), &place);
        }
    }
}

#[test]
fn the_example_builds_from_the_packages_alone() {
    let outside = Outside::new();
    let packages = pack(&outside.0.join("target"));
    unpack(&packages, &outside.0);
    for folder in [EXAMPLE, PROFILE] {
        copy(&checkout().join(folder), &outside.0.join(folder));
    }
    let mut cargo = Command::new(env!("CARGO"));
    cargo.args(["test", "--quiet", "--offline"]).current_dir(outside.0.join(EXAMPLE));
    for (name, folder) in PACKAGES.iter().filter(|(name, _)| *name != "drivewright") {
        // The packages name each other by version: nothing of this is published yet.
        let place = outside.0.join(folder).display().to_string();
        cargo.arg("--config").arg(format!("patch.crates-io.{name}.path={place:?}"));
    }
    succeeds(&mut cargo);
    fs::remove_dir_all(&outside.0).expect("removed");
}
