//! E1402: a command is not given by the bits of its mask, or is the same as another one.

use crate::check::Lint;
use crate::diag::{Code, Sink};
use crate::model::{Command, Model};

const CODE: Code =
    Code::error("E1402", "a command is not given by the bits of its mask, or is the same as another one");
const WHY: &str = "a client sets the bits of the mask and leaves the others alone: bits outside are never written, and a drive cannot tell two equal commands apart";
const HELP: &str = "compare mask and value bit by bit with the manual; of two commands with the same bits the transitions must differ";

/// Compares mask and value of each command, and the commands with each other.
pub(in crate::check) const LINT: Lint = Lint { code: CODE, page: include_str!("commands_fit.md"), run };

fn run(model: &Model, sink: &mut Sink) {
    let commands: Vec<&Command> =
        model.commands.iter().filter(|c| !super::settled(&c.mask) && !super::settled(&c.value)).collect();
    for (n, command) in commands.iter().enumerate() {
        let (mask, value, name) = (command.mask.value, command.value.value, &command.name.value);
        let text = if value & !mask != 0 {
            format!("`command {name}` sets {value:04X}h, which is not inside its mask {mask:04X}h")
        } else if let Some(other) = commands[..n].iter().find(|other| same(other, command)) {
            format!("`command {name}` has bits and transitions of {}", other.name.value)
        } else {
            continue;
        };
        sink.push(super::finding(CODE, command.value.span(), &format!("command {name}"), text, WHY, HELP));
    }
}

/// Whether nothing tells two commands apart.
fn same(a: &Command, b: &Command) -> bool {
    a.mask == b.mask && a.value == b.value && a.transitions == b.transitions
}
