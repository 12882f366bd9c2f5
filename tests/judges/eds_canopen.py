"""Compares an EDS, as python-canopen reads it, with model.json. Usage: eds_canopen.py MODEL_JSON EDS"""

import configparser
import functools
import json
import sys
import unicodedata
from collections import Counter
from pathlib import Path

import canopen
from canopen.objectdictionary import ODArray, ODRecord, ODVariable

import controls

# Words of model.json and the codes of CiA 301.
TYPES = {
    "bool": 0x01, "i8": 0x02, "i16": 0x03, "i32": 0x04, "u8": 0x05, "u16": 0x06, "u32": 0x07, "f32": 0x08,
    "string": 0x09, "octets": 0x0A, "unicode": 0x0B, "time": 0x0C, "time_difference": 0x0D, "domain": 0x0F,
    "i24": 0x10, "f64": 0x11, "i40": 0x12, "i48": 0x13, "i56": 0x14, "i64": 0x15, "u24": 0x16, "u40": 0x18,
    "u48": 0x19, "u56": 0x1A, "u64": 0x1B,
}
# python-canopen 2.4.1 drops the limits of these without a word, so they are read from the text.
UNREAD_LIMITS = {TYPES[word] for word in ("i24", "i40", "i48", "i56")}

CHANGES = [
    ("type", r"^(DataType=0x000)6$", r"\g<1>7"),
    ("lower limit", r"^(LowLimit=-?\d*)(\d)$", controls.other_digit),
    ("upper limit", r"^(HighLimit=-?\d*)(\d)$", controls.other_digit),
    ("access word", r"^(AccessType=r)w$", r"\g<1>o"),
    ("default", r"^(DefaultValue=-?\d*)(\d)$", controls.other_digit),
    ("mapping", r"^(PDOMapping=)1$", r"\g<1>0"),
    ("name", r"^(ParameterName=\w+)\w$", r"\g<1>_"),
    ("kind", r"^(ObjectType=0x)9$", r"\g<1>8"),
    ("index", r"^(\[6\d\d)\d\]$", r"\g<1>F]"),
    ("sub-index", r"^(\[1018sub)1\]$", r"\g<1>9]"),
    ("vendor", r"^(VendorNumber=0x\w*)\w$", r"\g<1>F"),
    ("file version", r"^(FileVersion=)(\d)$", controls.other_digit),
]


def value(row, key):
    """The value of a fact of model.json; None where nobody states it."""
    fact = row.get(key)
    return None if fact is None else fact["value"]


def number(row, key):
    """The same for whole numbers, which are text where they would not fit a float."""
    found = value(row, key)
    return None if found is None else int(found)


def ini(text):
    """A text as an EDS can hold it: one line of ASCII without signs that some reader takes for a comment or a quote."""
    hidden = [c if unicodedata.category(c) not in ("Cc", "Cf", "Zl", "Zp") else "\n" for c in text]
    line = " ".join(part for part in "".join(hidden).split("\n") if part).replace("#", "No.")
    line = line.translate({ord(";"): ",", ord("\\"): "/", ord("µ"): "u", ord("μ"): "u"})
    return "".join(c if c.isascii() else "?" for c in line).lstrip(" \"'").rstrip()


def unique(names):
    """Names with their number behind where a name stands there twice. Takes pairs of name and number."""
    times = Counter(name for name, _ in names)
    return [ini(name) if times[name] == 1 and ini(name) else ini(f"{ini(name)} {number}") for name, number in names]


def wanted(model):
    """What the model says: {index: (name, kind, {sub: facts})}."""
    mapped = mappings(model)
    titles = unique([(title(obj), f"{obj['index']:04X}h") for obj in model["objects"]])
    objects = {}
    for obj, name in zip(model["objects"], titles):
        names = unique([(value(e, "name"), str(e["sub"])) for e in obj["entries"]])
        kind = value(obj, "kind")
        entries = {
            entry["sub"]: facts(entry, name if kind == "var" else own, kind, obj, mapped)
            for entry, own in zip(obj["entries"], names)
        }
        objects[obj["index"]] = (name, kind, entries)
    return objects


def title(obj):
    """What an object is called: a variable as its only entry."""
    return value(obj["entries"][0] if value(obj, "kind") == "var" else obj, "name")


def mappings(model):
    """Defaults that follow from the default process data: {(index, sub): value}."""
    defaults = {}
    for pdo in model["pdos"]:
        defaults[pdo["index"], 0] = len(pdo["entries"])
        for entry in pdo["entries"]:
            word = entry["index"] << 16 | entry["sub"] << 8 | value(entry, "bits")
            defaults[pdo["index"], entry["position"]] = word
    return defaults


