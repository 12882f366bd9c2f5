//! Exact arithmetic of factors. Private: handles, values and scales are its face.
//!
//! Every fraction is reduced. Then `value / factor` is a whole number exactly if cancelling crosswise leaves 1 below,
//! so the exact way needs no 128-bit division, which costs kilobytes on a small processor.

/// A factor above zero, reduced.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(crate) struct Factor {
    num: u64,
    den: u64,
}

/// Why a conversion has no result.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(crate) enum Failure {
    /// The result lies between two representable values.
    NotExact,
    /// The result is beyond 64 bits above or 32 bits below the line.
    TooLarge,
}

impl Factor {
    /// `num / den`; `None` if one of them is 0.
    pub(crate) const fn new(num: u64, den: u64) -> Option<Self> {
        if num == 0 || den == 0 {
            return None;
        }
        let common = gcd(num, den);
        Some(Self { num: quotient(num, common), den: quotient(den, common) })
    }

    /// Above the line.
    pub(crate) const fn num(self) -> u64 {
        self.num
    }

    /// Below the line.
    pub(crate) const fn den(self) -> u64 {
        self.den
    }

    /// The product; `None` beyond 64 bits.
    pub(crate) const fn times(self, other: Self) -> Option<Self> {
        let (a, b) = (gcd(self.num, other.den), gcd(other.num, self.den));
        let num = quotient(self.num, a).checked_mul(quotient(other.num, b));
        let den = quotient(self.den, b).checked_mul(quotient(other.den, a));
        match (num, den) {
            (Some(num), Some(den)) => Some(Self { num, den }),
            _ => None,
        }
    }

    /// `num / den` divided by this factor, where `num / den` is reduced and `den` is not 0: a fraction, reduced.
    const fn divide(self, num: u64, den: u32) -> (u128, u128) {
        let (a, b) = (gcd(num, self.num), gcd(den as u64, self.den));
        let above = quotient(num, a) as u128 * quotient(self.den, b) as u128;
        let below = quotient(self.num, a) as u128 * quotient(den as u64, b) as u128;
        (above, below)
    }

    /// The count that stands for the reduced value `num / den`, if there is one.
    pub(crate) const fn exact_count(self, num: i64, den: u32) -> Result<i128, Failure> {
        let (above, below) = self.divide(num.unsigned_abs(), den);
        if below == 1 {
            signed(num, above)
        } else {
            Err(Failure::NotExact)
        }
    }

    /// The count nearest to the reduced value `num / den`; halves go away from zero.
    pub(crate) const fn nearest_count(self, num: i64, den: u32) -> Result<i128, Failure> {
        let (above, below) = self.divide(num.unsigned_abs(), den);
        match (above.checked_div(below), above.checked_rem(below)) {
            // `rest >= below - rest` is `2 * rest >= below` without the overflow.
            (Some(whole), Some(rest)) => signed(num, whole + (rest >= below - rest) as u128),
            _ => Err(Failure::TooLarge),
        }
    }

    /// `count` times this factor, reduced.
    // Every cast is behind a comparison with the limits of its target.
    #[allow(clippy::cast_possible_truncation)]
    pub(crate) const fn value_of(self, count: i128) -> Result<(i64, u32), Failure> {
        let size = count.unsigned_abs();
        if size > u64::MAX as u128 {
            return Err(Failure::TooLarge);
        }
        let common = gcd(size as u64, self.den);
        let num = quotient(size as u64, common) as u128 * self.num as u128;
        let den = quotient(self.den, common);
        let sign = if count < 0 { -1 } else { 1 };
        match signed(sign, num) {
            Ok(num) if num >= i64::MIN as i128 && num <= i64::MAX as i128 && den <= u32::MAX as u64 => {
                Ok((num as i64, den as u32))
            }
            _ => Err(Failure::TooLarge),
        }
    }
}

