//! The standard bases.

/// A base profile.
#[derive(Clone, Copy, Debug)]
pub struct Base {
    /// Its name.
    pub name: &'static str,
    /// Its files: path and text.
    pub files: &'static [(&'static str, &'static str)],
}

/// Every base.
pub fn bases() -> &'static [Base] {
    &[]
}
