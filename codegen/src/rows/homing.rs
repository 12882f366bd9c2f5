//! The homing language as text: `- fast until negative_limit on; + slow until negative_limit off; latch`.

use super::kind::{Expected, FromRaw, Kind, suggest};
use super::value::checked_text;
use crate::diag::code;
use crate::limits;
use crate::model::{Event, Level, Moves, Pace, Side, Signal, Step, When, Worded};
use crate::raw::RawValue;

const WHY: &str = "a homing program is executed: what cannot be read would move an axis in some other way";

fn wrong(message: String, help: String) -> Expected {
    Expected { code: code::BAD_PROGRAM, message, why: WHY.into(), help }
}

/// The words of a step that is no move.
const PLAIN: &[(&str, Step)] = &[
    ("stop", Step::Stop),
    ("latch", Step::Latch),
    ("return", Step::Return),
    ("done", Step::Done),
    ("not stated", Step::NotStated),
];

fn step(text: &str) -> Result<Step, Expected> {
    if let Some((_, step)) = PLAIN.iter().find(|(word, _)| *word == text) {
        return Ok(*step);
    }
    let words: Vec<&str> = text.split_whitespace().collect();
    let [sign, pace, "until", event @ ..] = words.as_slice() else {
        let plain: Vec<&str> = PLAIN.iter().map(|(word, _)| *word).collect();
        let help = format!("write `+ slow until home on`, or one of: {}", plain.join(", "));
        return Err(wrong(format!("`{text}` is no step"), help));
    };
    let direction = match *sign {
        "+" => Side::Positive,
        "-" => Side::Negative,
        other => return Err(wrong(format!("`{other}` is no direction"), "write `+` or `-`".into())),
    };
    let pace = match *pace {
        "fast" => Pace::Fast,
        "slow" => Pace::Slow,
        other => return Err(wrong(format!("`{other}` is no speed"), "write `fast` or `slow`".into())),
    };
    Ok(Step::Move { direction, pace, until: self::event(event)? })
}

fn event(words: &[&str]) -> Result<Event, Expected> {
    match words {
        ["index"] => Ok(Event::Index),
        ["stall"] => Ok(Event::Stall),
        ["torque", state] => on(state).map(Event::Torque),
        [signal, state] => Ok(Event::Switch(self::signal(signal)?, on(state)?)),
        _ => Err(wrong(
            format!("`{}` is no event", words.join(" ")),
            "write `home on`, `negative_limit off`, `index`, `stall` or `torque on`".into(),
        )),
    }
}

fn signal(word: &str) -> Result<Signal, Expected> {
    let known: Vec<&str> = Signal::ALL.iter().map(|s| s.word()).collect();
    <Signal as Worded>::from_word(word)
        .ok_or_else(|| wrong(format!("`{word}` is no switch"), suggest(word, &known)))
}

fn on(word: &str) -> Result<bool, Expected> {
    match word {
        "on" => Ok(true),
        "off" => Ok(false),
        other => Err(wrong(format!("`{other}` is no state of a switch"), "write `on` or `off`".into())),
    }
}

fn level(text: &str) -> Result<Level, Expected> {
    match text.split_whitespace().collect::<Vec<_>>().as_slice() {
        ["standstill"] => Ok(Level::Standstill),
        ["at_home"] => Ok(Level::AtHome),
        [signal, state] => Ok(Level::Switch(self::signal(signal)?, on(state)?)),
        _ => Err(wrong(
            format!("`{text}` is nothing that can be seen at the start"),
            "write `home off`, `negative_limit on`, `standstill` or `at_home`, or `any` alone".into(),
        )),
    }
}

impl FromRaw for Moves {
    const KIND: Kind = Kind::Text(None);

    fn from_raw(raw: &RawValue) -> Result<Self, Expected> {
        let text = checked_text(raw, limits::NAME_BYTES * 2)?;
        text.split(';').map(|part| step(part.trim())).collect::<Result<_, _>>().map(Self)
    }
}

impl FromRaw for When {
    const KIND: Kind = Kind::Text(None);

    fn from_raw(raw: &RawValue) -> Result<Self, Expected> {
        match checked_text(raw, limits::NAME_BYTES)? {
            "any" => Ok(Self(Vec::new())),
            text => text.split(',').map(|part| level(part.trim())).collect::<Result<_, _>>().map(Self),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn moves(text: &str) -> Result<Moves, Expected> {
        Moves::from_raw(&RawValue::Text(text.into()))
    }

    #[test]
    fn programs_are_read_and_written_back() {
        for text in [
            "- fast until negative_limit on; + slow until negative_limit off; + slow until index; latch",
            "+ fast until stall; not stated",
            "- slow until torque on; stop; latch; return",
            "done",
        ] {
            assert_eq!(moves(text).map(|m| m.to_string()).as_deref(), Ok(text));
        }
        for text in ["any", "home off, positive_limit on", "standstill"] {
            assert_eq!(
                When::from_raw(&RawValue::Text(text.into())).map(|w| w.to_string()).as_deref(),
                Ok(text)
            );
        }
    }

    #[test]
    fn what_is_no_program_is_refused() {
        for text in [
            "latch;",
            "+ slow until",
            "up slow until home on",
            "+ quick until home on",
            "+ slow until home",
            "+ slow until hom on",
            "+ slow while home on",
            "home on",
        ] {
            assert_eq!(moves(text).map_err(|e| e.code), Err(code::BAD_PROGRAM), "{text}");
        }
    }

    #[test]
    fn home_is_latched_at_the_last_event() {
        let edge = moves("+ fast until home on; - slow until home off; latch").unwrap();
        assert_eq!(edge.latched(), Some((Side::Negative, Event::Switch(Signal::Home, false))));
        assert_eq!(moves("+ fast until torque on; stop; latch").unwrap().latched(), None);
        assert_eq!(moves("latch").unwrap().latched(), None);
    }
}
