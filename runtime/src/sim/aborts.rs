//! Abort codes that the drive lists: another one is replaced by the nearest that it has.

use crate::abort::AbortCode;
use crate::model::DriveModel;

/// What says less than `code` and is true as well; `None` for the code that says nothing.
const fn wider(code: AbortCode) -> Option<AbortCode> {
    Some(match code {
        AbortCode::VALUE_TOO_HIGH
        | AbortCode::VALUE_TOO_LOW
        | AbortCode::MAX_BELOW_MIN
        | AbortCode::INCOMPATIBLE => AbortCode::VALUE,
        AbortCode::LENGTH_TOO_HIGH | AbortCode::LENGTH_TOO_LOW => AbortCode::LENGTH,
        AbortCode::READ_ONLY
        | AbortCode::WRITE_ONLY
        | AbortCode::SUB_INDEX_0_NOT_ZERO
        | AbortCode::NOT_MAPPABLE
        | AbortCode::NO_COMPLETE_ACCESS => AbortCode::UNSUPPORTED_ACCESS,
        AbortCode::PDO_LENGTH => AbortCode::INCOMPATIBLE,
        AbortCode::NO_SUB_INDEX => AbortCode::NO_OBJECT,
        AbortCode::LOCAL_CONTROL => AbortCode::DEVICE_STATE,
        AbortCode::DEVICE_STATE => AbortCode::NOT_STORED,
        AbortCode::GENERAL => return None,
        _ => AbortCode::GENERAL,
    })
}

/// `code`, or the nearest that the drive lists. One that lists none has them all; one that lists nothing near gives the
/// code itself.
pub(crate) fn listed(model: &DriveModel<'_>, code: AbortCode) -> AbortCode {
    let has = |code: &AbortCode| model.aborts().is_empty() || model.abort(*code).is_some();
    core::iter::successors(Some(code), |code| wider(*code)).find(has).unwrap_or(code)
}

#[cfg(test)]
mod tests {
    use super::super::samples::MODEL;
    use super::*;
    use crate::model::{AbortDesc, Identity};

    #[test]
    fn what_is_not_listed_is_replaced() {
        assert_eq!(listed(&MODEL, AbortCode::DEVICE_STATE), AbortCode::DEVICE_STATE, "it lists none");
        let rows = [AbortCode::VALUE, AbortCode::GENERAL].map(|code| AbortDesc::new(code, ""));
        let few = DriveModel::new(Identity::new("x", "y", "z")).with_aborts(&rows);
        assert_eq!(listed(&few, AbortCode::VALUE_TOO_HIGH), AbortCode::VALUE);
        assert_eq!(listed(&few, AbortCode::PDO_LENGTH), AbortCode::VALUE);
        assert_eq!(listed(&few, AbortCode::LOCAL_CONTROL), AbortCode::GENERAL);
        let none = [AbortDesc::new(AbortCode::TOGGLE, "")];
        let none = DriveModel::new(Identity::new("x", "y", "z")).with_aborts(&none);
        assert_eq!(listed(&none, AbortCode::READ_ONLY), AbortCode::READ_ONLY);
    }
}
