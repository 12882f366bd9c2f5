//! Names that are one for each object or entry: as printed, with the number behind where one print stands for several.

use std::collections::{BTreeMap, BTreeSet};

/// The names as `text` writes them, each at most `longest` bytes; one that stands there twice, or of which nothing is left,
/// gets the number that comes with it.
pub(super) fn unique(names: &[(&str, String)], text: impl Fn(&str) -> String, longest: usize) -> Vec<String> {
    let texts: Vec<String> = names.iter().map(|(name, _)| capped(&text(name), longest)).collect();
    let mut times: BTreeMap<&str, u32> = BTreeMap::new();
    for text in &texts {
        *times.entry(text).or_insert(0) += 1;
    }
    let alone = |text: &&String| times.get(text.as_str()) == Some(&1) && !text.is_empty();
    let mut taken: BTreeSet<String> = texts.iter().filter(alone).cloned().collect();
    let name = |(text, (_, number)): (&String, &(&str, String))| {
        if alone(&text) { text.clone() } else { numbered(text, number, longest, &mut taken) }
    };
    texts.iter().zip(names).map(name).collect()
}

/// The first bytes of a text, up to a whole character.
pub(super) fn capped(text: &str, most: usize) -> String {
    let end = (0..=most.min(text.len())).rev().find(|at| text.is_char_boundary(*at)).unwrap_or(0);
    text[..end].trim_end().to_owned()
}

/// `text` with its number behind it, more than once should that be the name of another.
fn numbered(text: &str, number: &str, longest: usize, taken: &mut BTreeSet<String>) -> String {
    let mut tail = String::new();
    loop {
        tail.extend([" ", number]);
        let name = capped(text, longest.saturating_sub(tail.len())) + &tail;
        let name = name.trim_start().to_owned();
        if taken.insert(name.clone()) {
            return name;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_character_is_not_cut() {
        assert_eq!(capped("aé", 2), "a");
        assert_eq!(capped("aé", 3), "aé");
        let names = [("éé", "1".to_owned()), ("éé", "2".to_owned())];
        assert_eq!(unique(&names, str::to_owned, 5), ["é 1", "é 2"]);
    }
}
