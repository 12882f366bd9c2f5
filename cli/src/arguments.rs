//! The command line.

use std::path::PathBuf;

use clap::{Args, Parser, Subcommand, ValueEnum};
use clap_complete::Shell;

use crate::convert::ConvertArguments;
use crate::demo::DemoArguments;
use crate::simulate::SimulateArguments;

const EXIT_CODES: &str = "\
Exit codes: 0 fine, 1 findings, 2 wrong usage, 3 the disk refused.
Colour is used on a terminal only, and never with NO_COLOR set.";

/// Compiles servo-drive profiles: checks them, builds crates and device files, explains findings.
#[derive(Parser)]
#[command(name = "drivewright", version, after_help = EXIT_CODES)]
pub(crate) struct Arguments {
    /// Say only what is wrong.
    #[arg(short, long, global = true)]
    pub(crate) quiet: bool,
    /// Print for programs: JSON on standard output.
    #[arg(long, global = true)]
    pub(crate) json: bool,
    #[command(subcommand)]
    pub(crate) command: Command,
}

#[derive(Subcommand)]
pub(crate) enum Command {
    /// Checks profiles and reports every finding.
    #[command(after_help = "Examples:\n  drivewright check\n  drivewright check sdv3-e --json\n  \
                            drivewright check profiles/acme/x1 --format github")]
    Check {
        /// Ids of drives below `profiles/`, or profiles' folders; every drive when left out.
        drives: Vec<String>,
        /// How findings are printed.
        #[arg(long, value_enum, default_value_t)]
        format: Format,
    },
    /// Builds a profile into a folder.
    #[command(after_help = "Examples:\n  drivewright build profiles/acme/x1 --out generated/acme-x1\n  \
                            drivewright build profiles/acme/x1 --out out --only eds,json\n  \
                            drivewright build profiles/acme/x1 --out out --check")]
    Build {
        /// Id of a drive below `profiles/`, or the profile's folder.
        drive: String,
        /// The folder to write. Other files in it are left alone.
        #[arg(long)]
        out: PathBuf,
        /// Remove every other file from that folder, so that it holds exactly what is built.
        #[arg(long, conflicts_with = "only")]
        prune: bool,
        /// Build only these formats.
        #[arg(long, value_delimiter = ',', value_parser = formats())]
        only: Vec<String>,
        /// Write nothing; name every missing or changed file, with --prune every other one too, and end with 1 if there is one.
        #[arg(long)]
        check: bool,
        /// Write nothing; show what would change.
        #[arg(long, conflicts_with = "check")]
        diff: bool,
        /// How findings are printed.
        #[arg(long, value_enum, default_value_t)]
        format: Format,
    },
    /// Explains a code of a finding, or what a drive shows: an alarm, an object, a parameter, a homing method, an erratum.
    #[command(after_help = "Examples:\n  drivewright explain E0602\n  drivewright explain sdv3-e 8611h\n  \
                            drivewright explain sdv3-e OF\n  drivewright explain sdv3-e 607D:01\n  \
                            drivewright explain sdv3-e homing 17")]
    Explain {
        /// The code of a finding, such as E0602; or id of a drive below `profiles/`, or the profile's folder.
        of: String,
        /// What to tell of the drive: an error code, a display, an object, a parameter, a method, an erratum, a rule.
        what: Vec<String>,
    },
    /// Proves the facts of a profile against the text extract of a manual.
    #[command(after_help = "Examples:\n  drivewright audit sdv3-e --manual sdv3-e.txt\n  \
                            drivewright audit profiles/acme/x1 --manual x1.txt --contradictions\n  \
                            drivewright audit sdv3-e --manual sdv3-e.txt --record\n  \
                            drivewright audit sdv3-e --manual sdv3-e.txt --json\n\n\
                            The manuals are their makers' and not part of the project. Without --manual the file is\n\
                            DRIVE.txt in the folder that DRIVEWRIGHT_MANUALS names.")]
    Audit(AuditArguments),
    /// Converts profile files between TOML and XML, with row order, number notation and comments.
    #[command(after_help = "Examples:\n  drivewright convert profiles/acme/x1/objects.toml --to xml\n  \
                            drivewright convert objects.xml --to toml --out objects.toml\n  \
                            drivewright convert profiles/acme/x1 --to xml --out x1-xml")]
    Convert(ConvertArguments),
    /// Counts, for each table of a drive, how many rows have which keys.
    #[command(after_help = "Examples:\n  drivewright coverage\n  drivewright coverage sdv3-e --json")]
    Coverage {
        /// Ids of drives below `profiles/`, or profiles' folders; every drive when left out.
        drives: Vec<String>,
    },
    /// Checks a configuration of a drive and writes it as a DCF, or as the list of writes of a master.
    #[command(after_help = "Examples:\n  drivewright dcf sdv3-e --config axis.toml\n  \
                            drivewright dcf profiles/acme/x1 --config axis.toml --out axis.dcf --concise axis.bin\n  \
                            drivewright dcf sdv3-e --config axis.toml --out axis.dcf --check\n\n\
                            profiles/CONFIGURATIONS.md describes the configuration.")]
    Dcf(DcfArguments),
    /// Lists what a profile does not state yet: to enable the drive, to commission an axis, and what would be nice.
    #[command(after_help = "Example:\n  drivewright todo sdv3-e")]
    Todo {
        /// Ids of drives below `profiles/`, or profiles' folders; every drive when left out.
        drives: Vec<String>,
    },
    /// Tells what a revision of a drive means to its users, and which version its crate needs.
    #[command(after_help = DIFF_HELP)]
    Diff(DiffArguments),
    /// Shows a drive without hardware: enabled, homed, run in each mode, made to fault, reset.
    #[command(after_help = crate::demo::HELP)]
    Demo(DemoArguments),
    /// Runs a virtual drive of a profile, commanded by a script or from the terminal.
    #[command(after_help = crate::simulate::HELP)]
    Simulate(SimulateArguments),
    /// Lists every code.
    #[command(after_help = "Examples:\n  drivewright lints\n  drivewright lints --json")]
    Lints,
    /// Prints the schema of profiles, for completion in an editor.
    #[command(after_help = "Examples:\n  drivewright schema > profile.schema.json\n  \
                            drivewright schema --format xsd > profile.xsd\n  \
                            drivewright schema --configuration > configuration.schema.json")]
    Schema {
        /// Print that of configurations. It is a JSON schema.
        #[arg(long, conflicts_with = "format")]
        configuration: bool,
        /// JSON schema for TOML files, XSD for XML files.
        #[arg(long, value_enum, default_value_t)]
        format: SchemaFormat,
    },
    /// Prints a completion script.
    #[command(
        after_help = "Example:\n  drivewright completions bash > ~/.local/share/bash-completion/completions/drivewright"
    )]
    Completions {
        /// The shell.
        shell: Shell,
    },
}

