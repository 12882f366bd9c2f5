//! A small drive, made by hand: the values of the tests.

use crate::homing::{Event, HomingCase, HomingDesc, HomingStatus, Level, Side, Signal, Step};
use crate::prelude::*;

pub(crate) const fn at(index: u16, sub: u8) -> Address {
    Address::new(index, sub)
}

/// One line an entry: index, sub-index, type, access, mapping, and what is said beyond.
macro_rules! objects {
    ($($index:literal:$sub:literal $ty:ident $access:ident $map:ident $(.$more:ident($($value:expr),*))*;)*) => {
        &[$(
            ObjectDesc::new(at($index, $sub), DataType::$ty, Access::$access, Mapping::$map, stringify!($index))
                $(.$more($($value),*))*,
        )*]
    };
}

static OBJECTS: &[ObjectDesc<'static>] = objects! {
    0x1000:0 UNSIGNED32 Ro Unmapped.default_int(0x0002_0192);
    0x1001:0 UNSIGNED8 Ro Tx;
    0x1003:0 UNSIGNED8 Rw Unmapped;
    0x1003:1 UNSIGNED32 Ro Unmapped;
    0x1003:2 UNSIGNED32 Ro Unmapped;
    0x1008:0 VISIBLE_STRING Const Unmapped;
    0x1010:0 UNSIGNED8 Ro Unmapped.default_int(3);
    0x1010:1 UNSIGNED32 Rw Unmapped;
    0x1010:3 UNSIGNED32 Rw Unmapped;
    0x1011:0 UNSIGNED8 Ro Unmapped.default_int(1);
    0x1011:1 UNSIGNED32 Rw Unmapped;
    0x1600:0 UNSIGNED8 Rw Unmapped.range(0, 8);
    0x1600:1 UNSIGNED32 Rw Unmapped.default_int(0x6040_0010);
    0x1600:2 UNSIGNED32 Rw Unmapped.default_int(0x607A_0020);
    0x1600:3 UNSIGNED32 Rw Unmapped.default_int(0x6060_0008);
    0x1600:4 UNSIGNED32 Rw Unmapped;
    0x1A00:0 UNSIGNED8 Rw Unmapped.range(0, 8).default_int(3);
    0x1A00:1 UNSIGNED32 Rw Unmapped.default_int(0x6041_0010);
    0x1A00:2 UNSIGNED32 Rw Unmapped.default_int(0x6064_0020);
    0x1A00:3 UNSIGNED32 Rw Unmapped.default_int(0x6061_0008);
    0x1A00:4 UNSIGNED32 Rw Unmapped;
    0x1A00:5 UNSIGNED32 Rw Unmapped;
    0x1A00:6 UNSIGNED32 Rw Unmapped;
    0x1A00:7 UNSIGNED32 Rw Unmapped;
    0x1A00:8 UNSIGNED32 Rw Unmapped;
    0x1C12:0 UNSIGNED8 Rw Unmapped.range(0, 1).default_int(1);
    0x1C12:1 UNSIGNED16 Rw Unmapped.default_int(0x1600);
    0x1C13:0 UNSIGNED8 Rw Unmapped.range(0, 1).default_int(1);
    0x1C13:1 UNSIGNED16 Rw Unmapped.default_int(0x1A00);
    0x2000:1 INTEGER16 Rw Unmapped;
    0x2000:2 INTEGER16 Rw Unmapped;
    0x2001:0 BOOLEAN Rw RxTx;
    0x2002:0 UNSIGNED8 Wo Unmapped;
    0x603F:0 UNSIGNED16 Ro Tx;
    0x6040:0 UNSIGNED16 Rw Rx;
    0x6041:0 UNSIGNED16 Ro Tx;
    0x605A:0 INTEGER16 Rw Unmapped.default_int(2);
    0x605B:0 INTEGER16 Rw Unmapped.default_int(0);
    0x605C:0 INTEGER16 Rw Unmapped.default_int(1);
    0x605D:0 INTEGER16 Rw Unmapped.default_int(1);
    0x605E:0 INTEGER16 Rw Unmapped.default_int(2);
    0x6060:0 INTEGER8 Rw Rx.default_int(0);
    0x6061:0 INTEGER8 Ro Tx.default_int(0);
    0x6062:0 INTEGER32 Ro Tx.unit(0);
    0x6063:0 INTEGER32 Ro Tx.unit(3);
    0x6064:0 INTEGER32 Ro Tx.unit(0);
    0x6065:0 UNSIGNED32 Rw Rx.unit(0).default_int(20_000);
    0x6067:0 UNSIGNED32 Rw Rx.unit(0).default_int(10);
    0x606B:0 INTEGER32 Ro Tx.unit(1);
    0x606C:0 INTEGER32 Ro Tx.unit(1);
    0x606D:0 UNSIGNED16 Rw Unmapped.unit(2).default_int(50);
    0x606F:0 UNSIGNED16 Rw Unmapped.unit(2).default_int(50);
    0x6071:0 INTEGER16 Rw RxTx.unit(5);
    0x6072:0 UNSIGNED16 Rw Unmapped.unit(5).default_int(3_000);
    0x6074:0 INTEGER16 Ro Tx.unit(5);
    0x6077:0 INTEGER16 Ro Tx.unit(5);
    0x607A:0 INTEGER32 Rw RxTx.unit(0);
    0x607C:0 INTEGER32 Rw Unmapped.unit(0).default_int(0);
    0x607D:0 UNSIGNED8 Ro Unmapped.default_int(2);
    0x607D:1 INTEGER32 Rw Unmapped.unit(0).default_int(-1_000_000);
    0x607D:2 INTEGER32 Rw Unmapped.unit(0).default_int(1_000_000);
    0x607F:0 UNSIGNED32 Rw Unmapped.unit(1).default_int(500_000);
    0x6080:0 UNSIGNED32 Rw Unmapped.unit(4).default_int(3_000);
    0x6081:0 UNSIGNED32 Rw RxTx.unit(1);
    0x6083:0 UNSIGNED32 Rw RxTx.unit(6).default_int(100);
    0x6084:0 UNSIGNED32 Rw RxTx.unit(6).default_int(100);
    0x6085:0 UNSIGNED32 Rw RxTx.unit(6).default_int(20);
    0x6091:1 UNSIGNED32 Rw Unmapped.default_int(1);
    0x6091:2 UNSIGNED32 Rw Unmapped.default_int(1);
    0x6092:1 UNSIGNED32 Rw Unmapped.default_int(10_000);
    0x6092:2 UNSIGNED32 Rw Unmapped.default_int(1);
    0x6098:0 INTEGER8 Rw RxTx.range(0, 37).default_int(0);
    0x6099:1 UNSIGNED32 Rw RxTx.unit(1).default_int(100_000);
    0x6099:2 UNSIGNED32 Rw RxTx.unit(1).default_int(10_000);
    0x60B0:0 INTEGER32 Rw RxTx.unit(0);
    0x60F4:0 INTEGER32 Ro Tx.unit(0);
    0x60FC:0 INTEGER32 Ro Tx.unit(3);
    0x60FD:0 UNSIGNED32 Ro Tx;
    0x60FF:0 INTEGER32 Rw RxTx.unit(1);
    0x6502:0 UNSIGNED32 Ro Tx.default_int(0x03AD);
};

