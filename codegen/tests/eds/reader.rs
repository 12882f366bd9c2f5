//! A strict reader of EDS files that shares no code with the writer: anything unusual is an error.

use std::collections::{BTreeMap, BTreeSet};

/// The keys of a section.
pub(crate) type Keys = BTreeMap<String, String>;

/// The sections of a file that is well formed down to its bytes.
pub(crate) fn read(bytes: &[u8]) -> Result<BTreeMap<String, Keys>, String> {
    let text = std::str::from_utf8(bytes).map_err(|e| e.to_string())?;
    if !text.bytes().all(|b| b == b'\r' || b == b'\n' || (0x20..0x7F).contains(&b)) {
        return Err("not printable ASCII".into());
    }
    let body = text.strip_suffix("\r\n").ok_or("no end of line at the end")?;
    let (mut sections, mut current) = (BTreeMap::<String, Keys>::new(), None::<String>);
    for (number, line) in (1..).zip(body.split("\r\n")) {
        let at = |what: &str| Err(format!("line {number}: {what}: {line}"));
        if line.contains(['\r', '\n', ';', '#', '\\']) || line.len() > 255 || line.trim() != line {
            return at("a sign that some reader misreads");
        }
        if line.is_empty() {
            current = None;
        } else if let Some(name) = line.strip_prefix('[').and_then(|l| l.strip_suffix(']')) {
            if sections.insert(name.to_owned(), Keys::new()).is_some() {
                return at("the section is there twice");
            }
            current = Some(name.to_owned());
        } else {
            let (Some((key, value)), Some(section)) = (line.split_once('='), &current) else {
                return at("neither a section nor a key of one");
            };
            let named = key.bytes().all(|b| b.is_ascii_alphanumeric() || b == b'_') && !key.is_empty();
            let keys = sections.entry(section.clone()).or_default();
            if !named || keys.insert(key.to_owned(), value.to_owned()).is_some() {
                return at("a bad key, or one that is there twice");
            }
        }
    }
    Ok(sections)
}

/// An entry as the file states it.
#[derive(Clone, PartialEq, Eq, Debug)]
pub(crate) struct Entry {
    pub(crate) name: String,
    pub(crate) ty: u16,
    pub(crate) access: String,
    pub(crate) low: Option<i128>,
    pub(crate) high: Option<i128>,
    pub(crate) default: Option<i128>,
    pub(crate) mapped: bool,
}

/// An object: name, object code, entries by sub-index.
pub(crate) type Object = (String, u8, BTreeMap<u8, Entry>);

/// The object dictionary of a file, with every count and list checked.
pub(crate) fn dictionary(sections: &BTreeMap<String, Keys>) -> Result<BTreeMap<u16, Object>, String> {
    let mut objects = BTreeMap::new();
    let mut used: BTreeSet<&str> = BTreeSet::new();
    for list in ["MandatoryObjects", "OptionalObjects", "ManufacturerObjects"] {
        let keys = section(sections, list)?;
        let count: usize = whole(get(keys, "SupportedObjects", list)?)?;
        if keys.len() != count + 1 {
            return Err(format!("{list}: {count} objects, {} keys", keys.len()));
        }
        for n in 1..=count {
            let index: u16 = whole(get(keys, &n.to_string(), list)?)?;
            let right = match index {
                0x1000 | 0x1001 | 0x1018 => "MandatoryObjects",
                0x2000..=0x5FFF => "ManufacturerObjects",
                _ => "OptionalObjects",
            };
            if list != right || objects.insert(index, object(sections, index, &mut used)?).is_some() {
                return Err(format!("{list}: {index:04X} is in the wrong list or there twice"));
            }
        }
    }
    let known = ["FileInfo", "DeviceInfo", "DummyUsage", "Comments"];
    match sections.keys().find(|name| {
        !name.ends_with("Objects") && !known.contains(&name.as_str()) && !used.contains(name.as_str())
    }) {
        Some(orphan) => Err(format!("[{orphan}] is in no list")),
        None => Ok(objects),
    }
}

fn object<'a>(
    sections: &'a BTreeMap<String, Keys>,
    index: u16,
    used: &mut BTreeSet<&'a str>,
) -> Result<Object, String> {
    let name = format!("{index:04X}");
    let (section_name, keys) = sections.get_key_value(&name).ok_or(format!("no [{name}]"))?;
    used.insert(section_name);
    let code: u8 = whole(get(keys, "ObjectType", &name)?)?;
    let title = get(keys, "ParameterName", &name)?.to_owned();
    let mut entries = BTreeMap::new();
    if !matches!(code, 8 | 9) {
        entries.insert(0, entry(keys, &name)?);
        return Ok((title, code, entries));
    }
    allowed(keys, &["ParameterName", "ObjectType", "SubNumber"], &name)?;
    for sub in 0..=u8::MAX {
        if let Some((section, keys)) = sections.get_key_value(&format!("{name}sub{sub:X}")) {
            used.insert(section);
            entries.insert(sub, entry(keys, section)?);
        }
    }
    let count: usize = whole(get(keys, "SubNumber", &name)?)?;
    if count == entries.len() {
        Ok((title, code, entries))
    } else {
        Err(format!("[{name}] SubNumber {count}"))
    }
}

fn entry(keys: &Keys, section: &str) -> Result<Entry, String> {
    let known = [
        "ParameterName",
        "ObjectType",
        "DataType",
        "AccessType",
        "LowLimit",
        "HighLimit",
        "DefaultValue",
        "PDOMapping",
    ];
    allowed(keys, &known, section)?;
    if !matches!(whole(get(keys, "ObjectType", section)?)?, 2_u8 | 7) {
        return Err(format!("[{section}] is no entry"));
    }
    let number = |key: &str| keys.get(key).filter(|v| !v.is_empty()).map(|v| whole(v)).transpose();
    Ok(Entry {
        name: get(keys, "ParameterName", section)?.to_owned(),
        ty: whole(get(keys, "DataType", section)?)?,
        access: get(keys, "AccessType", section)?.to_owned(),
        low: number("LowLimit")?,
        high: number("HighLimit")?,
        default: number("DefaultValue")?,
        mapped: keys.get("PDOMapping").is_some_and(|v| v == "1"),
    })
}

fn allowed(keys: &Keys, known: &[&str], section: &str) -> Result<(), String> {
    let other = keys.keys().find(|key| !known.contains(&key.as_str()));
    other.map_or(Ok(()), |key| Err(format!("[{section}] has a key `{key}`")))
}

/// A section.
pub(crate) fn section<'a>(sections: &'a BTreeMap<String, Keys>, name: &str) -> Result<&'a Keys, String> {
    sections.get(name).ok_or_else(|| format!("no [{name}]"))
}

/// A key that must be there and not empty.
pub(crate) fn get<'a>(keys: &'a Keys, key: &str, section: &str) -> Result<&'a str, String> {
    let value = keys.get(key).map(String::as_str).filter(|v| !v.is_empty());
    value.ok_or_else(|| format!("[{section}] lacks {key}"))
}

/// A number: hexadecimal with `0x`, or decimal without leading zeros.
pub(crate) fn whole<T: TryFrom<i128>>(text: &str) -> Result<T, String> {
    let digits = text.strip_prefix('-').unwrap_or(text);
    let number = match text.strip_prefix("0x") {
        Some(hex) => i128::from_str_radix(hex, 16).ok(),
        None if digits != "0" && digits.starts_with('0') => None,
        None => text.parse().ok(),
    };
    number.and_then(|n| T::try_from(n).ok()).ok_or_else(|| format!("`{text}` is no number, or too large"))
}
