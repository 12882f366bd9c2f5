//! Makes the folder of a new drive. It compiles at once and states nothing: what is not in it is listed.

use std::path::Path;
use std::time::{SystemTime, UNIX_EPOCH};

use drivewright_codegen::facts::facts;
use drivewright_codegen::source::Source;
use drivewright_codegen::todo::{Priority, todo};
use drivewright_codegen::{compile, sink};

use crate::{End, Options};

/// File, tables, what goes there.
#[rustfmt::skip]
const FILES: &[(&str, &[&str], &str)] = &[
    ("objects.toml", &["objects"], "The object dictionary, in its order. Values are raw counts; what the manual does not print is left out.\n# { at = \"2000:00\", name = \"As printed\", type = \"u16\", access = \"rw\", pdo = \"rx\", unit = \"0.1 rpm\", min = 0, max = 1, default = 0, src = \"SECTION TTABLE LLINE\" }"),
    ("enums.toml", &["enums"], "Names of values: `values` of an object names the table."),
    ("bits.toml", &["bits"], "Names of bits: `bits` of an object names the table; with `mode` where the mode decides."),
    ("alarms.toml", &["alarms"], "Faults and warnings. Display and number together tell them apart; causes and remedies in words of your own."),
    ("pdo.toml", &["pdo"], "Process data as the drive ships, one mapped entry a row."),
    ("modes.toml", &["modes"], "Modes of operation, with the objects that the section of each lists."),
    ("states.toml", &["states", "commands"], "The state machine: the statusword under `mask` is `value`; so is the controlword of a command."),
    ("homing.toml", &["homing"], "Homing methods, one case a row, in the language of profiles/README.md."),
    ("bus.toml", &["aborts", "emcy", "sync_managers", "fmmus", "ethercat", "coe", "dc_modes", "startup"], "Abort codes, the emergency message, the EtherCAT side."),
    ("io.toml", &["io"], "Terminals."),
    ("rules.toml", &["rules", "examples"], "What must hold between values, and worked examples of the manual."),
    ("errata.toml", &["errata"], "Where the manual is wrong or contradicts itself: the row says what is printed, the erratum why it is not so."),
    ("allow.toml", &["allow"], "Findings of lints that are accepted, each with its reason."),
    ("reading.toml", &["columns", "printed", "shifted", "unproved", "uncited"], "How the tables of the manual are read, for `drivewright audit`."),
];

/// Makes `profiles/<vendor>/<drive>`.
pub fn run(root: &Path, options: &Options) -> End {
    let [named] = options.drives.as_slice() else {
        eprintln!("error: name the drive: cargo xtask new VENDOR/DRIVE");
        return End::Usage;
    };
    let (vendor, drive) = match named.split_once('/') {
        Some((vendor, drive)) if is_id(vendor) && is_id(drive) && vendor != "standard" => (vendor, drive),
        _ => {
            eprintln!(
                "error: `{named}` is no VENDOR/DRIVE\nnote: both become names of folders and crates, and `standard` is taken\n\
                 help: use lower-case letters, digits and `-`, and start with a letter"
            );
            return End::Usage;
        }
    };
    let folder = root.join("profiles").join(vendor).join(drive);
    if folder.exists() {
        eprintln!("error: profiles/{named} is there already");
        return End::Usage;
    }
    write(&folder, &files(vendor, drive), named)
}

/// As ids of profiles are.
fn is_id(text: &str) -> bool {
    text.len() <= 64
        && text.starts_with(|c: char| c.is_ascii_lowercase())
        && text.bytes().all(|b| b.is_ascii_lowercase() || b.is_ascii_digit() || b == b'-')
}

fn files(vendor: &str, drive: &str) -> Vec<Source> {
    let table = |(path, tables, what): &(&str, &[&str], &str)| {
        let lists: Vec<String> = tables.iter().map(|name| format!("{name} = [\n]\n")).collect();
        Source { path: (*path).to_owned(), text: format!("# {what}\n{}", lists.join("")) }
    };
    let first = Source { path: "drive.toml".to_owned(), text: drive_toml(vendor, drive) };
    std::iter::once(first).chain(FILES.iter().map(table)).collect()
}

