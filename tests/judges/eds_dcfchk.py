"""Lets dcfchk of Lely judge an EDS: it must end with 0 and say nothing. Usage: eds_dcfchk.py EDS"""

import subprocess
import sys
from pathlib import Path

import controls

# dcfchk tells some defects only by a warning and ends with 0, so its silence counts as well.
COMMAND = [sys.executable, "-W", "always", "-m", "dcf.cli", "-n", "5"]

CHANGES = [
    ("type of a sub-index 0", r"(sub0\][^\[]*?DataType=0x000)5", r"\g<1>6"),
    ("limit", r"^((?:Low|High)Limit=-?\d*)\d$", r"\g<1>x"),
    ("access word", r"^(AccessType=r)[ow]$", r"\g<1>x"),
    ("list count", r"^(SupportedObjects=\d*)([1-9])$", controls.other_digit),
    ("count of sub-indexes", r"^(SubNumber=\d*)(\d)$", controls.other_digit),
    ("name of a section", r"^\[(\d{3})\d\]$", r"[\1X]"),
    ("key", r"^PDOMapping=", "PDOMappinx="),
    ("default", r"^(DefaultValue=-?\d*)\d$", r"\g<1>x"),
]


def judge(path):
    """What dcfchk has against the file."""
    done = subprocess.run([*COMMAND, str(path)], capture_output=True, text=True, check=False)
    findings = [line for line in done.stderr.splitlines() if line.strip()]
    return findings or ([f"dcfchk ends with {done.returncode}"] if done.returncode else [])


if __name__ == "__main__":
    sys.exit(0 if controls.run(Path(sys.argv[1]), CHANGES, judge) else 1)
