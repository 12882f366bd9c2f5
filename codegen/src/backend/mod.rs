//! Output formats. A new one is a folder here and a line in [`ALL`].

mod assumed;
pub mod docs;
pub mod eds;
pub mod esi;
pub mod ethercat;
pub mod json;
mod losses;
pub mod map;
mod prose;
pub mod rust;
pub mod sii;
mod template;
mod unique;

use crate::diag::{Code, Sink};
use crate::emit::FileSet;
use crate::model::Model;

/// An output format. It sees the model and nothing before it, writes paths below the drive's folder, and reports what
/// the format cannot express as a warning: nothing is dropped in silence.
pub trait Backend: Sync {
    /// Short name, as options and reports use it.
    fn id(&self) -> &'static str;
    /// The codes of its warnings, ascending.
    fn codes(&self) -> &'static [Code] {
        &[]
    }
    /// Adds the files of `model` to `out`. A model without errors can always be emitted.
    fn emit(&self, model: &Model, out: &mut FileSet, sink: &mut Sink);
}

/// Every backend, in the order of output.
pub const ALL: &[&dyn Backend] =
    &[&rust::Rust, &eds::Eds, &esi::Esi, &sii::Sii, &json::Json, &map::Map, &docs::Docs];

#[cfg(test)]
mod tests {
    use super::*;
    use crate::diag::{Severity, code};

    #[test]
    fn codes_of_backends_are_warnings_and_given_once() {
        let codes: Vec<Code> = ALL.iter().flat_map(|backend| backend.codes()).copied().collect();
        assert!(!codes.is_empty() && codes.iter().all(|c| c.severity() == Severity::Warning));
        for (n, code) in codes.iter().enumerate() {
            let others =
                codes[..n].iter().chain(code::ALL).chain(crate::check::LINTS.iter().map(|l| &l.code));
            assert!(others.clone().all(|other| other.id()[1..] != code.id()[1..]), "{}", code.id());
        }
    }
}