/// What `audit` is asked for.
#[derive(Args)]
#[allow(clippy::struct_excessive_bools, reason = "flags of a command line")]
pub(crate) struct AuditArguments {
    /// Id of a drive below `profiles/`, or the profile's folder.
    pub(crate) drive: String,
    /// The text extract.
    #[arg(long)]
    pub(crate) manual: Option<PathBuf>,
    /// Id of the manual, where the profile has several.
    #[arg(long)]
    pub(crate) id: Option<String>,
    /// List what is printed differently in several places.
    #[arg(long)]
    pub(crate) contradictions: bool,
    /// List what is accepted without proof, too.
    #[arg(long)]
    pub(crate) accepted: bool,
    /// Write the profile's `audit.toml` if nothing is left open.
    #[arg(long)]
    pub(crate) record: bool,
}

/// What `dcf` is asked for.
#[derive(Args)]
pub(crate) struct DcfArguments {
    /// Id of a drive below `profiles/`, or the profile's folder.
    pub(crate) drive: String,
    /// The configuration.
    #[arg(long)]
    pub(crate) config: PathBuf,
    /// The DCF to write. It goes to standard output where neither --out nor --concise is given.
    #[arg(long)]
    pub(crate) out: Option<PathBuf>,
    /// The concise DCF to write: what a master writes, in order, in binary.
    #[arg(long)]
    pub(crate) concise: Option<PathBuf>,
    /// Write nothing; name every missing or changed file and end with 1 if there is one.
    #[arg(long)]
    pub(crate) check: bool,
    /// How findings are printed.
    #[arg(long, value_enum, default_value_t)]
    pub(crate) format: Format,
}

pub(crate) const DIFF_HELP: &str = "\
Examples:
  drivewright diff old/sdv3-e profiles/savch/sdv3-e
  drivewright diff v0.1.0:profiles/savch/sdv3-e sdv3-e
  drivewright diff main:generated/savch-sdv3-e/model.json generated/savch-sdv3-e/model.json
  drivewright diff --base main sdv3-e --fail-on version
  drivewright diff --base origin/main --format markdown

A side is a profile's folder, the id of a drive below `profiles/`, a model.json, or either in a git revision (REV:PATH).
With --base the old side is the drive's model.json below `generated/` in that revision, or its profile where there is none;
without a drive, every drive that differs is shown.
A difference is no finding: the exit code is 0 unless --fail-on finds what it is asked for, then 1.";

/// What `diff` is asked for.
#[derive(Args)]
pub(crate) struct DiffArguments {
    /// OLD and NEW; with --base, ids or folders of drives.
    #[arg(value_name = "SIDE")]
    pub(crate) sides: Vec<String>,
    /// Compare with this git revision.
    #[arg(long, value_name = "REV")]
    pub(crate) base: Option<String>,
    /// How the differences are printed. `--json` is short for `--format json`.
    #[arg(long, value_enum, default_value_t)]
    pub(crate) format: DiffFormat,
    /// End with 1 if there is a difference of this kind.
    #[arg(long, value_enum, value_name = "WHAT")]
    pub(crate) fail_on: Option<FailOn>,
}

/// How differences are printed.
#[derive(Clone, Copy, Default, PartialEq, Eq, ValueEnum)]
pub(crate) enum DiffFormat {
    /// For people.
    #[default]
    Text,
    /// For a comment of a pull request, at most 65,000 bytes.
    Markdown,
    /// One JSON object.
    Json,
}

/// Which differences are findings.
#[derive(Clone, Copy, PartialEq, Eq, ValueEnum)]
pub(crate) enum FailOn {
    /// What breaks code.
    Breaking,
    /// What breaks code or moves an axis.
    Axis,
    /// Every difference.
    Any,
    /// A crate version that was not raised enough.
    Version,
}

/// How findings are printed. `--json` is short for `--format json`.
#[derive(Clone, Copy, Default, PartialEq, Eq, ValueEnum)]
pub(crate) enum Format {
    /// For people.
    #[default]
    Human,
    /// One JSON object a line, on standard output.
    Json,
    /// GitHub workflow commands, on standard output.
    Github,
}

/// A language of schemas.
#[derive(Clone, Copy, Default, ValueEnum)]
pub(crate) enum SchemaFormat {
    /// JSON schema, draft 7.
    #[default]
    Json,
    /// XML schema 1.0.
    Xsd,
}

fn formats() -> clap::builder::PossibleValuesParser {
    drivewright_codegen::backend::ALL.iter().map(|b| b.id()).collect::<Vec<_>>().into()
}
