//! Makes inputs: texts that are nearly a profile, since what is not one at all is refused in its first line.
//!
//! Input `n` is the same in every run. It is a seed (a golden case, a case of a diagnostic, an example of a lint, a file of a real
//! profile) with some changes that know rows, keys and values, and some that know nothing.

use std::collections::BTreeMap;
use std::fs;
use std::path::Path;

use drivewright_codegen::check::LINTS;
use drivewright_tests::random::Random;
use drivewright_tests::{cases, drives};

use crate::targets::Kind;

/// Longest input: what is longer is slower and says no more.
const LONGEST: usize = 20_000;

/// Seeds, and what stands at each key in any of them.
pub struct Inputs {
    small: Vec<String>,
    /// Files of real profiles with their drive: slow, since they name bases.
    real: Vec<String>,
    rows: Vec<String>,
    values: BTreeMap<String, Vec<String>>,
    keys: Vec<String>,
}

const NUMBERS: &[&str] = &[
    "0",
    "-1",
    "1",
    "7",
    "255",
    "256",
    "0xFFFF",
    "65536",
    "0x7FFFFFFF",
    "-2147483648",
    "0xFFFFFFFF",
    "4294967296",
    "9223372036854775807",
    "-9223372036854775808",
    "18446744073709551616",
    "170141183460469231731687303715884105727",
    "-170141183460469231731687303715884105728",
    "340282366920938463463374607431768211456",
    "1_000",
    "0b1",
    "1e9",
    "0.5",
    "nan",
    "00",
];
const TEXTS: &[&str] = &[
    "",
    " ",
    "a\\\"]})*/ <script>",
    "\\u202E",
    "\\n[6040]\\n",
    "\\u0000",
    "../../x",
    "r#fn",
    "self",
    "Self",
    "_",
    "é中µ",
    "]]>",
    "--",
    "&amp;",
    "${x}",
    "{{ x }}",
    "{% x %}",
    "|",
    "`",
    "\\\\",
    "2000:00",
    "2000:01..FF",
    "FFFF:FF",
    "1 L1",
    "T L99999999999999999999",
    "0.1 rpm",
    "1/0 rpm",
    "2000:00 / 0 == 0",
    "((((((((((1))))))))))",
    "- fast until index; latch",
];
const FRAGMENTS: &[&str] = &[
    "<",
    ">",
    "<!DOCTYPE a [<!ENTITY b \"c\">]>",
    "&b;",
    "<?xml version=\"1.0\"?>",
    "<![CDATA[",
    "]]>",
    "<a>",
    "</a>",
    "<objects>",
    "<row at=\"2000:00\"/>",
    "\"",
    "'''",
    "\"\"\"",
    "[",
    "]",
    "[[",
    "{",
    "}",
    "=",
    ",",
    "\n",
    "#",
    "\\",
    "\u{FEFF}",
    "\u{202E}",
    "\0",
];

/// Profiles in XML that are small and hostile.
const XML: &[&str] = &[
    "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<profile>\n<drive format=\"1\" id=\"x1\" vendor=\"Acme\" vendor_id=\"acme\" name=\"X1\" crate_version=\"0.1.0\" eds_version=\"1\" eds_revision=\"0\" date=\"2026-01-01\"/>\n<objects>\n<row at=\"2000:00\" name=\"Speed\" type=\"u16\" access=\"rw\" src=\"1 L1\"/>\n</objects>\n</profile>\n",
    "<!DOCTYPE a [<!ENTITY b \"bbbbbbbb\"><!ENTITY c \"&b;&b;&b;&b;\">]>\n<profile>&c;</profile>\n",
    "<profile><objects><objects><objects><row/></objects></objects></objects></profile>\n",
];

impl Default for Inputs {
    fn default() -> Self {
        Self::new()
    }
}

impl Inputs {
    /// Reads the seeds of the repository.
    pub fn new() -> Self {
        let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
        let read =
            |path: &Path| fs::read_to_string(path).unwrap_or_else(|e| panic!("{}: {e}", path.display()));
        let drive = read(&root.join("golden").join("drive.toml"));
        let with_drive =
            |text: &str| if text.contains("[drive]") { text.to_owned() } else { format!("{text}\0{drive}") };
        let golden = cases::golden_cases()
            .into_iter()
            .map(|case| case.sources.iter().map(|s| s.text.as_str()).collect::<Vec<_>>().join("\0"));
        let diagnostics =
            cases::toml_files(&root.join("diagnostics")).into_iter().map(|s| with_drive(&s.text));
        let examples = LINTS.iter().flat_map(|lint| lint.page.split("```toml\n").skip(1));
        let examples = examples.filter_map(|e| e.split("```").next()).map(with_drive);
        let xml = XML.iter().map(|x| (*x).to_owned());
        let small: Vec<String> = golden.chain(diagnostics).chain(examples).chain(xml).collect();
        let real = drives::all().iter().flat_map(|folder| real(folder)).collect::<Vec<_>>();
        let mut inputs = Self { small, real, rows: Vec::new(), values: BTreeMap::new(), keys: Vec::new() };
        inputs.learn();
        inputs
    }

