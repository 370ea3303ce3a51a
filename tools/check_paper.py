#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Fails unless PAPER.md and the sources name the same equations, and what PAPER.md names exists.

Every equation (1)-(29) must have a row in PAPER.md, be cited as `Eq. (n)` or `Eqs. (n)` in the
sources, and each file that a row names must exist.
"""
import pathlib
import re
import sys

EQUATIONS = set(range(1, 30))
# "Eq. (12)", "Eqs. (8), (9)", "Eqs. (10)-(12)"
CITED = re.compile(r"Eqs?\.\s*((?:\(\d+\)(?:\s*(?:,|-|and)\s*)?)+)")
ROW = re.compile(r"^\|\s*(\(\d+\)[^|]*)\|", re.M)
FILE = re.compile(r"`([\w./-]+\.(?:h|cpp|py|md|yaml))`")


def numbers(text):
    found = set()
    for first, last in re.findall(r"\((\d+)\)(?:\s*-\s*\((\d+)\))?", text):
        found |= set(range(int(first), int(last or first) + 1))
    return found


def main():
    root = pathlib.Path(__file__).resolve().parent.parent
    paper = (root / "PAPER.md").read_text()
    rows = set().union(*(numbers(row) for row in ROW.findall(paper)))
    cited = set()
    for folder in ("src", "include"):
        for path in (root / folder).rglob("*.[hc]*"):
            for match in CITED.findall(path.read_text()):
                cited |= numbers(match)
    problems = [f"Eq. ({n}): no row in PAPER.md" for n in sorted(EQUATIONS - rows)]
    problems += [f"Eq. ({n}): cited by no source" for n in sorted(EQUATIONS - cited)]
    problems += [f"Eq. ({n}): not in the paper" for n in sorted((rows | cited) - EQUATIONS)]
    for name in sorted(set(FILE.findall(paper))):
        if not any(root.rglob(name)) and not (root / name).exists():
            problems.append(f"PAPER.md names {name}, which does not exist")
    print("\n".join(problems) or f"{len(rows)} equations in PAPER.md and in the sources")
    return 1 if problems else 0


if __name__ == "__main__":
    sys.exit(main())
