//! Comments between the formats. XML allows no `--` in one: a backslash goes in between, and one more where some are there
//! already, so that every comment comes back as it was.

/// What stands between `<!--` and ` -->` for a comment of TOML.
pub(super) fn to_xml(comment: &str) -> String {
    map(comment, |hyphen, backslashes, out| {
        out.push_str(hyphen);
        out.extend(std::iter::repeat_n('\\', backslashes + 1));
    })
}

/// The comment of TOML for what stands between `<!--` and `-->`.
pub(super) fn from_xml(comment: &str) -> String {
    map(comment, |hyphen, backslashes, out| {
        out.push_str(hyphen);
        out.extend(std::iter::repeat_n('\\', backslashes.saturating_sub(1)));
    })
}

/// Copies a text; each hyphen that another one follows, with or without backslashes in between, goes to `between` with
/// the number of these.
fn map(text: &str, between: impl Fn(&str, usize, &mut String)) -> String {
    let mut out = String::with_capacity(text.len());
    let mut rest = text;
    while let Some(at) = rest.find('-') {
        out.push_str(&rest[..at]);
        let behind = &rest[at + 1..];
        let next = behind.trim_start_matches('\\');
        let backslashes = behind.len() - next.len();
        if next.starts_with('-') {
            between("-", backslashes, &mut out);
        } else {
            out.push_str(&rest[at..=at + backslashes]);
        }
        rest = next;
    }
    out.push_str(rest);
    out
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn hyphens_come_back() {
        for (toml, xml) in [
            (" a", " a"),
            (" a - b", " a - b"),
            (" a--b", " a-\\-b"),
            (" -----", " -\\-\\-\\-\\-"),
            ("-\\-", "-\\\\-"),
            ("-\\", "-\\"),
            ("\\-->", "\\-\\->"),
        ] {
            assert_eq!(to_xml(toml), xml);
            assert_eq!(from_xml(xml), toml);
            assert!(!to_xml(toml).contains("--"));
        }
        assert_eq!(from_xml("a-b -\\x"), "a-b -\\x");
    }
}
