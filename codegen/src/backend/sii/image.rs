//! Bytes with their meaning: the image and its listing come from the same fields, and cannot differ.

use crate::backend::ethercat::Assumptions;

/// Who says a field: the format itself, or the drive, by the name that an assumption would have.
pub(super) type Said<'k> = Option<&'k str>;

/// The format demands the value, whatever the drive is.
pub(super) const FORMAT: Said<'static> = None;

/// Some bytes that mean one thing.
pub(super) struct Field {
    pub(super) bytes: Vec<u8>,
    /// `format`, `assumed`, or `profile`.
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
            None => "format",
            Some(name) if self.assumed.holds(name) => "assumed",
            Some(_) => "profile",
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
        self.put(FORMAT, "Reserved", &vec![0; count]);
    }

    /// These fields as a category of `kind`, filled up to whole words; nothing where there are none.
    pub(super) fn category(mut self, kind: u16, name: &str, fill: u8) -> Self {
        if self.fields.is_empty() {
            return self;
        }
        if !self.len().is_multiple_of(2) {
            self.put(FORMAT, "Filled up to a word", &[fill]);
        }
        let mut whole = Self::new(self.assumed);
        whole.word(FORMAT, &format!("Category {kind}, {name}"), kind);
        // No category is longer: strings have 64 KiB, and the caller leaves out PDOs that do not fit.
        whole.word(FORMAT, "Its length in words", u16::try_from(self.len() / 2).unwrap_or(u16::MAX));
        whole.append(self);
        whole
    }
}
