//! Where a row of `objects` belongs.

use super::kind::{Expected, FromRaw, Kind};
use super::value::checked_text;
use crate::diag::code;
use crate::model::Address;
use crate::raw::RawValue;

/// Which sub-indexes a row states.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug)]
pub enum Sub {
    /// The index as a whole.
    Whole,
    /// One.
    One(u8),
    /// Several of one shape, first to last.
    Range(u8, u8),
}

/// Where a row of `objects` belongs: `6040:00`, `3000:01..63` or `607D`.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug)]
pub struct At {
    /// The index.
    pub index: u16,
    /// Its sub-indexes.
    pub sub: Sub,
}

impl At {
    /// Reads the text of an address; every number is hexadecimal with all its digits.
    pub fn parse(text: &str) -> Option<Self> {
        let hex = |t: &str, digits: usize| {
            (t.len() == digits && t.bytes().all(|b| b.is_ascii_hexdigit()))
                .then(|| u16::from_str_radix(t, 16).ok())?
        };
        let sub = |t: &str| hex(t, 2).and_then(|n| u8::try_from(n).ok());
        let Some((index, subs)) = text.split_once(':') else {
            return Some(Self { index: hex(text, 4)?, sub: Sub::Whole });
        };
        let sub = match subs.split_once("..") {
            Some((first, last)) => Sub::Range(sub(first)?, sub(last)?),
            None => Sub::One(sub(subs)?),
        };
        let ascending = !matches!(sub, Sub::Range(first, last) if first >= last);
        ascending.then_some(Self { index: hex(index, 4)?, sub })
    }

    /// Every address that it covers; none for an index as a whole.
    pub fn addresses(self) -> impl Iterator<Item = Address> {
        let range = match self.sub {
            Sub::Whole => None,
            Sub::One(sub) => Some(sub..=sub),
            Sub::Range(first, last) => Some(first..=last),
        };
        range.into_iter().flatten().map(move |sub| Address::new(self.index, sub))
    }
}

impl std::fmt::Display for At {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self.sub {
            Sub::Whole => write!(f, "{:04X}", self.index),
            Sub::One(sub) => write!(f, "{:04X}:{sub:02X}", self.index),
            Sub::Range(first, last) => write!(f, "{:04X}:{first:02X}..{last:02X}", self.index),
        }
    }
}

fn address_error(text: &str, wanted: &str) -> Expected {
    Expected {
        code: code::BAD_ADDRESS,
        message: format!("`{text}` is no address"),
        why: "index and sub-index are hexadecimal with all their digits, so that 10 cannot be read as ten"
            .into(),
        help: format!("write it as {wanted}"),
    }
}

impl FromRaw for At {
    const KIND: Kind = Kind::Text(Some("^[0-9A-Fa-f]{4}(:[0-9A-Fa-f]{2}(\\.\\.[0-9A-Fa-f]{2})?)?$"));

    fn from_raw(raw: &RawValue) -> Result<Self, Expected> {
        let text = checked_text(raw, 64)?;
        Self::parse(text).ok_or_else(|| {
            address_error(text, "`607D:01`, `607D`, or with the lower sub-index first `3000:01..63`")
        })
    }
}

impl FromRaw for Address {
    const KIND: Kind = Kind::Text(Some("^[0-9A-Fa-f]{4}:[0-9A-Fa-f]{2}$"));

    fn from_raw(raw: &RawValue) -> Result<Self, Expected> {
        let text = checked_text(raw, 64)?;
        match At::parse(text) {
            Some(At { index, sub: Sub::One(sub) }) => Ok(Self::new(index, sub)),
            _ => Err(address_error(text, "`607D:01`")),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn addresses() {
        assert_eq!(At::parse("607D:01").map(|a| a.to_string()).as_deref(), Some("607D:01"));
        assert_eq!(At::parse("3000:01..63").unwrap().addresses().count(), 99);
        assert_eq!(At::parse("607D").unwrap().addresses().count(), 0);
        for bad in
            ["607D:1", "0x607D:01", "607D:01..01", "607D:05..01", "607G:01", "607D:", ":01", "+07D:01", ""]
        {
            assert_eq!(At::parse(bad), None, "{bad}");
        }
    }
}
