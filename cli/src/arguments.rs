//! The command line.

use std::path::PathBuf;

use clap::{Args, Parser, Subcommand, ValueEnum};
use clap_complete::Shell;

use crate::convert::ConvertArguments;

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
    #[command(subcommand)]
    pub(crate) command: Command,
}

#[derive(Subcommand)]
pub(crate) enum Command {
    /// Checks a profile and reports every finding.
    #[command(after_help = "Example:\n  drivewright check profiles/savch/sdv3-e --format github")]
    Check {
        /// Id of a drive below `profiles/`, or the profile's folder.
        drive: String,
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
    /// Explains a code: why it is there, an example that fails, one that passes, what to do.
    #[command(after_help = "Example:\n  drivewright explain E0602")]
    Explain {
        /// The code, such as E0602.
        code: String,
    },
    /// Proves the facts of a profile against the text extract of a manual.
    #[command(after_help = "Examples:\n  drivewright audit sdv3-e --manual sdv3-e.txt\n  \
                            drivewright audit profiles/acme/x1 --manual x1.txt --contradictions\n  \
                            drivewright audit sdv3-e --manual sdv3-e.txt --record\n\n\
                            The manuals are their makers' and not part of the project. Without --manual the file is\n\
                            DRIVE.txt in the folder that DRIVEWRIGHT_MANUALS names.")]
    Audit(AuditArguments),
    /// Converts profile files between TOML and XML, with row order, number notation and comments.
    #[command(after_help = "Examples:\n  drivewright convert profiles/acme/x1/objects.toml --to xml\n  \
                            drivewright convert objects.xml --to toml --out objects.toml\n  \
                            drivewright convert profiles/acme/x1 --to xml --out x1-xml")]
    Convert(ConvertArguments),
    /// Counts, for each table of a drive, how many rows have which keys.
    #[command(after_help = "Example:\n  drivewright coverage sdv3-e")]
    Coverage {
        /// Ids of drives below `profiles/`, or profiles' folders; every drive when left out.
        drives: Vec<String>,
        /// Print the result as one JSON object.
        #[arg(long)]
        json: bool,
    },
    /// Lists every code.
    Lints,
    /// Prints the schema of profiles, for completion in an editor.
    #[command(after_help = "Example:\n  drivewright schema --format xsd > profile.xsd")]
    Schema {
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
    /// Print the result as one JSON object.
    #[arg(long)]
    pub(crate) json: bool,
}

/// How findings are printed.
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
