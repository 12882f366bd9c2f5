//! Whole numbers cut to a width on purpose: the low bits, as a register of that width holds them.

/// The low 16 bits.
#[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)]
pub(crate) const fn low16(value: i64) -> u16 {
    value as u16
}

/// The low 8 bits.
#[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)]
pub(crate) const fn low8(value: i64) -> u8 {
    value as u8
}

/// The low 32 bits.
#[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)]
pub(crate) const fn low32(value: i64) -> u32 {
    value as u32
}

/// The low 8 bits as a number with sign.
#[allow(clippy::cast_possible_truncation)]
pub(crate) const fn signed8(value: i64) -> i8 {
    value as i8
}

/// The low 16 bits as a number with sign.
#[allow(clippy::cast_possible_truncation)]
pub(crate) const fn signed16(value: i64) -> i16 {
    value as i16
}

/// The low 64 bits.
#[allow(clippy::cast_possible_truncation)]
pub(crate) const fn low64(value: u128) -> u64 {
    value as u64
}

/// The low 64 bits.
#[allow(clippy::cast_possible_truncation)]
pub(crate) const fn cell(value: i128) -> i64 {
    value as i64
}

/// The low `bits` bits of `raw`, with the sign of the highest of them if `signed`. 64 bits and more, and none, are the
/// whole.
#[allow(clippy::cast_possible_wrap, clippy::cast_sign_loss)]
pub(crate) const fn extend(raw: u64, bits: u32, signed: bool) -> i64 {
    let unused = 64_u32.saturating_sub(bits);
    let (Some(top), true) = (raw.checked_shl(unused), unused < 64) else { return raw as i64 };
    if signed {
        (top as i64) >> unused
    } else {
        (top >> unused) as i64
    }
}

/// A cell as bits.
#[allow(clippy::cast_sign_loss)]
pub(crate) const fn bits(value: i64) -> u64 {
    value as u64
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn signs_are_those_of_the_width() {
        for (raw, bits, signed, value) in [
            (0xFF, 8, true, -1),
            (0xFF, 8, false, 255),
            (0x1_7F, 8, true, 127),
            (0x8000, 16, true, -32_768),
            (1, 1, false, 1),
            (u64::MAX, 64, true, -1),
            (u64::MAX, 64, false, -1),
            (5, 0, false, 5),
        ] {
            assert_eq!(extend(raw, bits, signed), value, "{raw:X} {bits}");
        }
    }
}
