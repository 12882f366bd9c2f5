//! Evidence for homing, modes, states, commands, abort codes, terminals, rules, examples and limits.

use super::ethercat;
use super::page::Line;
use super::words::{Row, Words, holds_number, holds_word, names_parameter, same};
use crate::facts::{FactLine, Table};

pub(super) fn anchors(words: &Words<'_>, row: &Row<'_>, line: &Line) -> bool {
    let text = line.text.as_str();
    let id = row.id();
    match row.table {
        Table::Homing => method(row).is_some_and(|m| names_method(line, m)),
        Table::Modes => line.cells.iter().any(|c| c == id) || mode_set(text, id),
        Table::States | Table::Commands => line.cells.iter().any(|c| same(c, id)),
        Table::Aborts => line.cells.iter().any(|c| c.eq_ignore_ascii_case(id)),
        Table::Terminals => holds_word(text, id),
        Table::EtherCat => ethercat::anchors(words, row, text),
        Table::Emcy => emcy_column(row, line).is_some(),
        Table::Examples => row.facts.iter().any(|f| example_shown(&f.field, &f.value, text)),
        // Prose: whether a line has to do with it is for readers.
        Table::Rules => !text.trim().is_empty(),
        _ => false,
    }
}

pub(super) fn shows(words: &Words<'_>, row: &Row<'_>, fact: &FactLine<'_>, line: &Line) -> bool {
    let (field, value, text) = (fact.field.as_ref(), fact.value.as_str(), line.text.as_str());
    match row.table {
        Table::Drive => drive_shown(value, text),
        Table::Homing => homing_shown(words, field, value, line),
        Table::Modes => match field {
            "name" => line.cells.iter().any(|c| same(c, value)),
            _ => entry(line).is_some_and(|entry| value.split(' ').any(|listed| listed == entry)),
        },
        Table::States => pattern(line).is_some_and(|(mask, bits)| match field {
            "mask" => value == format!("0x{mask:04X}"),
            _ => value == format!("0x{bits:04X}"),
        }),
        Table::Commands => command_shown(field, value, line),
        Table::Terminals => terminal_shown(field, value, line),
        Table::EtherCat => ethercat::shows(words, row, field, value, text),
        Table::Emcy => emcy_shown(words, row, field, value, line),
        Table::Examples => example_shown(field, value, text),
        _ => false,
    }
}

/// Facts that only all of their lines together prove; `None` for every other fact.
pub(super) fn proves_whole(
    words: &Words<'_>,
    row: &Row<'_>,
    fact: &FactLine<'_>,
    lines: &[&Line],
) -> Option<bool> {
    let all = || lines.iter().map(|l| l.text.as_str()).collect::<Vec<_>>().join("\n");
    match (row.table, fact.field.as_ref()) {
        (Table::Modes, "objects") => Some(objects_listed(&fact.value, lines)),
        (Table::Drive, _) => Some(lines.iter().any(|l| drive_shown(&fact.value, &l.text))),
        (Table::Examples, "value") => {
            Some(example_shown("value", &fact.value, &without_address(row, &all())))
        }
        (Table::Examples, field) => Some(example_shown(field, &fact.value, &all())),
        (Table::Homing, "when" | "moves" | "abort" | "mask") => Some(false),
        (Table::EtherCat, field) => ethercat::proves_whole(field, &fact.value, &all()),
        (Table::Emcy, _) => Some(lines.iter().any(|l| shows(words, row, fact, l))),
        _ => None,
    }
}

/// A number, or the word for it.
fn drive_shown(value: &str, text: &str) -> bool {
    const NUMBERS: [&str; 5] = ["zero", "one", "two", "three", "four"];
    let word = value.parse::<usize>().ok().and_then(|n| NUMBERS.get(n));
    holds_word(text, value) || word.is_some_and(|w| holds_word(text, w))
}

/// The method of `homing 3` and of `homing 3.1`.
fn method(row: &Row<'_>) -> Option<i8> {
    row.id().split('.').next()?.parse().ok()
}

