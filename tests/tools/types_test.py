#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Fails where two files of the library define a type of one name in one namespace that has a name: the linker takes one of
them for both (the one-definition rule), and says nothing. usage: types_test.py"""
import collections
import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
SCOPE = re.compile(r"^(?P<opens>namespace (?P<name>[\w:]+ (?:\w+ )?)?\{)$|^(?P<closes>\}  // namespace)|"
                   r"^(?:struct|class|union|enum(?: class)?) (?:AVO_\w+ )?(?:alignas\(\w+\) )?(?P<type>\w+)(?!\w|::|<)[^;{]*\{", re.M)


def types(text):
    """namespace::name of each that stands in a namespace itself, and in none without a name."""
    within = []
    for match in SCOPE.finditer(text):
        if match["opens"]:
            within.append((match["name"] or "").strip())
        elif match["closes"]:
            within.pop()
        elif within and all(within):
            yield "::".join([*within, match["type"]])


def several(texts):
    """{type: files that define it}, where these are several."""
    files = collections.defaultdict(list)
    for file, text in texts.items():
        for name in types(text):
            files[name].append(file)
    return {name: found for name, found in files.items() if len(found) > 1}


def main():
    one = "namespace avo {\nstruct Leg {\n};\nnamespace judge {\nclass Arc final : Leg {\n};\n}  // namespace judge\n}  // namespace avo\n"
    other = "namespace avo {\nstruct Leg;\nstruct Arc {\n};\nenum class Kind : int { a };\n}  // namespace avo\n"
    assert list(types(one)) == ["avo::Leg", "avo::judge::Arc"] and not several({"one": one, "other": other})
    own = "namespace avo {\nnamespace {\nstruct Leg {\n};\n}  // namespace\nstruct Kind {\n};\n}  // namespace avo\n"
    assert list(types(own)) == ["avo::Kind"]
    assert list(types(own.replace("avo {", "avo::inline sim {"))) == ["avo::inline sim::Kind"]
    assert several({"one": one, "same": one + other}) == {name: ["one", "same"] for name in types(one)}
    texts = {path.relative_to(ROOT): path.read_text() for folder in ("src", "include", "io", "figures")
             for path in sorted((ROOT / folder).rglob("*.*")) if path.suffix in (".h", ".cpp")}
    assert sum(len(list(types(text))) for text in texts.values()) > 500
    found = several(texts)
    for name, files in found.items():
        print(f"{name} is defined in {' and '.join(map(str, files))}")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
