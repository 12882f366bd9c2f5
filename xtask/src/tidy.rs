//! Checks what no other tool knows.

use std::path::{Path, PathBuf};
use std::process::Command;

use crate::{End, Options};

/// Runs every check.
pub fn run(root: &Path, options: &Options) -> End {
    let files = tracked(root);
    let mut findings = Vec::new();
    for path in &files {
        let Ok(text) = std::fs::read_to_string(root.join(path)) else { continue };
        let name = path.to_string_lossy().replace('\\', "/");
        file(&name, &text, &mut findings);
    }
    for finding in &findings {
        println!("{finding}");
    }
    if !options.quiet {
        println!("tidy: {} files, {} findings", files.len(), findings.len());
    }
    if findings.is_empty() { End::Fine } else { End::Findings }
}

/// What git has or would take.
fn tracked(root: &Path) -> Vec<PathBuf> {
    let args = ["ls-files", "--cached", "--others", "--exclude-standard"];
    let out = Command::new("git").args(args).current_dir(root).output();
    let text = out.map(|o| String::from_utf8_lossy(&o.stdout).into_owned()).unwrap_or_default();
    text.lines().map(PathBuf::from).collect()
}

fn file(name: &str, text: &str, findings: &mut Vec<String>) {
    let rust = name.ends_with(".rs") && !name.starts_with("generated/") && !name.contains("/snapshots/");
    if rust && text.lines().count() > 500 {
        findings.push(format!("{name}: over 500 lines; would two rooms be clearer?"));
    }
    if rust && name.contains("/src/") && !text.starts_with("//!") && !text.starts_with("#!") {
        findings.push(format!("{name}: a module starts with `//!` and says what it is for"));
    }
    if name.ends_with(".snap.new") {
        findings.push(format!("{name}: a snapshot that nobody accepted"));
    }
    for (at, line) in text.lines().enumerate() {
        for path in ["/home/", "/root/", "/tmp/", "/work/"] {
            if line.contains(path) && !name.starts_with("xtask/src/tidy") {
                findings.push(format!("{name}:{}: a path of a machine ({path})", at + 1));
            }
        }
    }
}
