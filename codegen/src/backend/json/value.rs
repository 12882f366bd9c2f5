//! What the values of `model.json` are made of: facts, whole numbers, words, and the macro that makes structs of them.

use crate::model::{Mapping, Quantity, Type, Worded};

/// Defines structs that are written as JSON objects and described by the schema.
macro_rules! shapes {
    ($(
        $(#[doc = $doc:literal])+
        $name:ident $(<$lt:lifetime>)? {
            $( $(#[doc = $field_doc:literal])+ $field:ident $key:literal: $need:ident $ty:ty, )+
        }
    )+) => {$(
        $(#[doc = $doc])+
        pub(super) struct $name $(<$lt>)? {
            $( $(#[doc = $field_doc])+ pub(super) $field: shapes!(@type $need $ty), )+
        }

        impl $(<$lt>)? Struct for $name $(<$lt>)? {
            const NAME: &'static str = stringify!($name);
            const DOC: &'static str = concat!($($doc),+);
            const FIELDS: &'static [Field] = &[$( Field {
                key: $key,
                doc: concat!($($field_doc),+),
                required: shapes!(@required $need),
                schema: <$ty as Shape>::schema,
            } ),+];
        }

        impl $(<$lt>)? Json for $name $(<$lt>)? {
            const NESTED: bool = true;

            fn write(&self, out: &mut Writer) {
                let nested = false $( || shapes!(@nested $need $ty, &self.$field) )+;
                // What begins with its value is one line, as a fact is.
                let valued = Self::FIELDS.first().is_some_and(|field| field.key == "value");
                out.object(valued || !nested, |out| {
                    $( shapes!(@write $need out, concat!("\"", $key, "\": "), &self.$field); )+
                });
            }
        }
    )+};
    (@type required $ty:ty) => { $ty };
    (@type optional $ty:ty) => { Option<$ty> };
    (@required required) => { true };
    (@required optional) => { false };
    (@nested required $ty:ty, $value:expr) => { <$ty as Json>::NESTED };
    (@nested optional $ty:ty, $value:expr) => { <$ty as Json>::NESTED && $value.is_some() };
    (@write required $out:ident, $key:expr, $value:expr) => { $out.field($key, $value) };
    (@write optional $out:ident, $key:expr, $value:expr) => {
        if let Some(value) = $value {
            $out.field($key, value);
        }
    };
}

pub(super) use shapes;

/// A value and who says it.
pub(super) struct Known<'m, T> {
    pub(super) value: T,
    /// `stated`, `inferred`, `standard` or `assumed`.
    pub(super) class: &'static str,
    /// Key, quoted and with its colon, and text of what comes with the class.
    pub(super) detail: Option<(&'static str, &'m str)>,
    pub(super) cite: Option<String>,
    pub(super) erratum: Option<&'m str>,
}

/// A whole number of up to 64 bits. Beyond 2^53 - 1 it is written as text in decimal, because many readers of JSON would
/// round it.
#[derive(Clone, Copy)]
pub(super) struct Integer(pub(super) i128);

impl Integer {
    /// The largest that every reader keeps exact.
    pub(super) const EXACT: i64 = (1 << 53) - 1;

    /// The number, if every reader keeps it.
    pub(super) fn exact(self) -> Option<i64> {
        i64::try_from(self.0).ok().filter(|n| n.unsigned_abs() <= Self::EXACT.unsigned_abs())
    }
}

/// A value written as a word.
pub(super) struct Word<T>(pub(super) T);

/// Values that a fixed list of words stands for.
pub(super) trait Words: Sized {
    /// Its word.
    fn text(&self) -> &'static str;
    /// Every word.
    fn all() -> Vec<&'static str>;
}

impl<T: Worded> Words for T {
    fn text(&self) -> &'static str {
        self.word()
    }

    fn all() -> Vec<&'static str> {
        T::ALL.iter().map(|value| value.word()).collect()
    }
}

impl Words for Quantity {
    fn text(&self) -> &'static str {
        self.name()
    }

    fn all() -> Vec<&'static str> {
        Self::ALL.iter().map(|quantity| quantity.name()).collect()
    }
}

impl Words for Type {
    fn text(&self) -> &'static str {
        self.word()
    }

    fn all() -> Vec<&'static str> {
        Self::words().collect()
    }
}

impl Words for Mapping {
    fn text(&self) -> &'static str {
        self.word()
    }

    fn all() -> Vec<&'static str> {
        Self::ALL.map(Self::word).to_vec()
    }
}
