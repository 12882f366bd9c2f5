//! A page for each code that is no lint: why it is there, what it looks like, what to do. Pages of lints stand beside the
//! lints.

use std::fmt::Write;

use super::Code;

/// What is said of a code beyond its title.
struct Page {
    id: &'static str,
    why: &'static str,
    /// What has the finding; empty where a line cannot show it.
    example: &'static str,
    to_do: &'static str,
}

/// The page of `code` as Markdown; `None` for lints.
pub fn text(code: Code) -> Option<String> {
    let page = PAGES.iter().find(|page| page.id == code.id())?;
    let mut out = format!("# {}: {}\n\nSeverity: {}.\n\n", code.id(), code.title(), code.severity().word());
    let _ = write!(out, "## Why\n\n{}\n\n", page.why);
    if !page.example.is_empty() {
        let _ = write!(out, "## Fails\n\n```\n{}\n```\n\n", page.example);
    }
    let _ = writeln!(out, "## What to do\n\n{}", page.to_do);
    Some(out)
}

/// The codes that have a page, ascending by number in each list of codes.
pub fn ids() -> impl Iterator<Item = &'static str> {
    PAGES.iter().map(|page| page.id)
}

const fn page(id: &'static str, why: &'static str, example: &'static str, to_do: &'static str) -> Page {
    Page { id, why, example, to_do }
}

