//! Compiles the profile into this crate.

fn main() {
    drivewright_codegen::build("../../profiles/savch/sdv3-e");
}
