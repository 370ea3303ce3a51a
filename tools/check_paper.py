#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Fails unless PAPER.md and the sources name the same equations, functions stand where documents say, and tests exist.

Every equation (1)-(29) must have a row in PAPER.md and be cited as `Eq. (n)` or `Eqs. (n)` in the sources. Each row
there names a file and a function, and each file that PAPER.md names exists. A function that PAPER.md or a page of docs/
names together with its file is defined or declared in that file: `file`: `function`, `function` in `file`, or
file, function(). A test that such a page cites in *(`Suite.name`)* exists; a name may end in *.
"""
import functools
import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
FOLDERS = ("include", "src", "apps", "figures", "io", "bindings", "tests", "tools", "scenarios", "docs")
EQUATIONS = set(range(1, 30))
# "Eq. (12)", "Eqs. (8), (9)", "Eqs. (10)-(12)"
CITED = re.compile(r"Eqs?\.\s*((?:\(\d+\)(?:\s*(?:,|-|and)\s*)?)+)")
ROW = re.compile(r"^\|\s*(\(\d+\)[^|]*)\|", re.M)
FILE = re.compile(r"`([\w./-]+\.(?:h|cpp|py|md|yaml))`")
BEFORE = re.compile(r"`([\w./-]+\.(?:h|cpp))`: (`\w+`(?:, `\w+`)*)")
BEHIND = re.compile(r"`(\w+)(?:\(\))?` in\s+`([\w./-]+\.(?:h|cpp))`")
CITATION = re.compile(r"\*\((`[^()]*)\)\*")  # what proves a statement
CITED_TEST = re.compile(r"`(?:\w+/)?([A-Z]\w+)\.(\w*)(\*?)`")
TEST = re.compile(r"\bTEST(?:_[FP])?\(\s*(\w+),\s*(\w+)\)")
CALLED = re.compile(r"([\w/]+/\w+\.(?:h|cpp)), (\w+)\(\)")


def numbers(text):
    found = set()
    for first, last in re.findall(r"\((\d+)\)(?:\s*-\s*\((\d+)\))?", text):
        found |= set(range(int(first), int(last or first) + 1))
    return found


def equations(paper):
    rows = set().union(*(numbers(row) for row in ROW.findall(paper)))
    cited = set()
    for folder in ("src", "include"):
        for path in (ROOT / folder).rglob("*.[hc]*"):
            for match in CITED.findall(path.read_text()):
                cited |= numbers(match)
    yield from (f"Eq. ({n}): no row in PAPER.md" for n in sorted(EQUATIONS - rows))
    yield from (f"Eq. ({n}): cited by no source" for n in sorted(EQUATIONS - cited))
    yield from (f"Eq. ({n}): not in the paper" for n in sorted((rows | cited) - EQUATIONS))


def table(paper):
    for row in re.findall(r"^\|.*\|$", paper, re.M)[2:]:  # but its head
        if not BEFORE.search(row):
            yield f"PAPER.md names no file with a function for {row.split('|')[1].strip()}"


@functools.cache
def files(name):
    return [ROOT / name] if (ROOT / name).is_file() else [path for folder in FOLDERS for path in (ROOT / folder).rglob(name)]


@functools.cache
def has(name, function):
    """Whether a file of that name defines or declares the function, or a type."""
    typed = rf"^(?!\s*(?:return|else|throw)\b)[^=;/.(\n]*[\w>&*:\]]\s+[&*]?(?:\w+::)?{function}\("
    pattern = re.compile(rf"{typed}|^\s*(?:struct|class) (?:\w+ )?{function}\b", re.M)
    return any(pattern.search(path.read_text()) for path in files(name))


def functions(page):
    text = (ROOT / page).read_text()
    named = [(name, function) for name, all in BEFORE.findall(text) for function in re.findall(r"\w+", all)]
    named += [(name, function) for function, name in BEHIND.findall(text)] + CALLED.findall(text)
    return sorted({(name, function) for name, function in named if files(name)})


def tests():
    return {pair for path in (ROOT / "tests").rglob("*.cpp") for pair in TEST.findall(path.read_text())}


def cited_tests(page):
    text = re.sub(r"\s*\n\s*", " ", (ROOT / page).read_text())
    return sorted({cited for citation in CITATION.findall(text) for cited in CITED_TEST.findall(citation)})


def is_there(cited, all_tests):
    suite, name, rest = cited
    return any(suite == a and (b.startswith(name) if rest else b == name) for a, b in all_tests)


def main():
    paper = (ROOT / "PAPER.md").read_text()
    problems = [*equations(paper), *table(paper)]
    problems += [f"PAPER.md names {name}, which does not exist" for name in sorted(set(FILE.findall(paper)))
                 if not files(name)]
    pages = ["PAPER.md", *(str(path.relative_to(ROOT)) for path in sorted((ROOT / "docs").rglob("*.md")))]
    named = [(page, *pair) for page in pages for pair in functions(page)]
    problems += [f"{page}: no {function}() in {name}" for page, name, function in named if not has(name, function)]
    all_tests = tests()
    cited = [(page, test) for page in pages for test in cited_tests(page)]
    problems += [f"{page}: no test {'.'.join(test[:2])}{test[2]}" for page, test in cited if not is_there(test, all_tests)]
    print("\n".join(problems) or f"{len(EQUATIONS)} equations in PAPER.md and in the sources, "
          f"{len(named)} functions where documents say, {len(cited)} tests that documents cite")
    return 1 if problems else 0


if __name__ == "__main__":
    sys.exit(main())
