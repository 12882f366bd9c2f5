//! What is fuzzed: functions of bytes that panic where a promise of the compiler is broken.

use drivewright_codegen::backend::{self, Backend};
use drivewright_codegen::diag::{github, json, render};
use drivewright_codegen::source::Source;
use drivewright_codegen::{Compiled, compile, emit, limits};

use crate::judge::judge;

/// What an input led to: a fuzzer that reaches nothing is one that finds nothing.
#[derive(Clone, Default, Debug)]
pub struct Reached {
    /// Codes of the findings.
    pub codes: Vec<&'static str>,
    /// Whether the model was sound.
    pub sound: bool,
}

/// A function that panics where something is wrong.
pub type Function = Box<dyn Fn(&[u8]) -> Reached + Send + Sync>;

/// What a target is fed with.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Kind {
    /// Texts that are nearly a profile.
    Text,
    /// Bytes that stand for decisions.
    Bytes,
}

/// A function with its name.
pub struct Target {
    /// `parse_profile`, `emit_rust`, `client.step`.
    pub name: String,
    /// What it is fed with.
    pub kind: Kind,
    /// The function.
    pub function: Function,
}

/// `parse_profile`, and `emit_<id>` for every backend.
pub fn targets() -> Vec<Target> {
    let parse = Target { name: "parse_profile".into(), kind: Kind::Text, function: Box::new(parse_profile) };
    let emits = backend::ALL.iter().map(|backend| Target {
        name: format!("emit_{}", backend.id()),
        kind: Kind::Text,
        function: Box::new(|bytes| emitted(bytes, *backend)),
    });
    [parse].into_iter().chain(emits).collect()
}

/// Those of the compiler and those of the runtime.
pub fn all() -> Vec<Target> {
    targets().into_iter().chain(crate::behaviour::targets()).collect()
}

/// The files of an input: a zero byte is between two. XML begins with `<`, TOML does not.
pub fn sources(bytes: &[u8]) -> Vec<Source> {
    let file = |(n, part): (usize, &[u8])| {
        let text = String::from_utf8_lossy(part).into_owned();
        let end =
            if text.trim_start_matches('\u{FEFF}').trim_start().starts_with('<') { "xml" } else { "toml" };
        Source { path: format!("f{n}.{end}"), text }
    };
    bytes.split(|b| *b == 0).take(limits::FILES).enumerate().map(file).collect()
}

/// Reads, merges, resolves and checks; every finding can be shown in every form.
pub fn parse_profile(bytes: &[u8]) -> Reached {
    let compiled = compile(sources(bytes));
    let Compiled { diagnostics, sources, .. } = &compiled;
    // One more of each severity says that there are more.
    assert!(diagnostics.len() <= 2 * limits::FINDINGS + 2, "{} findings", diagnostics.len());
    // All say the same; showing thousands would be all that a run does.
    let some = &diagnostics[..diagnostics.len().min(4)];
    let shown = render::text(some, sources, render::Style::default());
    let lines = json::lines(some, sources, "") + &github::commands(some, sources, "");
    for text in shown.lines().chain(lines.lines()) {
        assert!(!text.contains(['\0', '\u{1B}', '\u{202E}']), "a finding shows a hidden character: {text:?}");
    }
    for line in json::lines(some, sources, "").lines() {
        judge("finding.json", line.as_bytes()).unwrap_or_else(|why| panic!("{why}: {line}"));
    }
    reached(&compiled)
}

/// A sound model can be emitted, and every file is what its name promises.
fn emitted(bytes: &[u8], backend: &dyn Backend) -> Reached {
    let compiled = compile(sources(bytes));
    let mut reached = reached(&compiled);
    let Some(model) = compiled.sound() else { return reached };
    let (files, losses) = emit(model, &[backend]);
    reached.codes.extend(losses.iter().map(|d| d.code.id()));
    for (path, text) in files.iter() {
        judge(path.as_str(), text).unwrap_or_else(|why| panic!("{path}: {why}"));
    }
    reached
}

fn reached(compiled: &Compiled) -> Reached {
    let codes = compiled.diagnostics.iter().map(|d| d.code.id()).collect();
    Reached { codes, sound: compiled.sound().is_some() }
}
