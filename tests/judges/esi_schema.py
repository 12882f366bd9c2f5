"""Lets xmllint and xmlschema judge every ESI by the schemas of ETG.2000. Usage: ETG_XSD_DIR=FOLDER esi_schema.py ROOT

FOLDER holds the schemas, which are not ours to publish: one `EtherCATInfo.xsd`, or a folder a version with one in each.
"""

import os
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

import xmlschema

import controls

# Each is a slip that files of real devices have.
CHANGES = [
    ("hexadecimal number", "#x", "0x"),
    ("order of two elements", r"( *<Type>.*</Type>\n)( *<BitSize>.*</BitSize>\n)( *<(?:Info|Flags)>)", r"\g<2>\g<1>\g<3>"),
    ("name that is missing", r"(<Object>\n *<Index>.*</Index>\n) *<Name>.*</Name>\n", r"\g<1>"),
    ("word of an access", r"<Access>rw</Access>", "<Access>const</Access>"),
    ("half a byte", r"<DefaultData>.", "<DefaultData>"),
    ("type that is not declared", r"(<SubItem>\n *<SubIdx>0</SubIdx>\n *<Name>.*</Name>\n *<Type>)\w+", r"\g<1>QINT"),
    ("data type twice", r"(<DataTypes>\n)( *<DataType>\n(?:.*\n)*?.*</DataType>\n)", r"\g<1>\g<2>\g<2>"),
    ("group that is missing", r"<GroupType>.*</GroupType>\n", ""),
]


def schemas(folder):
    """Every version of the schema below `folder`."""
    return sorted(Path(folder).rglob("EtherCATInfo.xsd"))


def by_xmllint(schema):
    """A judge that is content with what xmllint takes for valid."""

    def judge(file):
        found = subprocess.run(["xmllint", "--noout", "--nonet", "--schema", schema, file], capture_output=True, text=True)
        return [] if found.returncode == 0 else [line for line in found.stderr.splitlines() if line][:5]

    return judge


def by_xmlschema(schema):
    """The same for the package xmlschema."""
    compiled = xmlschema.XMLSchema(schema)

    def judge(file):
        try:
            return [f"{error.path}: {error.reason}" for error in compiled.iter_errors(file)][:5]
        except (xmlschema.XMLSchemaException, SyntaxError) as error:
            return [str(error)]

    return judge


def goldens(root, folder):
    """Copies of the ESI of every golden case, each with a name of its own."""
    for snapshot in sorted((root / "tests/golden").glob("*/out/esi-*.snap.xml")):
        copy = Path(folder, f"{snapshot.parents[1].name}.xml")
        copy.write_bytes(snapshot.read_bytes())
        yield copy


def main(root):
    """Judges every file with every schema and every engine; says what was found."""
    found, root = 0, Path(root)
    versions = schemas(os.environ["ETG_XSD_DIR"])
    if not versions:
        print(f"{os.environ['ETG_XSD_DIR']}: there is no EtherCATInfo.xsd")
        return 1
    engines = [("xmlschema", by_xmlschema)]
    if shutil.which("xmllint"):
        engines.append(("xmllint", by_xmllint))
    else:
        print("there is no xmllint; xmlschema judges alone")
    drives = sorted((root / "generated").glob("*/esi/*.xml"))
    with tempfile.TemporaryDirectory() as folder:
        cases = list(goldens(root, folder))
        if not drives or len(cases) < 3:
            print(f"only {len(drives)} drives and {len(cases)} golden cases found")
            return 1
        for schema in versions:
            for name, engine in engines:
                judge = engine(schema)
                print(f"{schema.parent.name}, {name}:")
                for file in cases:
                    findings = judge(file)
                    found += bool(findings)
                    print(*(f"{file.name}: {finding}" for finding in findings), sep="\n", end="\n" if findings else "")
                for file in drives:
                    found += not controls.run(file, CHANGES, judge, encoding="utf-8", newline="\n")
    print(f"{len(drives)} drives and {len(cases)} golden cases, {len(versions)} schemas: {found} findings")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1]))
