//! Values that are one of some words.

use super::kind::{Expected, FromRaw, Kind, suggest};
use super::value::{bad, checked_text};
use crate::model::{Mapping, Type, Worded};
use crate::raw::RawValue;

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

fn known<T: Worded>() -> Vec<&'static str> {
    T::ALL.iter().map(|value| value.word()).collect()
}

impl<T: Worded> FromRaw for T {
    const KIND: Kind = Kind::Words(known::<T>);

    fn from_raw(raw: &RawValue) -> Result<Self, Expected> {
        let found = word(raw)?;
        T::from_word(found).ok_or_else(|| no_such_word(found, &known::<T>()))
    }
}

impl FromRaw for Mapping {
    const KIND: Kind = Kind::Words(|| Self::ALL.map(Self::word).to_vec());

    fn from_raw(raw: &RawValue) -> Result<Self, Expected> {
        let found = word(raw)?;
        let mapping = Self::ALL.into_iter().find(|mapping| mapping.word() == found);
        mapping.ok_or_else(|| no_such_word(found, &Self::ALL.map(Self::word)))
    }
}

impl FromRaw for Type {
    const KIND: Kind = Kind::Words(|| Self::words().collect());

    fn from_raw(raw: &RawValue) -> Result<Self, Expected> {
        let found = word(raw)?;
        Self::from_word(found).ok_or_else(|| no_such_word(found, &Self::words().collect::<Vec<_>>()))
    }
}
