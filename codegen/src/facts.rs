//! The list of facts of a model: what `map.txt` prints and what the audit counts.
