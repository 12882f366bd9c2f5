//! The driver against a drive that is a map in memory.

use std::collections::BTreeMap;

use drivewright_runtime::prelude::*;
use drivewright_runtime::AbortCode;
use sdv3_e_driver::{run_at, Driver, Error, Sdo};

/// Objects and their bytes.
#[derive(Default)]
struct Memory(BTreeMap<Address, Vec<u8>>);

impl Memory {
    fn with(mut self, index: u16, sub: u8, bytes: &[u8]) -> Self {
        self.0.insert(Address::new(index, sub), bytes.to_vec());
        self
    }
}

impl Sdo for &mut Memory {
    type Error = AbortCode;

    fn upload(&mut self, at: Address, buffer: &mut [u8]) -> Result<usize, AbortCode> {
        let bytes = self.0.get(&at).ok_or(AbortCode::NO_OBJECT)?;
        buffer[..bytes.len()].copy_from_slice(bytes);
        Ok(bytes.len())
    }

    fn download(&mut self, at: Address, bytes: &[u8]) -> Result<(), AbortCode> {
        self.0.insert(at, bytes.to_vec());
        Ok(())
    }
}

/// 1018h sub-index 2 of the manual, least significant byte first: the letters `3VDS`.
const PRODUCT: &[u8] = b"3VDS";

#[test]
fn writes_a_velocity_in_counts_of_a_tenth() {
    let mut memory = Memory::default().with(0x1018, 2, PRODUCT);
    Driver::new(&mut memory).unwrap().set_profile_velocity(Value::rpm(1_500)).unwrap();
    assert_eq!(memory.0[&Address::new(0x6081, 0)], 15_000_u32.to_le_bytes());
}

#[test]
fn refuses_what_the_manual_does_not_allow_and_sends_nothing() {
    let mut memory = Memory::default().with(0x1018, 2, PRODUCT);
    let refused = Driver::new(&mut memory).unwrap().set_profile_velocity(Value::rpm(6_001));
    assert!(matches!(refused, Err(Error::Unit(_))), "{refused:?}");
    assert!(!memory.0.contains_key(&Address::new(0x6081, 0)));
}

#[test]
fn another_device_is_not_driven() {
    let mut memory = Memory::default().with(0x1018, 2, &[1, 0, 0, 0]);
    assert!(matches!(Driver::new(&mut memory), Err(Error::Identity { found: 1, .. })));
    assert!(matches!(Driver::new(&mut Memory::default()), Err(Error::Transfer(_))));
}

/// The frame byte by byte, from the lines of the manual: 6040, 607A, 60FF, 6071, 6060.
#[test]
fn a_frame_has_each_byte_in_its_place() {
    let frame = run_at(Value::rpm(-100)).unwrap();
    assert_eq!(frame, [0x0F, 0, 0, 0, 0, 0, 0x18, 0xFC, 0xFF, 0xFF, 0, 0, 9]);
}
