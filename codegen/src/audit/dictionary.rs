//! Evidence for objects, values, bits, alarms and process data.

use super::number::{Number, Range, factor, keyed, labels};
use super::page::Line;
use super::words::{Row, Words, holds_number, holds_word, names_parameter, same, same_letters};
use crate::facts::FactLine;

/// Index and sub-index of `object 607D:01`; no sub-index for an index as a whole.
fn address(row: &Row<'_>) -> Option<(u16, Option<u8>)> {
    let id = row.id();
    let (index, sub) = id.split_once(':').map_or((id, None), |(index, sub)| (index, Some(sub)));
    let sub = sub.map(|s| u8::from_str_radix(s, 16));
    Some((u16::from_str_radix(index, 16).ok()?, sub.transpose().ok()?))
}

/// Whether a cell of sub-indexes, decimal, names `sub`: alone or in a range.
fn names_sub(cell: &str, sub: u8) -> bool {
    let number = |t: &str| t.trim().parse::<u8>().ok();
    match cell.split_once('~') {
        Some((from, to)) => number(from).zip(number(to)).is_some_and(|(from, to)| (from..=to).contains(&sub)),
        None => number(cell) == Some(sub),
    }
}

pub(super) fn object_anchors(row: &Row<'_>, line: &Line) -> bool {
    let Some((index, sub)) = address(row) else { return false };
    let parameter = row.value("parameter");
    if let (Some(printed), Some(cell)) = (parameter, line.cell("parameter")) {
        return same(cell.trim_start_matches('*'), printed);
    }
    match (line.index(), line.cell("sub"), sub) {
        (Some(found), Some(cell), Some(sub)) => found == index && names_sub(cell, sub),
        (Some(found), _, None) => found == index,
        _ => {
            let text = line.text.as_str();
            parameter.is_some_and(|p| names_parameter(text, p))
                || [format!("{index:04X}h"), format!("0x{index:04X}")].iter().any(|w| holds_word(text, w))
        }
    }
}

pub(super) fn object_shows(words: &Words<'_>, row: &Row<'_>, fact: &FactLine<'_>, line: &Line) -> bool {
    let (field, value) = (fact.field.as_ref(), fact.value.as_str());
    let unit = row.value("unit");
    match field {
        "name" => line.cell("name").is_some_and(|cell| same_letters(cell, value)),
        "type" | "access" | "pdo" => line.cell(field).is_some_and(|cell| words.means(field, cell, value)),
        "unit" => line.cell("unit").is_some_and(|cell| words.means("unit", cell, value)),
        "min" | "max" | "allow" => {
            line.cell("range").is_some_and(|cell| range_shown(cell, field, value, unit))
        }
        "default" => line.cell("default").is_some_and(|cell| default_shown(words, cell, value, unit)),
        "parameter" => names_parameter(&line.text, value),
        "effect" => effect_shown(words, value, line),
        _ => false,
    }
}

fn effect_shown(words: &Words<'_>, value: &str, line: &Line) -> bool {
    let starred = line.cell("parameter").is_some_and(|cell| cell.starts_with('*'));
    // A star elsewhere in the line marks something else, such as a unit.
    words
        .printed_for("effect", value)
        .any(|word| if word == "*" { starred } else { line.text.contains(word) })
}

fn range_shown(cell: &str, field: &str, value: &str, unit: Option<&str>) -> bool {
    let factor = factor(unit);
    let numbers: Option<Vec<i128>> =
        value.trim_matches(['[', ']']).split(", ").map(|n| n.parse().ok()).collect();
    let Some(numbers) = numbers else { return false };
    let count = |n: &Number| n.count(factor);
    let keys = keyed(cell);
    let in_keys = match field {
        "min" => keys.iter().min() == numbers.first(),
        "max" => keys.iter().max() == numbers.first(),
        _ => keys == numbers,
    };
    match (Range::parse(cell), field) {
        (Some(Range::Ends(low, _)), "min") => count(&low) == numbers.first().copied(),
        (Some(Range::Ends(_, high)), "max") => count(&high) == numbers.first().copied(),
        (Some(Range::One(one)), "min" | "max") => count(&one) == numbers.first().copied(),
        (Some(Range::List(list)), "allow") => {
            list.iter().map(count).collect::<Option<Vec<_>>>() == Some(numbers)
        }
        _ => !keys.is_empty() && in_keys,
    }
}

