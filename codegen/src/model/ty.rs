//! CiA 301 data types.

use std::fmt;

/// The type of a value on the wire.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
pub enum Type {
    /// BOOLEAN, one bit in a PDO and one byte over SDO.
    Bool,
    /// `INTEGERn` (signed) or `UNSIGNEDn`, n = 8, 16, 24, 32, 40, 48, 56 or 64.
    Int {
        /// Two's complement.
        signed: bool,
        /// Width in bits.
        bits: u8,
    },
    /// REAL32 or REAL64.
    Real {
        /// Width in bits: 32 or 64.
        bits: u8,
    },
    /// `VISIBLE_STRING`.
    VisibleString,
    /// `OCTET_STRING`.
    OctetString,
    /// `UNICODE_STRING`.
    UnicodeString,
    /// `TIME_OF_DAY`, 48 bits.
    TimeOfDay,
    /// `TIME_DIFFERENCE`, 48 bits.
    TimeDifference,
    /// DOMAIN: bytes of any length.
    Domain,
}

/// Word in a profile, type, name in CiA 301, code in an EDS.
const TYPES: &[(&str, Type, &str, u16)] = &[
    ("bool", Type::Bool, "BOOLEAN", 0x01),
    ("i8", Type::int(true, 8), "INTEGER8", 0x02),
    ("i16", Type::int(true, 16), "INTEGER16", 0x03),
    ("i32", Type::int(true, 32), "INTEGER32", 0x04),
    ("u8", Type::int(false, 8), "UNSIGNED8", 0x05),
    ("u16", Type::int(false, 16), "UNSIGNED16", 0x06),
    ("u32", Type::int(false, 32), "UNSIGNED32", 0x07),
    ("f32", Type::Real { bits: 32 }, "REAL32", 0x08),
    ("string", Type::VisibleString, "VISIBLE_STRING", 0x09),
    ("octets", Type::OctetString, "OCTET_STRING", 0x0A),
    ("unicode", Type::UnicodeString, "UNICODE_STRING", 0x0B),
    ("time", Type::TimeOfDay, "TIME_OF_DAY", 0x0C),
    ("time_difference", Type::TimeDifference, "TIME_DIFFERENCE", 0x0D),
    ("domain", Type::Domain, "DOMAIN", 0x0F),
    ("i24", Type::int(true, 24), "INTEGER24", 0x10),
    ("f64", Type::Real { bits: 64 }, "REAL64", 0x11),
    ("i40", Type::int(true, 40), "INTEGER40", 0x12),
    ("i48", Type::int(true, 48), "INTEGER48", 0x13),
    ("i56", Type::int(true, 56), "INTEGER56", 0x14),
    ("i64", Type::int(true, 64), "INTEGER64", 0x15),
    ("u24", Type::int(false, 24), "UNSIGNED24", 0x16),
    ("u40", Type::int(false, 40), "UNSIGNED40", 0x18),
    ("u48", Type::int(false, 48), "UNSIGNED48", 0x19),
    ("u56", Type::int(false, 56), "UNSIGNED56", 0x1A),
    ("u64", Type::int(false, 64), "UNSIGNED64", 0x1B),
];

impl Type {
    /// An integer type.
    pub const fn int(signed: bool, bits: u8) -> Self {
        Self::Int { signed, bits }
    }

    /// Every word that a profile may use.
    pub fn words() -> impl Iterator<Item = &'static str> {
        TYPES.iter().map(|t| t.0)
    }

    /// The type that a profile calls `word`.
    pub fn from_word(word: &str) -> Option<Self> {
        TYPES.iter().find(|t| t.0 == word).map(|t| t.1)
    }

    fn row(self) -> &'static (&'static str, Type, &'static str, u16) {
        // The table holds every width that `from_word` can give; DOMAIN stands for none.
        TYPES.iter().find(|t| t.1 == self).unwrap_or(&TYPES[13])
    }

    /// What a profile calls it.
    pub fn word(self) -> &'static str {
        self.row().0
    }

    /// What CiA 301 calls it.
    pub fn cia301_name(self) -> &'static str {
        self.row().2
    }

    /// The data type code of CiA 301, as an EDS states it.
    pub fn cia301_code(self) -> u16 {
        self.row().3
    }

    /// Width in a PDO, in bits; `None` for strings and domains.
    pub fn bits(self) -> Option<u8> {
        match self {
            Self::Bool => Some(1),
            Self::Int { bits, .. } | Self::Real { bits } => Some(bits),
            Self::TimeOfDay | Self::TimeDifference => Some(48),
            Self::VisibleString | Self::OctetString | Self::UnicodeString | Self::Domain => None,
        }
    }

    /// Lowest and highest value of an integer or boolean.
    pub fn range(self) -> Option<(i128, i128)> {
        match self {
            Self::Bool => Some((0, 1)),
            Self::Int { signed: true, bits } => Some((-(1 << (bits - 1)), (1 << (bits - 1)) - 1)),
            Self::Int { signed: false, bits } => Some((0, (1 << bits) - 1)),
            _ => None,
        }
    }

    /// Whether values are whole numbers.
    pub fn is_integer(self) -> bool {
        matches!(self, Self::Int { .. })
    }
}

impl fmt::Display for Type {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.word())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_type_is_found_by_its_word() {
        for (word, ty, _, code) in TYPES {
            assert_eq!(Type::from_word(word), Some(*ty));
            assert_eq!(ty.word(), *word);
            assert_eq!(ty.cia301_code(), *code);
        }
    }

    #[test]
    fn ranges_of_the_edges() {
        assert_eq!(Type::int(true, 8).range(), Some((-128, 127)));
        assert_eq!(Type::int(false, 64).range(), Some((0, u64::MAX.into())));
        assert_eq!(Type::int(true, 64).range(), Some((i64::MIN.into(), i64::MAX.into())));
    }
}
