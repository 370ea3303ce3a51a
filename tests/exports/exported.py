# SPDX-License-Identifier: Apache-2.0
"""Runs of avo and their exports, for the tests of this folder."""
import csv
import os
import pathlib
import subprocess
import tempfile
import unittest


def avo(*arguments):
    """The error output of a command that succeeds."""
    done = subprocess.run([os.environ["AVO_BINARY"], *map(str, arguments)], capture_output=True, text=True)
    if done.returncode != 0:
        raise AssertionError(f"{arguments}: {done.returncode}: {done.stderr}")
    return done.stderr


class Exported(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def record(self, scene, *arguments, name="run.h5"):
        path = self.folder / name
        avo("run", scene, "--record", path, "-q", *arguments)
        return path

    def convert(self, recording, name, *arguments):
        path = self.folder / name
        self.warnings = avo("convert", recording, path, *arguments)
        return path

    def rows(self, recording):
        """Of the recording as CSV: a dictionary of numbers each; no heading is none."""
        path = self.convert(recording, "rows.csv")
        with open(path, newline="") as file:
            return [{key: float(value) if value else None for key, value in row.items()}
                    for row in csv.DictReader(file)]

    def assert_within(self, points, ring):
        """All points are in the rectangle around the ring."""
        for axis in (0, 1):
            least, most = min(p[axis] for p in ring), max(p[axis] for p in ring)
            self.assertTrue(all(least < p[axis] < most for p in points))


def rings(wkt):
    """The rings of a POLYGON."""
    assert wkt.startswith("POLYGON ((") and wkt.endswith("))"), wkt
    return [[tuple(map(float, point.split())) for point in ring.split(", ")]
            for ring in wkt[len("POLYGON (("):-2].split("), (")]


def area(ring):
    """Positive where it is counter-clockwise."""
    return sum(a[0] * b[1] - b[0] * a[1] for a, b in zip(ring, ring[1:])) / 2
