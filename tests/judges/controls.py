"""Negative controls: a judge that accepts a broken copy of a file judges nothing."""

import re
import tempfile
from pathlib import Path

# Fewer than this many kinds of breakage say too little about a judge.
LEAST = 4


def broken(text, changes, newline="\r\n"):
    """Yields (kind, copy of `text`) with one thing changed at the first place where each change applies."""
    lines = text.replace("\r\n", "\n")
    for kind, pattern, replacement in changes:
        changed, count = re.subn(pattern, replacement, lines, count=1, flags=re.MULTILINE)
        if count:
            yield kind, changed.replace("\n", newline)


def other_digit(match):
    """Keeps what the first group matched and changes the digit behind it."""
    return match.group(1) + str((int(match.group(2)) + 1) % 10)


def run(path, changes, judge, encoding="ascii", newline="\r\n"):
    """Whether `judge`, which gives a list of findings about a file, is content with `path` and with no broken copy."""
    findings = judge(path)
    if findings:
        print(*(f"{path.name}: {finding}" for finding in findings), sep="\n")
        return False
    text = path.read_bytes().decode(encoding)
    seen, missed = [], []
    others = [kind for kind, *_ in changes]
    with tempfile.TemporaryDirectory() as folder:
        copy = Path(folder, path.name)
        for kind, changed in broken(text, changes, newline):
            copy.write_bytes(changed.encode(encoding))
            (seen if judge(copy) else missed).append(kind)
            others.remove(kind)
    if others:
        print(f"{path.name}: it has nothing to change for the controls {', '.join(others)}")
    for kind in missed:
        print(f"{path.name}: the judge accepts a copy with a changed {kind}")
    if len(seen) < LEAST:
        print(f"{path.name}: only {len(seen)} controls apply to this file, {LEAST} are needed")
    print(f"{path.name}: no finding; broken copies refused: {', '.join(seen)}")
    return not missed and len(seen) >= LEAST
