//! Rust identifiers from names. Whether a word is a keyword is asked of `syn`, edition keywords included.

use std::collections::BTreeSet;

use crate::name::{Case, Name};

/// `name` as an identifier in `case`: `N` before a leading digit, `_` after a keyword.
pub(super) fn ident(name: &Name, case: Case) -> String {
    let mut text = name.to_identifier(case);
    if is_keyword(&text) {
        text.push('_');
    }
    text
}

fn is_keyword(text: &str) -> bool {
    // No keyword but `Self` has anything but small letters: that saves asking for nearly every name.
    let word = text == "Self" || text.bytes().all(|b| b.is_ascii_lowercase());
    // `gen` is a keyword from edition 2024 on, which a user's crate may have.
    word && (text == "gen" || syn::parse_str::<syn::Ident>(text).is_err())
}

/// Hands out identifiers, each once: a second use gets a number.
#[derive(Default)]
pub(super) struct Scope {
    taken: BTreeSet<String>,
}

impl Scope {
    /// A scope in which `words` are taken.
    pub(super) fn without(words: &[&str]) -> Self {
        Self { taken: words.iter().map(|w| (*w).to_owned()).collect() }
    }

    /// `wanted`, or the first of `wanted_2`, `wanted_3` that is free.
    pub(super) fn take(&mut self, wanted: &str) -> String {
        let mut name = wanted.to_owned();
        let mut n = 2;
        while !self.taken.insert(name.clone()) {
            name = format!("{wanted}_{n}");
            n += 1;
        }
        name
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn of(text: &str, case: Case) -> String {
        ident(&Name::new(text).unwrap(), case)
    }

    #[test]
    fn keywords_and_digits() {
        assert_eq!(of("Type", Case::Snake), "type_");
        assert_eq!(of("gen", Case::Snake), "gen_");
        assert_eq!(of("self", Case::Pascal), "Self_");
        assert_eq!(of("1st gain", Case::UpperSnake), "N1ST_GAIN");
        assert_eq!(of("match", Case::UpperSnake), "MATCH");
    }

    #[test]
    fn every_keyword_becomes_an_identifier() {
        let keywords = "as break const continue crate else enum extern false fn for if impl in let loop match mod move mut pub ref \
             return self Self static struct super trait true type unsafe use where while async await dyn abstract become box do \
             final macro override priv typeof unsized virtual yield try gen";
        for word in keywords.split_whitespace() {
            for case in [Case::Snake, Case::Pascal, Case::UpperSnake] {
                let text = of(word, case);
                assert!(syn::parse_str::<syn::Ident>(&text).is_ok() && text != "gen", "{text}");
            }
        }
    }

    #[test]
    fn a_scope_gives_each_name_once() {
        let mut scope = Scope::without(&["DESC"]);
        assert_eq!(scope.take("DESC"), "DESC_2");
        assert_eq!((scope.take("A"), scope.take("A")), ("A".into(), "A_2".into()));
    }
}
