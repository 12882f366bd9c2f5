//! Every table and every key, once.

mod behaviour;
mod configuration;
mod dictionary;
mod drive;
mod ethercat;
mod reading;

use std::collections::BTreeSet;

use super::Row;
use super::decode::TableInfo;
use super::define::{Visit, VisitMut, tables};
use crate::diag::Sink;
use crate::raw::RawTable;

pub use behaviour::*;
pub use configuration::*;
pub use dictionary::*;
pub use drive::*;
pub use ethercat::*;
pub use reading::*;

tables! {
    /// All rows of a profile or base.
    Rows {
        drive: DriveRow,
        manuals: ManualRow,
        objects: ObjectRow,
        enums: EnumRow,
        bits: BitRow,
        alarms: AlarmRow,
        pdo: PdoRow,
        homing: HomingRow,
        modes: ModeRow,
        states: StateRow,
        commands: CommandRow,
        aborts: AbortRow,
        io: TerminalRow,
        ethercat: EtherCatRow,
        sync_managers: SyncManagerRow,
        fmmus: FmmuRow,
        coe: CoeRow,
        dc_modes: DcModeRow,
        startup: StartUpRow,
        emcy: EmcyRow,
        rules: RuleRow,
        examples: ExampleRow,
        errata: ErratumRow,
        columns: ColumnRow,
        printed: PrintedRow,
        shifted: ShiftedRow,
        unproved: UnprovedRow,
        uncited: UncitedRow,
        audited: AuditedRow,
        allow: AllowRow,
    }
}

tables! {
    /// All rows of a configuration.
    ConfigurationRows {
        axis: AxisRow,
        values: SettingRow,
        pdo: MappedRow,
        communication: CommunicationRow,
    }
}
