//! What a format cannot hold, counted by kind: one warning for each, and the same sentence for the file.

use std::collections::BTreeMap;

use crate::diag::{Code, Diagnostic, Sink};
use crate::model::Address;
use crate::source::Span;

/// A kind of loss of one format.
pub(super) trait Kind: Copy + Ord {
    /// The format, as messages name it.
    const FORMAT: &'static str;

    /// Code, what happens to the entries, why, and what to do.
    fn texts(self) -> (Code, &'static str, &'static str, &'static str);
}

/// Defines the kinds of loss of a format.
macro_rules! losses {
    ($format:literal $($name:ident $code:ident $says:literal $why:literal $help:literal;)*) => {
        /// A kind of loss.
        #[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug)]
        pub(super) enum Loss {
            $($name,)*
        }

        impl $crate::backend::losses::Kind for Loss {
            const FORMAT: &'static str = $format;

            fn texts(self) -> ($crate::diag::Code, &'static str, &'static str, &'static str) {
                match self {
                    $(Self::$name => ($code, $says, $why, $help),)*
                }
            }
        }

        /// Losses with the entries that suffer them.
        pub(super) type Losses = $crate::backend::losses::Losses<Loss>;
    };
}

pub(super) use losses;

/// Losses by kind, with the entries that suffer them.
#[derive(Clone, Debug)]
pub(super) struct Losses<L>(BTreeMap<L, (Span, Vec<Address>)>);

impl<L> Default for Losses<L> {
    fn default() -> Self {
        Self(BTreeMap::new())
    }
}

impl<L: Kind> Losses<L> {
    /// Adds `address`; the warning points to the first one of its kind.
    pub(super) fn add(&mut self, loss: L, address: Address, span: Span) {
        let addresses = &mut self.0.entry(loss).or_insert((span, Vec::new())).1;
        // An object and its sub-index 0 share theirs.
        if addresses.last() != Some(&address) {
            addresses.push(address);
        }
    }

    /// Adds a loss of the drive as a whole.
    pub(super) fn add_of_drive(&mut self, loss: L) {
        self.0.entry(loss).or_insert((Span::nowhere(), Vec::new()));
    }

    /// Each kind in one sentence, with its entries.
    pub(super) fn sentences(&self) -> impl Iterator<Item = String> {
        self.0.iter().map(|(loss, (_, addresses))| match addresses.as_slice() {
            [] => format!("{}.", capital(loss.texts().1)),
            some => format!("{}: {}", capital(loss.texts().1), list(some)),
        })
    }

    /// One warning for each kind: a drive has hundreds of entries, and a reader wants to see the kinds.
    pub(super) fn report(&self, sink: &mut Sink) {
        for (loss, (span, addresses)) in &self.0 {
            let (code, says, why, help) = loss.texts();
            let message = match addresses.as_slice() {
                [] => format!("{}: {says}", L::FORMAT),
                some => format!("{}: {says}: {}", L::FORMAT, list(some)),
            };
            sink.push(Diagnostic::new(code, *span, message).why(why).help(help));
        }
    }
}

fn capital(text: &str) -> String {
    let mut chars = text.chars();
    chars.next().map_or_else(String::new, |c| c.to_ascii_uppercase().to_string() + chars.as_str())
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
