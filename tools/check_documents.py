#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Fails unless the documents that sources cite exist, and have what is cited of them.

Sources cite docs/NAME.md alone, or with a heading, docs/NAME.md, "Section", or with a number, docs/NAME.md, rule 4.
Links between documents are not looked at here: where one leads nowhere, the manual is not built (scripts/manual).
"""
import functools
import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
FOLDERS = ("apps", "bench", "bindings", "docs", "examples", "figures", "include", "io", "lab/page", "lab/wasm", "scripts",
           "src", "tests", "tools")
SOURCES = ("", ".cpp", ".h", ".py", ".ts", ".txt")
PLACE = r'(?:rules?\s\d+(?:(?:,|\sand|\sto)\s\d+)*|"[A-Z][^"]*")'
CITED = re.compile(rf"\b(docs/[a-z_/]+\.md)((?:,?\s(?:and\s)?{PLACE})*)")
LINE = re.compile(r"\s*\n\s*(?://+|#|\*)?\s*")  # a comment may go on in the next line


def citations(text):
    """(document, heading or number of a rule, None of the whole document)"""
    for match in CITED.finditer(LINE.sub(" ", text)):
        yield match[1], None
        for number, heading in re.findall(r'(\d+)|"([^"]*)"', match[2]):
            yield match[1], int(number) if number else heading


@functools.cache
def text_of(document):
    return (ROOT / document).read_text() if (ROOT / document).exists() else None


def problem_of(document, place):
    text = text_of(document)
    if text is None:
        return f"no {document}"
    if place is None:
        return None
    if isinstance(place, int):
        return None if re.search(rf"^{place}\. ", text, re.M) else f"no rule {place} in {document}"
    # a heading, or a title that a paragraph begins with
    title = re.escape(place)
    return None if re.search(rf"^(?:#+ {title}$|\*+{title}\.\*)", text, re.M) else f'no "{place}" in {document}'


def main():
    problems = []
    for path in sorted(path for folder in FOLDERS for path in (ROOT / folder).rglob("*") if path.suffix in SOURCES):
        if path.is_file() and "node_modules" not in path.parts:
            found = [problem_of(*citation) for citation in citations(path.read_text(errors="replace"))]
            problems += [f"{path.relative_to(ROOT)}: {problem}" for problem in found if problem]
    count = text_of.cache_info().currsize
    print("\n".join(problems) or f"{count} documents have what sources cite of them")
    return 1 if problems else 0


if __name__ == "__main__":
    sys.exit(main())
