//! Why a device refused an SDO transfer.

use core::fmt;

crate::wire_enum! {
    /// The code of an SDO abort, CiA 301 and, from 0601 0003 to 0601 0006, EtherCAT. Open: drives invent codes, and use
    /// these for one another.
    ///
    /// ```
    /// use drivewright_runtime::AbortCode;
    ///
    /// assert_eq!(AbortCode::READ_ONLY.to_string(), "0601 0002: object is read-only");
    /// assert_eq!(AbortCode(0x0800_1234).to_string(), "0800 1234");
    /// ```
    pub struct AbortCode(u32) = "SDO abort" {
        /// The toggle bit did not alternate.
        TOGGLE = 0x0503_0000 => "toggle bit not alternated",
        /// The partner did not answer in time.
        TIMED_OUT = 0x0504_0000 => "SDO protocol timed out",
        /// The command specifier is not valid or not known.
        COMMAND = 0x0504_0001 => "command specifier not valid or unknown",
        /// Block mode: the block size is not valid.
        BLOCK_SIZE = 0x0504_0002 => "invalid block size",
        /// Block mode: the sequence number is not valid.
        SEQUENCE = 0x0504_0003 => "invalid sequence number",
        /// Block mode: the checksum is wrong.
        CRC = 0x0504_0004 => "checksum error",
        /// The device is out of memory.
        OUT_OF_MEMORY = 0x0504_0005 => "out of memory",
        /// This way of access is not supported.
        UNSUPPORTED_ACCESS = 0x0601_0000 => "access to the object is not supported",
        /// A read of a write-only object.
        WRITE_ONLY = 0x0601_0001 => "object is write-only",
        /// A write of a read-only object.
        READ_ONLY = 0x0601_0002 => "object is read-only",
        /// EtherCAT: entries can be written only while sub-index 0 is 0.
        SUB_INDEX_0_NOT_ZERO = 0x0601_0003 => "sub-index 0 must be 0 before entries are written",
        /// EtherCAT: no complete access where lengths vary.
        NO_COMPLETE_ACCESS = 0x0601_0004 => "complete access is not possible: lengths vary",
        /// EtherCAT: the object is longer than the mailbox.
        EXCEEDS_MAILBOX = 0x0601_0005 => "object is longer than the mailbox",
        /// EtherCAT: the object is mapped into an `RxPDO`, so SDO writes are blocked.
        MAPPED_IN_RX_PDO = 0x0601_0006 => "object is mapped into an RxPDO, SDO writes are blocked",
        /// There is no such object.
        NO_OBJECT = 0x0602_0000 => "object does not exist",
        /// The object cannot be mapped into this PDO.
        NOT_MAPPABLE = 0x0604_0041 => "object cannot be mapped into the PDO",
        /// Too many objects, or too many bytes, for the PDO.
        PDO_LENGTH = 0x0604_0042 => "number or length of the mapped objects exceeds the PDO",
        /// Parameters that do not go together.
        INCOMPATIBLE = 0x0604_0043 => "general parameter incompatibility",
        /// Something inside the device does not go together.
        INTERNAL = 0x0604_0047 => "general internal incompatibility",
        /// Hardware, usually memory, failed.
        HARDWARE = 0x0606_0000 => "hardware error",
        /// The length is not that of the type.
        LENGTH = 0x0607_0010 => "data type or length does not match",
        /// More bytes than the type takes.
        LENGTH_TOO_HIGH = 0x0607_0012 => "length too high",
        /// Fewer bytes than the type takes.
        LENGTH_TOO_LOW = 0x0607_0013 => "length too low",
        /// There is no such sub-index.
        NO_SUB_INDEX = 0x0609_0011 => "sub-index does not exist",
        /// A value that the object does not take.
        VALUE = 0x0609_0030 => "value outside the range",
        /// A value above the highest.
        VALUE_TOO_HIGH = 0x0609_0031 => "value too high",
        /// A value below the lowest.
        VALUE_TOO_LOW = 0x0609_0032 => "value too low",
        /// The upper limit is below the lower limit.
        MAX_BELOW_MIN = 0x0609_0036 => "maximum is less than minimum",
        /// No free SDO connection.
        NO_RESOURCE = 0x060A_0023 => "resource not available",
        /// A failure without a better name.
        GENERAL = 0x0800_0000 => "general error",
        /// The value cannot be taken or stored.
        NOT_STORED = 0x0800_0020 => "data cannot be transferred or stored",
        /// The same, because the device is operated locally.
        LOCAL_CONTROL = 0x0800_0021 => "data cannot be transferred or stored because of local control",
        /// The same, because of the state that the device is in.
        DEVICE_STATE = 0x0800_0022 => "data cannot be transferred or stored in the present device state",
        /// There is no dictionary to look it up in.
        NO_DICTIONARY = 0x0800_0023 => "no object dictionary, or its generation failed",
        /// There is nothing to read.
        NO_DATA = 0x0800_0024 => "no data available",
    }
}

impl fmt::Display for AbortCode {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{:04X} {:04X}", self.0 >> 16, self.0 & 0xFFFF)?;
        self.name().map_or(Ok(()), |name| write!(f, ": {name}"))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::wire_enum::EnumValue;
    use std::collections::BTreeSet;

    #[test]
    fn codes_and_names_are_unique() {
        let values = AbortCode::DESC.values();
        let codes: BTreeSet<i64> = values.iter().map(EnumValue::value).collect();
        let names: BTreeSet<&str> = values.iter().map(EnumValue::name).collect();
        assert_eq!((values.len(), codes.len(), names.len()), (35, 35, 35));
    }
}
