//! Profiles made by chance, the same ones in every run.

use std::fmt::Write as _;

use drivewright_codegen::compile;
use drivewright_codegen::model::{Model, Type};
use drivewright_codegen::source::Source;

/// What every profile of these tests begins with.
pub(crate) const DRIVE: &str = r#"
manuals = [ { id = "m1", title = "Manual; of #1", version = "1", sha256 = "0000000000000000000000000000000000000000000000000000000000000000", lines = 10 } ]
[drive]
format = 1
id = "x1"
vendor = "Acme"
vendor_id = "acme"
name = "X1"
crate_version = "0.1.0"
eds_version = 3
eds_revision = 7
date = "2026-01-31"
"#;

/// Compiles `objects` with more tables behind them.
pub(crate) fn model(objects: &str, more: &str) -> Model {
    let source = |path: &str, text: String| Source { path: path.into(), text };
    let compiled = compile(vec![
        source("drive.toml", DRIVE.into()),
        source("objects.toml", format!("objects = [\n{objects}\n]\n{more}\n")),
    ]);
    match compiled.sound() {
        Some(model) => model.clone(),
        None => panic!("the profile of this test is wrong: {:#?}\n{objects}", compiled.diagnostics),
    }
}

/// A source of numbers that look random (an LCG; the high bits are the good ones).
pub(crate) struct Chance(u64);

impl Chance {
    pub(crate) fn new(seed: u64) -> Self {
        Self(seed.wrapping_mul(0x9E37_79B9_7F4A_7C15) ^ 0xD1B5_4A32_D192_ED03)
    }

    /// A number below `n`.
    fn below(&mut self, n: u64) -> u64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 33) % n
    }

    fn one_of<'a>(&mut self, list: &[&'a str]) -> &'a str {
        let n = self.below(list.len() as u64);
        list[usize::try_from(n).expect("a short list")]
    }

    /// A number from `low` to `high`, often an edge.
    fn within(&mut self, low: i128, high: i128) -> i128 {
        match self.below(6) {
            0 => low,
            1 => high,
            2 => 0.clamp(low, high),
            _ => {
                let span = u128::try_from(high - low).expect("in order") + 1;
                let n =
                    (u128::from(self.below(1 << 31)) << 62 | u128::from(self.below(1 << 31)) << 31) % span;
                low + i128::try_from(n).expect("below the span")
            }
        }
    }
}

/// A drive with the mandatory objects and a few dozen others.
pub(crate) fn random(seed: u64) -> Model {
    let mut chance = Chance::new(seed);
    let mut rows = String::from(
        r#"
{ at = "1000:00", name = "Device type", type = "u32", access = "ro", pdo = "no", default = 0x192, src = "1 L1" },
{ at = "1001:00", name = "Error register", type = "u8", access = "ro", src = "1 L1" },
{ at = "1018:00", name = "Identity", type = "u8", access = "ro", default = 3, src = "1 L1" },
{ at = "1018:01", name = "Vendor", type = "u32", access = "ro", default = 0x7E6, src = "1 L1" },
{ at = "1018:02", name = "Product", type = "u32", access = "ro", default = 0xFFFFFFFF, src = "1 L1" },
{ at = "1018:03", name = "Revision", type = "u32", access = "const", default = 0, src = "1 L1" },
"#,
    );
    for n in 0..16u16 {
        let index = [0x1008, 0x1C32, 0x2000, 0x5FF0, 0x6000, 0x6FF0, 0xA000][usize::from(n) % 7] + n;
        if chance.below(2) == 0 {
            row(index, 0, &mut chance, &mut rows);
        } else {
            several(index, &mut chance, &mut rows);
        }
    }
    model(&rows, "")
}

/// An array or record, with gaps between its sub-indexes.
fn several(index: u16, chance: &mut Chance, rows: &mut String) {
    let mut subs: Vec<u8> = (1..0xFE).filter(|_| chance.below(40) == 0).collect();
    subs.push(0xFE);
    subs.truncate(usize::try_from(chance.below(9)).expect("a small number") + 1);
    let highest = subs.last().expect("at least one");
    let default = if chance.below(2) == 0 { format!("default = {highest}, ") } else { String::new() };
    let _ = writeln!(
        rows,
        r#"{{ at = "{index:04X}:00", name = "Count {index}", type = "u8", access = "ro", {default}src = "1 L1" }},"#
    );
    for sub in subs {
        row(index, sub, chance, rows);
    }
}

fn row(index: u16, sub: u8, chance: &mut Chance, rows: &mut String) {
    let words: Vec<&str> = Type::words().collect();
    let word = chance.one_of(&words);
    let ty = Type::from_word(word).expect("a word of the list");
    let label = chance.one_of(&["Gain", "[6040]", "A;B", "100 % \u{2030}", "=x=", "'q'", "C:\\\\x #", "µ"]);
    let access = chance.one_of(&["ro", "rw", "wo", "const"]);
    let pdo =
        chance.one_of(&["", r#"pdo = "no", "#, r#"pdo = "rx", "#, r#"pdo = "tx", "#, r#"pdo = "rx tx", "#]);
    let _ = writeln!(
        rows,
        r#"{{ at = "{index:04X}:{sub:02X}", name = "{label} name {index} {sub}", type = "{word}", access = "{access}", {pdo}{}src = "1 L1" }},"#,
        numbers(ty, chance)
    );
}

fn numbers(ty: Type, chance: &mut Chance) -> String {
    let Some((least, most)) = ty.range() else { return String::new() };
    // TOML has 64 bits with a sign.
    let most = most.min(i64::MAX.into());
    let low = chance.within(least, most);
    let high = chance.within(low, most);
    let mut keys = String::new();
    for (key, n) in [("min", low), ("max", high), ("default", chance.within(low, high))] {
        if chance.below(3) > 0 {
            let _ = write!(keys, "{key} = {n}, ");
        }
    }
    keys
}
