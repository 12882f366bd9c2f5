//! Numbers and ranges as manuals print them: `-6000.0~6000.0`, `0~450.0%`, `0x1600~ 0x1603`, `604100 h`, `-200000 0000`.

/// A printed number, exact: `digits` divided by ten to the power of `places`.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) struct Number {
    digits: i128,
    places: u32,
    /// Printed in its unit and not in counts: with a decimal point or a percent sign.
    physical: bool,
}

impl Number {
    /// Reads a cell that holds one number, or the parts of one that the extract has split.
    pub(super) fn parse(text: &str) -> Option<Self> {
        if !is_one(text) {
            return None;
        }
        let compact: String = text.chars().filter(|c| !c.is_whitespace()).collect();
        let (body, percent) = compact.strip_suffix('%').map_or((compact.as_str(), false), |b| (b, true));
        let (negative, body) = match body.strip_prefix('-') {
            Some(rest) => (true, rest),
            None => (false, body.strip_prefix('+').unwrap_or(body)),
        };
        let hex = |digits: &str| {
            let digits =
                Some(digits).filter(|d| !d.is_empty() && d.bytes().all(|b| b.is_ascii_hexdigit()))?;
            i128::from_str_radix(digits, 16).ok().map(|n| (n, 0))
        };
        let plain = |digits: &str| {
            let (whole, fraction) = digits.split_once('.').unwrap_or((digits, ""));
            let both = format!("{whole}{fraction}");
            let fine = !both.is_empty() && both.len() < 30 && both.bytes().all(|b| b.is_ascii_digit());
            let places = u32::try_from(fraction.len()).ok()?;
            fine.then(|| both.parse().ok()).flatten().map(|n: i128| (n, places))
        };
        let prefixed = body.strip_prefix("0x").or_else(|| body.strip_suffix(['h', 'H']));
        let (digits, places) = prefixed.map_or_else(|| plain(body), hex)?;
        let digits = if negative { -digits } else { digits };
        Some(Self { digits, places, physical: percent || body.contains('.') })
    }

    /// The count that it stands for, where one count is `num / den` of the printed unit.
    pub(super) fn count(self, (num, den): (i128, i128)) -> Option<i128> {
        let (top, bottom) =
            if self.physical { (self.digits.checked_mul(den)?, num) } else { (self.digits, 1) };
        let bottom = bottom.checked_mul(10_i128.checked_pow(self.places)?)?;
        (bottom != 0 && top % bottom == 0).then(|| top / bottom)
    }
}

/// Whether the words of a cell can be one number: extracts break it only where it was too wide for its column.
fn is_one(text: &str) -> bool {
    const WIDE: usize = 6;
    let mut words = text.split_whitespace();
    let first = words.next().unwrap_or_default().trim_start_matches(['-', '+']);
    words.all(|word| matches!(word, "%" | "h" | "H") || first.len() >= WIDE)
}

/// The leading factor of a unit as a profile writes it: `0.1 rpm` is 1/10.
pub(super) fn factor(unit: Option<&str>) -> (i128, i128) {
    let Some(first) = unit.and_then(|u| u.split(' ').next()) else { return (1, 1) };
    if let Some((num, den)) = first.split_once('/') {
        return num.parse().ok().zip(den.parse().ok()).unwrap_or((1, 1));
    }
    Number::parse(first).map_or((1, 1), |n| (n.digits, 10_i128.pow(n.places)))
}

/// A printed range: its ends, or the values that it lists.
#[derive(Clone, PartialEq, Eq, Debug)]
pub(super) enum Range {
    /// From, to.
    Ends(Number, Number),
    /// One value: an upper limit, or the only value.
    One(Number),
    /// Values.
    List(Vec<Number>),
}

