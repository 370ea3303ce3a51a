#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""What a host holds in C++ it holds in C and in Python, under the same names: functions of classes, functions of headers,
members of structs. usage: languages_test.py"""
import pathlib
import re
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]

# class: (its header, functions of C begin with, functions that C names otherwise or not at all, the same for Python).
# None: the language does without, as the line above says.
CLASSES = {
    "Simulation": ("simulation.h", ("avo_simulation_", "avo_simulation_get_"), {
        "fleet": "avo_simulation_columns", "size": "avo_simulation_get_robot_count",
        "robot": "avo_simulation_get_position", "setup": "avo_simulation_get_robot_def", "teams": "avo_simulation_team",
        # what a robot senses: the batch of an external method has it, and explain() says what came of it
        "perceive": None,
        # avo_create_planner() makes one of the same definition
        "planner": None,
        # time by stages of a step, for those who change the library
        "measure": None, "profile": None,
    }, {
        # arrays by the names of columns
        "fleet": "position", "size": "__len__", "measure": None, "profile": None,
    }),
    "Navigator": ("navigator.h", ("avo_navigator_", "avo_navigator_get_"), {
        # what the host has given
        "planner": None, "options": None,
    }, {"options": None}),
    "ReferenceTracker": ("execution.h", ("avo_reference_tracker_",), {}, {}),
    "Events": ("events.h", ("avo_simulation_",), {"observe": "avo_simulation_events"}, {}),
}

# header: (functions that C names otherwise or not at all, the same for Python).
FUNCTIONS = {
    "teams.h": ({
        "to_string": None, "form_up": "avo_simulation_form_up", "make_team": "avo_create_team",
        "lead": "avo_team_lead", "serve": "avo_team_serve", "set_task": "avo_team_set_task",
        "disband": "avo_team_disband",
        # teams are validated when they are made
        "validate": None,
    }, {
        "to_string": None, "make_team": "Team", "validate": None,
    }),
    "navigator.h": ({"to_string": None}, {"to_string": None}),
    "execution.h": ({"execution_error": "avo_find_execution_error"}, {}),
    "footprint.h": ({}, {"cover_rectangle": "rectangle", "cover_polygon": "polygon"}),
    "events.h": ({"to_string": None}, {"to_string": None}),
}

# (header, struct of C++, struct of C, class of Python, members that C names otherwise or not at all, the same for Python).
STRUCTS = [
    ("simulation.h", "Route", "avo_route", "Route", {}, {}),
    ("simulation.h", "Wait", "avo_wait", "Wait", {}, {}),
    ("simulation.h", "MovingObstacleView", "avo_moving_obstacle_columns", "Simulation",
     {"setup": None, "id": None},  # one at a time, and in a list: avo_simulation_get_moving_obstacle_def()
     {"position": "moving_obstacle_position", "velocity": "moving_obstacle_velocity", "setup": "moving_obstacles",
      "next_point": "moving_obstacle_next_point", "id": "moving_obstacle_ids"}),
    ("simulation.h", "StaticObstacleView", "avo_obstacle_def", "Simulation", {"setup": "chains", "id": "size"},
     {"setup": "obstacles", "id": "obstacles"}),
    ("simulation.h", "RobotState", "avo_columns", "RobotState", {}, {}),
    ("simulation.h", "Perception", None, "Perception", {}, {"trajectories": None}),  # each neighbor has its own
    ("simulation.h", "Hit", "avo_hit", None, {}, {}),
    ("navigator.h", "NavigatorOptions", "avo_navigator_def", "Navigator",
     {"planner": None}, {}),  # an argument of its own
    ("navigator.h", "NavigatorDecision", "avo_navigator_decision", "NavigatorDecision", {"wait": "waits_for"}, {}),
    ("navigator.h", "NavigatorWait", "avo_navigator_decision", "NavigatorWait", {"neighbor": "waits_for"}, {}),
    ("navigator.h", "Stage", "avo_stage", None, {}, {}),
    ("execution.h", "ExecutionModel", "avo_execution_model", "ExecutionModel", {}, {}),
    ("execution.h", "ExecutionError", "avo_execution_error", "ExecutionError", {}, {}),
    ("execution.h", "BaseCommand", "avo_base_command", "BaseCommand", {}, {}),
    ("events.h", "Event", "avo_event", "Event", {"sentence": None}, {}),  # avo_simulation_event_sentence()
    ("teams.h", "Team", "avo_team_def", "Team",
     {"members": "robots", "trail": None, "leader": None, "since": None},  # what lead() remembers
     {"members": "robots", "trail": None, "leader": None, "since": None}),
]


def without_comments(text):
    return re.sub(r"/\*.*?\*/|//[^\n]*", "", text, flags=re.S)


def body(text, opening):
    """What is between the braces after OPENING."""
    start = re.search(opening, text).end()
    depth = 1
    for k in range(start, len(text)):
        depth += {"{": 1, "}": -1}.get(text[k], 0)
        if depth == 0:
            return text[start:k]
    raise AssertionError(opening)


def public_functions(text, name):
    public = body(text, rf"class AVO_API {name} \{{").split("private:")[0]
    public = re.sub(r"struct \w+ \{.*?\n  \};", "", public, flags=re.S)
    found = re.findall(r"^  (?:\[\[nodiscard\]\] )?[\w:<>&, ]+[>&\w] (\w+)\(", public, re.M)
    return [each for each in dict.fromkeys(found) if each != name and not each.startswith("operator")]


def free_functions(text):
    return list(dict.fromkeys(re.findall(r"^AVO_API (?!class)[\w:<>&,* ]+?[ *](\w+)\(", text, re.M)))


def members(text, opening):
    """Of a struct: the names, also of `Vec2 a = {}, b = {};`."""
    names = []
    for statement in re.sub(r"\{[^{}]*\}", "", body(text, opening)).split(";"):
        if "(" in statement or not statement.strip():
            continue
        for part in re.sub(r"<[^<>]*(?:<[^<>]*>)?[^<>]*>", "", statement).split(","):
            names.append(re.search(r"(\w+)\s*(?:=.*)?$", part.strip(), re.S)[1])
    return names


def python_class(stub, name):
    found = re.search(rf"^class {name}:\n((?:    .*\n|\n)*)", stub, re.M)[1]
    return set(re.findall(r"def (\w+)", found)) | set(re.findall(r"^ +(\w+): ", found, re.M))


class Languages(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.headers = {path.name: without_comments(path.read_text()) for path in (ROOT / "include/avo").glob("*.h")}
        cls.c = without_comments((ROOT / "bindings/c/include/avo_c/avo.h").read_text())
        cls.in_c = set(re.findall(r"\b(avo_\w+)\(", cls.c))
        cls.stub = (ROOT / "bindings/python/avo/_avo.pyi").read_text()
        cls.in_python = set(re.findall(r"^def (\w+)|^class (\w+)", cls.stub, re.M))
        cls.in_python = {name for pair in cls.in_python for name in pair if name}
        cls.methods = set(re.findall(r"^    def (\w+)", cls.stub, re.M))

    def compare(self, names, usual, otherwise, there, what):
        """Each of NAMES is THERE by one of its usual names, or by the one of OTHERWISE, or is None and is not there."""
        self.assertEqual(otherwise.keys() - set(names), set(), f"{what}: an exception for what is no longer there")
        for name in names:
            if name in otherwise and otherwise[name] is None:
                self.assertEqual([each for each in usual(name) if each in there], [], f"{what}: {name} is there by now")
            else:
                allowed = [otherwise[name]] if name in otherwise else usual(name)
                self.assertTrue(any(each in there for each in allowed), f"{what}: {name} is missing: {allowed}")

    def test_classes(self):
        for name, (header, prefixes, in_c, in_python) in CLASSES.items():
            found = public_functions(self.headers[header], name)
            self.assertTrue(found, name)
            self.compare(found, lambda each: [prefix + each for prefix in prefixes], in_c, self.in_c, f"C, {name}")
            self.compare(found, lambda each: [each], in_python, python_class(self.stub, name), f"Python, {name}")
        self.assertGreater(len(public_functions(self.headers["simulation.h"], "Simulation")), 50)

    def test_functions(self):
        for header, (in_c, in_python) in FUNCTIONS.items():
            found = free_functions(self.headers[header])
            self.compare(found, lambda each: ["avo_" + each], in_c, self.in_c, f"C, {header}")
            self.compare(found, lambda each: [each], in_python, self.in_python | self.methods, f"Python, {header}")
        self.assertGreaterEqual(len(free_functions(self.headers["teams.h"])), 10)

    def test_structs(self):
        for header, name, of_c, of_python, in_c, in_python in STRUCTS:
            found = members(self.headers[header], rf"struct {name} \{{")
            self.assertTrue(found, name)
            if of_c:
                c_members = set(members(self.c, rf"typedef struct {of_c} \{{"))
                self.compare(found, lambda each: [each], in_c, c_members, f"C, {of_c}")
            if of_python:
                self.compare(found, lambda each: [each], in_python, python_class(self.stub, of_python),
                             f"Python, {of_python}")

    def test_notices_what_is_missing(self):
        with self.assertRaisesRegex(AssertionError, "robots_within is missing"):
            self.compare(["robots_within"], lambda each: ["avo_" + each], {}, {"avo_nearest_robots"}, "C")
        with self.assertRaisesRegex(AssertionError, "perceive is there by now"):
            self.compare(["perceive"], lambda each: ["avo_" + each], {"perceive": None}, {"avo_perceive"}, "C")
        self.assertEqual(members("struct A { Vec2 a = {}, b; std::optional<Box<int>> c = {}; bool d(int); };",
                                 r"struct A \{"), ["a", "b", "c"])


unittest.main()
