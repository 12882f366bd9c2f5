//! What one count of a user unit is worth, as the gear objects of a drive say.

use core::marker::PhantomData;

use crate::quantity::{FixedUnit, UserUnit};
use crate::ratio::Factor;

/// One count of the user unit `Q` is `num / den` of the base unit of `P`.
///
/// The gear objects and the formula over them differ from drive to drive, so a scale is built from what was read
/// from the drive at hand, never from a default.
///
/// ```
/// use drivewright_runtime::prelude::*;
///
/// const TARGET_POSITION: Object<i32, Rw, Rx, UserPosition> = Object::new(0x607A, 0);
///
/// // 10,000 counts a revolution.
/// let scale = Scale::<UserPosition, Angle>::new(1, 10_000).unwrap();
/// let target = Value::<Angle>::degrees(90);
/// assert_eq!(TARGET_POSITION.raw_with(&scale, target), Ok(2_500));
/// assert_eq!(TARGET_POSITION.value_with(&scale, -5_000), Ok(Value::degrees(-180)));
/// ```
#[derive(Debug)]
pub struct Scale<Q, P> {
    factor: Factor,
    units: PhantomData<fn() -> (Q, P)>,
}

impl<Q, P> Scale<Q, P> {
    /// The scale; `None` if one of the numbers is 0, as objects of an unset gear read.
    pub const fn new(num: u32, den: u32) -> Option<Self>
    where
        Q: UserUnit<P>,
        P: FixedUnit,
    {
        match Factor::new(num as u64, den as u64) {
            Some(factor) => Some(Self { factor, units: PhantomData }),
            None => None,
        }
    }

    /// This scale times `num / den`, for formulas with several ratios; `None` if one of the numbers is 0 or the
    /// reduced product takes more than 64 bits above or below the line.
    #[must_use]
    pub const fn times(self, num: u32, den: u32) -> Option<Self> {
        match Factor::new(num as u64, den as u64) {
            Some(other) => match self.factor.times(other) {
                Some(factor) => Some(Self { factor, units: PhantomData }),
                None => None,
            },
            None => None,
        }
    }

    /// Above the line of the reduced fraction, never 0.
    pub const fn num(&self) -> u64 {
        self.factor.num()
    }

    /// Below the line of the reduced fraction, never 0.
    pub const fn den(&self) -> u64 {
        self.factor.den()
    }

    pub(crate) const fn factor(&self) -> Factor {
        self.factor
    }
}

impl<Q, P> Clone for Scale<Q, P> {
    fn clone(&self) -> Self {
        *self
    }
}

impl<Q, P> Copy for Scale<Q, P> {}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::quantity::{Angle, UserPosition};

    #[test]
    fn scales_multiply_and_refuse_zero() {
        type S = Scale<UserPosition, Angle>;
        let scale = S::new(1, 131_072).unwrap().times(16_777_216, 10_000).unwrap();
        assert_eq!((scale.num(), scale.den()), (8, 625));
        assert!(S::new(0, 1).is_none());
        assert!(S::new(1, 0).is_none());
        assert!(scale.times(0, 1).is_none());
        let big = S::new(u32::MAX, 1).unwrap().times(u32::MAX - 1, 1).unwrap();
        assert!(big.times(u32::MAX, 1).is_none());
    }
}
