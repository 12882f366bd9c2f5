//! Findings as GitHub workflow commands: annotations on the lines of a pull request.

use std::fmt::Write;

use super::Diagnostic;
use crate::emit::escape;
use crate::source::SourceMap;

/// One command a line. `folder` is the profile's folder from the repository's root, so that annotations find the file.
pub fn commands(findings: &[Diagnostic], sources: &SourceMap, folder: &str) -> String {
    let mut out = String::new();
    for d in findings {
        let mut place = String::new();
        let path = sources.path(d.span.file);
        if !path.is_empty() {
            let (start, end) = (
                sources.line_column(d.span.file, d.span.start),
                sources.line_column(d.span.file, d.span.end),
            );
            let file = if folder.is_empty() {
                path.to_owned()
            } else {
                format!("{}/{path}", folder.trim_end_matches('/'))
            };
            let _ = write!(
                place,
                "file={},line={},col={},endLine={},endColumn={},",
                property(&file),
                start.line,
                start.column,
                end.line,
                end.column
            );
        }
        let text = format!("{}\nwhy: {}\nhelp: {}", d.message, d.why, d.help);
        let title = format!("{}: {}", d.code.id(), d.code.title());
        let _ = writeln!(out, "::{} {place}title={}::{}", d.severity().word(), property(&title), data(&text));
    }
    out
}

fn data(text: &str) -> String {
    escape::visible(text).replace('%', "%25").replace('\n', "%0A")
}

fn property(text: &str) -> String {
    data(text).replace(':', "%3A").replace(',', "%2C")
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::diag::code;
    use crate::source::Span;

    #[test]
    fn nothing_in_a_text_ends_the_command() {
        let mut sources = SourceMap::default();
        let file = sources.add("a,b:c.toml", "x = 1\n");
        let finding = Diagnostic::new(code::SYNTAX, Span::new(file, 0..1), "50 %\nsecond").why("w").help("h");
        assert_eq!(
            commands(&[finding], &sources, "profiles/x/"),
            "::error file=profiles/x/a%2Cb%3Ac.toml,line=1,col=1,endLine=1,endColumn=2,title=E0101%3A the text is not TOML\
             ::50 %25%0Asecond%0Awhy: w%0Ahelp: h\n"
        );
    }
}