    /// Rows, keys and values of every seed.
    fn learn(&mut self) {
        for line in self.small.iter().chain(&self.real).flat_map(|text| text.lines()) {
            if line.trim_start().starts_with('{') {
                self.rows.push(line.to_owned());
            }
            for (key, value) in pairs(line) {
                let known = self.values.entry(line[key].to_owned()).or_default();
                known.push(line[value].to_owned());
            }
        }
        self.values.values_mut().for_each(|v| {
            v.sort();
            v.dedup();
        });
        self.keys = self.values.keys().cloned().collect();
    }

    /// How many seeds there are.
    pub fn seeds(&self) -> usize {
        self.small.len() + self.real.len()
    }

    /// Input `n` of a kind.
    pub fn of(&self, kind: Kind, n: u64) -> Vec<u8> {
        match kind {
            Kind::Text => self.get(n),
            Kind::Bytes => decisions(n),
        }
    }

    /// Input `n`, a text.
    pub fn get(&self, n: u64) -> Vec<u8> {
        let mut random = Random::new(n.wrapping_mul(0x2545_F491_4F6C_DD1D) ^ 402);
        if random.once_in(100) {
            return noise(&mut random);
        }
        let seeds = if random.once_in(500) { &self.real } else { &self.small };
        let mut text = random.pick(seeds).cloned().unwrap_or_default();
        for _ in 0..random.below(4) {
            self.change(&mut text, &mut random);
        }
        let mut bytes = text.into_bytes();
        if random.once_in(8) {
            scratch(&mut bytes, &mut random);
        }
        bytes.truncate(LONGEST);
        bytes
    }

    /// One change that knows what a profile is.
    fn change(&self, text: &mut String, random: &mut Random) {
        let mut lines: Vec<String> = text.lines().map(str::to_owned).collect();
        let at = random.below(lines.len());
        let Some(line) = lines.get_mut(at) else { return };
        match random.below(12) {
            0 => drop(lines.remove(at)),
            1 => {
                let twin = line.clone();
                lines.insert(at, twin);
            }
            2 => {
                let row = random.pick(&self.rows).cloned().unwrap_or_default();
                lines.insert(at, row);
            }
            3 => {
                let to = random.below(lines.len());
                lines.swap(at, to);
            }
            4 => {
                let place = boundary(line, random.below(line.len() + 1));
                line.insert_str(place, random.pick(FRAGMENTS).copied().unwrap_or_default());
            }
            _ => self.change_value(&mut lines, random),
        }
        *text = lines.join("\n");
    }

    /// Another value, key or pair in a row that has some.
    fn change_value(&self, lines: &mut [String], random: &mut Random) {
        let rows: Vec<usize> = (0..lines.len()).filter(|n| !pairs(&lines[*n]).is_empty()).collect();
        let Some(line) = random.pick(&rows).and_then(|n| lines.get_mut(*n)) else { return };
        let all = pairs(line);
        let Some((key, value)) = random.pick(&all).cloned() else { return };
        let known = self.values.get(&line[key.clone()]).map_or(&[][..], Vec::as_slice);
        match random.below(8) {
            0 => line.replace_range(key.start..value.end, ""),
            1 => line.replace_range(key, random.pick(&self.keys).map_or("", String::as_str)),
            2 => line.replace_range(value, random.pick(NUMBERS).copied().unwrap_or("0")),
            3 => line.replace_range(value, &format!("\"{}\"", random.pick(TEXTS).copied().unwrap_or(""))),
            4 => {
                let other = random.pick(&self.keys).map_or("", String::as_str);
                let known = self.values.get(other).map_or(&[][..], Vec::as_slice);
                let pair = format!("{other} = {}, ", random.pick(known).map_or("0", String::as_str));
                line.insert_str(key.start, &pair);
            }
            _ => line.replace_range(value, random.pick(known).map_or("0", String::as_str)),
        }
    }
}

