//! Answers on a terminal: what a drive's profile knows of an error code, a display, an object, a parameter, a homing method,
//! an erratum or a rule. The views are those of the pages.

use serde::Serialize;

use super::book::Book;
use super::{MARKS, alarms, errata, homing, modes, objects, rules};
use crate::backend::template::render_lines;
use crate::emit::escape::one_line;
use crate::model::{Address, Model};

/// What can be asked for, for messages.
pub const ASKED: &str = "an error code (8611h), a display (OF), an object (607Dh or 607D:01), a parameter (P1.01), \
    a homing method (homing 17), a mode (mode 8), an SDO abort code (06090030h), an erratum (E001) or a rule (R01)";

/// What `model` knows of `what`, as text for a terminal; `None` where it knows nothing of it.
pub fn explain(model: &Model, what: &str) -> Option<String> {
    let book = Book::new(model, true);
    let asked = Asked::new(what);
    let mut found = alarms_of(&book, &asked);
    found.extend(object_of(&book, &asked));
    found.extend(behaviour_of(&book, &asked));
    found.extend(texts_of(&book, &asked));
    let title = format!("{} {}", one_line(&model.drive.vendor), one_line(&model.drive.name));
    (!found.is_empty()).then(|| marks_told(format!("{title}\n\n{}", found.join("\n"))))
}

/// The answer, and what its marks mean where it has some.
fn marks_told(mut answer: String) -> String {
    if answer.contains(['ⁱ', 'ˢ', 'ᵃ']) {
        answer.extend(["\n", "Marks: ", MARKS, ".\n"]);
    }
    answer
}

/// A question, and the numbers that it may mean.
struct Asked<'a> {
    text: &'a str,
    /// Hexadecimal, with how many digits.
    hex: Option<(u64, usize)>,
    address: Option<Address>,
    /// `homing 17`: the word and the number.
    counted: Option<(&'a str, i8)>,
}

impl<'a> Asked<'a> {
    fn new(text: &'a str) -> Self {
        let text = text.trim();
        let digits = text.strip_prefix("0x").or_else(|| text.strip_prefix("0X")).unwrap_or(text);
        let digits = digits.strip_suffix(['h', 'H']).unwrap_or(digits);
        let plain = digits.bytes().all(|b| b.is_ascii_hexdigit());
        let hex = u64::from_str_radix(digits, 16).ok().filter(|_| plain).map(|n| (n, digits.len()));
        let address = text.split_once(':').and_then(|(index, sub)| {
            Some(Address::new(u16::from_str_radix(index, 16).ok()?, u8::from_str_radix(sub, 16).ok()?))
        });
        let counted = text.split_once(' ').and_then(|(word, n)| Some((word, n.trim().parse().ok()?)));
        Self { text, hex, address, counted }
    }

    /// The number, if it has 3 or 4 hexadecimal digits.
    fn word(&self) -> Option<u16> {
        self.hex.filter(|(_, digits)| (3..=4).contains(digits)).and_then(|(n, _)| u16::try_from(n).ok())
    }

    /// Whether it names `name`, in any case.
    fn is(&self, name: &str) -> bool {
        self.text.eq_ignore_ascii_case(name)
    }
}

fn shown(template: &str, view: &impl Serialize) -> String {
    super::squeezed(&render_lines(template, view))
}

/// Alarms by display, code of 603Fh, auxiliary code or AL status code. The display as written goes before one in another
/// case: `Ec2` is not `EC2`.
fn alarms_of(book: &Book<'_>, asked: &Asked<'_>) -> Vec<String> {
    let alarms = &book.model.alarms;
    let exact = alarms.iter().any(|a| a.display == asked.text);
    let fits = |a: &&crate::model::Alarm| {
        let display = if exact { a.display == asked.text } else { asked.is(&a.display) };
        let aux = a.aux.as_ref().map(|f| f.value);
        let status = a.detection.al_status.as_ref().map(|f| f.value);
        let code = asked.word().is_some_and(|n| [Some(a.code.value), aux, status].contains(&Some(n)));
        display || code
    };
    let found = alarms.iter().filter(fits);
    found.map(|a| shown(include_str!("res/alarm.txt.j2"), &alarms::view(book, a))).collect()
}

/// An object by its index, by one of its entries, or by a parameter number.
fn object_of(book: &Book<'_>, asked: &Asked<'_>) -> Option<String> {
    let named = |e: &&crate::model::Entry| e.parameter.as_ref().is_some_and(|p| asked.is(&p.value));
    let parameter = book.model.entries.as_slice().iter().find(named).map(|e| e.address);
    let at = asked.address.or(parameter).filter(|at| book.model.entry(*at).is_some());
    let index = at.map(|at| at.index).or_else(|| asked.word())?;
    let view = objects::told(book, book.model.object(index)?, at);
    Some(shown(include_str!("res/object.txt.j2"), &view))
}

/// A homing method, a mode or an abort code.
fn behaviour_of(book: &Book<'_>, asked: &Asked<'_>) -> Vec<String> {
    let model = book.model;
    let number = |words: [&str; 2]| asked.counted.filter(|(word, _)| words.contains(word)).map(|(_, n)| n);
    let method = number(["homing", "method"]).and_then(|n| model.homing.iter().find(|m| m.number == n));
    let mode = number(["mode", "modes"]).and_then(|n| model.modes.iter().find(|m| m.number == n));
    let abort = asked.hex.filter(|(_, digits)| *digits == 8).map(|(n, _)| n);
    let abort = model.aborts.iter().find(|a| Some(u64::from(a.code.value)) == abort);
    [
        method.map(|m| shown(include_str!("res/method.txt.j2"), &homing::view(book, m))),
        mode.map(|m| shown(include_str!("res/mode.txt.j2"), &modes::view(book, m))),
        abort.map(|a| {
            let (name, source) = (book.text(&a.name.value), book.source(&a.name.origin));
            format!("SDO abort code {:08X}h: {name}. Manual: {source}\n", a.code.value)
        }),
    ]
    .into_iter()
    .flatten()
    .collect()
}

/// An erratum or a rule by its id.
fn texts_of(book: &Book<'_>, asked: &Asked<'_>) -> Vec<String> {
    let model = book.model;
    let errata = model.errata.as_slice().iter().filter(|e| asked.is(&e.id));
    let rules = model.rules.iter().filter(|r| asked.is(&r.id));
    errata
        .map(|e| shown(include_str!("res/erratum.txt.j2"), &errata::view(book, e)))
        .chain(rules.map(|r| shown(include_str!("res/rule.txt.j2"), &rules::view(book, r))))
        .collect()
}
