//! Brings a [`crate::emit::FileSet`] to disk, or compares it with what is there.
