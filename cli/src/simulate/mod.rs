//! `simulate`: a virtual drive of any profile, commanded by a script or from a terminal.

mod faults;

mod script;
mod session;
mod state;
mod words;

use std::io::{IsTerminal, Write, stdin};
use std::path::{Path, PathBuf};

use clap::Args;
use drivewright_codegen::emit::escape;
use drivewright_runtime::sim::Config;
use serde_json::json;

use crate::End;
use crate::drives::find;
use crate::output::{Shape, counted, disk, print, tell, tell_all};
use crate::stage::{self, Pace, Recorder, TraceFiles, Watched};
use crate::trace;
use script::Command;
use session::{Failed, Session};

/// Examples, and what a script looks like.
pub(crate) const HELP: &str = "\
Examples:
  drivewright simulate sdv3-e
  drivewright simulate sdv3-e --script enable.txt --plot enable.svg
  echo 'run 200ms' | drivewright simulate profiles/acme/x1 --trace --quiet
  drivewright simulate sdv3-e --script enable.txt --speed real --json

A script has a command a line; `help` is one of them and lists the others. SDO transfers take a millisecond.
  run 200ms                          # the drive starts up
  write 6040:00 0x06
  until 6041:00 & 0x6F == 0x21 within 50ms
  refused 06090030h write 6060:00 2  # a mode that the drive does not have
The exit code is 1 where the drive refuses something or is not as expected, 2 where the script cannot be read.";

/// What `simulate` is asked for.
#[derive(Args)]
pub(crate) struct SimulateArguments {
    /// Id of a drive below `profiles/`, or the profile's folder.
    pub(crate) drive: String,
    /// The script. Without it commands come from standard input, one a line.
    #[arg(long, value_name = "FILE")]
    pub(crate) script: Option<PathBuf>,
    /// How fast time goes: max, real, or a number of virtual seconds a second.
    #[arg(long, value_name = "SPEED", default_value = "max", value_parser = Pace::read)]
    pub(crate) speed: Pace,
    /// Print the trace at the end: what changed, and when.
    #[arg(long)]
    pub(crate) trace: bool,
    #[command(flatten)]
    pub(crate) files: TraceFiles,
}

/// A line with a command.
struct Line {
    number: usize,
    text: String,
    command: Command,
}

/// Runs the command.
pub(crate) fn run(asked: &SimulateArguments, shape: Shape) -> End {
    let found = match find(&asked.drive) {
        Ok(found) => found,
        Err(end) => return end,
    };
    let typed = asked.script.is_none() && stdin().is_terminal();
    let lines = match if typed { Ok(Vec::new()) } else { script(asked.script.as_deref()) } {
        Ok(lines) => lines,
        Err(end) => return end,
    };
    let config = Config::default();
    let ran = stage::with(&found, config, |_, drive| {
        let recorder = Recorder::new(drive.model(), stage::title(&found), asked.speed);
        if !shape.quiet {
            tell_all(&format!(
                "{}. Where manuals are silent, it assumes:\n{}",
                recorder.trace.title,
                stage::assumptions()
            ));
        }
        let mut bus = Watched::new(drive, config.cycle, recorder);
        bus.look();
        let mut session = Session::new(&mut bus, config.cycle);
        let end = if typed { converse(&mut session, shape) } else { follow(&mut session, &lines, shape) };
        let trace = &bus.recorder.trace;
        let told = if asked.trace {
            print(&if shape.json { trace::json_lines(trace) } else { trace::text(trace) })
        } else {
            End::Fine
        };
        end.max(told).max(asked.files.write(trace))
    });
    ran.unwrap_or_else(|end| end)
}

/// The lines of a script. All that is wrong is said at once.
fn script(place: Option<&Path>) -> Result<Vec<Line>, End> {
    let name = place.map_or("standard input".to_owned(), |place| place.display().to_string());
    let text = match place {
        Some(place) => std::fs::read_to_string(place),
        None => std::io::read_to_string(stdin()),
    };
    let text = text.map_err(|error| disk(&format!("{name}: {error}")))?;
    let mut lines = Vec::new();
    let mut wrong = 0;
    for (number, text) in (1..).zip(text.lines()) {
        match script::command(text) {
            Ok(Some(command)) => lines.push(Line { number, text: text.trim().to_owned(), command }),
            Ok(None) => {}
            Err(refused) => {
                wrong += 1;
                tell!("error: {name}, line {number}: {}; {}", refused.what, refused.help);
            }
        }
    }
    if wrong == 0 {
        return Ok(lines);
    }
    tell!("{} of the script cannot be read; nothing was run", counted(wrong, "line"));
    Err(End::Usage)
}

/// Executes a script up to its end, or to the first line that fails.
fn follow(session: &mut Session<'_, '_, '_, '_>, lines: &[Line], shape: Shape) -> End {
    for line in lines {
        if line.command == Command::Quit {
            break;
        }
        let said = session.execute(&line.command);
        let end = say(session, Some(line.number), &line.text, &said, shape);
        if end != End::Fine {
            return end;
        }
    }
    End::Fine
}

/// Asks for commands on a terminal until there are no more.
fn converse(session: &mut Session<'_, '_, '_, '_>, shape: Shape) -> End {
    tell!("`help` lists the commands, `quit` ends.");
    loop {
        let clock = session.clock();
        tell_all(&format!("{clock} ms> "));
        let _ = std::io::stderr().flush();
        let mut line = String::new();
        match stdin().read_line(&mut line) {
            Ok(0) => return End::Fine,
            Err(error) => return disk(&error),
            Ok(_) => {}
        }
        match script::command(&line) {
            Ok(Some(Command::Quit)) => return End::Fine,
            Ok(Some(command)) => {
                let said = session.execute(&command);
                let _ = say(session, None, line.trim(), &said, shape);
            }
            Ok(None) => {}
            Err(refused) => tell!("{}; {}", refused.what, refused.help),
        }
    }
}

/// Prints what a command has to say, and tells what failed.
fn say(
    session: &mut Session<'_, '_, '_, '_>,
    number: Option<usize>,
    command: &str,
    said: &Result<String, Failed>,
    shape: Shape,
) -> End {
    let clock = session.clock();
    let (text, fine) = match said {
        Ok(text) => (text.as_str(), true),
        Err(failed) => (failed.text(), false),
    };
    if shape.json {
        let object =
            json!({ "line": number, "command": command, "at_ms": clock, "fine": fine, "said": text });
        let printed = print(&format!("{}\n", escape::json(&object.to_string())));
        return if fine { printed } else { printed.max(End::Findings) };
    }
    if !fine {
        let place = number.map(|n| format!("line {n}, ")).unwrap_or_default();
        tell!("error: {place}{clock} ms, `{}`: {}", escape::visible(command), escape::visible(text));
        return End::Findings;
    }
    if text.is_empty() {
        return End::Fine;
    }
    // The time once, before the first line.
    let time = format!("{clock:>9} ms  ");
    let rest = " ".repeat(time.len());
    let starts = std::iter::once(&time).chain(std::iter::repeat(&rest));
    let lines = text.lines().zip(starts).map(|(line, start)| format!("{start}{}\n", escape::visible(line)));
    print(&lines.collect::<String>())
}
