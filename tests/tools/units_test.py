#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""A unit of several files has one anonymous namespace. A function of that namespace hides a function of a header that has
the same name and parameters, for all later files of the unit. A constant hides one of the same name. The compiler does not
report it. This test fails where a test file has a function of a header of the tests, or a constant of a header of its
folder. usage: units_test.py"""
import pathlib
import re
import sys

TESTS = pathlib.Path(__file__).resolve().parent.parent
FUNCTION = re.compile(r"^(?!TEST|class|struct|namespace)[\w:][\w:<>, *&]*?[ *&](\w+)\(([^;{}()]*)\)(?: const)? \{", re.M)

CONSTANT = re.compile(r"^(?:inline )?constexpr [\w:<>, ]+ (\w+)(?: =|\{)", re.M)


def functions(text):
    """(name, types of the parameters) of all that begin a line."""
    for name, parameters in FUNCTION.findall(text):
        types = [re.sub(r"\s*=.*", "", part.strip()) for part in re.split(r",(?![^<]*>)", parameters)]
        yield name, tuple(" ".join(re.sub(r"\b\w+$", "", part).split()) for part in types)


def hidden(texts, headers):
    """(file, header, function) for each function of TEXTS that one of HEADERS has."""
    known = {function: header for header, text in headers.items() for function in functions(text)}
    return [(file, known[function], function[0]) for file, text in texts.items() for function in functions(text)
            if function in known]


def hidden_constants(texts, headers):
    """(file, header, constant) for each constant of TEXTS that a header of its folder has."""
    known = {(header.parent, name): header for header, text in headers.items() for name in CONSTANT.findall(text)}
    return [(file, known[file.parent, name], name) for file, text in texts.items() for name in CONSTANT.findall(text)
            if (file.parent, name) in known]


def main():
    # one that hides, one with other parameters, one with another name
    header = "inline Check judge_of(const Scenario& scene) {\n"
    hiding = {"a": "Check judge_of(const Scenario& of_it) {\n", "b": "Check judge_of(int n) {\n", "c": "int judge() {\n"}
    assert hidden(hiding, {"h": header}) == [("a", "h", "judge_of")]
    step = "constexpr double kStep = 0.4;  // s\n"
    long, rules, other = pathlib.Path("a/long.cpp"), pathlib.Path("a/rules.h"), pathlib.Path("b/rules.h")
    assert hidden_constants({long: step}, {rules: "inline " + step, other: step}) == [(long, rules, "kStep")]
    assert not hidden_constants({long: "constexpr int kStep;\n"}, {other: step})
    read = lambda ending: {file.relative_to(TESTS): file.read_text() for file in TESTS.rglob(ending)}
    texts, headers = read("*.cpp"), read("*.h")
    assert sum(len(list(functions(text))) for text in texts.values()) > 800
    found = hidden(texts, headers)
    for file, header, name in found:
        print(f"tests/{file}: {name}() hides that of tests/{header}: use that one, or rename this one")
    constants = hidden_constants(texts, headers)
    for file, header, name in constants:
        print(f"tests/{file}: {name} hides that of tests/{header}: use that one, or rename this one")
    return 1 if found or constants else 0


if __name__ == "__main__":
    sys.exit(main())
