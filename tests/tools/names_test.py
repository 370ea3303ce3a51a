#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Fails where the name of a type has several meanings: where two places of the plane define a type of that name, or where
space defines one that SAME does not name. usage: names_test.py"""
import collections
import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
TYPE = re.compile(r"^ *(?:template <[^>]*>\s+)?(?:struct|class|union|enum(?: class)?) (?:AVO_\w+ )?(?:alignas\(\w+\) )?"
                  r"(?P<name>\w+)(?: final)?(?: : [^;{]*)? \{", re.M)
SPACE = re.compile(r"/space[/_]")
# Packs of each instruction set; the kinds of the struct that contains them; the scalar and the lanes of one thing. Two
# meanings remain: the stages of a step and of a mission, the bounds of errors and of places.
ALIKE = {"Pack", "MaskOf", "Kind", "Line", "Stage", "Bounds"}
# What space and the plane have alike: the public types, and the parts of decisions, evasions and routes.
SAME = {
    "Check", "CheckedRobot", "CheckedState", "Detour", "Events", "Metrics", "MovingObstacle", "Neighbor",
    "OutOfReach", "Plan", "PlanWorkspace", "Planner", "Robot", "RobotSetup", "Scenario", "Simulation", "Route",
    "CheckedMover", "BrakingVerdict", "Crossing", "Cause", "DecisionTrace", "Evasion", "Explanation", "Perception",
    "Recorder", "Taken", "TraceRecord", "Wait", "Deciding", "Evading", "FirstStep", "FullBraking", "MoverColumns",
    "Node", "Observer", "PastState", "Plane", "Reached", "Senses", "Sight", "Then", "Traffic", "EvasionState",
    "EvasionStep"}


def several(texts):
    """{name: files that define it} of the names that have several meanings."""
    plane, space = collections.defaultdict(list), collections.defaultdict(list)
    for file, text in texts.items():
        for match in TYPE.finditer(text):
            (space if SPACE.search(file) else plane)[match["name"]].append(file)
    found = {name: files for name, files in plane.items() if len(files) > 1 and name not in ALIKE}
    for name in space.keys() & plane.keys() - SAME - ALIKE:
        found[name] = plane[name] + space[name]
    return found


def main():
    leg, nested = "struct Leg {\n};\n", "class Arc final : Leg {\n  enum class Turn : int { a };\n};\ntemplate <int D>\nstruct Leg {\n"
    assert several({"a": leg, "b": nested}) == {"Leg": ["a", "b"]}
    assert several({"a": nested, "b": "struct Leg;\nstruct Turn {\n"}) == {"Turn": ["a", "b"]}
    assert several({"a": leg, "src/space/b": leg}) == {"Leg": ["a", "src/space/b"]}
    assert several({"a": "struct Sight {\n", "src/space/b": "struct Sight {\n"}) == {}
    texts = {str(path.relative_to(ROOT)): path.read_text() for folder in ("src", "include")
             for path in sorted((ROOT / folder).rglob("*.*")) if path.suffix in (".h", ".cpp")}
    assert sum(len(TYPE.findall(text)) for text in texts.values()) > 700
    found = several(texts)
    for name, files in sorted(found.items()):
        print(f"{name} has several meanings, in {' and '.join(files)}: say in its name what each of them is")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
