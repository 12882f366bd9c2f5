//! Conversion between the formats, on files made by chance: hostile texts, odd comments, numbers in every notation.

use drivewright_codegen::source::Format;
use drivewright_tests::formats::{sorted, to_toml, to_xml, tree};
use proptest::collection::vec;
use proptest::prelude::*;
use proptest::sample::select;

use super::cases;
use super::order::quoted;

/// A text that XML can hold.
fn text() -> impl Strategy<Value = String> {
    let odd = select(vec![
        "",
        " ",
        "0x10",
        "-1",
        "1_0",
        "true",
        "false",
        "1.5",
        "1e3",
        "nan",
        "]]>",
        "<!--",
        "-->",
        "--",
        "&amp;",
        "&#0;",
        "\"",
        "'",
        "<a b='c'/>",
        "\n",
        "\r\n",
        "\t",
        "\u{202E}",
        "\u{FEFF}",
        "\u{85}",
        "\u{2028}",
        "\u{FFFD}",
        "µ",
        "\u{1F600}",
        "# x",
        "\\",
        "\\u0041",
        "[drive]",
        "007",
    ]);
    let any = "\\PC{0,12}".prop_map(|text| text.replace(['\u{FFFE}', '\u{FFFF}'], "?"));
    prop_oneof![4 => odd.prop_map(str::to_owned), 2 => any, 2 => (0_u32..99).prop_map(|n| format!("{n}"))]
}

/// A number as TOML writes it.
fn number() -> impl Strategy<Value = String> {
    let odd = select(vec![
        "0",
        "-0",
        "+7",
        "0x0",
        "0xDEAD_beef",
        "0o17",
        "0b1_0",
        "1_000",
        "-2_0",
        "170141183460469231731687303715884105727",
    ]);
    prop_oneof![
        odd.prop_map(str::to_owned),
        any::<i64>().prop_map(|n| n.to_string()),
        any::<u32>().prop_map(|n| format!("0x{n:08X}"))
    ]
}

fn scalar() -> impl Strategy<Value = String> {
    prop_oneof![4 => text().prop_map(|t| quoted(&t)), 4 => number(), 1 => any::<bool>().prop_map(|b| b.to_string())]
}

fn comment() -> impl Strategy<Value = String> {
    let odd = select(vec![
        "",
        " ",
        "--",
        " ---",
        "-",
        ">",
        "->",
        "-\\-",
        "-\\",
        " a -- b",
        "!",
        "[",
        " { a = 1 }",
        ":schema x",
        " <!-- x -->",
        " µ",
        "# #",
    ]);
    let any = "[ -~]{0,20}";
    prop_oneof![odd.prop_map(str::to_owned), any].prop_map(|text| format!("#{}", text.trim_end()))
}

/// Comments on lines of their own, mostly none.
fn before(indent: &'static str) -> impl Strategy<Value = String> {
    let lines = move |all: Vec<String>| all.iter().flat_map(|c| [indent, c, "\n"]).collect::<String>();
    prop_oneof![3 => Just(String::new()), 1 => vec(comment(), 1..3).prop_map(lines)]
}

/// A comment at the end of a line, mostly none.
fn behind() -> impl Strategy<Value = String> {
    prop_oneof![3 => Just(String::new()), 1 => comment().prop_map(|c| format!(" {c}"))]
}

fn list() -> impl Strategy<Value = String> {
    let line = vec(scalar(), 0..4).prop_map(|items| format!("[{}]", items.join(", ")));
    let item = (before("    "), scalar(), behind())
        .prop_map(|(before, item, behind)| format!("{before}    {item},{behind}\n"));
    prop_oneof![3 => line, 1 => vec(item, 1..3).prop_map(|items| format!("[\n{}  ]", items.concat()))]
}

fn value() -> impl Strategy<Value = String> {
    prop_oneof![4 => scalar(), 1 => list()]
}

const KEYS: &[&str] = &[
    "at", "name", "max", "default", "allow", "causes", "was", "set", "unset", "format", "bases", "row",
    "item", "kind", "x-1",
];

/// Keys of a row, each once, with their values.
fn keys() -> impl Strategy<Value = Vec<(&'static str, String)>> {
    vec((select(KEYS), value()), 0..7).prop_map(|mut keys| {
        let mut seen = Vec::new();
        keys.retain(|(key, _)| {
            !seen.contains(key) && {
                seen.push(*key);
                true
            }
        });
        keys
    })
}

