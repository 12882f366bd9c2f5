//! `explain`: what the code of a finding means, and what a drive's profile knows of what the drive shows.

use drivewright_codegen::backend::docs;
use drivewright_codegen::check::LINTS;
use drivewright_codegen::diag::page;

use crate::End;
use crate::commands::plain_codes;
use crate::drives::find;
use crate::output::{print, tell};

/// Explains the code `of`, or `what` of the drive `of`.
pub(crate) fn run(of: &str, what: &[String]) -> End {
    if what.is_empty() { code(of) } else { drive(of, &what.join(" ")) }
}

fn code(wanted: &str) -> End {
    let wanted = wanted.to_ascii_uppercase();
    if let Some(lint) = LINTS.iter().find(|l| l.code.id() == wanted) {
        return print(lint.page);
    }
    if let Some(text) = plain_codes().find(|c| c.id() == wanted).and_then(page::text) {
        return print(&text);
    }
    tell!("error: there is no code `{wanted}`; `drivewright lints` lists them");
    End::Usage
}

fn drive(named: &str, what: &str) -> End {
    let found = match find(named) {
        Ok(found) => found,
        Err(end) => return end,
    };
    let Some(text) = found.compiled.sound().and_then(|model| docs::explain(model, what)) else {
        tell!(
            "error: the profile of {} knows nothing of `{}`; ask for {}",
            found.id,
            what.escape_debug(),
            docs::ASKED
        );
        return End::Usage;
    };
    print(&text)
}
