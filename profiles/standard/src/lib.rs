//! The standard bases.