def facts(entry, name, kind, obj, mapped):
    """What the file must say about an entry."""
    word = value(entry, "type")
    integer = word[0] in "iu" and word[1:].isdigit() or word == "bool"
    default = number(entry, "default")
    if default is None:
        default = mapped.get((entry["index"], entry["sub"]))
    if default is None and kind != "var" and entry["sub"] == 0:
        default = max(e["sub"] for e in obj["entries"])
    return {
        "name": name,
        "type": TYPES[word],
        "access": value(entry, "access"),
        "lower limit": number(entry, "min") if integer else None,
        "upper limit": number(entry, "max") if integer else None,
        "default": default if integer else None,
        "mapping": word != "domain" and value(entry, "pdo") not in (None, "no"),
    }


def found(dictionary, text):
    """What python-canopen read, in the same form. Its arrays invent members, so only those read are looked at."""
    objects = {}
    for index, obj in dictionary.indices.items():
        kind = {ODVariable: "var", ODArray: "array", ODRecord: "record"}[type(obj)]
        members = {0: obj} if kind == "var" else obj.subindices
        objects[index] = (obj.name, kind, {sub: read(member, kind, text) for sub, member in members.items()})
    return objects


def read(variable, kind, text):
    """What python-canopen read of an entry. An empty default becomes an empty text or none at all."""
    low, high = variable.min, variable.max
    if variable.data_type in UNREAD_LIMITS:
        section = f"{variable.index:04X}" + ("" if kind == "var" else f"sub{variable.subindex:X}")
        low, high = (text.getint(section, key, fallback=None) for key in ("LowLimit", "HighLimit"))
    return {
        "name": variable.name,
        "type": variable.data_type,
        "access": variable.access_type,
        "lower limit": low,
        "upper limit": high,
        "default": variable.default if variable.default not in ("", b"") else None,
        "mapping": variable.pdo_mappable,
    }


def compare(here, there, what):
    """Names of what is on one side only, and pairs of what is on both."""
    findings = [f"{what(key)} is missing" for key in here.keys() - there.keys()]
    findings += [f"{what(key)} is not in the model" for key in there.keys() - here.keys()]
    return sorted(findings), [(key, here[key], there[key]) for key in sorted(here.keys() & there.keys())]


def dictionary_findings(here, there):
    """Every difference between two dictionaries."""
    findings, both = compare(here, there, lambda index: f"{index:04X}")
    for index, (name, kind, entries), (name_there, kind_there, entries_there) in both:
        if (name, kind) != (name_there, kind_there):
            findings.append(f"{index:04X}: {kind_there} {name_there!r}, not {kind} {name!r}")
        more, members = compare(entries, entries_there, lambda sub, index=index: f"{index:04X}:{sub:02X}")
        findings += more
        for sub, facts_here, facts_there in members:
            findings += [
                f"{index:04X}:{sub:02X} {key}: {facts_there[key]!r}, not {facts_here[key]!r}"
                for key in facts_here
                if facts_there[key] != facts_here[key]
            ]
    return findings


def header_findings(model, dictionary, text, path):
    """Every difference between the identity, names and versions of the drive and those of the file."""
    info, drive, identity = dictionary.device_information, model["drive"], model["identity"]
    file = text["FileInfo"]
    year, month, day = drive["date"].split("-")
    pairs = {
        "vendor": (info.vendor_number, int(identity.get("vendor_id", 0))),
        "product": (info.product_number, int(identity.get("product_code", 0))),
        "revision": (info.revision_number, int(identity.get("revision", 0))),
        "vendor name": (info.vendor_name, ini(drive["vendor"])),
        "product name": (info.product_name, ini(drive["name"])),
        "file name": (file["FileName"], path.name),
        "file version": (file["FileVersion"], str(drive["eds_version"])),
        "file revision": (file["FileRevision"], str(drive["eds_revision"])),
        "date": (file["CreationDate"], f"{month}-{day}-{year}"),
    }
    return [f"{key}: {there!r}, not {here!r}" for key, (there, here) in pairs.items() if there != here]


def judge(model, path):
    """Everything in which the file differs from the model."""
    text = configparser.RawConfigParser(delimiters="=")
    try:
        text.read(path, encoding="ascii")
        dictionary = canopen.import_od(str(path))
    except Exception as error:  # Whatever stops the reader is a finding.
        return [f"python-canopen cannot read it: {error!r}"]
    header = header_findings(model, dictionary, text, path)
    return header + dictionary_findings(wanted(model), found(dictionary, text))


if __name__ == "__main__":
    MODEL = json.loads(Path(sys.argv[1]).read_text(encoding="utf-8"))
    sys.exit(0 if controls.run(Path(sys.argv[2]), CHANGES, functools.partial(judge, MODEL)) else 1)
