//! What an output must be, by the end of its name: a reader that is not ours takes it.

use quick_xml::Reader;
use quick_xml::events::Event;

/// Why the text of `path` is not what its name promises.
pub fn judge(path: &str, bytes: &[u8]) -> Result<(), String> {
    let end = path.rsplit('.').next().unwrap_or_default();
    // An image is read by what made it; nothing in it is text.
    if matches!(end, "bin" | "sii") {
        return Ok(());
    }
    let text = std::str::from_utf8(bytes).map_err(said)?;
    match end {
        "rs" => syn::parse_file(text).map(drop).map_err(said),
        "toml" => toml::from_str::<toml::Table>(text).map(drop).map_err(said),
        "json" => serde_json::from_str::<serde_json::Value>(text).map(drop).map_err(said),
        "eds" | "dcf" => canopen_host::eds::Eds::parse(text).map(drop).map_err(said),
        "xml" => well_formed(text),
        _ => plain(text),
    }
}

fn said(error: impl std::fmt::Debug) -> String {
    format!("{error:?}")
}

/// Every element is closed, by its own name, and there is one root.
fn well_formed(text: &str) -> Result<(), String> {
    let mut reader = Reader::from_str(text);
    let (mut depth, mut roots) = (0_usize, 0_usize);
    loop {
        match reader.read_event().map_err(said)? {
            Event::Start(e) => {
                e.attributes().try_for_each(|a| a.map(drop)).map_err(said)?;
                roots += usize::from(depth == 0);
                depth += 1;
            }
            Event::Empty(e) => {
                e.attributes().try_for_each(|a| a.map(drop)).map_err(said)?;
                roots += usize::from(depth == 0);
            }
            Event::End(_) => depth = depth.saturating_sub(1),
            Event::Eof => break,
            _ => {}
        }
    }
    if depth == 0 && roots == 1 { Ok(()) } else { Err(format!("{roots} roots, {depth} open")) }
}

/// No character that moves what stands around it, or that nobody sees.
fn plain(text: &str) -> Result<(), String> {
    let hidden =
        |c: &char| (c.is_control() && !"\n\t\r".contains(*c)) || ('\u{202A}'..='\u{202E}').contains(c);
    text.chars().find(hidden).map_or(Ok(()), |c| Err(format!("the character {}", c.escape_unicode())))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Each reader refuses something.
    #[test]
    fn what_is_broken_is_refused() {
        let pairs = [
            ("a.rs", "fn f() {}", "fn f( {}"),
            ("a.toml", "a = 1", "a = "),
            ("a.json", "{}", "{"),
            ("a.xml", "<a b=\"1\"><c/></a>", "<a><c></a>"),
            ("b.xml", "<a/>", "<a/><b/>"),
            ("c.xml", "<a/>", "<a b=\"1\" b=\"2\"/>"),
            ("a.md", "text\n", "te\u{202E}xt"),
            ("a.txt", "text", "te\0xt"),
        ];
        for (path, good, bad) in pairs {
            assert_eq!(judge(path, good.as_bytes()), Ok(()), "{path}");
            assert!(judge(path, bad.as_bytes()).is_err(), "{path}");
        }
        assert!(judge("a.md", b"\xFF").is_err());
        assert!(judge("a.eds", b"[1000]\nParameterName=A\nDataType=no number\n").is_err());
    }
}