/// The files of a real profile, each with its drive and bases.
fn real(folder: &Path) -> Vec<String> {
    let files = cases::toml_files(folder);
    let drive = files.iter().find(|f| f.path == "drive.toml").map_or("", |f| f.text.as_str()).to_owned();
    files
        .iter()
        .filter(|f| f.path != "drive.toml" && f.text.len() < LONGEST / 2)
        .map(|f| format!("{}\0{drive}", f.text))
        .collect()
}

type Range = std::ops::Range<usize>;

/// Where the keys and values of a line stand: `key = value`, the value up to the next comma outside of quotes and brackets.
fn pairs(line: &str) -> Vec<(Range, Range)> {
    let mut found = Vec::new();
    let mut from = 0;
    while let Some(equals) = line[from..].find(" = ").map(|n| n + from) {
        let key = line[..equals].rfind(|c: char| !c.is_ascii_alphanumeric() && c != '_').map_or(0, |n| n + 1);
        // Behind a character that is longer than a byte there is no key.
        let key = boundary(line, key);
        let end = equals + 3 + value_len(&line[equals + 3..]);
        if key < equals {
            found.push((key..equals, equals + 3..end));
        }
        from = end;
    }
    found
}

/// Bytes of the value at the start of a text.
fn value_len(text: &str) -> usize {
    let (mut depth, mut quoted, mut escaped) = (0_usize, false, false);
    for (at, c) in text.char_indices() {
        match c {
            '"' if !escaped => quoted = !quoted,
            '[' if !quoted => depth += 1,
            ']' if !quoted && depth > 0 => depth -= 1,
            ',' | '}' | ']' if !quoted && depth == 0 => return text[..at].trim_end().len(),
            _ => {}
        }
        escaped = c == '\\' && !escaped;
    }
    text.trim_end().len()
}

/// The first place from `at` on where a character begins.
fn boundary(text: &str, at: usize) -> usize {
    (at..=text.len()).find(|n| text.is_char_boundary(*n)).unwrap_or(text.len())
}

/// Changes that know nothing.
fn scratch(bytes: &mut Vec<u8>, random: &mut Random) {
    for _ in 0..=random.below(3) {
        let at = random.below(bytes.len() + 1);
        match random.below(4) {
            0 => bytes.truncate(at),
            1 => bytes.insert(at, random.next() as u8),
            2 => {
                let part: Vec<u8> = bytes.iter().skip(at).take(random.below(200)).copied().collect();
                let to = random.below(bytes.len() + 1);
                bytes.splice(to..to, part);
            }
            _ => {
                if let Some(byte) = bytes.get_mut(at) {
                    *byte ^= 1 << random.below(8);
                }
            }
        }
    }
}

/// Bytes of chance, or one fragment many times.
/// Bytes that decide: some inputs are short, none is long.
fn decisions(n: u64) -> Vec<u8> {
    let mut random = Random::new(n.wrapping_mul(0x2545_F491_4F6C_DD1D) ^ 6402);
    let length = 16 + random.below(1_200);
    let mut bytes: Vec<u8> = (0..length.div_ceil(8)).flat_map(|_| random.next().to_le_bytes()).collect();
    bytes.truncate(length);
    bytes
}

fn noise(random: &mut Random) -> Vec<u8> {
    if random.once_in(2) {
        return (0..random.below(300)).map(|_| random.next() as u8).collect();
    }
    let fragment = random.pick(FRAGMENTS).copied().unwrap_or_default();
    fragment.repeat(random.below(LONGEST / fragment.len().max(1))).into_bytes()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn pairs_of_a_row() {
        let line = r#"  { at = "a, = b", list = [1, "]"], n = -1, µ x = 2 }"#;
        let found: Vec<(&str, &str)> = pairs(line).into_iter().map(|(k, v)| (&line[k], &line[v])).collect();
        assert_eq!(found, [("at", "\"a, = b\""), ("list", "[1, \"]\"]"), ("n", "-1"), ("x", "2")]);
    }

    #[test]
    fn inputs_are_many_and_stable() {
        let (one, other) = (Inputs::new(), Inputs::new());
        let made: std::collections::BTreeSet<Vec<u8>> = (0..1000).map(|n| one.get(n)).collect();
        assert!(made.len() > 700, "{} different inputs", made.len());
        assert!((0..1000).all(|n| one.get(n) == other.get(n)));
    }
}
