#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""The lists of Debian packages, scripts/setup, and that a missing test package ends the configuration."""
import os
import pathlib
import re
import shutil
import stat
import subprocess
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
LISTS = ("packages.txt", "packages-test.txt", "packages-optional.txt")


def packages(name):
    lines = (ROOT / name).read_text().splitlines()
    return [line for line in lines if line and not line.startswith("#")]


def setup(*arguments, installed=None):
    """Of a user who is not root and has no sudo, on a system with INSTALLED packages."""
    with tempfile.TemporaryDirectory() as folder:
        programs = {"id": "echo 1000", "apt-get": "echo apt-get >&2; exit 1"}
        if installed is not None:
            programs["dpkg-query"] = "\n".join(f"echo 'installed {name}'" for name in installed) or ":"
        for name, text in programs.items():
            path = pathlib.Path(folder, name)
            path.write_text(f"#!/bin/sh\n{text}\n")
            path.chmod(path.stat().st_mode | stat.S_IXUSR)
        for name in ("bash", "dirname", "sed", "xargs", "sort", "comm", "cat", "echo"):
            os.symlink(f"/usr/bin/{name}", pathlib.Path(folder, name))
        return subprocess.run([ROOT / "scripts/setup", *arguments], env={"PATH": folder}, capture_output=True,
                              text=True)


class Lists(unittest.TestCase):
    def test_no_package_is_named_twice(self):
        names = [name for each in LISTS for name in packages(each)]
        self.assertEqual(sorted(set(names)), sorted(names))
        self.assertTrue(all(re.fullmatch(r"[a-z0-9][a-z0-9.+-]+", name) for name in names), names)

    def test_what_only_tests_need_is_not_in_the_first_list(self):
        for name in ("libgtest-dev", "valgrind", "clang", "python3", "pybind11-dev", "doxygen"):
            self.assertNotIn(name, packages(LISTS[0]))
            self.assertIn(name, packages(LISTS[1]))

    def test_package_xml_has_the_version_of_the_project(self):
        version = re.search(r"project\(avo VERSION (\S+)", (ROOT / "CMakeLists.txt").read_text())[1]
        self.assertIn(f"<version>{version}</version>", (ROOT / "package.xml").read_text())


class Rvo2(unittest.TestCase):
    def test_page_names_all_that_edits_robots_and_obstacles(self):
        header = (ROOT / "include/avo/simulation.h").read_text()
        edits = re.findall(r"^  (?:void|RobotId|ObstacleId) (\w+)\((?:RobotId|ObstacleId|const RobotSetup&|"
                           r"const StaticObstacle&) ", header, re.M)
        self.assertTrue({"add_robot", "move_robot", "remove_obstacle"} <= set(edits), edits)
        page = (ROOT / "docs/manual/howto/from_rvo2.md").read_text()
        self.assertEqual([name for name in edits if f"`Simulation::{name}`" not in page], [])


class Setup(unittest.TestCase):
    def test_names_what_is_missing_where_it_may_not_install(self):
        for arguments, lists in (((), LISTS[:1]), (("test",), LISTS[:2]), (("all",), LISTS)):
            wanted = sorted(name for each in lists for name in packages(each))
            found = setup(*arguments, installed=wanted[2:])
            self.assertEqual(found.returncode, 1, found)
            self.assertEqual(found.stderr, f"missing packages, install them first: {' '.join(wanted[:2])}\n")

    def test_lab_needs_a_part_of_what_the_tests_need(self):
        found = setup("lab", installed=packages(LISTS[0]))
        self.assertEqual(found.returncode, 1)
        missing = found.stderr.split(": ")[1].split()
        self.assertLess(set(missing), set(packages(LISTS[1])))
        self.assertTrue({"clang-19", "nodejs", "npm", "wasi-libc"} <= set(missing), missing)

    def test_is_silent_where_nothing_is_missing(self):
        found = setup("test", installed=packages(LISTS[0]) + packages(LISTS[1]))
        self.assertEqual((found.returncode, found.stdout, found.stderr), (0, "", ""))

    def test_counts_what_a_package_provides(self):
        wanted = packages(LISTS[0])
        others = [f"nodejs, {wanted[0]} (= 9.2), node-{wanted[1]}, {wanted[2]}, node-x:any", *wanted[3:]]
        found = setup(installed=others)
        self.assertEqual(found.stderr, f"missing packages, install them first: {wanted[1]}\n")

    def test_refuses_other_arguments_in_one_line(self):
        for arguments in (("tests",), ("test", "all")):
            found = setup(*arguments, installed=[])
            self.assertEqual(found.returncode, 2)
            self.assertEqual(found.stderr.count("\n"), 1)
            self.assertIn(f"found '{' '.join(arguments)}'", found.stderr)


class Missing(unittest.TestCase):
    def test_package_of_the_tests_ends_the_configuration(self):
        every = ("GTest", "nlohmann_json", "benchmark")
        with tempfile.TemporaryDirectory() as build:  # one for all, which looks for the compiler once
            for package in every:
                found = subprocess.run(
                    ["cmake", "-S", ROOT, "-B", build, "-G", "Ninja", "-DAVO_CLI=OFF", "-DAVO_TESTS=ON",
                     *(f"-DCMAKE_DISABLE_FIND_PACKAGE_{other}={'ON' if other == package else 'OFF'}" for other in every)],
                    capture_output=True, text=True)
                self.assertNotEqual(found.returncode, 0, package)
                self.assertIn(package, found.stderr)

    def test_package_of_the_lab_ends_the_configuration(self):
        places = ["-DCMAKE_IGNORE_PATH=/bin;/usr/bin;/usr/local/bin", f"-DCMAKE_MAKE_PROGRAM={shutil.which('ninja')}",
                  f"-DCMAKE_C_COMPILER={shutil.which('cc')}", f"-DCMAKE_CXX_COMPILER={shutil.which('c++')}"]
        with tempfile.TemporaryDirectory() as build:
            found = subprocess.run(["cmake", "-S", ROOT, "-B", build, "-G", "Ninja", "-DAVO_LAB=ON",
                                    f"-DAVO_NODE={shutil.which('true')}", *places], capture_output=True, text=True)
        self.assertNotEqual(found.returncode, 0)
        self.assertIn("AVO_LAB: found no npm, must be there: install the package npm\n", found.stderr)

    def test_none_is_looked_for_quietly(self):
        for folder in ("tests", "bench"):
            for path in (ROOT / folder).rglob("CMakeLists.txt"):
                self.assertNotIn("QUIET", path.read_text(), path)


unittest.main()
