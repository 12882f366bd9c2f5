//! Exact numbers of measured values.

/// `n * num / den` exactly: as a decimal fraction, or where that does not end or is long, as a fraction. `den` is not 0.
pub(super) fn scaled(n: i128, num: u64, den: u64) -> String {
    let Some(above) = n.checked_mul(num.into()) else { return format!("{n} * {num}/{den}") };
    let common = gcd(above.unsigned_abs(), den.into());
    let (above, below) = (above / common.cast_signed(), u128::from(den) / common);
    match decimal(above, below) {
        Some(text) => text,
        None => format!("{above}/{below}"),
    }
}

/// Most digits behind the point.
const PLACES: u32 = 6;

/// `above / below` as a decimal fraction, if that ends soon enough.
fn decimal(above: i128, below: u128) -> Option<String> {
    let places = (0..=PLACES).find(|places| 10_u128.pow(*places).is_multiple_of(below))?;
    let scale = 10_u128.pow(places);
    let digits = above.unsigned_abs().checked_mul(scale / below)?;
    let sign = if above < 0 { "-" } else { "" };
    let whole = format!("{sign}{}", digits / scale);
    let width = places as usize;
    Some(if width == 0 { whole } else { format!("{whole}.{:0width$}", digits % scale) })
}

fn gcd(mut a: u128, mut b: u128) -> u128 {
    while b != 0 {
        (a, b) = (b, a % b);
    }
    a.max(1)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn scaled_numbers_are_exact() {
        assert_eq!(scaled(60_000, 1, 10), "6000");
        assert_eq!(scaled(-15, 1, 10), "-1.5");
        assert_eq!(scaled(-1, 1, 1000), "-0.001");
        assert_eq!(scaled(7, 1, 360), "7/360");
        assert_eq!(scaled(360, 1, 360), "1");
        assert_eq!(scaled(3, 250, 1), "750");
        assert_eq!(scaled(1, 1, 65_536), "1/65536");
        assert_eq!(scaled(0, 1, 3), "0");
        assert_eq!(scaled(i128::MAX, 7, 3), format!("{} * 7/3", i128::MAX));
    }
}