/// `size` with the sign of `sign`.
// The casts are behind the comparison.
#[allow(clippy::cast_possible_wrap)]
const fn signed(sign: i64, size: u128) -> Result<i128, Failure> {
    if size > i128::MAX as u128 {
        Err(Failure::TooLarge)
    } else if sign < 0 {
        Ok(-(size as i128))
    } else {
        Ok(size as i128)
    }
}

/// `a / b`, and 0 where `b` is 0. No caller has that, and the compiler need not know it: nothing here can panic.
pub(crate) const fn quotient(a: u64, b: u64) -> u64 {
    match a.checked_div(b) {
        Some(quotient) => quotient,
        None => 0,
    }
}

/// The greatest common divisor; the other one if one is 0, and 1 if both are.
pub(crate) const fn gcd(a: u64, b: u64) -> u64 {
    let (mut a, mut b) = (a, b);
    while b != 0 {
        (a, b) = (b, a % b);
    }
    if a == 0 {
        1
    } else {
        a
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn factor(num: u64, den: u64) -> Factor {
        Factor::new(num, den).unwrap()
    }

    #[test]
    fn tenths() {
        let tenth = factor(1, 10);
        assert_eq!(tenth.exact_count(3_000, 1), Ok(30_000));
        assert_eq!(tenth.exact_count(-3, 10), Ok(-3));
        assert_eq!(tenth.exact_count(1, 3), Err(Failure::NotExact));
        assert_eq!(tenth.value_of(-25), Ok((-5, 2)));
        assert_eq!(tenth.value_of(0), Ok((0, 1)));
        assert_eq!(tenth.exact_count(0, 1), Ok(0));
    }

    #[test]
    fn halves_go_away_from_zero() {
        let one = factor(1, 1);
        for (num, den, count) in
            [(1, 2, 1), (-1, 2, -1), (1, 3, 0), (-2, 3, -1), (5, 2, 3), (-5, 2, -3), (7, 1, 7)]
        {
            assert_eq!(one.nearest_count(num, den), Ok(count), "{num}/{den}");
        }
    }

    #[test]
    fn extremes_do_not_overflow() {
        let (tiny, huge) = (factor(1, u64::MAX), factor(u64::MAX, 1));
        assert_eq!(tiny.exact_count(i64::MIN, 1), Ok(i128::from(i64::MIN) * i128::from(u64::MAX)));
        assert_eq!(tiny.nearest_count(i64::MAX, u32::MAX), Ok(39_614_081_266_355_540_829_331_783_679));
        assert_eq!(huge.nearest_count(i64::MIN, 1), Ok(-1));
        assert_eq!(huge.exact_count(i64::MIN, 1), Err(Failure::NotExact));
        assert_eq!(huge.value_of(i128::from(u64::MAX)), Err(Failure::TooLarge));
        assert_eq!(huge.value_of(i128::MIN), Err(Failure::TooLarge));
        assert_eq!(tiny.value_of(1), Err(Failure::TooLarge));
        assert_eq!(factor(1, 1).value_of(i128::from(i64::MIN)), Ok((i64::MIN, 1)));
        assert_eq!(factor(1, 1).value_of(i128::from(i64::MAX) + 1), Err(Failure::TooLarge));
        assert_eq!(huge.times(huge), None);
        assert_eq!(huge.times(tiny), Factor::new(1, 1));
    }

    #[test]
    fn zero_is_no_factor() {
        assert_eq!((Factor::new(0, 1), Factor::new(1, 0)), (None, None));
    }

    #[test]
    fn what_is_exact_comes_back() {
        let mut state = 0x2545_F491_4F6C_DD1D_u64;
        let mut next = || {
            state ^= state << 13;
            state ^= state >> 7;
            state ^= state << 17;
            state
        };
        for _ in 0..20_000 {
            let f = factor(next() >> 44 | 1, next() >> 40 | 1);
            let count = i128::from(next() >> 32) - (1 << 31);
            let (num, den) = f.value_of(count).unwrap();
            assert_eq!(f.exact_count(num, den), Ok(count), "{f:?}");
            assert_eq!(f.nearest_count(num, den), Ok(count), "{f:?}");
        }
    }
}
