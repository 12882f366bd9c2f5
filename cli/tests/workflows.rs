//! The workflows for a code host: they parse, what they call is there, and nobody's code meets a token that can write.

#![allow(clippy::expect_used, clippy::panic, clippy::disallowed_methods, reason = "a test reads files")]

use std::path::Path;
use std::process::Command;

use yaml_rust2::{Yaml, YamlLoader};

/// Every workflow: its name and what it says.
fn workflows() -> Vec<(String, Yaml)> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../.github/workflows");
    let mut found = Vec::new();
    for entry in std::fs::read_dir(folder).expect("a folder").map(|e| e.expect("an entry").path()) {
        let name = entry.file_name().expect("a name").to_string_lossy().into_owned();
        let text = std::fs::read_to_string(&entry).expect("a text");
        let mut documents = YamlLoader::load_from_str(&text).unwrap_or_else(|e| panic!("{name}: {e}"));
        assert_eq!(documents.len(), 1, "{name}");
        found.push((name, documents.remove(0)));
    }
    found.sort_by(|a, b| a.0.cmp(&b.0));
    found
}

/// Every step of every job.
fn steps(workflow: &Yaml) -> Vec<&Yaml> {
    let jobs = workflow["jobs"].as_hash().expect("jobs");
    jobs.values().flat_map(|job| job["steps"].as_vec().expect("steps")).collect()
}

fn named(wanted: &str) -> Yaml {
    workflows().into_iter().find(|(name, _)| name == wanted).expect("the workflow").1
}

fn is_pinned(action: &str) -> bool {
    action.split_once('@').is_some_and(|(_, at)| at.len() == 40 && at.bytes().all(|b| b.is_ascii_hexdigit()))
}

#[test]
fn actions_are_pinned_to_commits() {
    assert!(is_pinned(&format!("a/b@{}", "0f".repeat(20))) && !is_pinned("a/b@v4") && !is_pinned("a/b"));
    for (name, workflow) in workflows() {
        for action in steps(&workflow).iter().filter_map(|step| step["uses"].as_str()) {
            assert!(is_pinned(action), "{name}: {action}");
        }
    }
}

/// Whether any permission of a workflow or of one of its jobs lets it write; one that names none may have all.
fn writes(workflow: &Yaml) -> bool {
    let jobs = workflow["jobs"].as_hash().expect("jobs").values();
    let can = |permissions: &Yaml| match permissions {
        Yaml::Hash(all) => all.values().any(|level| level.as_str() == Some("write")),
        Yaml::BadValue => false,
        _ => true,
    };
    workflow["permissions"].is_badvalue()
        || can(&workflow["permissions"])
        || jobs.into_iter().any(|j| can(&j["permissions"]))
}

#[test]
fn what_runs_the_code_of_a_pull_request_cannot_write() {
    for (name, workflow) in workflows() {
        let on = &workflow["on"];
        assert!(on["pull_request_target"].is_badvalue(), "{name} gives a token to code of a fork");
        if !on["pull_request"].is_badvalue() {
            assert!(!writes(&workflow), "{name} can write");
        }
        if !on["workflow_run"].is_badvalue() {
            assert!(steps(&workflow).iter().all(|step| step["uses"].is_badvalue()), "{name} fetches code");
            let runs = steps(&workflow).into_iter().filter_map(|step| step["run"].as_str());
            assert!(runs.into_iter().all(|run| !run.contains("${{")), "{name}: a text of others in a script");
        }
    }
    let open = "on: { pull_request: ~ }\njobs: { a: { permissions: { contents: write }, steps: [] } }";
    assert!(writes(&YamlLoader::load_from_str(open).expect("YAML")[0]), "the check sees nothing");
}

#[test]
fn the_two_parts_belong_together() {
    let (first, second) = (named("drive-revisions.yml"), named("drive-revisions-comment.yml"));
    assert_eq!(second["on"]["workflow_run"]["workflows"][0].as_str(), first["name"].as_str());
    let upload = steps(&first)
        .into_iter()
        .find(|s| s["with"]["name"].as_str() == Some("drives"))
        .expect("an artifact");
    let file = upload["with"]["path"].as_str().expect("a file");
    let script = steps(&second)[0]["run"].as_str().expect("a script");
    assert!(script.contains("--name drives") && script.contains(&format!("found/{file}")));
}

/// Each line that calls drivewright is one that the program takes: asked for help, it ends with 0.
#[test]
fn what_is_called_is_there() {
    let mut called = 0;
    for (name, workflow) in workflows() {
        for run in steps(&workflow).iter().filter_map(|step| step["run"].as_str()) {
            for line in run.lines().filter_map(|l| l.split_once("-p drivewright -- ")) {
                called += 1;
                let arguments: Vec<&str> =
                    line.1.split_whitespace().take_while(|word| *word != ">").collect();
                let takes = |more: &str| {
                    let mut program = Command::new(env!("CARGO_BIN_EXE_drivewright"));
                    program.args(&arguments).arg(more).output().expect("the program runs").status.code()
                };
                assert_eq!(takes("--help"), Some(0), "{name}: {arguments:?}");
                assert_eq!(takes("--no-such-flag"), Some(2), "{name}: {arguments:?}");
            }
        }
    }
    assert!(called >= 2, "nothing was looked at");
}