fn default_shown(words: &Words<'_>, cell: &str, value: &str, unit: Option<&str>) -> bool {
    if let Some(text) = value.strip_prefix('"').and_then(|v| v.strip_suffix('"')) {
        return cell == text;
    }
    let Ok(wanted) = value.parse::<i128>() else { return words.means("default", cell, value) };
    Number::parse(cell).and_then(|n| n.count(factor(unit))) == Some(wanted)
        || words.means("default", cell, value)
}

/// Whether a cell that the extract has split over two cited lines shows the value: one part says nothing by itself.
pub(super) fn shows_split(words: &Words<'_>, row: &Row<'_>, fact: &FactLine<'_>, lines: &[&Line]) -> bool {
    let column = match fact.field.as_ref() {
        "min" | "max" | "allow" => "range",
        "default" => "default",
        _ => return false,
    };
    let parts: Vec<&str> = lines.iter().filter_map(|l| l.cell(column)).collect();
    let unit = row.value("unit");
    let pairs = parts.iter().zip(parts.iter().skip(1));
    pairs.filter(|(first, rest)| is_part(column, first) || rest.starts_with('~')).any(|(first, rest)| {
        let joined = format!("{first}{rest}");
        match column {
            "range" => range_shown(&joined, fact.field.as_ref(), &fact.value, unit),
            _ => default_shown(words, &joined, &fact.value, unit),
        }
    })
}

/// Whether a cell is no number or range by itself.
fn is_part(column: &str, cell: &str) -> bool {
    if column == "range" { Range::parse(cell).is_none() } else { Number::parse(cell).is_none() }
}

pub(super) fn pdo_anchors(row: &Row<'_>, line: &Line) -> bool {
    let mut parts = row.id().split(' ');
    let index = parts.next().and_then(|i| u16::from_str_radix(i, 16).ok());
    let position = parts.next().and_then(|p| p.parse::<u8>().ok());
    line.index().is_some()
        && line.index() == index
        && position.is_none_or(|p| line.cell("sub").is_some_and(|cell| names_sub(cell, p)))
}

pub(super) fn pdo_shows(row: &Row<'_>, fact: &FactLine<'_>, line: &Line) -> bool {
    let word = line.cell("default").and_then(|cell| Number::parse(cell)?.count((1, 1)));
    match fact.field.as_ref() {
        "dir" => {
            line.cell("name").is_some_and(|name| name.to_lowercase().contains(&format!("{}pdo", fact.value)))
        }
        "bits" => word.is_some_and(|w| fact.value.parse() == Ok(w & 0xFF)),
        "entry" => word.is_some_and(|w| fact.value == format!("{:04X}:{:02X}", w >> 16, w >> 8 & 0xFF)),
        _ => pdo_anchors(row, line),
    }
}

/// The number that a row of a value table or bit table is about.
fn number(row: &Row<'_>) -> Option<i128> {
    let id = row.id();
    let id = id.split_once(" mode ").map_or(id, |(id, _)| id);
    id.rsplit_once(' ')?.1.parse().ok()
}

/// Whether a cell of bits names `bit`: `7`, `15~14`, `12 - 13`.
fn names_bit(cell: &str, bit: i128) -> bool {
    let ends: Vec<i128> = cell
        .split(|c: char| !c.is_ascii_digit())
        .filter(|p| !p.is_empty())
        .filter_map(|p| p.parse().ok())
        .collect();
    match ends.as_slice() {
        [one] => *one == bit,
        [a, b] => (*a.min(b)..=*a.max(b)).contains(&bit),
        _ => false,
    }
}

