//! Names as words. The case is chosen by each backend; two names clash when their words are equal.

use std::fmt;

/// A name: what was written, and its words in lower case.
#[derive(Clone, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
pub struct Name {
    original: String,
    words: Vec<String>,
}

/// How a backend joins words.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Case {
    /// `TARGET_POSITION`
    UpperSnake,
    /// `target_position`
    Snake,
    /// `TargetPosition`
    Pascal,
}

impl Name {
    /// Splits `text` into words; `None` when no letter or digit is left.
    pub fn new(text: &str) -> Option<Self> {
        let words = split(text);
        (!words.is_empty()).then(|| Self { original: text.to_owned(), words })
    }

    /// A printed name. Where it has no ASCII letter or digit it has no words, and code must call the thing otherwise.
    pub fn printed(text: &str) -> Self {
        Self { original: text.to_owned(), words: split(text) }
    }

    /// As written.
    pub fn original(&self) -> &str {
        &self.original
    }

    /// The words, lower case.
    pub fn words(&self) -> &[String] {
        &self.words
    }

    /// The words joined in `case`.
    pub fn to_case(&self, case: Case) -> String {
        match case {
            Case::Snake => self.words.join("_"),
            Case::UpperSnake => self.words.join("_").to_ascii_uppercase(),
            Case::Pascal => self.words.iter().map(|w| capital(w)).collect(),
        }
    }

    /// The words joined in `case` as an identifier: none may start with a digit, so that an `n` goes before it.
    pub fn to_identifier(&self, case: Case) -> String {
        let mut text = self.to_case(case);
        if text.starts_with(|c: char| c.is_ascii_digit()) {
            text.insert(0, if case == Case::Snake { 'n' } else { 'N' });
        }
        text
    }
}

impl fmt::Display for Name {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.original)
    }
}

fn capital(word: &str) -> String {
    let mut chars = word.chars();
    chars.next().map_or_else(String::new, |c| c.to_ascii_uppercase().to_string() + chars.as_str())
}

/// Words end at anything that is no ASCII letter or digit, where a lower-case letter meets an upper-case one, and before
/// the last capital of a run that a lower-case letter follows (`PDOAssign` is `pdo assign`). A digit stays with what is
/// before it (`rxpdo1`, `x2`), and abbreviations of the field that mix cases (`RxPDO`, `CiA`) stay one word, as do their
/// plurals.
fn split(text: &str) -> Vec<String> {
    let mut words = Vec::new();
    for part in text.split(|c: char| !c.is_ascii_alphanumeric()).filter(|p| !p.is_empty()) {
        split_part(part.as_bytes(), &mut words);
    }
    words
}

/// Abbreviations that mix cases and are one word all the same.
const WHOLE: &[&str] = &["RxPDO", "TxPDO", "RPDO", "TPDO", "CiA", "EtherCAT", "CANopen"];

/// Whether what stands at `at` is the `s` of a plural, and the end of a word.
fn is_plural(part: &[u8], at: usize) -> bool {
    part.get(at) == Some(&b's') && !part.get(at + 1).is_some_and(u8::is_ascii_lowercase)
}

/// The abbreviation at `at`, with the `s` of its plural; one inside of a word, as in `SpeCiAl`, is none.
fn whole(part: &[u8], at: usize) -> Option<&[u8]> {
    // All of them begin so, and few letters of a text do.
    if !part[at].is_ascii_uppercase() {
        return None;
    }
    let word = WHOLE.iter().find(|w| part[at..].starts_with(w.as_bytes()))?;
    let end = at + word.len();
    let plural = is_plural(part, end);
    let goes_on = part.get(end).is_some_and(u8::is_ascii_lowercase) && !plural;
    let inside = at.checked_sub(1).is_some_and(|before| part[before].is_ascii_uppercase());
    (!inside && !goes_on).then(|| &part[at..end + usize::from(plural)])
}

fn split_part(part: &[u8], words: &mut Vec<String>) {
    let mut word = String::new();
    let mut at = 0;
    while at < part.len() {
        if let Some(whole) = whole(part, at) {
            flush(&mut word, words);
            word.extend(whole.iter().map(|c| char::from(c.to_ascii_lowercase())));
            at += whole.len();
            if part.get(at).is_some_and(u8::is_ascii_alphabetic) {
                flush(&mut word, words);
            }
            continue;
        }
        let c = part[at];
        let before = at.checked_sub(1).and_then(|i| part.get(i));
        let lower_then_upper =
            before.is_some_and(|b| b.is_ascii_lowercase() || b.is_ascii_digit()) && c.is_ascii_uppercase();
        let run_ends = before.is_some_and(u8::is_ascii_uppercase)
            && c.is_ascii_uppercase()
            && part.get(at + 1).is_some_and(u8::is_ascii_lowercase)
            && !is_plural(part, at + 1);
        if lower_then_upper || run_ends {
            flush(&mut word, words);
        }
        word.push(char::from(c.to_ascii_lowercase()));
        at += 1;
    }
    flush(&mut word, words);
}

fn flush(word: &mut String, words: &mut Vec<String>) {
    if !word.is_empty() {
        words.push(std::mem::take(word));
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn words(text: &str) -> String {
        Name::new(text).map(|n| n.words().join(" ")).unwrap_or_default()
    }

    #[test]
    fn words_of_names() {
        assert_eq!(words("Target position"), "target position");
        assert_eq!(words("FooBar"), words("foo_bar"));
        assert_eq!(words("SDO server"), "sdo server");
        assert_eq!(words("PDOAssign"), "pdo assign");
        assert_eq!(words("1st RxPDO1 Mapped Object"), "1st rxpdo1 mapped object");
        assert_eq!(words("Quick-stop (option) code"), "quick stop option code");
        assert_eq!(words("ModeOp"), "mode op");
        assert_eq!(words("\u{202E}"), "");
    }

    #[test]
    fn abbreviations_are_words_of_their_own() {
        assert_eq!(words("CiA402 EtherCATState NoRxPDO"), "cia402 ethercat state no rxpdo");
        assert_eq!(words("RxPDOs, TPDOs, PDOs, SDOsOff"), "rxpdos tpdos pdos sdos off");
        assert_eq!(words("SpeCiAl"), "spe ci al");
        assert_eq!(words("XRxPDO"), "x rx pdo");
    }

    #[test]
    fn cases() {
        let name = Name::new("Target position").unwrap();
        assert_eq!(name.to_case(Case::UpperSnake), "TARGET_POSITION");
        assert_eq!(name.to_case(Case::Pascal), "TargetPosition");
        assert_eq!(name.to_case(Case::Snake), "target_position");
    }
}
