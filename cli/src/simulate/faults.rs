//! Disturbances and inputs.

use drivewright_runtime::sim::VirtualDrive;

use crate::stage::Watched;

pub(super) fn disturb(
    _bus: &mut Watched<'_, '_, '_>,
    kind: &str,
    _number: Option<u64>,
) -> Result<String, String> {
    Err(format!("there is no fault `{}`", kind.escape_debug()))
}

pub(super) fn input(_drive: &mut VirtualDrive<'_, '_>, name: &str, _on: bool) -> Result<String, String> {
    Err(format!("there is no input `{}`", name.escape_debug()))
}
