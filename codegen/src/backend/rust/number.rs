//! Numbers as a person would write them in code.

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
    fn groups() {
        assert_eq!(grouped(0), "0");
        assert_eq!(grouped(-9_999), "-9999");
        assert_eq!(grouped(60_000), "60_000");
        assert_eq!(grouped(i128::from(i64::MIN)), "-9_223_372_036_854_775_808");
    }
}
