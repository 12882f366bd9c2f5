//! What a drive is, on both ends of the line.

use std::time::Duration;

use drivewright_runtime::Address;
use drivewright_runtime::cia402::Mode;
use drivewright_runtime::client::axis::AxisPolicy;
use drivewright_runtime::client::error::ClientError;
use drivewright_runtime::client::home::Homing;
use drivewright_runtime::client::image::Image;
use drivewright_runtime::client::session::Client;
use drivewright_runtime::sim::{Config, VirtualDrive, cells};
use savch_sdv3_e::{MODEL, od};

/// SDV3-E manual, 4.2: 607Dh has the lower limit at sub-index 1 and the upper one at 2.
#[test]
fn b34_limits_are_at_the_sub_index_of_their_name() {
    assert_eq!(od::MIN_POSITION_LIMIT.address(), Address::new(0x607D, 1));
    assert_eq!(od::MAX_POSITION_LIMIT.address(), Address::new(0x607D, 2));
}

/// The objects of the second axis lie 800h above those of the first.
#[test]
fn b37_each_axis_has_its_own_objects() {
    for (axis, controlword) in [(0, 0x6040), (1, 0x6840), (3, 0x7840)] {
        let image = Image::for_axis(&[], &[], axis).unwrap();
        assert_eq!(image.at(Address::new(0x6040, 0)), Address::new(controlword, 0));
        assert_eq!(image.at(Address::new(0x1018, 1)), Address::new(0x1018, 1), "the device is one");
    }
}

#[test]
fn b25_no_homing_is_no_method() {
    let client = Client::new(&MODEL, Image::of(&MODEL, 0x1600, 0x1A00).unwrap(), AxisPolicy::default());
    let refused = Homing::method(0).plan(&client).err();
    assert!(matches!(refused, Some(ClientError::NotAHomingMethod { method: 0 })), "{refused:?}");
}

/// A virtual drive that acknowledges, and moves.
#[test]
fn b43_the_virtual_drive_acknowledges_a_set_point_and_goes_there() {
    let mut memory = vec![0; cells(&MODEL)];
    let mut drive = VirtualDrive::new(&MODEL, &mut memory, Config::default()).unwrap();
    let ms = |drive: &mut VirtualDrive<'_, '_>, n| drive.advance(Duration::from_millis(n));
    ms(&mut drive, 200);
    let write = |drive: &mut VirtualDrive<'_, '_>, index, data: &[u8]| {
        drive.download(Address::new(index, 0), data).unwrap();
        ms(drive, 5);
    };
    write(&mut drive, 0x6060, &[Mode::PROFILE_POSITION.0.to_le_bytes()[0]]);
    write(&mut drive, 0x6081, &1_000_u32.to_le_bytes());
    write(&mut drive, 0x607A, &4_000_i32.to_le_bytes());
    for word in [0x06_u16, 0x07, 0x0F] {
        write(&mut drive, 0x6040, &word.to_le_bytes());
    }
    let acknowledged = |drive: &VirtualDrive<'_, '_>| drive.statusword().0 & 0x1000 != 0;
    assert!(!acknowledged(&drive));
    write(&mut drive, 0x6040, &0x1F_u16.to_le_bytes());
    assert!(acknowledged(&drive));
    write(&mut drive, 0x6040, &0x0F_u16.to_le_bytes());
    assert!(!acknowledged(&drive));
    ms(&mut drive, 20_000);
    let place = drive.value(Address::new(0x6064, 0)).unwrap();
    assert!((place - 4_000).abs() < 50, "{place}");
}
