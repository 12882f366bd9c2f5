//! Codecs and units of the runtime: what is written comes back, order is kept, and the ends of a range are exact.
//!
//! What is expected is arithmetic on 128 bits, written here.

use drivewright_runtime::prelude::*;
use drivewright_runtime::wire::{Count, I24, I40, I48, I56, U24, U40, U48, U56, Wire};
use proptest::prelude::*;
use proptest::sample::select;
use proptest::strategy::ValueTree;
use proptest::test_runner::TestRunner;

use super::cases;

/// Codes of CiA 301 with width and sign, written once more.
const INTEGERS: [(u8, u32, bool); 16] = [
    (0x05, 8, false),
    (0x06, 16, false),
    (0x16, 24, false),
    (0x07, 32, false),
    (0x18, 40, false),
    (0x19, 48, false),
    (0x1A, 56, false),
    (0x1B, 64, false),
    (0x02, 8, true),
    (0x03, 16, true),
    (0x10, 24, true),
    (0x04, 32, true),
    (0x12, 40, true),
    (0x13, 48, true),
    (0x14, 56, true),
    (0x15, 64, true),
];

/// Lowest and highest number of so many bits.
fn ends(bits: u32, signed: bool) -> (i128, i128) {
    let all = 1_i128 << bits;
    if signed { (-(all / 2), all / 2 - 1) } else { (0, all - 1) }
}

/// Two's complement, little endian.
fn bytes(number: i128, bits: u32) -> Vec<u8> {
    let positive = number.rem_euclid(1 << bits);
    (0..bits / 8).map(|place| u8::try_from(positive >> (8 * place) & 0xFF).expect("a byte")).collect()
}

/// Numbers near the ends of every width, and others.
fn number() -> impl Strategy<Value = i128> {
    let near =
        (select(&INTEGERS[..]), any::<bool>(), -2..=2_i128).prop_map(|((_, bits, signed), high, off)| {
            let (min, max) = ends(bits, signed);
            off + if high { max } else { min }
        });
    prop_oneof![near, any::<i64>().prop_map(i128::from), any::<i16>().prop_map(i128::from), any::<i128>()]
}

/// One type against arithmetic.
fn codec<T: Count>(number: i128, code: u8) -> Result<(), TestCaseError> {
    let (_, bits, signed) = *INTEGERS.iter().find(|row| row.0 == code).expect("a row");
    let (min, max) = ends(bits, signed);
    let length = bits as usize / 8;
    prop_assert_eq!((T::DATA_TYPE.0, u32::from(T::BITS)), (code, bits));
    let value = T::from_count(number);
    prop_assert_eq!(value.is_some(), (min..=max).contains(&number));
    let mut out = [0xAA; 17];
    let dynamic = T::DATA_TYPE.encode_int(number, &mut out);
    let Some(value) = value else {
        prop_assert_eq!(dynamic, Err(WireError::DoesNotFit { data_type: T::DATA_TYPE }));
        return Ok(());
    };
    prop_assert_eq!(value.to_count(), number);
    prop_assert_eq!((dynamic, &out[..length]), (Ok(length), &bytes(number, bits)[..]));
    let mut out = [0xAA; 17];
    prop_assert_eq!(T::encode(value, &mut out), Ok(length));
    prop_assert_eq!((&out[..length], out[length]), (&bytes(number, bits)[..], 0xAA), "its own bytes alone");
    prop_assert_eq!(T::decode(&out[..length]).map(T::to_count), Ok(number));
    prop_assert_eq!(T::DATA_TYPE.decode_int(&out[..length]), Ok(number));
    for wrong in (0..12).filter(|n| *n != length) {
        prop_assert!(T::decode(&out[..wrong]).is_err() && T::DATA_TYPE.decode_int(&out[..wrong]).is_err());
        prop_assert_eq!(T::encode(value, &mut [0; 12][..wrong]).is_ok(), wrong > length);
    }
    Ok(())
}

/// Every type, in the order of its code in [`INTEGERS`].
fn every_codec(number: i128) -> Result<(), TestCaseError> {
    macro_rules! codecs {
        ($($type:ty = $code:literal),*) => { $(codec::<$type>(number, $code)?;)* };
    }
    codecs!(u8 = 0x05, u16 = 0x06, U24 = 0x16, u32 = 0x07, U40 = 0x18, U48 = 0x19, U56 = 0x1A, u64 = 0x1B);
    codecs!(i8 = 0x02, i16 = 0x03, I24 = 0x10, i32 = 0x04, I40 = 0x12, I48 = 0x13, I56 = 0x14, i64 = 0x15);
    Ok(())
}

proptest! {
    #![proptest_config(cases(2_000))]

    #[test]
    fn b35_numbers_come_back_from_the_wire(number in number()) {
        every_codec(number)?;
    }

    #[test]
    fn other_types_come_back_from_the_wire(real in any::<u64>(), byte in any::<u8>()) {
        let (single, double) = (f32::from_bits(u32::try_from(real >> 32).expect("32 bits")), f64::from_bits(real));
        let mut out = [0; 8];
        prop_assert_eq!(f64::encode(double, &mut out), Ok(8));
        prop_assert_eq!((out, f64::decode(&out).map(f64::to_bits)), (real.to_le_bytes(), Ok(real)));
        prop_assert_eq!(f32::encode(single, &mut out), Ok(4));
        prop_assert_eq!(f32::decode(&out[..4]).map(f32::to_bits), Ok(single.to_bits()));
        let truth = bool::decode(&[byte]);
        prop_assert_eq!(truth, if byte < 2 { Ok(byte == 1) } else { Err(WireError::NotBoolean { found: byte }) });
    }
}

