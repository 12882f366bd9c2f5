//! A made-up drive of any size, the same in every run: what every compiler here is fed, each in its own language.

use drivewright_tests::random::Random;

/// A drive.
pub struct Drive {
    pub objects: Vec<Object>,
    pub tables: Vec<Table>,
    pub alarms: usize,
}

/// An object: a variable where it has one entry, else a record.
pub struct Object {
    pub index: u16,
    pub name: String,
    pub entries: Vec<Entry>,
}

/// An entry of an object.
pub struct Entry {
    pub sub: u8,
    pub name: String,
    pub ty: Type,
    pub writable: bool,
    /// Receive or transmit process data may carry it.
    pub mapped: bool,
    pub unit: Option<&'static str>,
    /// Lowest, highest and first value.
    pub range: Option<[i64; 3]>,
    /// The table that names its values.
    pub table: Option<usize>,
    pub text: Option<String>,
}

/// An integer type.
#[derive(Clone, Copy, PartialEq, Eq)]
pub struct Type {
    pub signed: bool,
    pub bits: u8,
}

/// Named values from 0.
pub struct Table {
    pub name: String,
    pub labels: Vec<String>,
}

/// Named values of a table.
pub const LABELS: usize = 6;
/// Value tables of 1,000 entries.
const TABLES_PER_1000: usize = 150;
/// Alarms of 1,000 entries.
const ALARMS_PER_1000: usize = 40;
/// Variables before each record.
const VARIABLES: usize = 2;
/// Entries of a record, sub-index 0 included.
const MEMBERS: u8 = 8;

const COUNT: Type = Type { signed: false, bits: 8 };
const TYPES: [Type; 6] = [
    COUNT,
    Type { signed: false, bits: 16 },
    Type { signed: false, bits: 32 },
    Type { signed: true, bits: 16 },
    Type { signed: true, bits: 32 },
    Type { signed: true, bits: 32 },
];
const UNITS: [&str; 4] = ["0.1 rpm", "1 ms", "0.1 %", "1 mA"];
const WORDS: [&str; 16] = [
    "position", "velocity", "torque", "current", "limit", "filter", "gain", "window", "time", "demand",
    "actual", "offset", "brake", "encoder", "feedback", "ramp",
];

/// A drive of `entries` entries, or a few more so that the last record is whole.
pub fn drive(entries: usize) -> Drive {
    let mut maker = Maker { random: Random::new(402), made: 0, tables: entries * TABLES_PER_1000 / 1000 };
    let mut objects = Vec::new();
    for index in 0x2000.. {
        if maker.made >= entries {
            break;
        }
        objects.push(maker.object(index, objects.len() % (VARIABLES + 1) < VARIABLES));
    }
    let tables = (0..maker.tables).map(|n| maker.table(n)).collect();
    Drive { objects, tables, alarms: entries * ALARMS_PER_1000 / 1000 }
}

impl Drive {
    /// How many entries it has.
    pub fn entries(&self) -> usize {
        self.objects.iter().map(|o| o.entries.len()).sum()
    }
}

struct Maker {
    random: Random,
    made: usize,
    tables: usize,
}

impl Maker {
    fn words(&mut self, many: usize) -> String {
        let words: Vec<&str> = (0..many).filter_map(|_| self.random.pick(&WORDS)).copied().collect();
        words.join(" ")
    }

    fn object(&mut self, index: u16, variable: bool) -> Object {
        let name = format!("{} {index:X}", self.words(2));
        let subs = if variable { 0..1 } else { 0..MEMBERS };
        let entries = subs.map(|sub| self.entry(index, sub, variable)).collect();
        Object { index, name, entries }
    }

    fn entry(&mut self, index: u16, sub: u8, variable: bool) -> Entry {
        self.made += 1;
        if !variable && sub == 0 {
            return count(index);
        }
        // Spread over the drive, one entry a table.
        let table = (self.made * TABLES_PER_1000 / 1000 > (self.made - 1) * TABLES_PER_1000 / 1000)
            .then_some(self.made * TABLES_PER_1000 / 1000 - 1)
            .filter(|n| *n < self.tables);
        let ty = table.map_or_else(|| self.random.pick(&TYPES).copied().unwrap_or(COUNT), |_| COUNT);
        Entry {
            sub,
            name: format!("{} {index:X}.{sub}", self.words(2)),
            ty,
            writable: !self.random.once_in(4),
            mapped: self.random.once_in(4),
            unit: self.random.pick(&UNITS).copied().filter(|_| table.is_none()),
            range: (table.is_none() && !self.random.once_in(3)).then(|| self.range(ty)),
            table,
            text: self.random.once_in(2).then(|| format!("Sets the {}.", self.words(6))),
        }
    }

    fn range(&mut self, ty: Type) -> [i64; 3] {
        let most = (1_i64 << (ty.bits - 1)) - 1;
        let high = 1 + self.random.below(usize::try_from(most).unwrap_or(1)) as i64;
        [if ty.signed { -high } else { 0 }, high, high / 2]
    }

    fn table(&mut self, n: usize) -> Table {
        let labels = (0..LABELS).map(|label| format!("{} {label}", self.words(2))).collect();
        Table { name: format!("table {n}"), labels }
    }
}

/// Sub-index 0 of a record.
fn count(index: u16) -> Entry {
    Entry {
        sub: 0,
        name: format!("highest sub-index {index:X}"),
        ty: COUNT,
        writable: false,
        mapped: false,
        unit: None,
        range: Some([0, i64::from(MEMBERS - 1), i64::from(MEMBERS - 1)]),
        table: None,
        text: None,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn is_of_the_size_asked_and_the_same_each_time() {
        let one = drive(1000);
        assert_eq!(one.entries(), 1000);
        assert_eq!(one.tables.len(), 150);
        let used = one.objects.iter().flat_map(|o| &o.entries).filter(|e| e.table.is_some()).count();
        assert!(used > 100, "{used}");
        assert_eq!(one.objects[7].entries[0].name, drive(1000).objects[7].entries[0].name);
    }
}
