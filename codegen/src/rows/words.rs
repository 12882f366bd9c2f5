//! Values that are one of some words.

use super::kind::{Expected, FromRaw, Kind, suggest};
use super::value::{bad, checked_text};
use crate::model::{Access, Direction, Mapping, ObjectKind, Reset, Sure, Type};
use crate::raw::RawValue;

macro_rules! words {
    ($($ty:ident: $($word:literal => $value:expr),+;)*) => {$(
        impl FromRaw for $ty {
            const KIND: Kind = Kind::Words(|| vec![$($word),+]);

            fn from_raw(raw: &RawValue) -> Result<Self, Expected> {
                match word(raw)? {
                    $($word => Ok($value),)+
                    other => Err(no_such_word(other, &[$($word),+])),
                }
            }
        }
    )*};
}

fn word(raw: &RawValue) -> Result<&str, Expected> {
    checked_text(raw, 64)
}

fn no_such_word(found: &str, words: &[&str]) -> Expected {
    bad(
        format!("`{found}` is not one of the words allowed here"),
        "another word would have to be guessed at",
        suggest(found, words),
    )
}

words! {
    Access: "ro" => Access::Ro, "rw" => Access::Rw, "wo" => Access::Wo, "const" => Access::Const;
    Mapping: "no" => Mapping { rx: false, tx: false }, "rx" => Mapping { rx: true, tx: false },
        "tx" => Mapping { rx: false, tx: true }, "rx tx" => Mapping { rx: true, tx: true };
    Direction: "rx" => Direction::Rx, "tx" => Direction::Tx;
    ObjectKind: "var" => ObjectKind::Var, "array" => ObjectKind::Array, "record" => ObjectKind::Record;
    Reset: "resettable" => Reset::Resettable, "not resettable" => Reset::NotResettable;
    Sure: "high" => Sure::High, "medium" => Sure::Medium, "low" => Sure::Low;
}

impl FromRaw for Type {
    const KIND: Kind = Kind::Words(|| Self::words().collect());

    fn from_raw(raw: &RawValue) -> Result<Self, Expected> {
        let found = word(raw)?;
        Self::from_word(found).ok_or_else(|| no_such_word(found, &Self::words().collect::<Vec<_>>()))
    }
}