/// 6083h and 6084h are times for 2,000 rpm: unit 6.
static UNITS: [UnitDesc<'static>; 7] = [
    UnitDesc::new("user position", QuantityKind::UserPosition, 1, 1),
    UnitDesc::new("user velocity", QuantityKind::UserVelocity, 1, 1),
    UnitDesc::new("rpm", QuantityKind::Velocity, 1, 1),
    UnitDesc::new("count", QuantityKind::Counts, 1, 1),
    UnitDesc::new("rpm", QuantityKind::Velocity, 1, 1),
    UnitDesc::new("0.1 % rated torque", QuantityKind::TorqueRatio, 1, 1000),
    UnitDesc::new("ms", QuantityKind::Time, 1, 1000),
];
static TEXTS: [TextDefault<'static>; 1] = [TextDefault::new(at(0x1008, 0), "X3")];
static ALLOWED: [Allowed<'static>; 1] = [Allowed::new(at(0x6060, 0), &[0, 1, 3, 4, 6, 8, 9, 10])];
static RX: [MapEntry; 3] =
    [MapEntry::new(at(0x6040, 0), 16), MapEntry::new(at(0x607A, 0), 32), MapEntry::new(at(0x6060, 0), 8)];
static TX: [MapEntry; 3] =
    [MapEntry::new(at(0x6041, 0), 16), MapEntry::new(at(0x6064, 0), 32), MapEntry::new(at(0x6061, 0), 8)];
static PDOS: [PdoDesc<'static>; 2] = [
    PdoDesc::new(at(0x1600, 0), Direction::Rx, &RX)
        .with_max_entries(8)
        .with_max_bytes(32)
        .with_remap(Remap::Free),
    PdoDesc::new(at(0x1A00, 0), Direction::Tx, &TX)
        .with_max_entries(8)
        .with_max_bytes(32)
        .with_remap(Remap::Free),
];
static ALARMS: [AlarmDesc<'static>; 5] = [
    AlarmDesc::new("OF", 0x25, 0x8611, "Following error exceeded").with_reset(Reset::Resettable),
    AlarmDesc::new("ET", 0x06, 0x7305, "Encoder error").with_reset(Reset::NotResettable),
    AlarmDesc::new("OL", 0x0F, 0x2350, "Overload").with_reset(Reset::Resettable),
    AlarmDesc::new("LuP", 0x21, 0x3220, "Undervoltage").with_reset(Reset::Resettable),
    AlarmDesc::new("Wd", 0x33, 0x8100, "Watchdog of process data").with_reset(Reset::Resettable),
];
static EFFECTS: [EffectDesc; 2] =
    [EffectDesc::new(at(0x2000, 1), Effect::AtStop), EffectDesc::new(at(0x2000, 2), Effect::PowerCycle)];

const SEEK: &[Step] = &[
    Step::fast(Side::Negative, Event::on(Signal::NegativeLimit)),
    Step::slow(Side::Positive, Event::off(Signal::NegativeLimit)),
    Step::Latch,
];
static HOMING: [HomingDesc<'static>; 3] = [
    HomingDesc::new(15).with_status(HomingStatus::Reserved),
    HomingDesc::new(17).with_cases(&[HomingCase::new(&[Level::off(Signal::NegativeLimit)], SEEK)]),
    HomingDesc::new(35).with_cases(&[HomingCase::new(&[Level::Standstill], &[Step::Latch])]),
];

/// A drive with everything that the tests need.
pub(crate) static MODEL: DriveModel<'static> = DriveModel::new(Identity::new("sample", "Acme", "X3"))
    .with_objects(OBJECTS)
    .with_units(&UNITS)
    .with_texts(&TEXTS)
    .with_allowed(&ALLOWED)
    .with_pdos(&PDOS)
    .with_alarms(&ALARMS)
    .with_effects(&EFFECTS)
    .with_homing(&HOMING);
