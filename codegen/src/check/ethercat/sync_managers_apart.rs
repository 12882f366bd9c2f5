//! E1502: two sync managers share memory.

use crate::check::Lint;
use crate::diag::{Code, Sink};
use crate::model::{Model, SyncManager, SyncManagerUse};

const CODE: Code = Code::error("E1502", "two sync managers share memory");
const WHY: &str = "what one of them receives would overwrite what the other one holds";
const HELP: &str = "look at `start`, `size` and `max_size` again; process data takes its length three times";

/// Compares the memory of each sync manager with that of the others.
pub(in crate::check) const LINT: Lint =
    Lint { code: CODE, page: include_str!("sync_managers_apart.md"), run };

/// First address and the one behind the last.
fn memory(manager: &SyncManager) -> Option<(u32, u32)> {
    let start = u32::from(manager.start.as_ref()?.value);
    let size = u32::from(manager.max_size.as_ref().or(manager.size.as_ref())?.value);
    let buffers = match manager.carries.value {
        SyncManagerUse::MailboxOut | SyncManagerUse::MailboxIn => 1,
        SyncManagerUse::Outputs | SyncManagerUse::Inputs => 3,
    };
    Some((start, start + size * buffers))
}

fn run(model: &Model, sink: &mut Sink) {
    let mut placed: Vec<(u32, u32, &SyncManager)> =
        model.sync_managers.iter().filter_map(|m| memory(m).map(|(start, end)| (start, end, m))).collect();
    placed.sort_by_key(|(start, _, manager)| (*start, manager.number));
    for pair in placed.windows(2) {
        let [(_, end, first), (start, _, second)] = pair else { continue };
        if start >= end {
            continue;
        }
        let row = format!("sync manager {}", second.number);
        let text = format!("`{row}` starts at {start:04X}h, before sync manager {} ends", first.number);
        let span = second.start.as_ref().map_or(second.carries.span(), crate::model::Fact::span);
        let last = first.start.as_ref().map_or(first.carries.span(), crate::model::Fact::span);
        sink.push(
            super::finding(CODE, span, &row, text, WHY, HELP)
                .related(last, format!("its memory ends before {end:04X}h")),
        );
    }
}
