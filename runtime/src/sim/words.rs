//! Words in texts of a model, found without the searcher of the standard library, which can panic as far as a compiler
//! knows.

/// Where `word` begins in `text`; in any case of letters.
pub(crate) fn place(text: &str, word: &str) -> Option<usize> {
    let at = |from: &usize| text.as_bytes().get(*from..).and_then(|rest| rest.get(..word.len()));
    (0..=text.len()).find(|from| at(from).is_some_and(|part| part.eq_ignore_ascii_case(word.as_bytes())))
}

/// Whether `word` is in `text`, in any case of letters.
pub(crate) fn holds(text: &str, word: &str) -> bool {
    place(text, word).is_some()
}

/// The bytes of `text` after the first `word`; in any case of letters.
pub(crate) fn after<'t>(text: &'t str, word: &str) -> Option<&'t [u8]> {
    text.as_bytes().get(place(text, word)?.checked_add(word.len())?..)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn words_are_found_in_any_case() {
        assert!(holds("PDO Watchdog timeout", "watchdog") && !holds("dog", "watchdog") && holds("", ""));
        assert_eq!(after("is alarm oPE.", "alarm "), Some(&b"oPE."[..]));
        assert_eq!(after("is", "alarm "), None);
    }
}
