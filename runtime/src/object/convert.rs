//! Physical values of a handle, both ways, without floating point.

use super::{ConvertError, Object, RangeError};
use crate::quantity::{FixedUnit, UserUnit};
use crate::ratio::{Factor, Failure};
use crate::scale::Scale;
use crate::value::Value;
use crate::wire::Count;

impl<T, A, M, Q> Object<T, A, M, Q> {
    const fn own_factor(self) -> Result<Factor, ConvertError> {
        match Factor::new(self.num as u64, self.den as u64) {
            Some(factor) => Ok(factor),
            None => Err(ConvertError::NoScale { address: self.address }),
        }
    }

    /// The handle's factor joined with that of the drive.
    const fn joined_factor(self, gear: Factor) -> Result<Factor, ConvertError> {
        match self.own_factor() {
            Ok(own) => match own.times(gear) {
                Some(factor) => Ok(factor),
                None => Err(ConvertError::NoScale { address: self.address }),
            },
            Err(error) => Err(error),
        }
    }

    const fn failure(self, failure: Failure) -> ConvertError {
        match failure {
            Failure::NotExact => ConvertError::NotExact { address: self.address },
            Failure::TooLarge => ConvertError::TooLarge { address: self.address },
        }
    }

    /// The count that is exactly `value`, before the limits and the type are looked at. For constants: see
    /// [`constant!`](crate::constant!).
    ///
    /// # Errors
    /// [`ConvertError::NotExact`] between two counts, [`ConvertError::NoScale`].
    pub const fn exact_count(self, value: Value<Q>) -> Result<i128, ConvertError>
    where
        Q: FixedUnit,
    {
        match self.own_factor() {
            Ok(factor) => match factor.exact_count(value.num(), value.den()) {
                Ok(count) => Ok(count),
                Err(failure) => Err(self.failure(failure)),
            },
            Err(error) => Err(error),
        }
    }
}

impl<T, A, M, Q> Object<T, A, M, Q> {
    /// The count as a value of the type, if limits and type allow it.
    fn accepted(self, count: Result<i128, Failure>) -> Result<T, ConvertError>
    where
        T: Count,
    {
        let count = count.map_err(|f| self.failure(f))?;
        self.check_count(count)?;
        T::from_count(count).ok_or_else(|| self.beyond_type(count).into())
    }

    #[cold]
    fn beyond_type(self, count: i128) -> RangeError
    where
        T: Count,
    {
        let (min, max) = T::DATA_TYPE.range().unwrap_or((0, 0));
        let near = |n: i128| i64::try_from(n).unwrap_or(if n < 0 { i64::MIN } else { i64::MAX });
        let range = (self.min.max(near(min)), self.max.min(near(max)));
        RangeError::new(self.address, count, range, self.allowed)
    }

    fn value<P>(self, factor: Factor, raw: T) -> Result<Value<P>, ConvertError>
    where
        T: Count,
    {
        match factor.value_of(raw.to_count()) {
            Ok((num, den)) => Ok(Value::reduced(num, den)),
            Err(failure) => Err(self.failure(failure)),
        }
    }

    /// The raw value that is exactly `value`.
    ///
    /// # Errors
    /// [`ConvertError::NotExact`] between two counts, [`ConvertError::OutOfRange`] outside the limits or the type.
    pub fn raw_from(self, value: Value<Q>) -> Result<T, ConvertError>
    where
        T: Count,
        Q: FixedUnit,
    {
        self.accepted(self.own_factor()?.exact_count(value.num(), value.den()))
    }

    /// The raw value nearest to `value`; halves go away from zero.
    ///
    /// # Errors
    /// [`ConvertError::OutOfRange`] if the nearest count is outside the limits or the type.
    pub fn raw_nearest(self, value: Value<Q>) -> Result<T, ConvertError>
    where
        T: Count,
        Q: FixedUnit,
    {
        self.accepted(self.own_factor()?.nearest_count(value.num(), value.den()))
    }

    /// What `raw` stands for, exactly.
    ///
    /// # Errors
    /// [`ConvertError::TooLarge`] if the fraction takes more than 64 bits above or 32 bits below the line.
    pub fn value_of(self, raw: T) -> Result<Value<Q>, ConvertError>
    where
        T: Count,
        Q: FixedUnit,
    {
        self.value(self.own_factor()?, raw)
    }

    /// The raw value that is exactly `value` on a drive with this `scale`.
    ///
    /// # Errors
    /// Those of [`raw_from`](Self::raw_from), and [`ConvertError::NoScale`] if the product of both scales takes more
    /// than 64 bits.
    pub fn raw_with<P: FixedUnit>(self, scale: &Scale<Q, P>, value: Value<P>) -> Result<T, ConvertError>
    where
        T: Count,
        Q: UserUnit<P>,
    {
        self.accepted(self.joined_factor(scale.factor())?.exact_count(value.num(), value.den()))
    }

    /// The raw value nearest to `value` on a drive with this `scale`; halves go away from zero.
    ///
    /// # Errors
    /// Those of [`raw_nearest`](Self::raw_nearest), and [`ConvertError::NoScale`].
    pub fn raw_nearest_with<P: FixedUnit>(
        self,
        scale: &Scale<Q, P>,
        value: Value<P>,
    ) -> Result<T, ConvertError>
    where
        T: Count,
        Q: UserUnit<P>,
    {
        self.accepted(self.joined_factor(scale.factor())?.nearest_count(value.num(), value.den()))
    }

