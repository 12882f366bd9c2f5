"""Lets xmlschema judge profiles in XML, as `drivewright convert` writes them, by their XSD. Usage: profile_xsd.py ROOT"""

import os
import subprocess
import sys
import tempfile
from pathlib import Path

import xmlschema

# Broken copies: in which file, what is changed, and how.
BROKEN = [
    ("objects", "key that nobody knows", ' name="', ' nmae="'),
    ("objects", "element that nobody knows", "<row ", "<object "),
    ("objects", "table that nobody knows", "objects>", "objcets>"),
    ("objects", "word", 'access="ro"', 'access="or"'),
    ("objects", "type", 'type="u32"', 'type="u33"'),
    ("objects", "address", 'at="1000:00"', 'at="0x1000"'),
    ("objects", "text of no length", ' name="Device type"', ' name=""'),
    ("alarms", "number", 'number="0x01"', 'number="0y01"'),
    ("alarms", "number with a fraction", 'code="0x2311"', 'code="1.5"'),
    ("alarms", "text among items", "<causes>", "<causes>text"),
    ("alarms", "word in a list", "<item>PreOP</item>", "<item>Boot</item>"),
    ("alarms", "element of a list", "item>", "value>"),
    ("errata", "true or false", 'unset="true"', 'unset="1"'),
    ("drive", "list as an attribute", ' name="', ' bases="cia301" name="'),
    ("drive", "key that is there twice", "<date>", "<date>2026-01-01</date><date>"),
    ("drive", "date", "<date>2026-", "<date>26-"),
    ("drive", "table that is there twice", "<drive", "<manuals/><drive"),
]


def converted(root, profile, folder):
    """The files of a profile as XML, by name."""
    cargo = os.environ.get("CARGO", "cargo")
    program = [cargo, "run", "--quiet", "--package", "drivewright", "--"]
    subprocess.run(program + ["convert", str(profile), "--to", "xml", "--out", folder, "--quiet"], cwd=root, check=True)
    return {file.stem: file.read_text("utf-8") for file in sorted(Path(folder).glob("*.xml"))}


def findings(schema, text):
    """What is wrong with a file, with the place; text that is no XML any more is one finding."""
    try:
        return [f"{error.path}: {error.reason}" for error in schema.iter_errors(text)]
    except (xmlschema.XMLSchemaException, SyntaxError) as error:
        return [str(error)]


def main(root):
    schema = xmlschema.XMLSchema(str(Path(root, "codegen/schema/profile.xsd")))
    folders = sorted({file.parent for file in Path(root, "profiles").glob("*/*/*.toml")})
    clean, files, drive = True, 0, None
    for profile in folders:
        with tempfile.TemporaryDirectory() as folder:
            texts = converted(root, profile.resolve(), folder)
        for name, text in texts.items():
            files += 1
            for finding in findings(schema, text):
                clean = False
                print(f"{profile.name}/{name}.xml: {finding[:300]}")
        drive = texts if drive is None and "drive" in texts else drive
    refused = []
    for name, kind, old, new in BROKEN:
        # Names of elements change in both of their tags.
        broken = drive[name].replace(old, new) if new.endswith(">") and "<" not in new else drive[name].replace(old, new, 1)
        if broken == drive[name]:
            clean = False
            print(f"{name}.xml: there is nothing to break for another {kind}")
        elif findings(schema, broken):
            refused.append(kind)
        else:
            clean = False
            print(f"{name}.xml: a copy with another {kind} is accepted")
    print(f"{files} files; broken copies refused: {', '.join(refused)}")
    return 0 if clean and files else 1


if __name__ == "__main__":
    sys.exit(main(sys.argv[1]))