fn drive_toml(vendor: &str, drive: &str) -> String {
    format!(
        "# The drive, and the manuals that its facts cite. What is not stated yet: `drivewright todo {drive}`.\n\
         # SHA-256 and lines are those of the text extract whose lines are cited.\n\
         # {{ id = \"m1\", title = \"As printed\", version = \"As printed\", date = \"As printed\", sha256 = \"\", lines = 0 }}\n\
         manuals = [\n]\n\n\
         [drive]\nformat = 1\nid = \"{drive}\"\n# As printed.\nvendor = \"{vendor}\"\nvendor_id = \"{vendor}\"\n\
         # As printed.\nname = \"{drive}\"\n# Add \"coe\" for an EtherCAT drive.\nbases = [\"cia301\", \"cia402\"]\n\
         crate_version = \"0.1.0\"\neds_version = 1\neds_revision = 0\ndate = \"{}\"\n",
        today()
    )
}

/// The date in UTC, by the civil calendar: days are counted in years that begin in March, so that a leap day is the last.
fn today() -> String {
    let seconds = SystemTime::now().duration_since(UNIX_EPOCH).map_or(0, |d| d.as_secs());
    civil(seconds / 86_400)
}

fn civil(days: u64) -> String {
    let days = days + 719_468;
    let (era, day) = (days / 146_097, days % 146_097);
    let year = (day - day / 1_460 + day / 36_524 - day / 146_096) / 365;
    let day = day - (365 * year + year / 4 - year / 100);
    let month = (5 * day + 2) / 153;
    let (date, from_march) = (day - (153 * month + 2) / 5 + 1, month < 10);
    let month = if from_march { month + 3 } else { month - 9 };
    format!("{:04}-{month:02}-{date:02}", era * 400 + year + u64::from(!from_march))
}

fn write(folder: &Path, files: &[Source], named: &str) -> End {
    let compiled = compile(files.to_vec());
    let Some(model) = compiled.sound() else {
        eprintln!(
            "error: the new profile does not compile; this is an error of xtask: {:#?}",
            compiled.diagnostics
        );
        return End::Findings;
    };
    let items = todo(&facts(model));
    if let Err(error) = std::fs::create_dir_all(folder) {
        eprintln!("error: {error}");
        return End::Disk;
    }
    for file in files {
        if let Err(error) = sink::write_file(&folder.join(&file.path), file.text.as_bytes()) {
            eprintln!("error: {error}");
            return End::Disk;
        }
    }
    println!("made profiles/{named}: {} files, no fact yet. Not stated:", files.len());
    for priority in Priority::ALL {
        println!("{}", priority.word());
        for item in items.iter().filter(|item| item.priority == priority) {
            println!("  {} ({})", item.what, item.why);
        }
    }
    println!("next: transcribe a table, `cargo xtask regen`; `drivewright todo` lists again what is left");
    End::Fine
}

#[cfg(test)]
mod tests {
    use super::*;
    use drivewright_codegen::rows::Rows;

    #[test]
    fn every_table_has_a_file() {
        // `drive` and `manuals` are in drive.toml; the audit writes `audited`.
        let own = ["drive", "manuals", "audited"];
        let placed: Vec<&str> = FILES.iter().flat_map(|(_, tables, _)| *tables).copied().chain(own).collect();
        let missing: Vec<&str> =
            Rows::TABLES.iter().map(|t| t.name).filter(|t| !placed.contains(t)).collect();
        assert_eq!(missing, Vec::<&str>::new());
        assert_eq!(placed.len(), Rows::TABLES.len());
    }

    /// Days since 1970-01-01: the epoch, a leap day, the day after one, the last of a year.
    #[test]
    fn dates() {
        for (days, date) in
            [(0, "1970-01-01"), (11_016, "2000-02-29"), (11_017, "2000-03-01"), (20_818, "2026-12-31")]
        {
            assert_eq!(civil(days), date);
        }
    }
}
