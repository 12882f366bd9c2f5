//! One tree for every input format: rows of keys and values, each with its place.