/// A speed with any factor and any range.
#[derive(Clone, Copy, Debug)]
struct Handle {
    object: Object<i32, Rw, RxTx, Velocity>,
    factor: (i128, i128),
    range: (i32, i32),
}

fn handle() -> impl Strategy<Value = Handle> {
    let part = prop_oneof![1..=100_u32, 1..=u32::MAX];
    (part.clone(), part, any::<(i32, i32)>()).prop_map(|(num, den, (a, b))| {
        let range = (a.min(b), a.max(b));
        let object = Object::new(0x6081, 0).range(range.0.into(), range.1.into()).scale(num, den);
        Handle { object, factor: (num.into(), den.into()), range }
    })
}

/// `value` in counts of the handle, as a fraction.
fn counts(handle: Handle, value: Value<Velocity>) -> (i128, i128) {
    let (num, den) = handle.factor;
    (i128::from(value.num()) * den, i128::from(value.den()) * num)
}

fn value() -> impl Strategy<Value = Value<Velocity>> {
    let num = prop_oneof![-100_000..=100_000_i64, (i64::MIN >> 2)..=(i64::MAX >> 2)];
    (num, prop_oneof![Just(1), 1..=1000_u32]).prop_map(|(num, den)| Value::new(num, den).expect("not 0"))
}

proptest! {
    #![proptest_config(cases(5_000))]

    /// The inverse of a scale is made of the scale: one factor for both ways.
    #[test]
    fn b38_a_value_comes_back_from_its_count(handle in handle(), raw in any::<i32>()) {
        let Ok(value) = handle.object.value_of(raw) else { return Ok(()) };
        let (above, below) = counts(handle, value);
        prop_assert_eq!(above, i128::from(raw) * below, "the value is exact");
        let inside = (handle.range.0..=handle.range.1).contains(&raw);
        for back in [handle.object.raw_from(value), handle.object.raw_nearest(value)] {
            prop_assert_eq!(back.is_ok(), inside);
            prop_assert_eq!(back.unwrap_or(raw), raw);
        }
    }

    #[test]
    fn the_ends_of_a_range_are_exact(handle in handle()) {
        let (min, max) = handle.range;
        for (end, beyond) in [(min, min.checked_sub(1)), (max, max.checked_add(1))] {
            if let Ok(value) = handle.object.value_of(end) {
                prop_assert_eq!(handle.object.raw_from(value), Ok(end));
            }
            let Some(Ok(value)) = beyond.map(|raw| handle.object.value_of(raw)) else { continue };
            let refused = handle.object.raw_from(value);
            let Err(ConvertError::OutOfRange(error)) = refused else { panic!("{refused:?}") };
            prop_assert_eq!((error.min, error.max), (min.into(), max.into()));
        }
    }

    #[test]
    fn the_nearest_count_is_the_nearest(handle in handle(), value in value()) {
        let Ok(raw) = handle.object.raw_nearest(value) else { return Ok(()) };
        let (above, below) = counts(handle, value);
        // Half a count at most.
        prop_assert!((2 * (above - i128::from(raw) * below)).abs() <= below);
        let exact = handle.object.raw_from(value);
        prop_assert_eq!(exact.is_ok(), above % below == 0);
        prop_assert_eq!(exact.unwrap_or(raw), raw);
    }

    #[test]
    fn a_larger_value_has_no_smaller_count(handle in handle(), a in value(), b in value()) {
        let (Ok(low), Ok(high)) = (handle.object.raw_nearest(a), handle.object.raw_nearest(b)) else { return Ok(()) };
        let ordered = (i128::from(a.num()) * i128::from(b.den())).cmp(&(i128::from(b.num()) * i128::from(a.den())));
        prop_assert!(low.cmp(&high) == ordered || low == high, "{:?} of {} and {}", ordered, low, high);
    }

    /// With a gear that was read from the drive, too.
    #[test]
    fn b38_user_units_come_back_with_the_scale_of_the_drive(
        num in 1..=u32::MAX, den in 1..=u32::MAX, (above, below) in (1..=1000_u32, 1..=1000_u32), raw in any::<i32>(),
    ) {
        const TARGET: Object<i32, Rw, Rx, UserPosition> = Object::new(0x607A, 0);
        let scale = Scale::<UserPosition, Angle>::new(num, den).and_then(|scale| scale.times(above, below));
        let Some(scale) = scale else { return Ok(()) };
        let Ok(value) = TARGET.value_with(&scale, raw) else { return Ok(()) };
        let wanted = i128::from(raw) * i128::from(num) * i128::from(above) * i128::from(value.den());
        prop_assert_eq!(i128::from(value.num()) * i128::from(den) * i128::from(below), wanted);
        prop_assert_eq!(TARGET.raw_with(&scale, value), Ok(raw));
        prop_assert_eq!(TARGET.raw_nearest_with(&scale, value), Ok(raw));
    }
}

/// A generator that only makes what is refused would prove nothing.
#[test]
fn most_values_are_tried() {
    let (mut runner, mut tried) = (TestRunner::new(cases(1_000)), 0);
    for _ in 0..1_000 {
        let handle = handle().new_tree(&mut runner).expect("a handle").current();
        let raw = any::<i32>().new_tree(&mut runner).expect("a number").current();
        tried += u32::from(handle.object.value_of(raw).is_ok());
    }
    assert!(tried > 900, "{tried} of 1,000");
}
