//! Homing methods.

use drivewright_runtime::homing::{HomingCase, HomingDesc};

use super::Arena;
use crate::model::{self, HomingMethod, Model};

pub(super) fn table<'a>(profile: &'a Model, arena: &'a Arena) -> &'a [HomingDesc<'a>] {
    arena.slice(profile.homing.iter().map(|method| row(method, arena)))
}

fn row<'a>(method: &'a HomingMethod, arena: &'a Arena) -> HomingDesc<'a> {
    let cases = arena.slice(method.cases.iter().map(case));
    let row = HomingDesc::new(method.number).with_status(method.status.value).with_cases(cases);
    let row = method.same.as_ref().map_or(row, |same| row.with_same(same.value));
    let row = method.start.as_ref().map_or(row, |start| row.with_start(start.value));
    let row = method.approach.as_ref().map_or(row, |approach| row.with_approach(approach.value));
    let row = method.reference.as_ref().map_or(row, |reference| row.with_reference(reference.value));
    let row = method.side.as_ref().map_or(row, |side| row.with_side(side.value));
    method.edge.as_ref().map_or(row, |edge| row.with_edge(edge.value))
}

fn case(case: &model::HomingCase) -> HomingCase<'_> {
    let row = HomingCase::new(&case.when.value.0, &case.moves.value.0);
    let row = case.abort.as_ref().map_or(row, |abort| row.with_abort(&abort.value.0));
    case.mask.as_ref().map_or(row, |mask| row.with_mask(&mask.value))
}
