"""Lets python-canopen judge the EDS of every golden case, and dcfchk those with a device type. Usage: golden.py ROOT

Their broken copies are tried on the files of real drives: here a great many shapes of dictionaries are read.
"""

import json
import sys
import tempfile
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import eds_canopen
import eds_dcfchk


def findings(case):
    """What the judges have against the EDS of a case, which is copied to a file of its own name."""
    model = json.loads((case / "out/model.snap.json").read_text(encoding="utf-8"))
    found = []
    for snapshot in sorted((case / "out").glob("eds-*.snap.eds")):
        with tempfile.TemporaryDirectory() as folder:
            file = Path(folder) / snapshot.name.removeprefix("eds-").replace(".snap", "")
            file.write_bytes(snapshot.read_bytes())
            found += [f"{case.name}: canopen: {text}" for text in eds_canopen.judge(model, file)]
            # dcfchk ends with a stack trace unless there is 1000h, which most of the small cases leave out.
            if any(entry["index"] == 0x1000 for entry in model["objects"]):
                found += [f"{case.name}: dcfchk: {text}" for text in eds_dcfchk.judge(file)]
    return found


def main(root):
    """Judges every case; says what was found."""
    cases = sorted(path for path in (Path(root) / "tests/golden").iterdir() if (path / "out").is_dir())
    if len(cases) < 40:
        print(f"only {len(cases)} golden cases found")
        return 1
    with ThreadPoolExecutor() as pool:
        found = [text for texts in pool.map(findings, cases) for text in texts]
    for text in found:
        print(text)
    print(f"{len(cases)} golden cases: {len(found)} findings")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1]))
