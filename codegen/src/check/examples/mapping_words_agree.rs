//! E1301: the mapping word of an example is not the one of its entry.

use crate::check::Lint;
use crate::diag::{Code, Sink};
use crate::model::{Example, Model};

const CODE: Code = Code::error("E1301", "the mapping word of an example is not the one of its entry");
const WHY: &str = "examples are test vectors, and readers copy them: one of the three is read wrongly";
const HELP: &str =
    "compare the example with the dictionary. `60400010h` is object 6040h, sub-index 00h, 16 bits";

/// Compares `value` of an example with the word that `entry` and `bits` make, and `bits` with the type of the entry.
pub(in crate::check) const LINT: Lint =
    Lint { code: CODE, page: include_str!("mapping_words_agree.md"), run };

fn run(model: &Model, sink: &mut Sink) {
    for example in &model.examples {
        let (Some(value), Some(wrong)) = (&example.value, wrong(model, example)) else { continue };
        let text = format!("`example {}` {wrong}", example.label());
        sink.push(super::finding(
            CODE,
            value.span(),
            &format!("example {}", example.label()),
            text,
            WHY,
            HELP,
        ));
    }
}

/// What is wrong with a mapping word, where the example has one.
fn wrong(model: &Model, example: &Example) -> Option<String> {
    let (entry, bits, value) = (example.entry.as_ref()?, example.bits.as_ref()?, example.value.as_ref()?);
    if super::settled(entry) || super::settled(bits) || super::settled(value) {
        return None;
    }
    let (address, length) = (entry.value, bits.value);
    let word = i128::from(address.index) << 16 | i128::from(address.sub) << 8 | i128::from(length);
    let width = model.entry(address).map(|(_, entry)| entry.ty.value.bits())?;
    if width != Some(length) {
        return Some(format!("maps {length} bits of {address}, which has another width"));
    }
    (value.value != word).then(|| format!("has {:08X}h, and {address} maps as {word:08X}h", value.value))
}