/// A table as a list of rows in lines.
fn rows(name: &'static str) -> impl Strategy<Value = String> {
    let row = (before("  "), keys(), behind()).prop_map(|(before, keys, behind)| {
        let keys: Vec<String> = keys.iter().map(|(key, value)| format!("{key} = {value}")).collect();
        format!("{before}  {{ {} }},{behind}\n", keys.join(", "))
    });
    (before(""), vec(row, 0..4), before("  "))
        .prop_map(move |(before, rows, tail)| format!("{before}{name} = [\n{}{tail}]\n", rows.concat()))
}

/// A table as blocks.
fn blocks(header: &'static str, most: usize) -> impl Strategy<Value = String> {
    let key = (before(""), behind());
    let row = (before(""), keys(), vec(key, 7)).prop_map(move |(before, keys, notes)| {
        let line = |((key, value), (before, behind)): (&(&str, String), &(String, String))| {
            format!("{before}{key} = {value}{behind}\n")
        };
        format!("{before}{header}\n{}", keys.iter().zip(&notes).map(line).collect::<String>())
    });
    vec(row, 0..=most).prop_map(|rows| rows.concat())
}

fn file() -> impl Strategy<Value = String> {
    let head = prop_oneof![Just(String::new()), before("").prop_map(|c| format!("{c}\n"))];
    let lists = (rows("objects"), rows("errata"), rows("unknown"));
    let rest = (blocks("[[alarms]]", 2), blocks("[drive]", 1), before(""));
    (head, lists, rest)
        .prop_map(|(head, lists, rest)| [head, lists.0, lists.1, lists.2, rest.0, rest.1, rest.2].concat())
}

/// What stands behind a `#`, and numbers: what a text of TOML holds beside its facts, in the order of letters.
fn comments(text: &str) -> Vec<String> {
    let mut out: Vec<String> = Vec::new();
    let mut quote = false;
    for line in text.lines() {
        let mut escaped = false;
        for (at, c) in line.char_indices() {
            match c {
                _ if escaped => escaped = false,
                '\\' if quote => escaped = true,
                '"' => quote = !quote,
                '#' if !quote => {
                    out.push(line[at + 1..].trim_end().to_owned());
                    break;
                }
                _ => {}
            }
        }
    }
    out.sort();
    out
}

/// The numbers of a text, as written, in order.
fn numbers(text: &str) -> Vec<String> {
    let mut out: Vec<String> = Vec::new();
    for line in text.lines().map(|line| line.split('"').step_by(2).collect::<Vec<_>>().join("\"")) {
        let code = line.split('#').next().unwrap_or_default().to_owned();
        let words =
            code.split(|c: char| " =,[]{}".contains(c)).filter(|w| w.contains(|c: char| c.is_ascii_digit()));
        out.extend(words.filter(|w| !w.contains("x-1")).map(str::to_owned));
    }
    out.sort();
    out
}

/// Texts without quotes and backslashes, so that [`numbers`] can tell them from numbers.
fn is_plain(text: &str) -> bool {
    !text.contains('\\')
}

proptest! {
    #![proptest_config(cases(400))]

    #[test]
    fn files_come_back(toml in file()) {
        let xml = to_xml(&toml);
        prop_assert_eq!(tree(&xml, Format::Xml), tree(&toml, Format::Toml), "{}", xml);
        let again = to_toml(&xml);
        prop_assert_eq!(sorted(tree(&again, Format::Toml)), sorted(tree(&toml, Format::Toml)), "{}", again);
        prop_assert_eq!(to_toml(&to_xml(&again)), again.clone(), "written once, a file stays\n{}", to_xml(&again));
        let xml = to_xml(&again);
        prop_assert_eq!(to_xml(&to_toml(&xml)), xml);
        if is_plain(&toml) {
            prop_assert_eq!(numbers(&again), numbers(&toml));
        }
    }

    #[test]
    fn no_comment_is_lost(toml in file()) {
        let again = to_toml(&to_xml(&toml));
        let joined = |text: &str| comments(text).concat().split_whitespace().collect::<String>();
        let mut counted = [joined(&toml), joined(&again)].map(|text| text.chars().collect::<Vec<_>>());
        for chars in &mut counted {
            chars.sort_unstable();
        }
        prop_assert_eq!(&counted[0], &counted[1], "{}\n{}", toml, again);
    }
}
