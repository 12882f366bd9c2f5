//! A layout against what the drive holds.

use core::fmt;

use super::MapEntry;

/// The first place where the drive's layout is not the expected one. From here on every value would be read from the
/// wrong bytes.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[non_exhaustive]
pub enum LayoutMismatch {
    /// Another object is mapped.
    Object {
        /// Sub-index of the mapping object, from 1.
        position: usize,
        /// What should be mapped.
        expected: MapEntry,
        /// What the drive maps.
        found: MapEntry,
    },
    /// The right object has another length.
    Bits {
        /// Sub-index of the mapping object, from 1.
        position: usize,
        /// What should be mapped.
        expected: MapEntry,
        /// What the drive maps.
        found: MapEntry,
    },
    /// The drive maps fewer entries.
    Missing {
        /// Sub-index of the mapping object, from 1.
        position: usize,
        /// What should be mapped.
        expected: MapEntry,
    },
    /// The drive maps more entries.
    Extra {
        /// Sub-index of the mapping object, from 1.
        position: usize,
        /// What the drive maps.
        found: MapEntry,
    },
}

impl LayoutMismatch {
    /// Sub-index of the mapping object, from 1.
    pub const fn position(&self) -> usize {
        match self {
            Self::Object { position, .. }
            | Self::Bits { position, .. }
            | Self::Missing { position, .. }
            | Self::Extra { position, .. } => *position,
        }
    }
}

impl fmt::Display for LayoutMismatch {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Object { position, expected, found } => {
                write!(f, "entry {position} of the drive's layout is {found}, not {expected}")
            }
            Self::Bits { position, expected, found } => {
                write!(
                    f,
                    "entry {position} of the drive's layout is {found} long, not {} bit",
                    expected.bits()
                )
            }
            Self::Missing { position, expected } => {
                write!(f, "the drive's layout ends before entry {position}, {expected}")
            }
            Self::Extra { position, found } => {
                write!(f, "the drive's layout has an entry {position}, {found}, that is not expected")
            }
        }
    }
}

impl core::error::Error for LayoutMismatch {}

/// That the words read from sub-indexes 1 and up of a mapping object are `expected`.
///
/// `words` has as many items as sub-index 0 says.
///
/// # Errors
/// The first [`LayoutMismatch`].
///
/// ```
/// use drivewright_runtime::pdo::{compare, LayoutMismatch, MapEntry};
///
/// let expected = [0x6041_0010, 0x6064_0020].map(MapEntry::from_word);
/// assert_eq!(compare(&expected, [0x6041_0010, 0x6064_0020]), Ok(()));
/// let difference = compare(&expected, [0x6041_0010, 0x6064_0010]).unwrap_err();
/// assert!(matches!(difference, LayoutMismatch::Bits { position: 2, .. }));
/// ```
pub fn compare(expected: &[MapEntry], words: impl IntoIterator<Item = u32>) -> Result<(), LayoutMismatch> {
    let mut found = words.into_iter().map(MapEntry::from_word);
    for (position, expected) in (1..=usize::MAX).zip(expected.iter().copied()) {
        let found = found.next().ok_or(LayoutMismatch::Missing { position, expected })?;
        entry_agrees(position, expected, found)?;
    }
    match found.next() {
        Some(found) => Err(LayoutMismatch::Extra { position: expected.len().saturating_add(1), found }),
        None => Ok(()),
    }
}

fn entry_agrees(position: usize, expected: MapEntry, found: MapEntry) -> Result<(), LayoutMismatch> {
    if found.address() != expected.address() {
        Err(LayoutMismatch::Object { position, expected, found })
    } else if found.bits() != expected.bits() {
        Err(LayoutMismatch::Bits { position, expected, found })
    } else {
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::string::ToString;

    const EXPECTED: [MapEntry; 2] = [MapEntry::from_word(0x6041_0010), MapEntry::from_word(0x6064_0020)];

    #[test]
    fn the_first_difference_is_told() {
        let text = |words: &[u32]| compare(&EXPECTED, words.iter().copied()).unwrap_err().to_string();
        assert_eq!(text(&[]), "the drive's layout ends before entry 1, 6041:00 16 bit");
        assert_eq!(text(&[0x6041_0010]), "the drive's layout ends before entry 2, 6064:00 32 bit");
        assert_eq!(
            text(&[0x6041_0010, 0x6064_0010]),
            "entry 2 of the drive's layout is 6064:00 16 bit long, not 32 bit"
        );
        assert_eq!(
            text(&[0x6077_0010, 0]),
            "entry 1 of the drive's layout is 6077:00 16 bit, not 6041:00 16 bit"
        );
        let extra = [0x6041_0010, 0x6064_0020, 0x6061_0008, 1];
        assert_eq!(text(&extra), "the drive's layout has an entry 3, 6061:00 8 bit, that is not expected");
    }

    #[test]
    fn a_sub_index_is_part_of_the_object() {
        let error = compare(&EXPECTED, [0x6041_0110, 0]).unwrap_err();
        assert!(matches!(error, LayoutMismatch::Object { position: 1, .. }));
        assert_eq!(error.position(), 1);
    }

    #[test]
    fn nothing_is_equal_to_nothing() {
        assert_eq!(compare(&[], []), Ok(()));
    }
}
