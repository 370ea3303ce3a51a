# SPDX-License-Identifier: Apache-2.0
"""Exports as JuPedSim's database, by the queries of PedPy (pedpy/io/jupedsim_loader.py)."""
import math
import sqlite3
import sys
import unittest

from exported import Exported, area, rings

# PedPy's own: load_trajectory_from_jupedsim_sqlite(), load_walkable_area_from_jupedsim_sqlite()
TRAJECTORY = "select frame, id, pos_x as x, pos_y as y from trajectory_data"
FRAME_RATE = "select value from metadata where key = 'fps'"
VERSION = "SELECT value FROM metadata WHERE key = ?"
AREA = "SELECT wkt FROM geometry"


class Sqlite(Exported):
    def database(self, recording, *arguments):
        connection = sqlite3.connect(self.convert(recording, "out.sqlite", *arguments))
        self.addCleanup(connection.close)
        return connection

    def fps(self, database):
        return float(database.cursor().execute(FRAME_RATE).fetchone()[0])

    def test_pedpy_finds_all_rows_frames_and_the_version(self):
        recording = self.record("circle-10", "--duration", 5)
        database = self.database(recording)
        self.assertEqual(int(database.cursor().execute(VERSION, ("version",)).fetchone()[0]), 2)
        self.assertEqual(self.fps(database), 10.0)
        rows = [(round(row["time"] * 10), int(row["robot"]), row["x"], row["y"]) for row in self.rows(recording)]
        self.assertEqual(database.execute(TRAJECTORY).fetchall(), rows)
        self.assertEqual([row[0] for row in rows[::10]], list(range(51)))

    def test_has_the_tables_of_jupedsim(self):
        database = self.database(self.record("doorway", "--duration", 1))
        columns = {table: [(name, kind, needed) for _, name, kind, needed, _, _ in
                           database.execute(f"PRAGMA table_info({table})")]
                   for table in ("trajectory_data", "metadata", "geometry", "frame_data")}
        self.assertEqual(columns, {
            "trajectory_data": [("frame", "INTEGER", 1), ("id", "INTEGER", 1), ("pos_x", "REAL", 1),
                                ("pos_y", "REAL", 1), ("ori_x", "REAL", 1), ("ori_y", "REAL", 1)],
            "metadata": [("key", "TEXT", 1), ("value", "TEXT", 1)],
            "geometry": [("hash", "INTEGER", 1), ("wkt", "TEXT", 1)],
            "frame_data": [("frame", "INTEGER", 1), ("geometry_hash", "INTEGER", 1)]})
        self.assertEqual(database.execute("SELECT frame, wkt FROM frame_data, geometry WHERE hash = geometry_hash "
                                          "ORDER BY frame").fetchall(),
                         [(frame, database.execute(AREA).fetchone()[0]) for frame in range(11)])
        self.assertEqual({key: float(value) for key, value in database.execute("SELECT * FROM metadata")},
                         {"version": 2, "fps": 10, "xmin": -16, "xmax": 16, "ymin": -8, "ymax": 8})
        self.assertEqual(database.execute("PRAGMA integrity_check").fetchall(), [("ok",)])

    def test_robots_face_where_they_go_or_head(self):
        recording = self.record("mixed-yard", "--duration", 2)
        rows = self.rows(recording)
        faces = self.database(recording).execute("select ori_x, ori_y from trajectory_data").fetchall()
        self.assertEqual(len(faces), len(rows))
        heading, moving = 0, 0
        for row, face in zip(rows, faces):
            self.assertAlmostEqual(math.hypot(*face), 1.0, places=14)
            speed = math.hypot(row["vx"], row["vy"])
            if row["heading"] is not None:
                heading += 1
                self.assertAlmostEqual(face[0], math.cos(row["heading"]), places=14)
                self.assertAlmostEqual(face[1], math.sin(row["heading"]), places=14)
            elif speed > 1e-12:
                moving += 1
                self.assertAlmostEqual(face[0], row["vx"] / speed, places=14)
                self.assertAlmostEqual(face[1], row["vy"] / speed, places=14)
        self.assertTrue(heading > 100 and moving > 100)
        at_rest = self.database(self.record("circle-3", "--duration", 0.1)).execute(
            "select ori_x, ori_y from trajectory_data where frame = 0").fetchall()
        self.assertEqual(at_rest, [(1.0, 0.0)] * 3)

    def test_walls_are_cut_out_of_the_area(self):
        wkt = self.database(self.record("doorway", "--duration", 1)).execute(AREA).fetchall()
        self.assertEqual(wkt, [("POLYGON ((-16 -8, -0.005 -8, -0.005 -0.795, 0.005 -0.795, 0.005 -8, 16 -8, 16 8, "
                                "0.005 8, 0.005 0.795, -0.005 0.795, -0.005 8, -16 8, -16 -8))",)])
        outer, *holes = rings(self.database(self.record("warehouse", "--duration", 1)).execute(AREA).fetchone()[0])
        self.assertGreater(area(outer), 0)
        self.assertEqual(len(holes), 10)
        self.assertTrue(all(abs(area(hole) + 12.0) < 1e-6 for hole in holes), "shelves of 10 x 1.2 m")

    def test_open_scenes_get_a_rectangle_around_all_motion(self):
        recording = self.record("circle-10", "--until-arrived")
        outer, *holes = rings(self.database(recording).execute(AREA).fetchone()[0])
        self.assertEqual((len(outer), holes), (5, []))
        points = [(row["x"], row["y"]) for row in self.rows(recording)]
        self.assert_within(points, outer)
        for axis in (0, 1):  # radius and 1 m
            self.assertAlmostEqual(max(p[axis] for p in outer), max(p[axis] for p in points) + 1.5, places=5)
            self.assertAlmostEqual(min(p[axis] for p in outer), min(p[axis] for p in points) - 1.5, places=5)

    def test_frame_rates_are_exact_where_they_are_whole(self):
        for step, every, fps in ((0.1, 1, 10), (0.05, 1, 20), (0.1, 3, 1 / (3 * 0.1)), (0.1, 10, 1), (0.04, 5, 5)):
            recording = self.record("circle-3", "--duration", 12, "--set", f"time_step={step}", "--every", every,
                                    name=f"{step}-{every}.h5")
            self.assertEqual(self.fps(self.database(recording)), fps)
            self.assertEqual(self.warnings, "")

    def test_rounding_of_times_is_not_in_the_frame_rate(self):
        def fps(step, *arguments):
            recording = self.folder / "late.csv"
            recording.write_text("time,robot,x,y,vx,vy\n" + "".join(
                f"{3 + k * step!r},{robot},{9 * robot},0,0,0\n" for k in range(50) for robot in range(3)))
            return self.fps(self.database(recording, *arguments))

        self.assertNotEqual(1 / ((3 + 0.1) - 3), 10)
        self.assertEqual(fps(0.1), 10)
        self.assertNotEqual(1 / ((3 + 0.3) - 3), 1 / 0.3)
        self.assertEqual(fps(0.3, "--scene", "circle-3", "--set", "time_step=0.3"), 1 / 0.3)
        self.assertEqual(fps(0.6, "--scene", "circle-3", "--set", "time_step=0.3"), 1 / 0.6)

    def test_the_last_time_is_left_out_where_it_is_no_frame(self):
        recording = self.record("circle-3", "--duration", 3.5, "--every", 10)
        database = self.database(recording)
        self.assertEqual(self.warnings, "warning: the last time, 3.5 s, is left out: it is between two frames\n")
        self.assertEqual(database.execute("select distinct frame from trajectory_data").fetchall(),
                         [(frame,) for frame in range(4)])

    def test_csv_of_other_programs_needs_no_scene(self):
        recording = self.folder / "other.csv"
        recording.write_text("time,robot,x,y,vx,vy\n3,7,0,0,1,0\n3,4000000000,5,5,0,0\n"
                             "3.5,7,0.5,0,1,0\n4.5,7,1.5,0,1,0\n")
        database = self.database(recording)
        self.assertIn("there is no scene, and nobody knows of walls", self.warnings)
        self.assertEqual(self.fps(database), 2)
        self.assertEqual(database.execute(TRAJECTORY).fetchall(),
                         [(0, 7, 0, 0), (0, 4000000000, 5, 5), (1, 7, 0.5, 0), (3, 7, 1.5, 0)])


unittest.main(argv=sys.argv[:1])
