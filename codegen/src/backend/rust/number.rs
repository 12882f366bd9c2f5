//! Numbers as a person would write them: literals of code, and numbers of documentation.

/// Decimal, in groups of three from five digits on.
pub(super) fn grouped(n: i128) -> String {
    let digits = n.unsigned_abs().to_string();
    let sign = if n < 0 { "-" } else { "" };
    if digits.len() < 5 {
        return format!("{sign}{digits}");
    }
    let mut out = String::from(sign);
    for (at, digit) in digits.chars().enumerate() {
        if at > 0 && (digits.len() - at).is_multiple_of(3) {
            out.push('_');
        }
        out.push(digit);
    }
    out
}

/// Digits in hexadecimal, in groups of four: `0x6040_0010` for 8 digits.
pub(super) fn hex(n: i128, digits: usize) -> String {
    let text = format!("{n:0digits$X}");
    let first = text.len() % 4;
    let (head, tail) = text.split_at(if first == 0 { 4.min(text.len()) } else { first });
    let groups = tail.as_bytes().chunks(4).map(String::from_utf8_lossy);
    groups.fold(format!("0x{head}"), |out, group| out + "_" + &group)
}

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
    fn hexadecimal() {
        assert_eq!(hex(0x1600, 4), "0x1600");
        assert_eq!(hex(0x6040_0010, 8), "0x6040_0010");
        assert_eq!(hex(0x192, 8), "0x0000_0192");
        assert_eq!(hex(0xF, 2), "0x0F");
        assert_eq!(hex(0x1_0000, 4), "0x1_0000");
    }

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

    #[test]
    fn groups() {
        assert_eq!(grouped(0), "0");
        assert_eq!(grouped(-9_999), "-9999");
        assert_eq!(grouped(60_000), "60_000");
        assert_eq!(grouped(i128::from(i64::MIN)), "-9_223_372_036_854_775_808");
    }
}