fn names_method(line: &Line, method: i8) -> bool {
    let Some(cell) = line.cell("method") else { return holds_number(&line.text, method.into()) };
    match cell.split_once('~') {
        Some((from, to)) => {
            let ends = from.trim().parse::<i8>().ok().zip(to.trim().parse::<i8>().ok());
            ends.is_some_and(|(from, to)| (from..=to).contains(&method))
        }
        None => cell.parse() == Ok(method),
    }
}

fn homing_shown(words: &Words<'_>, field: &str, value: &str, line: &Line) -> bool {
    match field {
        "same" => {
            line.cells.iter().any(|c| c.split(' ').next_back() == Some(value) && c.split(' ').count() > 1)
        }
        "start" | "approach" | "reference" | "side" | "edge" => {
            line.cell(field).is_some_and(|cell| words.means(field, cell, value))
        }
        _ => false,
    }
}

/// `6060h = 0Ah`.
fn mode_set(text: &str, id: &str) -> bool {
    id.parse::<i8>().is_ok_and(|n| text.contains(&format!("6060h = {n:02X}h")))
}

/// The address of a row of a table of objects.
fn entry(line: &Line) -> Option<String> {
    let sub = line.cell("sub")?.parse::<u8>().ok()?;
    Some(format!("{:04X}:{sub:02X}", line.index()?))
}

/// Whether the lines are rows of exactly these objects, in this order.
fn objects_listed(value: &str, lines: &[&Line]) -> bool {
    let found: Option<Vec<String>> = lines.iter().map(|l| entry(l)).collect();
    found.is_some_and(|list| list.join(" ") == value)
}

/// Mask and value of a pattern such as `xxxx xxxx x0xx 0000`.
fn pattern(line: &Line) -> Option<(u32, u32)> {
    let cell =
        line.cells.iter().find(|c| c.len() > 15 && c.chars().all(|c| matches!(c, 'x' | '0' | '1' | ' ')))?;
    let bits = cell.chars().filter(|c| *c != ' ');
    Some(bits.fold((0, 0), |(mask, value), bit| {
        (mask << 1 | u32::from(bit != 'x'), value << 1 | u32::from(bit == '1'))
    }))
}

fn command_shown(field: &str, value: &str, line: &Line) -> bool {
    let bits = ["bit-7", "bit-3", "bit-2", "bit-1", "bit-0"];
    let cell = |name: &str| line.cell(name).unwrap_or_default();
    let number = |name: &str| name.rsplit('-').next().and_then(|n| n.parse::<u32>().ok()).unwrap_or(0);
    let sum = |of: &dyn Fn(&str) -> bool| -> u32 {
        bits.iter().filter(|b| of(cell(b))).map(|b| 1 << number(b)).sum()
    };
    let seen = bits.iter().all(|b| !cell(b).is_empty());
    match field {
        "mask" => seen && value == format!("0x{:04X}", sum(&|c| !c.eq_ignore_ascii_case("x"))),
        "value" => seen && value == format!("0x{:04X}", sum(&|c| matches!(c, "1" | "↑"))),
        "edge" => value == "true" && bits.iter().any(|b| cell(b) == "↑"),
        "transitions" => line.cells.iter().any(|c| c.replace(", ", ",").replace(',', " ") == value),
        _ => false,
    }
}

fn terminal_shown(field: &str, value: &str, line: &Line) -> bool {
    match field {
        "pin" => line.cells.iter().any(|c| c == value),
        "parameter" => names_parameter(&line.text, value),
        "object" => entry(line).is_some_and(|entry| entry == value),
        _ => false,
    }
}

/// The cell of the row's byte in the line that names the bytes' content.
fn emcy_column<'l>(row: &Row<'_>, line: &'l Line) -> Option<(usize, &'l str)> {
    let byte: usize = row.id().parse().ok()?;
    let cell = line.cells.get(byte + 1)?;
    (!cell.is_empty()).then_some((byte + 1, cell))
}