pub(super) fn named_anchors(row: &Row<'_>, line: &Line) -> bool {
    let Some(n) = number(row) else { return false };
    let cells = line.cells.iter();
    let first_cells = || cells.clone().take(2);
    row.key.starts_with("bits") && first_cells().any(|cell| names_bit(cell, n))
        || row.key.starts_with("enum")
            && line.cells.iter().any(|cell| cell.parse() == Ok(n) || label_of(cell, n).is_some())
        || line.cells.is_empty() && holds_number(&line.text, n)
}

pub(super) fn enum_shows(row: &Row<'_>, fact: &FactLine<'_>, line: &Line) -> bool {
    if fact.field != "label" {
        return false;
    }
    let Some(n) = number(row) else { return false };
    // `[us]` in a manual is `us` in a label.
    let plain = |text: &str| text.replace(['[', ']'], "");
    let keyed = line
        .cells
        .iter()
        .filter_map(|cell| label_of(cell, n))
        .any(|label| same(&plain(label), &plain(&fact.value)));
    let in_cells =
        line.cells.iter().any(|c| same(c, &fact.value)) && line.cells.iter().any(|c| c.parse() == Ok(n));
    keyed || in_cells
}

/// The label that a cell lists for a value.
fn label_of(cell: &str, value: i128) -> Option<&str> {
    labels(cell).into_iter().find(|(key, _)| key.parse() == Ok(value)).map(|(_, label)| label)
}

pub(super) fn bit_shows(fact: &FactLine<'_>, line: &Line) -> bool {
    match fact.field.as_ref() {
        "label" => line.cells.iter().any(|cell| same_letters(cell, &fact.value)),
        "width" => {
            line.cells.iter().take(2).any(|cell| width(cell).is_some_and(|w| fact.value.parse() == Ok(w)))
        }
        _ => false,
    }
}

fn width(cell: &str) -> Option<u32> {
    let ends: Option<Vec<u32>> =
        cell.split(|c: char| !c.is_ascii_digit()).filter(|p| !p.is_empty()).map(|p| p.parse().ok()).collect();
    match ends?.as_slice() {
        [a, b] => Some(a.abs_diff(*b) + 1),
        _ => Some(1),
    }
}

/// The display of `alarm OF 0x25`.
fn display<'f>(row: &Row<'f>) -> &'f str {
    row.id().rsplit_once(' ').map_or(row.id(), |(display, _)| display)
}

pub(super) fn alarm_anchors(words: &Words<'_>, row: &Row<'_>, line: &Line) -> bool {
    let in_section = || words.meanings("section", &line.section).any(|m| m == display(row));
    line.cell("display") == Some(display(row)) || line.cells.iter().any(|c| !c.is_empty()) && in_section()
}

pub(super) fn alarm_shows(words: &Words<'_>, fact: &FactLine<'_>, line: &Line) -> bool {
    let (field, value) = (fact.field.as_ref(), fact.value.as_str());
    let Some(cell) = line.cell(field).or_else(|| words.beside(field, line)) else { return false };
    match field {
        "number" | "code" | "aux" | "al_status" => {
            let wanted = value.strip_prefix("0x").and_then(|hex| i128::from_str_radix(hex, 16).ok());
            wanted.is_some() && Number::parse(cell).and_then(|n| n.count((1, 1))) == wanted
        }
        "esm" => esm_shown(words, cell, value),
        _ => words.means(field, cell, value),
    }
}

/// States with whatever stands between them.
fn esm_shown(words: &Words<'_>, cell: &str, value: &str) -> bool {
    let states: Vec<&str> =
        cell.split(|c: char| !c.is_ascii_alphanumeric()).filter(|p| !p.is_empty()).collect();
    words.means("esm", cell, value) || states.join(" ") == value
}
