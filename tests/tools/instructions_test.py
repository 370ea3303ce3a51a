#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""bench/instructions/check.py finds what it is there to find; nothing is counted here."""
import importlib.util
import json
import pathlib
import sys
import unittest

sys.dont_write_bytecode = True  # beside check.py

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
PATH = ROOT / "bench/instructions/check.py"
SPEC = importlib.util.spec_from_file_location("check", PATH)
check = importlib.util.module_from_spec(SPEC)
SPEC.loader.exec_module(check)


def found(avx2, scalar, hashes=("1", "1"), simd=("avx2", "scalar")):
    results = [{"instructions": count, "hash": state, "simd": name}
               for count, state, name in zip((avx2, scalar), hashes, simd)]
    return {"a": {"avx2": results[0], "scalar": results[1]}}


def problems(measured, expected):
    return check.problems(check.deviations(expected, measured), measured)


class Check(unittest.TestCase):
    expected = {"a": {"avx2": 1000.0, "scalar": 4000.0}}

    def test_two_percent_either_way_are_allowed_and_no_more(self):
        self.assertEqual(problems(found(1019, 3921), self.expected), [])
        self.assertEqual(problems(found(1021, 4000), self.expected),
                         ["a, avx2: found 1021 instructions, must be within 2% of 1000; "
                          "an intended change: --update REASON"])
        self.assertEqual(len(problems(found(979, 3919), self.expected)), 2)

    def test_a_case_that_nobody_expects_fails(self):
        self.assertEqual(len(problems(found(1000, 4000), {})), 2)
        self.assertEqual(len(problems(found(1000, 4000), {"a": {"avx2": 1000.0}})), 1)

    def test_other_states_fail(self):
        self.assertEqual(problems(found(1000, 4000, hashes=("1", "2")), self.expected),
                         ["a: found another state for each SIMD target, must be the same"])

    def test_a_target_that_was_not_used_fails(self):
        self.assertEqual(problems(found(1000, 4000, simd=("scalar", "scalar")), self.expected),
                         ["a: found SIMD target scalar, must be avx2"])

    def test_expected_figures_are_those_of_the_cases(self):
        cases = json.loads(check.EXPECTED.read_text())["cases"]
        self.assertEqual(set(cases), set(check.CASES))
        for targets in cases.values():
            self.assertEqual(set(targets), set(check.TARGETS))


if __name__ == "__main__":
    unittest.main()
