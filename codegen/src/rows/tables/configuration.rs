//! What a user sets in one drive: the tables of a configuration.

use std::collections::BTreeMap;

use crate::diag::Sink;
use crate::model::{Address, Cite, Value};
use crate::raw::RawRow;
use crate::rows::decode::{Decoder, FieldInfo, TableInfo};
use crate::rows::define::rows;
use crate::rows::kind::FromRaw;
use crate::rows::value::{Ident, Text};
use crate::rows::{Meta, Row};
use crate::source::Sp;

rows! {
    /// The axis: one row.
    AxisRow in axis, key |_row| { "axis".to_owned() } {
        /// Version of the configuration format: 1.
        format "format": required u32,
        /// Id of the drive, or name of its package.
        drive "drive": required Ident,
        /// Node-ID, 1 to 127.
        node_id "node_id": required u8,
        /// Name of the node.
        name "name": optional Text,
        /// Bit rate of the CAN bus, in kbit/s.
        baudrate "baudrate": optional u16,
        /// Number of the network.
        network "network": optional u32,
        /// Serial number of the one drive that it is for.
        serial "serial": optional u32,
        /// A remark for the reader.
        note "note": optional Text,
    }

    /// A value that the master writes, in the order of rows.
    SettingRow in values, key |row| { row.at.value.to_string() } {
        /// The object: `6081:00`.
        at "at": required Address,
        /// A raw count, or a quantity that is a whole number of counts: `"150.0 rpm"`.
        value "value": required Value,
        /// A remark for the reader.
        note "note": optional Text,
    }

    /// An entry that a PDO carries. The rows of one PDO, in their order, are its whole mapping.
    MappedRow in pdo, key |row| { format!("pdo {:04X}", row.map.value) } {
        /// Index of the mapping object.
        map "map": required u16,
        /// The mapped entry.
        entry "entry": required Address,
        /// A remark for the reader.
        note "note": optional Text,
    }

    /// When and under which identifier a PDO goes over the CAN bus. What is left out stays as it is.
    CommunicationRow in communication, key |row| { format!("communication {:04X}", row.map.value) } {
        /// Index of the mapping object.
        map "map": required u16,
        /// The CAN identifier, 11 bits.
        cob_id "cob_id": optional u32,
        /// Transmission type.
        transmission "transmission": optional u8,
        /// Inhibit time, in 100 us.
        inhibit "inhibit": optional u16,
        /// Event timer, in ms.
        event "event": optional u16,
        /// `true`: the PDO is switched off. A PDO of this table or of `pdo` is switched on otherwise.
        off "off": optional bool,
        /// A remark for the reader.
        note "note": optional Text,
    }
}
