//! Links of Markdown files: those inside of the repository lead to a file, and to a heading or an anchor in it.
//!
//! Anchors of headings are those of GitHub, Gitea and GitLab: lower case, blanks as `-`, other signs left out, and a number
//! behind one that is there before.

use std::collections::BTreeSet;
use std::fs;
use std::path::Path;

/// Pages of golden cases, whose names are not those that their links name. A test of the pages reads their links.
const SNAPSHOTS: &str = "tests/golden/";

/// Checks the links of the file `name`.
pub fn check(root: &Path, name: &str, text: &str, findings: &mut Vec<String>) {
    if !name.ends_with(".md") || name.starts_with(SNAPSHOTS) {
        return;
    }
    let folder = root.join(name).parent().map(Path::to_owned).unwrap_or_default();
    for link in links(text).iter().filter(|l| !l.contains("://") && !l.starts_with("mailto:")) {
        let (file, anchor) = link.split_once('#').unwrap_or((link, ""));
        let path = if file.is_empty() { root.join(name) } else { folder.join(file) };
        if !path.exists() {
            findings.push(format!("{name}: the link `{link}` leads nowhere"));
        } else if !anchor.is_empty() && path.extension().is_some_and(|e| e == "md") {
            let there = fs::read_to_string(&path).map(|text| anchors(&text)).unwrap_or_default();
            if !there.contains(anchor) {
                findings.push(format!("{name}: the link `{link}` names no heading or anchor there"));
            }
        }
    }
}

/// The targets of inline links, outside of code.
fn links(text: &str) -> Vec<String> {
    let mut found = Vec::new();
    for line in prose(text) {
        let parts = line.split("](").skip(1).filter_map(|rest| rest.split_once(')'));
        found.extend(parts.map(|(link, _)| link.to_owned()));
    }
    found
}

/// Lines outside of code blocks, without code spans.
fn prose(text: &str) -> Vec<String> {
    let mut code = false;
    let mut lines = Vec::new();
    for line in text.lines() {
        let fence = line.trim_start().starts_with("```");
        code ^= fence;
        if !code && !fence {
            lines.push(line.split('`').step_by(2).collect::<Vec<_>>().join("``"));
        }
    }
    lines
}

/// Anchors of headings, and those that are written as `<a id="...">`.
fn anchors(text: &str) -> BTreeSet<String> {
    let mut found = BTreeSet::new();
    let mut code = false;
    for line in text.lines() {
        code ^= line.trim_start().starts_with("```");
        let heading = line.trim_start_matches('#');
        if !code && heading.len() < line.len() && heading.starts_with(' ') {
            let slug = slug(heading);
            let numbered = (1..).map(|n| format!("{slug}-{n}"));
            let free = std::iter::once(slug.clone()).chain(numbered).find(|s| !found.contains(s));
            found.extend(free);
        }
        let written = line.split("<a id=\"").skip(1).filter_map(|rest| rest.split_once('"'));
        found.extend(written.map(|(id, _)| id.to_owned()));
    }
    found
}

/// The anchor of a heading.
fn slug(heading: &str) -> String {
    // Tags are no text of the heading.
    let shown = heading.split('<').map(|p| p.split_once('>').map_or(p, |(_, text)| text)).collect::<String>();
    let kept = shown.trim().chars().filter(|c| c.is_alphanumeric() || matches!(c, ' ' | '-' | '_'));
    kept.flat_map(char::to_lowercase).map(|c| if c == ' ' { '-' } else { c }).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn links_outside_of_code() {
        let text = "[a](b.md) and `[c](d.md)` [e](f.md#g)\n```\n[h](i.md)\n```\n[j](k)\n";
        assert_eq!(links(text), ["b.md", "f.md#g", "k"]);
    }

    #[test]
    fn anchors_of_headings_and_tags() {
        let text = "# One, `two`\n## A B\n## A B\n```\n# no heading\n```\n| <a id=\"607d-01\"></a>01 |\n## <a id=\"x\"></a>607Dh Limit\n";
        let wanted = ["607d-01", "607dh-limit", "a-b", "a-b-1", "one-two", "x"];
        assert!(anchors(text).iter().map(String::as_str).eq(wanted), "{:?}", anchors(text));
    }

    #[test]
    fn a_link_to_a_heading_that_is_not_there_is_found() {
        let root = std::env::temp_dir().join(format!("links-{}", std::process::id()));
        fs::create_dir_all(&root).unwrap();
        fs::write(root.join("b.md"), "# Here\n").unwrap();
        let mut findings = Vec::new();
        check(&root, "a.md", "[1](b.md#here) [2](b.md#gone) [3](c.md) [4](https://x.org/#y)", &mut findings);
        fs::remove_dir_all(&root).unwrap();
        assert_eq!(findings.len(), 2, "{findings:?}");
    }
}