fn emcy_shown(words: &Words<'_>, row: &Row<'_>, field: &str, value: &str, line: &Line) -> bool {
    let Some((at, cell)) = emcy_column(row, line) else { return false };
    let empty = line.cells[at + 1..].iter().take_while(|c| c.is_empty()).count();
    match field {
        "holds" => words.means("emcy", cell, value),
        "bytes" => value.parse() == Ok(empty + 1),
        _ => false,
    }
}

/// What the lines must hold for a fact in words of our own: the numbers of a rule. They do not prove it.
pub(super) fn allows(fact: &FactLine<'_>, lines: &[&Line]) -> bool {
    let numbered = fact.table == Table::Rules && matches!(fact.field.as_ref(), "require" | "when");
    let all = || lines.iter().map(|l| l.text.as_str()).collect::<Vec<_>>().join("\n");
    !numbered || constants_shown(&fact.value, &all())
}

/// Every number of an expression but 0 and 1, and the index of every object, is in the text; times as `10ms` or `250 us`.
fn constants_shown(expression: &str, text: &str) -> bool {
    expression
        .split(|c: char| !c.is_ascii_alphanumeric() && c != ':')
        .filter(|word| !word.is_empty())
        .all(|word| constant_shown(word, text))
}

fn constant_shown(word: &str, text: &str) -> bool {
    if let Some((index, _)) = word.split_once(':') {
        return [index.to_owned(), format!("0x{index}"), format!("{index}h")]
            .iter()
            .any(|w| holds_word(text, w));
    }
    let number = match word.strip_prefix("0x") {
        Some(hex) => i128::from_str_radix(hex, 16).ok(),
        None => word.parse().ok(),
    };
    number.is_some_and(|n| n <= 1 || holds_number(text, n) || time_shown(text, n))
}

/// Nanoseconds as a manual prints them.
pub(super) fn time_shown(text: &str, ns: i128) -> bool {
    let unit = |per: i128, unit: &str| {
        ns % per == 0
            && [format!("{}{unit}", ns / per), format!("{} {unit}", ns / per)]
                .iter()
                .any(|t| holds_word(text, t))
    };
    unit(1_000, "us") || unit(1_000_000, "ms")
}

pub(super) fn example_shown(field: &str, value: &str, text: &str) -> bool {
    let number = || match value.strip_prefix("0x") {
        Some(hex) => i128::from_str_radix(hex, 16).ok(),
        None => value.parse().ok(),
    };
    let address = |value: &str| {
        value.split_once(':').is_some_and(|(index, subs)| {
            let named = [format!("{index}h"), format!("0x{index}"), index.to_owned()];
            let mut subs = subs.split("..");
            named.iter().any(|n| holds_word(text, n)) && subs.all(|sub| sub_shown(sub, text))
        })
    };
    match field {
        "write" | "entry" => address(value),
        "parameter" => names_parameter(text, value),
        _ => number().is_some_and(|n| holds_number(text, n)),
    }
}

/// The text without the address that the example writes, whose numbers are not those of its value.
fn without_address(row: &Row<'_>, text: &str) -> String {
    let mut text = text.to_lowercase();
    let address = row.value("write").unwrap_or_default().to_lowercase();
    let (index, subs) = address.split_once(':').unwrap_or_default();
    let forms = [format!("0x{index}"), format!("{index}h")];
    let subs = subs.split("..").map(|sub| format!("0x{sub}h"));
    for form in forms.into_iter().chain(subs).filter(|form| form.len() > 3) {
        text = text.replacen(&form, "", 1);
    }
    text
}

/// A sub-index as `0x0ah`, `00` or decimal.
fn sub_shown(sub: &str, text: &str) -> bool {
    let decimal = u8::from_str_radix(sub, 16).map(|n| n.to_string()).unwrap_or_default();
    [format!("0x{sub}h"), sub.to_owned(), decimal].iter().any(|form| holds_word(text, form))
}