#[rustfmt::skip]
const PAGES: &[Page] = &[
    page("E0001", "Without the file the profile is not whole, and half a profile is a wrong one.",
        "drivewright check profiles/acme/not-there",
        "Name the folder that holds `drive.toml`, and see that it and its files can be read."),
    page("E0002", "A table of a manual has kilobytes. A file of many megabytes is no profile, and every tool would wait for it.",
        "", "Split the table into several files; rows of one table may stand in any of them."),
    page("E0003", "Only in UTF-8 does each byte mean the same to every reader.",
        "name = \"R\\xFCcklauf\"   (a byte FCh)", "Save the file as UTF-8."),
    page("E0004", "A profile has one file a table, and there are about twenty tables.",
        "", "Join tables; name the folder of one drive, not one above it."),
    page("E0005", "A profile is what its folder holds: a link that leads out would make it depend on the machine.",
        "objects.toml -> ../other/objects.toml", "Copy the file into the folder."),
    page("E0006", "Controls, bidi marks, zero-width characters and tags can make a text read as what it is not.",
        "name = \"Speed\\u202E\"", "Remove the character. A row is one line of text."),
    page("E0007", "One slip can give a finding a row. A run keeps the first ones and counts the others.",
        "", "Correct those shown and run again."),
    page("W0008", "One slip can give a finding a row. A run keeps the first ones and counts the others.",
        "", "Correct those shown and run again."),
    page("E0009", "Reading a pipe or a device would wait for ever, and give something else the next time.",
        "mkfifo profiles/acme/x1/objects.toml", "Put a file in its place, or give it another name than `*.toml`."),
    page("E0010", "One of the two texts would be lost. No profile should be able to do this: it is an error of drivewright.",
        "", "Report it, with the profile."),

    page("E0101", "The file must be TOML before any of it can be trusted. Rows without an error in them are still read.",
        "{ at = \"2000:00\" name = \"Speed\" }", "Correct the text at the marked place."),
    page("E0102", "Rows of a table that is not known would be lost.",
        "object = [ { at = \"2000:00\" } ]", "Correct the name: `drivewright schema` lists the tables."),
    page("E0103", "A key that is not known would be lost, and the fact with it.",
        "{ at = \"2000:00\", nmae = \"Speed\" }", "Correct the key: `drivewright schema` lists those of each table."),
    page("E0104", "Without this key the row states nothing, and nothing is guessed.",
        "enums = [ { name = \"Mode\", label = \"Off\" } ]", "Add the key from the manual."),
    page("E0105", "A value of another kind would have to be guessed at.",
        "{ at = \"2000:00\", max = \"100\" }", "Write text in quotes, numbers without, lists in square brackets."),
    page("E0106", "The key takes certain words or shapes, and each means one thing.",
        "{ at = \"2000:00\", access = \"readonly\" }", "Write one of the words that the finding lists."),
    page("E0107", "A number that does not fit would be cut to another one.",
        "{ at = \"2000:00\", max = 18446744073709551616 }", "Correct the number; it is a raw count."),
    page("E0108", "Every output format must be able to hold the text, and every reader to see its end.",
        "", "Say it shorter; describe the rest in `text` or in the manual's own place."),
    page("E0109", "No drive has so many facts of one kind. What is in the table is not looked at.",
        "", "Remove rows that repeat a fact, and use ranges: `3000:01..63`."),
    page("E0110", "Index and sub-index are hexadecimal with all their digits, so that 10 cannot be read as ten.",
        "{ at = \"607D:1\" }", "Write `607D:01`, `607D`, or `3000:01..63` for a range."),
    page("E0111", "A citation that cannot be read leads nobody to the manual.",
        "src = \"page 12\"", "Write section, table and line, as in `6.2 T6-2 L1230`."),
    page("E0112", "The unit of one count becomes an exact factor of a typed quantity.",
        "unit = \"rpms\"", "Write a factor and a symbol, as in `0.1 rpm`; other words belong into `text`."),
    page("E0113", "This version knows other keys than the profile was written for, and would misread it.",
        "format = 2", "Use the version of drivewright that the profile was written for."),
    page("E0114", "Profiles are exact. Values are raw counts, and the unit carries the factor.",
        "{ at = \"2000:00\", max = 3000.0 }", "Write the raw count: 0.1 to 6000.0 at 0.1 rpm is 1 to 60000."),
    page("E0115", "A homing program is executed: what cannot be read would move an axis in some other way.",
        "moves = \"fast until home on\"", "Write steps as in `+ fast until home on; - slow until home off; latch`."),
    page("E0116", "A rule is evaluated: what cannot be read would hold for everything or for nothing.",
        "require = \"2000:00 % == 0\"", "Write objects as `6041:00`, whole numbers, operators and parentheses."),
    page("E0117", "Ids become names of folders, crates and files on every system.",
        "id = \"../x1\"", "Use lower-case letters, digits and `-`, and start with a letter."),
    page("E0118", "A table holds rows, a row holds values, and a value is at most a list.",
        "at = [[[[[[ ... ]]]]]]", "Write each fact as a row of its own."),
    page("E0119", "There are about twenty tables. What is in the file is not looked at.",
        "[a0] [a1] [a2] ...", "Put the rows of one kind into one table."),
    page("E0120", "No table has so many keys. What is in the row is not looked at.",
        "{ k0 = 0, k1 = 1, k2 = 2, ... }", "Write each fact as a row of its own."),

    page("E0201", "Standard objects would lose their types.",
        "bases = [\"cia403\"]", "Name a base that there is: `cia301`, `cia402`, `coe`."),
    page("E0202", "Two rows for one thing may come to differ, and nobody could say which holds.",
        "{ at = \"2000:00\", ... }\n{ at = \"2000:00\", ... }",
        "Keep one. If the manual prints both and they differ, keep the one you trust and add an erratum."),
    page("E0203", "A correction that matches nothing has been overtaken, or never worked; one of two rows would be a guess.",
        "errata = [ { at = \"2001:00\", ... } ]   (there is no such row)",
        "Name the row as messages do; of alarms with one display name the number as well: `alarm OF 0x25`."),
    page("E0204", "An erratum holds for the printed value that it was written against, and for no other.",
        "{ at = \"2000:00\", max = 3000 }   and   { at = \"2000:00\", field = \"max\", was = 30000, ... }",
        "Look at the manual again: correct `was`, or remove the erratum."),
    page("E0205", "Of two corrections of one value at most one can be right.",
        "{ id = \"E1\", field = \"max\", set = 5, ... }\n{ id = \"E2\", field = \"max\", set = 6, ... }", "Keep one of them."),
    page("E0206", "A correction that changes nothing hides what it is for.",
        "was = 30000, set = 30000", "Leave `set` out to keep the printed value and record the contradiction."),
    page("E0207", "Most contradictions of a standard object are slips of the pen or of the manual.",
        "{ at = \"6041:00\", access = \"rw\" }   (with base `cia402`)",
        "Correct the row. If the drive really differs, say why in `deviation`; if the manual is wrong, add an erratum."),
    page("E0208", "A reason without a contradiction would hide the next one.",
        "{ at = \"6041:00\", deviation = \"...\" }", "Remove `deviation`; if the meaning differs, describe it in `text` as well."),
    page("E0209", "The row `drive` names the maker, the product and the versions of what is generated. There is one.",
        "", "Add `[drive]` in `drive.toml`, or keep one of two."),
    page("E0210", "An allowance that matches nothing may hide the next real finding.",
        "allow = [ { lint = \"E0402\", at = \"2000:00\", ... } ]   (and E0402 finds nothing there)",
        "Remove it, or correct `lint` and `at`."),
    page("E0211", "There are fewer bases than that.",
        "", "Remove bases whose objects the drive does not have."),

    page("E0301", "Width and sign are needed to build a frame, and nothing is assumed in silence.",
        "{ at = \"2000:00\", name = \"Speed\", access = \"rw\" }",
        "Add `type`; if it follows by a rule, name the rule in `inferred`; if the object is a standard one, name its base."),
    page("E0302", "A write that the drive would refuse must not compile, and nothing is assumed in silence.",
        "{ at = \"2000:00\", name = \"Speed\", type = \"u16\" }",
        "Add `access`; if it follows by a rule, name the rule in `inferred`; if the object is a standard one, name its base."),
    page("E0303", "Generated code could not be called anything.",
        "{ at = \"2000:00\", type = \"u16\", access = \"rw\" }", "Add `name` as the manual prints it."),
    page("E0304", "Names of generated code are made of ASCII letters and digits. The printed name may be of any script.",
        "{ at = \"2000:00\", name = \"速度\", ... }", "Keep the name as printed and add `rename` with an English one."),
    page("E0305", "A number behind one of two equal names would change its meaning when a row is added, and break users in silence.",
        "{ at = \"2000:00\", name = \"Speed limit\", ... }\n{ at = \"2001:00\", name = \"Speed Limit\", ... }",
        "Give one of the rows `rename`."),
    page("E0306", "The values of the object would stay without a meaning.",
        "{ at = \"2000:00\", values = \"Mode\" }   (and no row of `enums` has that name)", "Add the table, or correct its name."),
    page("E0307", "The bits of the object would stay without a meaning.",
        "{ at = \"2000:00\", bits = \"State\" }   (and no row of `bits` has that name)", "Add the table, or correct its name."),
    page("E0308", "What refers to an object must find it in the dictionary.",
        "pdo = [ { entry = \"2000:00\", ... } ]   (and no row has that address)", "Add a row to `objects`, or correct the address."),
    page("E0309", "A citation names a document of the table `manuals`.",
        "src = \"m2 L12\"   (and `manuals` has no `m2`)", "Add the manual, or correct its id."),
    page("E0310", "No drive has so many entries; most often a range is too wide.",
        "", "Look for a range of sub-indexes that the drive does not have."),
    page("E0311", "A reason or a correction belongs to one value of one row.",
        "inferred = [\"typ: width from the range\"]", "Name a key that the row has."),
    page("E0312", "A method that is half said would be executed some other way.",
        "{ method = 1, moves = \"...\" }   (and no `when`)", "State start and moves, or `same`, or `status`."),
    page("E0313", "Sub-index 0 of a mapping counts its entries in one byte, and the highest values are reserved.",
        "", "Check the columns `map` and `pos`."),
    page("E0314", "One frame carries the process data of a direction.",
        "", "Check the columns `map` and `bits`."),
    page("E0315", "No servo drive has so many PDOs.",
        "", "Check the column `map`."),

    page("W1201", "A typed layout has whole bytes in the order of the frame, so that each value is read in one step.",
        "", "Nothing, if the drive maps it so: the mapping is in the table of the crate all the same."),
    page("W1202", "A limit is written with the type of its object.",
        "", "Correct the limit or the type. If both are printed so, nothing: the table carries them."),
    page("W1203", "A type of values has a width that Rust has.",
        "", "Nothing: the names are in the table of the crate all the same."),
    page("W1001", "An EDS writes values as CiA 306 says, and readers differ on the others.",
        "", "Nothing: model.json and the generated crate carry the value."),
    page("W1002", "Readers of an EDS refuse limits that contradict each other or the default; so these are left out.",
        "", "Correct the row, or record the contradiction as an erratum."),
    page("W1003", "CiA 306 has no word for the type or no section for the sub-index.",
        "", "Nothing: model.json and the generated crate carry the object."),
    page("W1004", "CiA 306 demands 1000h, 1001h and 1018h, and some readers refuse a file without them.",
        "", "Add the object if the drive has it."),
    page("W1005", "An EDS is ASCII, one line a value, and some signs have a meaning of their own in it.",
        "name = \"速度\"", "Nothing, or a shorter `name`; model.json and the generated crate carry the text as printed."),
    page("W1901", "An ESI states values as the bytes of their type, and older masters take named values for 32 bits.",
        "", "Nothing, or correct the row where the value is none of the type: model.json carries the value."),
    page("W1902", "An ESI has no index below 1000h, no sub-index FFh, and no PDO that carries nothing; start-up values need CoE.",
        "", "Nothing: model.json carries the object. Correct `mailbox` if the drive has CoE."),
    page("W1903", "An ESI states the bits of every type. Nobody states how long a text or a domain can become.",
        "{ at = \"1008:00\", type = \"string\", ... }", "Nothing: masters read the length that the drive sends."),
    page("W1904", "The codes of units (ETG.1004) have a factor of a power of ten.",
        "unit = \"1/65536 rev\"", "Nothing: model.json and the generated crate carry the unit."),
    page("W1905", "A slave controller has addresses of 16 bits, and process data takes its length three times.",
        "", "State `start` and `size` in `sync_managers`, or correct `pdo_bytes` and `pdos_per_direction`."),
    page("W2001", "A slave controller takes an SII as it is, so what would not work there is not written.",
        "{ number = 2, use = \"outputs\", size = 0, enable = true, ... }", "Correct the row, or add the SyncManagers that are missing."),
    page("W2002", "An SII lists PDOs with entries, four ports and ways to synchronize; it has no start-up values.",
        "", "Nothing: the ESI carries the rest, and a master without the ESI must be told the start-up values."),
    page("W2003", "The size of an EEPROM is a number of 128 bytes, and the image must fit it.",
        "eeprom_bytes = 100", "State `eeprom_bytes` of the row `ethercat` as the drive has it."),
    page("W2004", "An SII holds 255 texts of ASCII, each of at most 255 characters.",
        "name = \"速度\"", "Nothing: model.json and the ESI carry the text as printed."),
];
