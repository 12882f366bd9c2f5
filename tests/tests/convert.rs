//! Profiles in XML: every profile there is goes to XML and back, compiles to the same bytes from both, and is found fault
//! with in the same way.

#![allow(clippy::expect_used, clippy::panic, reason = "a test fails by panicking")]

use std::path::Path;

use drivewright_codegen::emit::RelPath;
use drivewright_codegen::source::{Format, Source};
use drivewright_codegen::{backend, compile, emit};
use drivewright_tests::cases::{golden_cases, profiles, toml_files};
use drivewright_tests::formats::{converted, sorted, to_toml, to_xml, tree, xml_file};

/// Every file of every golden case.
fn golden_files() -> Vec<(String, String)> {
    let cases = golden_cases().into_iter();
    cases
        .flat_map(|case| case.sources.into_iter().map(move |f| (format!("{}/{}", case.name, f.path), f.text)))
        .collect()
}

/// The profiles are written as the house writes TOML: they come back with every byte.
#[test]
fn every_profile_comes_back_from_xml_as_it_was() {
    for (name, files) in profiles() {
        for file in files {
            assert_eq!(to_toml(&to_xml(&file.text)), file.text, "{name}/{}", file.path);
        }
    }
}

#[test]
fn every_golden_case_keeps_its_facts() {
    for (name, text) in golden_files() {
        let xml = to_xml(&text);
        assert_eq!(tree(&xml, Format::Xml), tree(&text, Format::Toml), "{name}\n{xml}");
        let toml = to_toml(&xml);
        assert_eq!(sorted(tree(&toml, Format::Toml)), sorted(tree(&text, Format::Toml)), "{name}\n{toml}");
        assert_eq!(to_toml(&to_xml(&toml)), toml, "{name}");
    }
}

#[test]
fn comments_stay_where_they_belong() {
    let toml = "\
# The file -- and its head.

# Before the table.
objects = [
  # Before the row.
  { at = \"2000:00\", max = 0x1_0, note = \"<&>\\\"\\u202E\", allow = [1, 0x02] }, # Behind the row.
  # Behind all rows.
]

# The drive.
[drive]
# The format.
format = 1 # Behind the key.
bases = [
  # Before the item.
  \"cia301\", # Behind the item.
]
date = \"x\" # Behind the last key.

# The end.
";
    let xml = "\
<?xml version=\"1.0\" encoding=\"UTF-8\"?>
<!-- The file -\\- and its head. -->
<profile>
  <!-- Before the table. -->
  <objects>
    <!-- Before the row. -->
    <row at=\"2000:00\" max=\"0x1_0\" note=\"&lt;&amp;&gt;&quot;&#x202E;\">
      <allow><item>1</item><item>0x02</item></allow>
    </row> <!-- Behind the row. -->
    <!-- Behind all rows. -->
  </objects>
  <!-- The drive. -->
  <drive>
    <!-- The format. -->
    <format>1</format> <!-- Behind the key. -->
    <bases>
      <!-- Before the item. -->
      <item>cia301</item> <!-- Behind the item. -->
    </bases>
    <date>x</date>
  </drive> <!-- Behind the last key. -->
  <!-- The end. -->
</profile>
";
    // A drive whose first key is no attribute is a table with a row.
    let xml =
        xml.replace("  <drive>\n", "  <drive>\n    <row>\n").replace("  </drive> <!--", "    </row> <!--");
    assert_eq!(to_toml(&to_xml(toml)), toml);
    let again = to_xml(toml);
    let flat =
        |text: &str| text.lines().map(str::trim).filter(|l| *l != "</drive>").collect::<Vec<_>>().join("\n");
    assert_eq!(flat(&again), flat(&xml));
}

#[test]
fn values_that_look_like_others_keep_their_kind() {
    let toml = "\
errata = [
  { was = \"16\", set = 16 },
  { was = \"true\", set = true },
  { was = \"1.5\", set = [] },
  { was = [\"1\", 1, true, \"a\"], set = \"\" },
]
objects = [
  { max = \"100\", name = 5, allow = 1, src = true, min = [1] },
]
enums = []
";
    let xml = to_xml(toml);
    assert!(xml.contains("<was kind=\"text\">16</was>\n      <set>16</set>"), "{xml}");
    assert!(xml.contains("<set kind=\"list\"/>") && xml.contains("<name kind=\"number\">5</name>"), "{xml}");
    assert_eq!(to_toml(&xml), toml);
}

/// Every file that a profile gives, and what is found, without places.
fn built(sources: Vec<Source>, name: &str) -> (Vec<(RelPath, Vec<u8>)>, Vec<String>) {
    let compiled = compile(sources);
    let model = compiled.sound().unwrap_or_else(|| panic!("{name}: {:#?}", compiled.diagnostics));
    let (files, losses) = emit(model, backend::ALL);
    let files = files.iter().map(|f| (f.0.to_owned(), f.1.to_owned())).collect();
    let found = compiled.diagnostics.iter().chain(&losses);
    (files, found.map(|d| format!("{} {}", d.code.id(), d.message)).collect())
}

#[test]
fn both_formats_give_the_same_bytes() {
    let golden = golden_cases().into_iter().map(|case| (case.name, case.sources));
    let drives = profiles().into_iter().filter(|(name, _)| !name.starts_with("standard/"));
    for (name, sources) in golden.chain(drives) {
        let xml: Vec<Source> = sources.iter().map(xml_file).collect();
        let mut half = xml.clone();
        half[0] = sources[0].clone();
        let wanted = built(sources, &name);
        assert!(built(xml, &name) == wanted, "{name} differs");
        assert!(built(half, &name) == wanted, "{name} differs when half of it is XML");
    }
}

/// Codes and messages, and what each points at.
fn found(sources: Vec<Source>) -> Vec<(&'static str, String, String)> {
    let compiled = compile(sources);
    let pointed = |d: &drivewright_codegen::diag::Diagnostic| {
        let text = compiled.sources.text(d.span.file).get(d.span.range()).unwrap_or_default();
        // Rows, lists and hidden characters look different; a text stands in quotes.
        let text =
            text.replace("&lt;", "<").replace("&gt;", ">").replace("&quot;", "\"").replace("&amp;", "&");
        let other = text.starts_with(['{', '<', '[']) || text.contains(['\\', '&']);
        let text = if other { "..." } else { &text };
        text.trim_matches(['"', '\'']).to_owned()
    };
    let mut found: Vec<_> =
        compiled.diagnostics.iter().map(|d| (d.code.id(), d.message.clone(), pointed(d))).collect();
    found.sort();
    found
}

#[test]
fn both_formats_are_found_fault_with_alike() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("diagnostics");
    let shared = toml_files(&folder.join("shared"));
    let mut same = 0;
    for case in toml_files(&folder) {
        let rest = || shared.iter().filter(|_| !case.text.contains("[drive]")).cloned();
        // What is no TOML, or holds what XML cannot, stays as it is.
        if converted(&case.text, Format::Toml, Format::Xml).is_err() {
            assert!(
                ["E0101", "E0105", "E0107", "E0114", "E0118"].iter().any(|id| case.path.starts_with(id)),
                "{}",
                case.path
            );
            continue;
        }
        let toml = std::iter::once(case.clone()).chain(rest()).collect();
        let xml = std::iter::once(xml_file(&case)).chain(rest()).collect();
        assert_eq!(found(xml), found(toml), "{}\n{}", case.path, xml_file(&case).text);
        same += 1;
    }
    assert!(same >= 80, "only {same} cases were compared");
}
