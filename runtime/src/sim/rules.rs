//! The rules of the manual, asked at the moment at which they must hold.

use crate::address::Address;
use crate::model::{AlarmDesc, DriveModel};
use crate::rule::{Occasion, RuleDesc};

use super::memory::Memory;
use super::words::{after, holds};

/// The rules of an occasion that are broken at this moment.
pub(crate) fn broken<'a, 'm>(
    memory: &'a Memory<'m, '_>,
    on: Occasion,
) -> impl Iterator<Item = &'m RuleDesc<'m>> + 'a {
    let value = |at| memory.at(at).map(i128::from);
    memory.model().rules_on(Some(on)).filter(move |rule| rule.broken(value))
}

/// The rules without an occasion, and those of process data, that name `address` and are broken once it holds `value`.
pub(crate) fn broken_by<'a, 'm>(
    memory: &'a Memory<'m, '_>,
    address: Address,
    value: i64,
) -> impl Iterator<Item = &'m RuleDesc<'m>> + 'a {
    let with = move |at| if at == address { Some(value) } else { memory.at(at) }.map(i128::from);
    let model = memory.model();
    let rules = model.rules_on(None).chain(model.rules_on(Some(Occasion::Remap)));
    rules.filter(move |rule| rule.names(address) && rule.broken(with))
}

/// The alarm that a rule names in its words: `alarm oPE`. A rule has no other place for it.
pub(crate) fn alarm<'m>(model: &DriveModel<'m>, rule: &RuleDesc<'_>) -> Option<&'m AlarmDesc<'m>> {
    let rest = after(rule.text(), "alarm ")?;
    let named = |alarm: &&AlarmDesc<'_>| {
        let end = rest.strip_prefix(alarm.display().as_bytes());
        end.is_some_and(|end| !end.first().is_some_and(u8::is_ascii_alphanumeric))
    };
    model.alarms().iter().find(named)
}

/// Whether a write that breaks the rule is refused: process data are, and what the manual says is.
pub(crate) fn refuses(rule: &RuleDesc<'_>) -> bool {
    rule.on() == Some(Occasion::Remap) || holds(rule.text(), "refused")
}

#[cfg(test)]
mod tests {
    use super::super::samples::MODEL;
    use super::*;

    #[test]
    fn a_rule_names_its_alarm() {
        let named = |text| alarm(&MODEL, &RuleDesc::new("R", text)).map(AlarmDesc::number);
        assert_eq!(named("A mode is set before: alarm OF."), Some(0x25));
        assert_eq!(named("alarm OFF"), None);
        assert_eq!(named("There is an alarm"), None);
    }
}
