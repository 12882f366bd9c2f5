//! Impls for `serde` and `defmt` that macros expand to. They live here because `cfg` in an expansion would look at
//! the features of the crate that uses the macro.

#[doc(hidden)]
#[cfg(feature = "serde")]
pub use serde;

#[doc(hidden)]
#[cfg(feature = "defmt")]
pub use defmt;

/// `Serialize` for a newtype, as its raw number.
#[doc(hidden)]
#[macro_export]
#[cfg(feature = "serde")]
macro_rules! __serde {
    ($name:ident) => {
        impl $crate::optional::serde::Serialize for $name {
            fn serialize<S: $crate::optional::serde::Serializer>(
                &self,
                serializer: S,
            ) -> ::core::result::Result<S::Ok, S::Error> {
                $crate::optional::serde::Serialize::serialize(&self.0, serializer)
            }
        }
    };
}

/// Nothing without the feature.
#[doc(hidden)]
#[macro_export]
#[cfg(not(feature = "serde"))]
macro_rules! __serde {
    ($name:ident) => {};
}

/// `Format` for a newtype, as its raw number.
#[doc(hidden)]
#[macro_export]
#[cfg(feature = "defmt")]
macro_rules! __defmt {
    ($name:ident) => {
        impl $crate::optional::defmt::Format for $name {
            fn format(&self, f: $crate::optional::defmt::Formatter<'_>) {
                $crate::optional::defmt::Format::format(&self.0, f);
            }
        }
    };
}

/// Nothing without the feature.
#[doc(hidden)]
#[macro_export]
#[cfg(not(feature = "defmt"))]
macro_rules! __defmt {
    ($name:ident) => {};
}

#[cfg(all(test, feature = "serde", feature = "defmt"))]
mod tests {
    use crate::prelude::*;

    crate::wire_enum! {
        /// One.
        struct Mode(i8) = "mode" {
            /// One.
            ONE = 1 => "one",
        }
    }

    crate::bit_field! {
        /// One.
        struct Word(u16) {
            /// Lowest.
            LOW: 0,
        }
    }

    fn both<T: serde::Serialize + defmt::Format>() {}

    #[test]
    fn public_data_has_both() {
        both::<Mode>();
        both::<Word>();
        both::<Address>();
        both::<DataType>();
        both::<Value<Velocity>>();
        both::<MapEntry>();
        both::<(RangeError, EncodeError)>();
        both::<(ConvertError, WireError)>();
        both::<(LayoutMismatch, ModelError)>();
        both::<(Access, Mapping)>();
        both::<(Direction, QuantityKind)>();
        both::<(Reset, Remap)>();
        both::<(EsmState, EsmAfter)>();
        both::<(SyncMode, Led)>();
        both::<(Effect, crate::rule::Term)>();
        both::<(EmcyContent, crate::rule::Occasion)>();
        both::<TerminalKind>();
        both::<(crate::homing::Step, crate::homing::Level)>();
        both::<(I24, U56)>();
    }
}
