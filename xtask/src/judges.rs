//! Foreign programs judge the generated files: the Python ones of `tests/judges`, in an environment of their own.
//!
//! Everything installed is pinned by hash. Without Python, its module venv or a network, the judges are skipped and the
//! reason is said; a package whose hash is wrong is a failure.

use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};
use std::{env, fs};

use crate::Options;
use crate::outcome::Outcome;
use crate::outside;

/// Judges of a kind of file: name of the script, and whether it also takes `model.json`.
type Judges = &'static [(&'static str, bool)];
/// Folder and extension of each kind of file that is judged, with its judges.
const KINDS: &[(&str, &str, Judges)] = &[
    ("eds", "eds", &[("eds_canopen", true), ("eds_dcfchk", false)]),
    ("esi", "xml", &[("esi_model", true)]),
    ("sii", "bin", &[("sii", true), ("sii_ebpfcat", false)]),
];
/// Names the folder with the schemas of ETG.2000: a folder a version, each with an `EtherCATInfo.xsd`.
const SCHEMAS: &str = "ETG_XSD_DIR";
/// What pip installs, in this order, and with which options. The first builds what of the second comes as source.
const PACKAGES: &[(&str, &[&str])] = &[("build.txt", &[]), ("requirements.txt", &["--no-build-isolation"])];
/// What pip says when it cannot reach an index.
const OFFLINE: &[&str] =
    &["NewConnectionError", "ConnectTimeoutError", "ReadTimeoutError", "ProxyError", "NameResolutionError"];

/// Runs every judge over every generated file of its kind. `step` runs and reports one of them.
pub fn run(root: &Path, options: &Options, step: &mut dyn FnMut(&str, &mut dyn FnMut() -> Outcome)) {
    let quiet = options.quiet;
    let judges = root.join("tests/judges");
    let mut python = Err("its packages could not be installed".to_owned());
    step("judges: python packages", &mut || match environment(root, &judges) {
        Ok(found) => {
            python = Ok(found);
            Outcome::Passed
        }
        Err(outcome) => {
            if let Outcome::Skipped(why) = &outcome {
                python = Err(why.clone());
            }
            outcome
        }
    });
    step("schemas", &mut || match &python {
        Ok(python) => ask(python, &judges.join("schemas.py"), root, false, quiet),
        Err(why) => Outcome::Skipped(why.clone()),
    });
    step("XSD of profiles", &mut || match &python {
        Ok(python) => ask(python, &judges.join("profile_xsd.py"), root, false, quiet),
        Err(why) => Outcome::Skipped(why.clone()),
    });
    step("EDS of golden cases", &mut || match &python {
        Ok(python) => ask(python, &judges.join("golden.py"), root, false, quiet),
        Err(why) => Outcome::Skipped(why.clone()),
    });
    step("configurations", &mut || match &python {
        Ok(python) => ask(python, &judges.join("configurations.py"), root, false, quiet),
        Err(why) => Outcome::Skipped(why.clone()),
    });
    step("ESI of golden cases", &mut || match &python {
        Ok(python) => ask(python, &judges.join("esi_model.py"), root, false, quiet),
        Err(why) => Outcome::Skipped(why.clone()),
    });
    step("schemas of ETG.2000", &mut || match &python {
        Ok(_) if env::var_os(SCHEMAS).is_none() => {
            Outcome::Skipped(format!("{SCHEMAS} does not name a folder with the schemas, which are not ours"))
        }
        Ok(python) => ask(python, &judges.join("esi_schema.py"), root, false, quiet),
        Err(why) => Outcome::Skipped(why.clone()),
    });
    for (folder, extension, judging) in KINDS {
        let files = files_of(root, folder, extension);
        if files.is_empty() {
            let reason = format!("there is no {folder}/*.{extension} below generated/");
            step(&format!("judges of {folder}"), &mut || Outcome::Skipped(reason.clone()));
        }
        for file in files {
            let name = file.file_stem().unwrap_or_default().to_string_lossy().into_owned();
            for (judge, with_model) in *judging {
                step(&format!("{judge} {name}"), &mut || match &python {
                    Ok(python) => ask(python, &judges.join(format!("{judge}.py")), &file, *with_model, quiet),
                    Err(why) => Outcome::Skipped(why.clone()),
                });
            }
        }
    }
}

