//! The homing language as text, as profiles have it.

use core::fmt;

use super::{Event, Level, Pace, Side, Signal, Step};

/// The steps of a case. Shows as `- fast until home on; latch`.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct Moves<'m>(pub &'m [Step]);

/// What is seen, all of it. Shows as `home off, negative_limit on`, or as `any` if it is nothing.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct When<'m>(pub &'m [Level]);

fn switch(f: &mut fmt::Formatter<'_>, signal: Signal, on: bool) -> fmt::Result {
    write!(f, "{signal} {}", on_off(on))
}

const fn on_off(on: bool) -> &'static str {
    if on {
        "on"
    } else {
        "off"
    }
}

impl fmt::Display for Event {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match *self {
            Self::Switch(signal, on) => switch(f, signal, on),
            Self::Index => f.write_str("index"),
            Self::Torque(on) => write!(f, "torque {}", on_off(on)),
            Self::Stall => f.write_str("stall"),
        }
    }
}

impl fmt::Display for Step {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match *self {
            Self::Move { direction, pace, until } => motion(f, direction, pace, until),
            Self::Stop => f.write_str("stop"),
            Self::Latch => f.write_str("latch"),
            Self::Return => f.write_str("return"),
            Self::Done => f.write_str("done"),
            Self::NotStated => f.write_str("not stated"),
        }
    }
}

fn motion(f: &mut fmt::Formatter<'_>, direction: Side, pace: Pace, until: Event) -> fmt::Result {
    let sign = match direction {
        Side::Negative => '-',
        Side::Positive => '+',
    };
    write!(f, "{sign} {pace} until {until}")
}

impl fmt::Display for Level {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match *self {
            Self::Switch(signal, on) => switch(f, signal, on),
            Self::Standstill => f.write_str("standstill"),
            Self::AtHome => f.write_str("at_home"),
        }
    }
}

/// Items with something between them.
fn joined<T: fmt::Display>(f: &mut fmt::Formatter<'_>, items: &[T], between: &str) -> fmt::Result {
    let Some((first, others)) = items.split_first() else { return Ok(()) };
    first.fmt(f)?;
    others.iter().try_for_each(|item| write!(f, "{between}{item}"))
}

impl fmt::Display for Moves<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        joined(f, self.0, "; ")
    }
}

impl fmt::Display for When<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if self.0.is_empty() {
            f.write_str("any")
        } else {
            joined(f, self.0, ", ")
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::string::ToString;

    #[test]
    fn programs_show_as_profiles_write_them() {
        let moves = [
            Step::fast(Side::Negative, Event::on(Signal::NegativeLimit)),
            Step::slow(Side::Positive, Event::Torque(false)),
            Step::slow(Side::Positive, Event::Index),
            Step::fast(Side::Positive, Event::Stall),
            Step::Stop,
            Step::Latch,
            Step::Return,
            Step::Done,
            Step::NotStated,
        ];
        assert_eq!(
            Moves(&moves).to_string(),
            "- fast until negative_limit on; + slow until torque off; + slow until index; + fast until stall; \
             stop; latch; return; done; not stated"
        );
        assert_eq!(Moves(&[]).to_string(), "");
    }

    #[test]
    fn starts_show_as_profiles_write_them() {
        let when =
            [Level::off(Signal::Home), Level::on(Signal::PositiveLimit), Level::Standstill, Level::AtHome];
        assert_eq!(When(&when).to_string(), "home off, positive_limit on, standstill, at_home");
        assert_eq!(When(&[]).to_string(), "any");
    }
}
