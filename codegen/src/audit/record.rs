//! What an audit leaves behind: hashes and counts, so that facts cannot change without a new one.

use std::fmt::Write;

use sha2::{Digest, Sha256};

use super::Report;
use crate::facts::FactLine;

/// The record of an audit, a row of the table `audited`.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Record {
    /// Id of the manual.
    pub manual: String,
    /// SHA-256 of the text extract.
    pub extract: String,
    /// SHA-256 of the facts.
    pub facts: String,
    /// Facts that the cited lines hold.
    pub proved: usize,
    /// Facts that are accepted without proof.
    pub accepted: usize,
    /// Rows of printed tables that facts cite.
    pub cited_lines: usize,
    /// Rows of printed tables that none cites, with a reason.
    pub uncited_lines: usize,
}

impl Record {
    /// The record of `report`.
    pub fn new(manual: &str, text: &str, facts: &[FactLine<'_>], report: &Report) -> Self {
        Self {
            manual: manual.to_owned(),
            extract: text_hash(text),
            facts: facts_hash(facts),
            proved: report.proved,
            accepted: report.accepted(),
            cited_lines: report.cited_lines,
            uncited_lines: report.uncited_lines,
        }
    }

    /// The file `audit.toml` with this record.
    pub fn to_toml(&self) -> String {
        format!(
            "# Written by `drivewright audit --record`: the last audit of these facts. When a fact changes, audit again.\n\
             audited = [\n  {{ manual = \"{}\", extract = \"{}\", facts = \"{}\", proved = {}, accepted = {}, \
             cited_lines = {}, uncited_lines = {} }},\n]\n",
            self.manual,
            self.extract,
            self.facts,
            self.proved,
            self.accepted,
            self.cited_lines,
            self.uncited_lines
        )
    }
}

fn hex(bytes: &[u8]) -> String {
    bytes.iter().fold(String::with_capacity(64), |mut out, byte| {
        // Writing to a String cannot fail.
        let _ = write!(out, "{byte:02x}");
        out
    })
}

/// SHA-256 of a text.
pub fn text_hash(text: &str) -> String {
    hex(&Sha256::digest(text.as_bytes()))
}

/// SHA-256 of the facts that a manual can prove: keys, values, classes and citations, not the profile's own words.
pub fn facts_hash(facts: &[FactLine<'_>]) -> String {
    let mut hash = Sha256::new();
    for fact in facts.iter().filter(|f| f.class.is_some() || f.cite.is_some()) {
        let class = fact.class.map(ToString::to_string).unwrap_or_default();
        let cite = fact.cite.map(ToString::to_string).unwrap_or_default();
        for part in [&fact.key, &fact.field.to_string(), &fact.value, &class, &cite] {
            hash.update(part.as_bytes());
            hash.update([0]);
        }
    }
    hex(&hash.finalize())
}
