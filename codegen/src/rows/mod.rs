//! The rows of each table, decoded from the raw tree.
