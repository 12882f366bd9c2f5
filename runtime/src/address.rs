//! Where an entry of the object dictionary is.

use core::fmt;
use core::str::FromStr;

/// Index and sub-index of an entry, shown as `607D:01`.
///
/// Ordered by index, then by sub-index.
///
/// ```
/// use drivewright_runtime::Address;
///
/// let at = Address::new(0x607D, 1);
/// assert_eq!(at.to_string(), "607D:01");
/// assert!(at < Address::new(0x607E, 0));
/// ```
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Address {
    index: u16,
    sub: u8,
}

impl Address {
    /// The entry at `index` and `sub`; every combination is an address.
    pub const fn new(index: u16, sub: u8) -> Self {
        Self { index, sub }
    }

    /// The index: the whole range of 16 bits.
    pub const fn index(self) -> u16 {
        self.index
    }

    /// The sub-index: the whole range of 8 bits.
    pub const fn sub(self) -> u8 {
        self.sub
    }
}

impl fmt::Display for Address {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{:04X}:{:02X}", self.index, self.sub)
    }
}

impl fmt::Debug for Address {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        fmt::Display::fmt(self, f)
    }
}

#[cfg(feature = "serde")]
impl serde::Serialize for Address {
    /// As text: `607D:01`.
    fn serialize<S: serde::Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_str(self)
    }
}

/// The text is not four hexadecimal digits, a colon and two hexadecimal digits.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
#[non_exhaustive]
pub struct ParseAddressError;

impl fmt::Display for ParseAddressError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("an address is four hexadecimal digits, a colon and two more, such as 607D:01")
    }
}

impl core::error::Error for ParseAddressError {}

impl FromStr for Address {
    type Err = ParseAddressError;

    fn from_str(text: &str) -> Result<Self, ParseAddressError> {
        let (index, sub) = text.split_once(':').ok_or(ParseAddressError)?;
        Ok(Self::new(hex(index, 4)?, u8::try_from(hex(sub, 2)?).map_err(|_| ParseAddressError)?))
    }
}

/// Exactly `digits` hexadecimal digits: `from_str_radix` alone would take a sign.
fn hex(text: &str, digits: usize) -> Result<u16, ParseAddressError> {
    let plain = text.len() == digits && text.bytes().all(|b| b.is_ascii_hexdigit());
    plain.then(|| u16::from_str_radix(text, 16).ok()).flatten().ok_or(ParseAddressError)
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::string::ToString;

    #[test]
    fn text_round_trips() {
        for at in [Address::new(0, 0), Address::new(0x607D, 1), Address::new(0xFFFF, 0xFF)] {
            assert_eq!(at.to_string().parse(), Ok(at));
        }
    }

    #[test]
    fn other_texts_are_refused() {
        for text in ["", "607D", "607D:1", "607D:001", "+07D:01", "607D:+1", "607G:01", "07D:01", "607D:01 "]
        {
            assert_eq!(text.parse::<Address>(), Err(ParseAddressError), "{text}");
        }
    }

    #[test]
    fn index_orders_before_sub_index() {
        assert!(Address::new(0x6000, 0xFF) < Address::new(0x6001, 0));
        assert!(Address::new(0x6000, 1) < Address::new(0x6000, 2));
    }
}