/// Every `generated/<package>/<folder>/*.<extension>`, in path order.
fn files_of(root: &Path, folder: &str, extension: &str) -> Vec<PathBuf> {
    let list = |folder: &Path| -> Vec<PathBuf> {
        let entries = fs::read_dir(folder).into_iter().flatten().flatten();
        entries.map(|entry| entry.path()).collect()
    };
    let files = list(&root.join("generated")).into_iter().flat_map(|package| list(&package.join(folder)));
    let mut files: Vec<PathBuf> =
        files.filter(|file| file.extension().is_some_and(|e| e == extension)).collect();
    files.sort();
    files
}

/// Asks one judge about one file; it prints its findings and what its negative controls saw.
fn ask(python: &Path, judge: &Path, file: &Path, with_model: bool, quiet: bool) -> Outcome {
    let mut command = Command::new(python);
    command.arg(judge).env("PYTHONDONTWRITEBYTECODE", "1").env("PYTHONUTF8", "1").envs(outside::variables());
    if with_model {
        let model = file.parent().and_then(Path::parent).unwrap_or(file).join("model.json");
        if !model.exists() {
            return Outcome::Skipped(format!("there is no {}", model.display()));
        }
        command.arg(model);
    }
    if quiet {
        command.stdout(Stdio::null());
    }
    match command.arg(file).status() {
        Ok(status) if status.success() => Outcome::Passed,
        Ok(status) => Outcome::Failed(format!("{} has findings ({status})", judge.display())),
        Err(error) => Outcome::Failed(format!("{} cannot be started: {error}", python.display())),
    }
}

/// The interpreter of an environment with the packages of `judges`; made anew when their list has changed.
fn environment(root: &Path, judges: &Path) -> Result<PathBuf, Outcome> {
    let folder = root.join("target/judges");
    let (bin, installed) =
        (folder.join(if cfg!(windows) { "Scripts" } else { "bin" }), folder.join("installed.txt"));
    let python = bin.join(if cfg!(windows) { "python.exe" } else { "python" });
    let wanted: Vec<u8> =
        PACKAGES.iter().flat_map(|(list, _)| fs::read(judges.join(list)).unwrap_or_default()).collect();
    if python.exists() && fs::read(&installed).is_ok_and(|found| found == wanted) {
        return Ok(python);
    }
    let system = system_python()?;
    let folder_text = folder.display().to_string();
    said(Command::new(system).args(["-m", "venv", "--clear", &folder_text])).map_err(Outcome::Failed)?;
    for (list, options) in PACKAGES {
        let mut pip = Command::new(&python);
        pip.args(["-m", "pip", "install", "--quiet", "--retries", "2", "--require-hashes"]).args(*options);
        said(pip.arg("-r").arg(judges.join(list))).map_err(unreachable_or_wrong)?;
    }
    fs::write(&installed, wanted).map_err(|e| Outcome::Failed(format!("{}: {e}", installed.display())))?;
    Ok(python)
}

/// Without a network there is nothing to judge with; everything else that pip refuses is wrong.
fn unreachable_or_wrong(says: String) -> Outcome {
    if OFFLINE.iter().any(|word| says.contains(word)) {
        Outcome::Skipped("the package index cannot be reached".to_owned())
    } else {
        Outcome::Failed(says)
    }
}

/// A Python of the system that is new enough and can make environments.
fn system_python() -> Result<&'static str, Outcome> {
    const CHECK: &str =
        "import sys\nassert sys.version_info >= (3, 9), 'it is older than 3.9'\nimport venv, ensurepip";
    let mut reason = "there is no python3".to_owned();
    for name in ["python3", "python"] {
        match Command::new(name).args(["-c", CHECK]).output() {
            Ok(output) if output.status.success() => return Ok(name),
            Ok(output) => reason = format!("{name} is of no use: {}", last_line(&output.stderr)),
            Err(_) => {}
        }
    }
    Err(Outcome::Skipped(reason))
}

/// Runs a command and gives what it says when it fails.
fn said(command: &mut Command) -> Result<(), String> {
    match command.output() {
        Ok(output) if output.status.success() => Ok(()),
        Ok(output) => {
            Err(String::from_utf8_lossy(&[output.stdout, output.stderr].concat()).trim().to_owned())
        }
        Err(error) => Err(format!("{command:?} cannot be started: {error}")),
    }
}

fn last_line(bytes: &[u8]) -> String {
    String::from_utf8_lossy(bytes).trim().lines().last().unwrap_or_default().to_owned()
}
