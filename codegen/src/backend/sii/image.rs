//! Bytes with their meaning: the image and its listing come from the same fields, and cannot differ.

use crate::backend::ethercat::Assumptions;

/// Who says a field.
#[derive(Clone, Copy)]
pub(super) enum Said<'k> {
    /// The format demands the value, whatever the drive is.
    Format,
    /// The profile.
    Profile,
    /// The profile, unless there is an assumption of that name.
    Unless(&'k str),
    /// Whoever says the field that refers to it.
    Below,
}

/// Some bytes that mean one thing.
pub(super) struct Field {
    pub(super) bytes: Vec<u8>,
    /// `format`, `assumed`, `profile` or `below`.
    pub(super) source: &'static str,
    /// What it is, and its value where the bytes do not say it plainly.
    pub(super) what: String,
}

/// Fields, one behind the other.
pub(super) struct Image<'m> {
    fields: Vec<Field>,
    assumed: &'m Assumptions,
}

impl<'m> Image<'m> {
    pub(super) fn new(assumed: &'m Assumptions) -> Self {
        Self { fields: Vec::new(), assumed }
    }

    pub(super) fn fields(&self) -> &[Field] {
        &self.fields
    }

    pub(super) fn len(&self) -> usize {
        self.fields.iter().map(|field| field.bytes.len()).sum()
    }

    pub(super) fn bytes(&self) -> Vec<u8> {
        self.fields.iter().flat_map(|field| field.bytes.iter().copied()).collect()
    }

    pub(super) fn append(&mut self, mut other: Self) {
        self.fields.append(&mut other.fields);
    }

    pub(super) fn put(&mut self, said: Said<'_>, what: impl Into<String>, bytes: &[u8]) {
        let source = match said {
            Said::Format => "format",
            Said::Unless(name) if self.assumed.holds(name) => "assumed",
            Said::Profile | Said::Unless(_) => "profile",
            Said::Below => "below",
        };
        self.fields.push(Field { bytes: bytes.to_vec(), source, what: what.into() });
    }

    pub(super) fn byte(&mut self, said: Said<'_>, what: impl Into<String>, value: u8) {
        self.put(said, what, &[value]);
    }

    pub(super) fn word(&mut self, said: Said<'_>, what: &str, value: u16) {
        self.put(said, format!("{what}: 0x{value:04X}"), &value.to_le_bytes());
    }

    pub(super) fn long(&mut self, said: Said<'_>, what: &str, value: u32) {
        self.put(said, format!("{what}: 0x{value:08X}"), &value.to_le_bytes());
    }

    /// Bytes that have no meaning yet.
    pub(super) fn reserved(&mut self, count: usize) {
        self.put(Said::Format, "Reserved", &vec![0; count]);
    }

    /// These fields as a category of `kind`, filled up to whole words; nothing where there are none.
    pub(super) fn category(mut self, kind: u16, name: &str, fill: u8) -> Self {
        if self.fields.is_empty() {
            return self;
        }
        if !self.len().is_multiple_of(2) {
            self.put(Said::Format, "Filled up to a word", &[fill]);
        }
        let mut whole = Self::new(self.assumed);
        whole.word(Said::Format, &format!("Category {kind}, {name}"), kind);
        // No category is longer: strings have 64 KiB, and the caller leaves out PDOs that do not fit.
        whole.word(Said::Format, "Its length in words", u16::try_from(self.len() / 2).unwrap_or(u16::MAX));
        whole.append(self);
        whole
    }
}