impl Range {
    /// Reads a cell of a range; what follows a value with a colon, as in `0~42 0: Action mode`, is left aside.
    pub(super) fn parse(text: &str) -> Option<Self> {
        let ranges = text.replace('～', "~");
        if let Some((low, high)) = ranges.split_once('~') {
            let high = Number::parse(high).or_else(|| Number::parse(high.split_whitespace().next()?))?;
            return Some(Self::Ends(Number::parse(low)?, high));
        }
        let parts: Vec<&str> = ranges.split(',').collect();
        match parts.as_slice() {
            [one] => Number::parse(one).map(Self::One),
            many => many.iter().map(|part| Number::parse(part)).collect::<Option<_>>().map(Self::List),
        }
    }
}

/// The values that a cell lists with their labels: `0: off 1~99: alarm` gives (`0`, `off`) and (`1~99`, `alarm`).
pub(super) fn labels(text: &str) -> Vec<(&str, &str)> {
    let inside = |c: char| c.is_ascii_digit() || c == '~';
    let start = |colon: usize| {
        let before = text[..colon].trim_end();
        before.rfind(|c| !inside(c)).map_or(0, |n| n + before[n..].chars().next().map_or(1, char::len_utf8))
    };
    let keys: Vec<(usize, usize)> = text
        .match_indices(':')
        .map(|(colon, _)| (start(colon), colon))
        .filter(|(start, colon)| text[*start..*colon].contains(|c: char| c.is_ascii_digit()))
        .collect();
    let ends = keys.iter().skip(1).map(|(start, _)| *start).chain([text.len()]);
    let label = |((start, colon), end): (&(usize, usize), usize)| {
        (text[*start..*colon].trim(), text.get(*colon + 1..end).unwrap_or_default().trim())
    };
    keys.iter().zip(ends).map(label).collect()
}

/// The values in front of colons: `0: off 1: on` gives 0 and 1; `1~99: ...` gives both ends.
pub(super) fn keyed(text: &str) -> Vec<i128> {
    labels(text).iter().flat_map(|(key, _)| key.split('~')).filter_map(|n| n.trim().parse().ok()).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn count(text: &str, unit: &str) -> Option<i128> {
        Number::parse(text)?.count(factor(Some(unit)))
    }

    #[test]
    fn numbers_become_counts() {
        assert_eq!(count("6000.0", "0.1 rpm"), Some(60_000));
        assert_eq!(count("-300.0%", "0.1 % rated torque"), Some(-3_000));
        assert_eq!(count("500", "0.1 rpm"), Some(500));
        assert_eq!(count("0.01", "0.1 rpm"), None);
        assert_eq!(count("-200000 0000", "user position"), Some(-2_000_000_000));
        assert_eq!(count("604100 h", "x"), Some(0x0060_4100));
        assert_eq!(count("0x1A00", "x"), Some(0x1A00));
        assert_eq!(count("300.0 %", "0.1 %"), Some(3_000));
        assert_eq!((count("0 1", "x"), count("1 0 %", "x"), count("- 5", "x")), (None, None, None));
        assert_eq!((count("", "x"), count("-", "x"), count("1-2", "x")), (None, None, None));
    }

    #[test]
    fn ranges() {
        let ends = |t: &str| match Range::parse(t) {
            Some(Range::Ends(a, b)) => a.count((1, 10)).zip(b.count((1, 10))),
            _ => None,
        };
        assert_eq!(ends("0.1~6000.0"), Some((1, 60_000)));
        assert_eq!(ends("0x1600~ 0x1603"), Some((0x1600, 0x1603)));
        assert_eq!(ends("0~42 0: Action mode 1: Speed"), Some((0, 42)));
        assert!(matches!(Range::parse("0,1,5"), Some(Range::List(list)) if list.len() == 3));
        assert_eq!(Range::parse("Refer to"), None);
        assert_eq!(labels("0~2 0: off 1: on 11: x"), [("0", "off"), ("1", "on"), ("11", "x")]);
        assert_eq!(keyed("0: no detection 1~99: alarm"), [0, 1, 99]);
    }
}
