#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""No test fails because the machine is busy: all have one limit, for those that hang, and none looks at a clock.

usage: limits_test.py BUILD

What is timed is in scripts/waiting and scripts/lab-check.
"""
import json
import pathlib
import re
import subprocess
import sys
import unittest

TESTS = pathlib.Path(__file__).resolve().parents[1]
BUILD = pathlib.Path(sys.argv.pop(1))
LONGEST = 180  # s of faults, the test that takes longest on an idle machine
# A deadline in a test's own words, or a clock whose reading it could compare.
DEADLINE = re.compile(r"\balarm\(\s*\d|\btimeout\s*[=:]\s*\d|\bsetTimeout\(.*[1-9]\d{3}|performance\.now\(\)|Date\.now\(\)"
                      r"|time\.(monotonic|perf_counter|time)\(\)")
TIMED = {"text_speed.mjs", "speed.mjs", pathlib.Path(__file__).name}  # run by scripts/lab-check


class Limits(unittest.TestCase):
    def test_there_is_one_for_all_tests(self):
        shown = subprocess.run(["ctest", "--test-dir", BUILD, "--show-only=json-v1"], check=True, capture_output=True,
                               text=True).stdout
        tests = json.loads(shown)["tests"]
        self.assertGreater(len(tests), 50)
        own = [test["name"] for test in tests for each in test.get("properties", []) if each["name"] == "TIMEOUT"]
        self.assertEqual(own[:5], [])

    def test_it_is_for_those_that_hang(self):
        limit = re.search(r"^TimeOut: (\d+)$", (BUILD / "DartConfiguration.tcl").read_text(), re.M)
        self.assertGreaterEqual(int(limit[1]), 20 * LONGEST)

    def test_no_test_has_a_deadline_of_its_own(self):
        found = []
        for path in sorted(TESTS.rglob("*")):
            if path.suffix not in (".cpp", ".c", ".h", ".py", ".mjs") or path.name in TIMED:
                continue
            found += [f"{path.relative_to(TESTS)}:{number}: {line.strip()}"
                      for number, line in enumerate(path.read_text().splitlines(), 1) if DEADLINE.search(line)]
        self.assertEqual(found, [])


unittest.main()
