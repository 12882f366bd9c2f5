//! Addresses, numbers and times as people write them.

use std::time::Duration;

use drivewright_runtime::Address;

/// `6041`, `6041h`, `0x6041`, `6041:00`, `607D:01`.
pub(super) fn address(word: &str) -> Result<Address, String> {
    let (index, sub) = word.split_once(':').unwrap_or((word, "0"));
    let index = u16::from_str_radix(hexadecimal(index), 16).ok();
    let sub = u8::from_str_radix(hexadecimal(sub), 16).ok();
    match (index, sub) {
        (Some(index), Some(sub)) => Ok(Address::new(index, sub)),
        _ => Err(format!("`{}` is no address, such as 6041:00", word.escape_debug())),
    }
}

fn hexadecimal(word: &str) -> &str {
    let digits = word.strip_prefix("0x").unwrap_or(word);
    let digits = digits.strip_suffix(['h', 'H']).unwrap_or(digits);
    // `from_str_radix` takes a sign.
    if digits.starts_with(['+', '-']) { "" } else { digits }
}

/// `-5`, `0x1F`, `1Fh`, `1_000`.
pub(super) fn number(word: &str) -> Result<i128, String> {
    let plain = word.replace('_', "");
    let (sign, digits) = plain.strip_prefix('-').map_or((1, plain.as_str()), |digits| (-1, digits));
    let radix = if digits.starts_with("0x") || digits.ends_with(['h', 'H']) { 16 } else { 10 };
    let digits = if radix == 16 { hexadecimal(digits) } else { digits };
    let known = i64::from_str_radix(digits, radix).ok().filter(|_| !digits.starts_with(['+', '-']));
    let wide = known.map(i128::from).or_else(|| u64::from_str_radix(digits, radix).ok().map(i128::from));
    wide.map(|n| n * sign).ok_or_else(|| {
        format!("`{}` is no number of 64 bits, such as 15, -5, 0x1F or 1Fh", word.escape_debug())
    })
}

/// `250us`, `10ms`, `2s`, `1.5s`.
pub(super) fn duration(word: &str) -> Result<Duration, String> {
    let wrong = || format!("`{}` is no time, such as 250us, 10ms or 2s", word.escape_debug());
    let digits = word.trim_end_matches(|c: char| c.is_ascii_alphabetic());
    let micros: u64 = match &word[digits.len()..] {
        "us" => 1,
        "ms" => 1_000,
        "s" => 1_000_000,
        _ => return Err(wrong()),
    };
    let (whole, part) = digits.split_once('.').unwrap_or((digits, ""));
    if !whole.bytes().chain(part.bytes()).all(|b| b.is_ascii_digit()) || part.len() > 6 {
        return Err(wrong());
    }
    let whole: u64 = whole.parse().map_err(|_| wrong())?;
    let part: u64 = format!("{part:0<6}").parse().map_err(|_| wrong())?;
    let all = whole.checked_mul(micros).ok_or_else(wrong)?.checked_add(part * micros / 1_000_000);
    // A day is more than anybody waits for, and a trace of it would fill a disk.
    let all = all.filter(|all| *all <= DAY).ok_or_else(|| format!("{} or a day at most", wrong()))?;
    Ok(Duration::from_micros(all))
}

const DAY: u64 = 86_400_000_000;

/// A name without what people write differently: case, blanks, dashes, underscores.
pub(super) fn usual(name: &str) -> String {
    let letters = name.chars().filter(|c| !c.is_whitespace() && !matches!(c, '-' | '_' | '"'));
    letters.flat_map(char::to_lowercase).collect()
}
