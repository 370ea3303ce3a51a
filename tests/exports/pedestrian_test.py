# SPDX-License-Identifier: Apache-2.0
"""Exports for the Pedestrian Dynamics Data Archive, read as PedPy does (pedpy/io/ped_data_archive_loader.py)."""
import sqlite3
import sys
import unittest

import h5py

from exported import Exported


class Pedestrian(Exported):
    def export(self, recording, name="out.h5"):
        return self.convert(recording, name, "--to", "pedestrian-hdf5")

    def test_pedpy_finds_all_rows_and_the_frame_rate(self):
        recording = self.record("circle-100", "--duration", 20)  # more than one chunk of rows
        rows = self.rows(recording)
        self.assertGreater(len(rows), 16384)
        with h5py.File(self.export(recording)) as file:
            trajectory = file["trajectory"]
            self.assertEqual(set(trajectory.dtype.names), {"id", "frame", "x", "y"})
            self.assertEqual([trajectory.dtype[name].str for name in ("id", "frame", "x", "y")],
                             ["<i8", "<i8", "<f8", "<f8"])
            self.assertEqual(trajectory.attrs["fps"], 10.0)
            for name in (b".", b"trajectory"):
                self.assertEqual(h5py.h5g.get_objinfo(file.id, name).mtime, 0, "no time of day")
            self.assertEqual([tuple(row) for row in trajectory[:][["id", "frame", "x", "y"]].tolist()],
                             [(int(row["robot"]), round(row["time"] * 10), row["x"], row["y"]) for row in rows])

    def test_the_area_is_text_and_that_of_the_database(self):
        recording = self.record("office", "--duration", 1)
        with h5py.File(self.export(recording)) as file:
            wkt = file.attrs["wkt_geometry"]
        self.assertIs(type(wkt), str)
        with sqlite3.connect(self.convert(recording, "out.sqlite")) as database:
            self.assertEqual(database.execute("SELECT wkt FROM geometry").fetchone()[0], wkt)

    def test_large_areas_fit(self):
        scene = self.folder / "pillars.yaml"
        pillars = "".join(f"  - {{disc: {{center: [{3 * (k % 40)}, {3 * (k // 40) + 9}], radius: 0.5}}}}\n"
                          for k in range(800))
        scene.write_text("version: 1\ntime_step: 0.1\nduration: 1\nobstacles:\n" + pillars +
                         "robots:\n  - {position: [0, 0], goal: [4, 0], radius: 0.3}\n")
        with h5py.File(self.export(self.record(scene))) as file:
            self.assertGreater(len(file.attrs["wkt_geometry"]), 1 << 16)

    def test_rows_of_robots_that_leave_end(self):
        recording = self.record("planes-12", "--duration", 300, "--until-arrived", "--every", 20)
        with h5py.File(self.export(recording)) as file:
            trajectory = file["trajectory"][:]
        frames = trajectory["frame"].max() + 1
        self.assertLess(len(trajectory), 12 * frames)
        self.assertEqual(len(trajectory[trajectory["frame"] == 0]), 12)

    def test_equal_recordings_give_equal_bytes(self):
        recording = self.record("circle-10", "--duration", 3)
        for name, *arguments in (("a.h5", "--to", "pedestrian-hdf5"), ("a.sqlite",), ("a.mcap",), ("a.csv",)):
            first = self.convert(recording, name, *arguments).read_bytes()
            self.assertEqual(self.convert(recording, "b" + name[1:], *arguments).read_bytes(), first)


unittest.main(argv=sys.argv[:1])
