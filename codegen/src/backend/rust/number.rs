//! Number literals as a person would write them.

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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn groups() {
        assert_eq!(grouped(0), "0");
        assert_eq!(grouped(-9_999), "-9999");
        assert_eq!(grouped(60_000), "60_000");
        assert_eq!(grouped(i128::from(i64::MIN)), "-9_223_372_036_854_775_808");
    }
}
