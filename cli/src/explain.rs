//! `explain`: what the code of a finding means, and what a drive's profile knows of what the drive shows.

use std::borrow::Cow;

use drivewright_codegen::backend::docs;
use drivewright_codegen::check::LINTS;
use drivewright_codegen::diag::{Code, page};
use serde_json::{Value, json};

use crate::End;
use crate::commands::plain_codes;
use crate::drives::find;
use crate::output::{print, tell};

/// Explains the code `of`, or `what` of the drive `of`.
pub(crate) fn run(of: &str, what: &[String], json: bool) -> End {
    if what.is_empty() { code(of, json) } else { drive(of, &what.join(" "), json) }
}

fn code(wanted: &str, json: bool) -> End {
    let wanted = wanted.to_ascii_uppercase();
    let Some((code, page)) = page_of(&wanted) else {
        tell!(
            "error: there is no code `{}`; `drivewright lints` lists them, and `drivewright explain DRIVE WHAT` asks a drive",
            wanted.escape_debug()
        );
        return End::Usage;
    };
    let (severity, title) = (code.severity().word(), code.title());
    show(
        &page,
        json.then(|| json!({ "code": code.id(), "severity": severity, "title": title, "page": page })),
    )
}

fn page_of(wanted: &str) -> Option<(Code, Cow<'static, str>)> {
    if let Some(lint) = LINTS.iter().find(|lint| lint.code.id() == wanted) {
        return Some((lint.code, lint.page.into()));
    }
    let code = plain_codes().find(|code| code.id() == wanted)?;
    page::text(code).map(|text| (code, text.into()))
}

fn drive(named: &str, what: &str, json: bool) -> End {
    let found = match find(named) {
        Ok(found) => found,
        Err(end) => return end,
    };
    let answer = found.compiled.sound().and_then(|model| Some((model, docs::explain(model, what)?)));
    let Some((model, page)) = answer else {
        tell!(
            "error: the profile of {} knows nothing of `{}`; ask for {}",
            found.id,
            what.escape_debug(),
            docs::ASKED
        );
        return End::Usage;
    };
    show(&page, json.then(|| json!({ "drive": model.drive.package, "asked": what, "page": page })))
}

/// Prints the page; for programs, the object that holds it.
fn show(page: &str, object: Option<Value>) -> End {
    object.map_or_else(|| print(page), |object| print(&format!("{object}\n")))
}
