//! What an EDS cannot hold: one warning for each kind, and the same sentence for the comments of the file.

use std::collections::BTreeMap;

use crate::diag::{Code, Diagnostic, Sink};
use crate::model::Address;
use crate::source::Span;

/// An EDS cannot state a value.
pub const VALUE: Code = Code::warning("W1001", "an EDS cannot state a value");
/// Limits contradict each other or the default.
pub const LIMITS: Code = Code::warning("W1002", "limits contradict each other or the default");
/// An EDS has no place for an object.
pub const PLACE: Code = Code::warning("W1003", "an EDS has no place for an object");
/// An object lacks what CiA 306 demands.
pub const SHAPE: Code = Code::warning("W1004", "an object lacks what CiA 306 demands");
/// A text is not written as printed.
pub const TEXT: Code = Code::warning("W1005", "a text is not written as printed");

macro_rules! losses {
    ($($name:ident $code:ident $says:literal $why:literal $help:literal;)*) => {
        /// A kind of loss.
        #[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug)]
        pub(super) enum Loss {
            $($name,)*
        }

        impl Loss {
            /// Code, what happens to the entries, why, and what to do.
            fn texts(self) -> (Code, &'static str, &'static str, &'static str) {
                match self {
                    $(Self::$name => ($code, $says, $why, $help),)*
                }
            }
        }
    };
}

losses! {
    TextDefault VALUE
        "the default is text and is left out"
        "readers disagree on whether text stands in quotes"
        "nothing; model.json and the generated crate carry it";
    OtherDefault VALUE
        "the default has no form that every reader takes and is left out"
        "CiA 306 does not say how reals and times are written, and readers disagree"
        "nothing; model.json and the generated crate carry it";
    DefaultOutsideType VALUE
        "the default is no value of the type and is left out"
        "readers cut it to another number, or refuse the file"
        "correct `type` or `default`, or add an erratum";
    LimitOutsideType VALUE
        "a limit is no value of the type and is left out"
        "readers cut it to another number, or refuse the file"
        "correct `type`, `min` or `max`, or add an erratum";
    LimitOfOtherType VALUE
        "limits of a type that is no integer are left out"
        "CiA 306 has limits for integers only"
        "nothing; model.json and the generated crate carry them";
    MappedDomain VALUE
        "a DOMAIN is not marked as mappable"
        "a PDO carries values of fixed length, and CiA 306 has no such key for a DOMAIN"
        "correct `type` or `pdo`";
    DefaultOutsideLimits LIMITS
        "the default is outside the limits and is left out"
        "readers refuse a file whose default breaks its own limits"
        "correct `default`, `min` or `max`, or add an erratum";
    LimitsCrossed LIMITS
        "the lowest value is above the highest, and both limits are left out"
        "no value could be written"
        "correct `min` or `max`, or add an erratum";
    IndexOfDataTypes PLACE
        "the object is left out"
        "indexes below 1000h are data types, which none of the three object lists may hold"
        "correct `at`";
    SubIndexFf PLACE
        "the entry is left out"
        "CiA 306 lists sub-indexes 00h to FEh; FFh describes the object itself"
        "correct `at`";
    NoSubIndex0 SHAPE
        "the object has no sub-index 0, and some readers refuse that"
        "an array or record says at sub-index 0 how many entries it has"
        "add sub-index 0 if the drive has it";
    VarWithSubIndexes SHAPE
        "the object is a variable with other sub-indexes than 0, and is written as a record"
        "an EDS lists sub-indexes of arrays and records only"
        "correct `kind`";
    MandatoryMissing SHAPE
        "a mandatory object is missing, and some readers refuse that"
        "CiA 306 demands 1000h, 1001h and 1018h"
        "add it if the drive has it";
    NameChanged TEXT
        "a name is not written as printed"
        "an EDS holds one line of at most 241 characters of ASCII, in which some signs have a meaning of their own"
        "nothing, or a shorter `name`; model.json and the generated crate carry it";
    DriveTextChanged TEXT
        "the name of the maker or of the product is not written as printed"
        "an EDS holds one line of at most 240 characters of ASCII"
        "nothing, or a shorter `vendor` or `name`";
}

impl Loss {
    /// What happens to the objects, in one clause.
    pub(super) fn says(self) -> &'static str {
        self.texts().1
    }
}

/// Losses by kind, with the entries that suffer them.
#[derive(Clone, Default, Debug)]
pub(super) struct Losses(BTreeMap<Loss, (Span, Vec<Address>)>);

impl Losses {
    /// Adds `address`; the warning points to the first one of its kind.
    pub(super) fn add(&mut self, loss: Loss, address: Address, span: Span) {
        let addresses = &mut self.0.entry(loss).or_insert((span, Vec::new())).1;
        // An object and its sub-index 0 share theirs.
        if addresses.last() != Some(&address) {
            addresses.push(address);
        }
    }

    /// Adds a loss of the drive as a whole.
    pub(super) fn add_of_drive(&mut self, loss: Loss) {
        self.0.entry(loss).or_insert((Span::nowhere(), Vec::new()));
    }

    /// Each kind with its entries.
    pub(super) fn iter(&self) -> impl Iterator<Item = (Loss, &[Address])> {
        self.0.iter().map(|(loss, (_, addresses))| (*loss, addresses.as_slice()))
    }

    /// One warning for each kind: a drive has hundreds of entries, and a reader wants to see the kinds.
    pub(super) fn report(&self, sink: &mut Sink) {
        for (loss, (span, addresses)) in &self.0 {
            let (code, says, why, help) = loss.texts();
            let message = match addresses.as_slice() {
                [] => format!("EDS: {says}"),
                some => format!("EDS: {says}: {}", list(some)),
            };
            sink.push(Diagnostic::new(code, *span, message).why(why).help(help));
        }
    }
}

/// Addresses with runs of sub-indexes joined: `3000:01..63, 6040:00`.
pub(super) fn list(addresses: &[Address]) -> String {
    let run =
        |pair: &[Address]| pair[0].index == pair[1].index && pair[0].sub.checked_add(1) == Some(pair[1].sub);
    let runs = addresses.chunk_by(|a, b| run(&[*a, *b]));
    let texts: Vec<String> = runs
        .map(|run| match run {
            [first, .., last] => format!("{first}..{:02X}", last.sub),
            _ => run.iter().map(ToString::to_string).collect(),
        })
        .collect();
    texts.join(", ")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn runs_are_joined() {
        let at = Address::new;
        let addresses =
            [at(0x3000, 1), at(0x3000, 2), at(0x3000, 3), at(0x3001, 4), at(0x3001, 6), at(0x3001, 255)];
        assert_eq!(list(&addresses), "3000:01..03, 3001:04, 3001:06, 3001:FF");
    }
}