    /// What `raw` stands for on a drive with this `scale`, exactly.
    ///
    /// # Errors
    /// Those of [`value_of`](Self::value_of), and [`ConvertError::NoScale`].
    pub fn value_with<P: FixedUnit>(self, scale: &Scale<Q, P>, raw: T) -> Result<Value<P>, ConvertError>
    where
        T: Count,
        Q: UserUnit<P>,
    {
        self.value(self.joined_factor(scale.factor())?, raw)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::prelude::*;

    const SPEED: Object<i32, Rw, RxTx, Velocity> = Object::new(0x60FF, 0).range(-60_000, 60_000).scale(1, 10);
    const TORQUE: Object<i16, Rw, RxTx, TorqueRatio> = Object::new(0x6071, 0).scale(1, 1_000);
    const POSITION: Object<i32, Rw, RxTx, UserPosition> = Object::new(0x607A, 0);

    #[test]
    fn exact_or_refused() {
        assert_eq!(SPEED.raw_from(Value::rpm(-3_000)), Ok(-30_000));
        assert_eq!(SPEED.value_of(-30_001), Ok(Value::new(-30_001, 10).unwrap()));
        assert_eq!(
            SPEED.raw_from(Value::new(1, 3).unwrap()),
            Err(ConvertError::NotExact { address: SPEED.address })
        );
        assert_eq!(SPEED.raw_nearest(Value::new(1, 3).unwrap()), Ok(3));
        assert_eq!(SPEED.raw_nearest(Value::new(-1, 20).unwrap()), Ok(-1), "halves go away from zero");
    }

    #[test]
    fn limits_hold_for_physical_values() {
        assert_eq!(SPEED.raw_from(Value::rpm(6_000)), Ok(60_000));
        assert!(
            matches!(SPEED.raw_from(Value::rpm(-6_001)), Err(ConvertError::OutOfRange(e)) if e.min == -60_000)
        );
        assert!(matches!(SPEED.raw_nearest(Value::whole(i64::MIN)), Err(ConvertError::OutOfRange(_))));
        let Err(ConvertError::OutOfRange(error)) = TORQUE.raw_from(Value::percent_torque(3_277)) else {
            panic!("32,770 does not fit INTEGER16")
        };
        assert_eq!((error.value, error.min, error.max), (32_770, -32_768, 32_767));
    }

    #[test]
    fn the_widest_values_do_not_overflow() {
        const WIDE: Object<u64, Rw, Unmapped, Time> = Object::new(0x3000, 0).scale(u32::MAX, 1);
        assert_eq!(WIDE.value_of(u64::MAX), Err(ConvertError::TooLarge { address: WIDE.address }));
        assert_eq!(WIDE.value_of(1), Ok(Value::whole(u32::MAX.into())));
        let fine = WIDE.scale(1, u32::MAX);
        assert!(matches!(fine.raw_from(Value::whole(i64::MAX)), Err(ConvertError::OutOfRange(_))));
        assert!(matches!(fine.raw_from(Value::whole(-1)), Err(ConvertError::OutOfRange(e)) if e.min == 0));
        assert_eq!(fine.raw_from(Value::whole(1)), Ok(u32::MAX.into()));
    }

    #[test]
    fn no_scale_no_value() {
        for bad in [SPEED.scale(0, 1), SPEED.scale(1, 0)] {
            assert_eq!(bad.value_of(1), Err(ConvertError::NoScale { address: SPEED.address }));
            assert_eq!(bad.raw_from(Value::ZERO), Err(ConvertError::NoScale { address: SPEED.address }));
        }
    }

    #[test]
    fn user_units_convert_with_the_scale_of_the_drive() {
        let scale = Scale::<UserPosition, Angle>::new(1, 10_000).unwrap();
        assert_eq!(POSITION.raw_with(&scale, Value::revolutions(-2)), Ok(-20_000));
        assert_eq!(POSITION.value_with(&scale, 2_500), Ok(Value::degrees(90)));
        assert!(matches!(POSITION.raw_with(&scale, Value::degrees(1)), Err(ConvertError::NotExact { .. })));
        assert_eq!(POSITION.raw_nearest_with(&scale, Value::degrees(1)), Ok(28));
        assert!(matches!(
            POSITION.raw_with(&scale, Value::revolutions(i32::MAX)),
            Err(ConvertError::OutOfRange(_))
        ));
        let linear = Scale::<UserPosition, Length>::new(1, 1_000_000).unwrap();
        assert_eq!(POSITION.raw_with(&linear, Value::millimetres(12)), Ok(12_000));
        let fine = Scale::<UserPosition, Angle>::new(1, u32::MAX).unwrap().times(1, u32::MAX).unwrap();
        let both = POSITION.scale(1, 3);
        assert!(matches!(both.value_with(&fine, 1), Err(ConvertError::NoScale { .. })));
    }

    #[test]
    fn every_count_comes_back() {
        for raw in (-60_000..=60_000).step_by(7) {
            let value = SPEED.value_of(raw).unwrap();
            assert_eq!(SPEED.raw_from(value), Ok(raw));
            assert_eq!(SPEED.raw_nearest(value), Ok(raw));
        }
    }
}
