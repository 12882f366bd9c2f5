//! The bugs that are known: patches, and the table that lists all of them.

use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};

/// How many bugs the table has.
const BUGS: u32 = 45;

/// A bug that can be put back.
#[derive(Debug)]
pub struct Mutant {
    /// `b04`.
    pub bug: String,
    /// `b04-resumes-by-itself`.
    pub name: String,
    /// Test targets that may see it.
    pub targets: Vec<String>,
    pub path: PathBuf,
}

/// Every patch of the folder, by name.
pub fn read(folder: &Path) -> Result<Vec<Mutant>, String> {
    let entries = fs::read_dir(folder).map_err(|e| format!("{}: {e}", folder.display()))?;
    let mut paths: Vec<PathBuf> = entries.filter_map(|e| Some(e.ok()?.path())).collect();
    paths.retain(|path| path.extension().is_some_and(|e| e == "patch"));
    paths.sort();
    paths.iter().map(|path| mutant(path)).collect()
}

fn mutant(path: &Path) -> Result<Mutant, String> {
    let text = fs::read_to_string(path).map_err(|e| format!("{}: {e}", path.display()))?;
    let name = path.file_stem().unwrap_or_default().to_string_lossy().into_owned();
    let bug = name.split('-').next().unwrap_or_default().to_owned();
    let number = bug.strip_prefix('b').and_then(|n| n.parse::<u32>().ok());
    if bug.len() != 3 || !number.is_some_and(|n| (1..=BUGS).contains(&n)) {
        return Err(format!("{name}: its name is to begin with the number of a bug, b01 to b{BUGS}"));
    }
    let tests = text.lines().find_map(|line| line.strip_prefix("tests: "));
    let targets = tests.unwrap_or_default().split_whitespace().map(str::to_owned).collect::<Vec<_>>();
    if targets.is_empty() {
        return Err(format!("{name}: it lacks a line `tests: TARGET`"));
    }
    Ok(Mutant { bug, name, targets, path: path.to_owned() })
}

/// The table has a row for each bug, with its patches and no others.
pub fn agree(folder: &Path, mutants: &[Mutant]) -> Result<(), String> {
    let path = folder.join("README.md");
    let text = fs::read_to_string(&path).map_err(|e| format!("{}: {e}", path.display()))?;
    disagreements(&text, mutants).map_or(Ok(()), |why| Err(format!("tests/mutants/README.md: {why}")))
}

fn disagreements(text: &str, mutants: &[Mutant]) -> Option<String> {
    for number in 1..=BUGS {
        let Some(row) = text.lines().find(|line| line.starts_with(&format!("| B{number} |"))) else {
            return Some(format!("B{number} has no row"));
        };
        let bug = format!("b{number:02}");
        let named: BTreeSet<&str> =
            row.split('`').filter(|word| word.starts_with(&format!("{bug}-"))).collect();
        let there = mutants.iter().filter(|m| m.bug == bug).map(|m| m.name.as_str()).collect();
        if named != there {
            return Some(format!("the row of B{number} names {named:?}, and there is {there:?}"));
        }
    }
    None
}

#[cfg(test)]
mod tests {
    use super::*;

    fn table(third: &str) -> String {
        let row = |n| format!("| B{n} | {} |\n", if n == 3 { third } else { "does not apply" });
        (1..=BUGS).map(row).collect()
    }

    #[test]
    fn a_table_that_says_something_else_is_refused() {
        let name = "b03-not-modelled".to_owned();
        let mutant = Mutant { bug: "b03".into(), name, targets: Vec::new(), path: PathBuf::new() };
        let mutants = [mutant];
        assert_eq!(disagreements(&table("`b03-not-modelled`"), &mutants), None);
        assert!(disagreements(&table("none"), &mutants).is_some_and(|why| why.contains("B3 names")));
        assert!(disagreements(&table("`b03-other`"), &mutants).is_some());
        assert!(disagreements(&table("`b03-not-modelled` `b03-other`"), &mutants).is_some());
        let short = table("`b03-not-modelled`").replace("| B45 |", "| B46 |");
        assert_eq!(disagreements(&short, &mutants).as_deref(), Some("B45 has no row"));
    }
}
