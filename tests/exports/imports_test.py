# SPDX-License-Identifier: Apache-2.0
"""Trajectories as other programs write them: read, judged, converted, and refused where they are damaged."""
import json
import os
import sqlite3
import subprocess
import sys
import unittest

import h5py
import numpy as np

import exported

# Two who pass each other 1 m apart, at 1 m/s, and one that comes later; ids as others have them.
FPS = 10
PEOPLE = [(person, frame, x, y)
          for person, first, last, place in ((7, 0, 40, lambda t: (-2 + t, 0.0)), (9, 0, 40, lambda t: (2 - t, 1.0)),
                                             (1000000, 20, 40, lambda t: (0.0, 3 + t / 2)))
          for frame in range(first, last + 1) for x, y in [place(frame / FPS)]]


def text_of(people, header=f"# framerate: {FPS}\n# id frame x/m y/m z/m\n"):
    return header + "".join(f"{person}\t{frame} {x!r} {y!r} 1.7\n" for person, frame, x, y in people)


def obsmat_of(people, stride=1, header=""):
    return header + "".join(f"  {stride * frame:.7e}   {person:.7e}   {x:.7e} 0 {y:.7e} 1.0 0 0.0\n"
                            for person, frame, x, y in sorted(people, key=lambda row: row[1]))


def write_sqlite(path, people, version, fps=FPS):
    path.unlink(missing_ok=True)
    with sqlite3.connect(path) as base:
        base.execute("CREATE TABLE trajectory_data (frame INTEGER NOT NULL, id INTEGER NOT NULL, pos_x REAL, "
                     "pos_y REAL, ori_x REAL NOT NULL, ori_y REAL NOT NULL)")
        base.execute("CREATE TABLE metadata(key TEXT NOT NULL UNIQUE PRIMARY KEY, value TEXT NOT NULL)")
        base.executemany("INSERT INTO metadata VALUES (?, ?)", [("version", str(version)), ("fps", str(fps))])
        if version == 1:
            base.execute("CREATE TABLE geometry(wkt TEXT NOT NULL)")
        else:
            base.execute("CREATE TABLE geometry(hash INTEGER NOT NULL, wkt TEXT NOT NULL)")
            base.execute("CREATE TABLE frame_data(frame INTEGER NOT NULL, geometry_hash INTEGER NOT NULL)")
        base.executemany("INSERT INTO trajectory_data VALUES (?, ?, ?, ?, 1, 0)",
                         [(frame, person, x, y) for person, frame, x, y in people])
    base.close()


def write_hdf5(path, people, fps=FPS, types=("<u4", "<u4"), **options):
    rows = np.array([(*row, 1.7) for row in people],
                    dtype=[("id", types[0]), ("frame", types[1]), ("x", "<f8"), ("y", "<f8"), ("z", "<f8")])
    with h5py.File(path, "w") as file:
        table = file.create_dataset("trajectory", data=rows, **options)
        if fps is not None:
            table.attrs["fps"] = fps
        file.attrs["wkt_geometry"] = "POLYGON ((-9 -9, 9 -9, 9 9, -9 9, -9 -9))"


class Imports(exported.Exported):
    def path(self, name, content):
        path = self.folder / name
        path.write_text(content)
        return path

    def check(self, path, *arguments, status=0):
        done = subprocess.run([os.environ["AVO_BINARY"], "check", str(path), "--json", "-q", *map(str, arguments)],
                              capture_output=True, text=True)
        self.assertEqual(done.returncode, status, done.stderr + done.stdout)
        return json.loads(done.stdout)

    def refusal(self, path, *arguments, status=3, verb="check"):
        done = subprocess.run([os.environ["AVO_BINARY"], verb, str(path), *map(str, arguments)], capture_output=True,
                              text=True)
        self.assertEqual(done.returncode, status, done.stderr + done.stdout)
        self.assertEqual(done.stderr.count("\n"), 1, done.stderr)
        self.assertEqual(done.stdout, "")
        return done.stderr.replace(f"{self.folder}/", "")

    def every_kind(self, people=PEOPLE):
        files = [self.path("archive.txt", text_of(people)), self.path("obsmat.txt", obsmat_of(people, 6))]
        for version in (1, 2):
            files.append(self.folder / f"{version}.sqlite")
            write_sqlite(files[-1], people, version)
        for name, options in (("plain", {}), ("packed", {"compression": "gzip", "chunks": (32,)}),
                              ("floats", {"types": ("<f8", "<i8")})):
            files.append(self.folder / f"{name}.h5")
            write_hdf5(files[-1], people, **options)
        return files

    def test_every_format_becomes_the_same_recording(self):
        for path in self.every_kind():
            with self.subTest(path.name):
                fps = 2.5 if path.name == "obsmat.txt" else FPS
                rows = self.rows(path)
                self.assertEqual({(int(row["robot"]), round(row["time"] * fps), row["x"], row["y"]) for row in rows},
                                 {(person, frame, float(f"{x:.7e}") if fps == 2.5 else x,
                                   float(f"{y:.7e}") if fps == 2.5 else y) for person, frame, x, y in PEOPLE})
                self.assertTrue(all(row["estimated"] == 1 for row in rows))
                for row in rows if fps == FPS else []:
                    vx, vy = {7: (1, 0), 9: (-1, 0), 1000000: (0, 0.5)}[row["robot"]]
                    self.assertAlmostEqual(row["vx"], vx, 12)
                    self.assertAlmostEqual(row["vy"], vy, 12)
                found = self.check(path, "--radius", 0.4)
                self.assertEqual((found["verdict"], found["robots"], found["estimated"]), ("safe", 3, True))
                self.assertAlmostEqual(found["least_clearance"], 0.2, 6)

    def test_what_was_converted_is_judged_alike(self):
        for path in self.every_kind():
            again = self.convert(path, "again.csv")
            first, second = self.check(path, "--radius", 0.4), self.check(again, "--radius", 0.4)
            first["recording"] = second["recording"]
            self.assertEqual(first, second)

    def test_every_format_goes_out_again(self):
        source = self.path("archive.txt", text_of(PEOPLE))
        for name, to in (("a.sqlite", []), ("a.h5", ["--to", "pedestrian-hdf5"]), ("a.txt", ["--to", "pedestrian-text"]),
                         ("b.txt", ["--to", "obsmat"])):
            out = self.convert(source, name, *to)
            self.assertEqual([(row["time"], row["robot"], row["x"], row["y"]) for row in self.rows(out)],
                             [(row["time"], row["robot"], row["x"], row["y"]) for row in self.rows(source)], name)
        self.assertTrue((self.folder / "a.txt").read_text().startswith("# framerate: 10\n# id frame x/m y/m z/m\n"))

    def test_limits_that_are_not_given_are_unknown(self):
        path = self.path("archive.txt", text_of(PEOPLE))
        found = self.check(path, "--radius", 0.4)
        unknown = {"count": None, "worst": None, "first": None}
        self.assertEqual([found[key] for key in ("accelerations", "speeds")], [unknown] * 2)
        self.assertAlmostEqual(found["largest_speed"], 1.0, 9)
        found = self.check(path, "--radius", 0.4, "--max-speed", 0.9, status=1)
        self.assertEqual((found["speeds"]["count"], found["accelerations"]), (82, unknown))
        done = subprocess.run([os.environ["AVO_BINARY"], "check", path, "--radius", "0.4"], capture_output=True, text=True)
        self.assertIn("speed              unknown, without a limit; largest 1 m/s", done.stdout)
        self.assertIn("velocities         estimated", done.stdout)

    def test_contacts_jumps_and_walls_are_judged(self):
        walls = self.path("walls.yaml", "version: 1\nobstacles: [{polyline: [[-1, -0.3], [1, -0.3]]}]\n")
        for path in self.every_kind():
            self.assertEqual(self.check(path, "--radius", 0.55, status=1)["overlaps"]["first"]["robot"], 7)
            found = self.check(path, "--radius", 0.4, "--scene", walls, status=1)
            self.assertEqual(found["static_contacts"]["count"], 1)
            self.assertEqual(found["static_contacts"]["first"]["robot"], 7)
        for path in self.every_kind([(person, frame, x, y + (5 if person == 9 and frame > 20 else 0))
                                     for person, frame, x, y in PEOPLE]):
            found = self.check(path, "--radius", 0.4, status=1)
            self.assertEqual(found["jumps"]["count"], 1, path)
            self.assertEqual(found["jumps"]["first"]["robot"], 9)

    def test_measurements_that_shake_do_not_jump(self):
        chance = np.random.default_rng(5)
        people = [(person, frame, x + chance.normal(0, 0.02), y) for person, frame, x, y in PEOPLE]
        self.assertEqual(self.check(self.path("a.txt", text_of(people)), "--radius", 0.3)["jumps"]["count"], 0)

    def test_centimeters(self):
        path = self.path("cm.txt", text_of([(person, frame, 100 * x, 100 * y) for person, frame, x, y in PEOPLE],
                                           "# framerate: 10.00 fps\n# id frame x/cm y/cm z/cm\n"))
        self.assertAlmostEqual(self.check(path, "--radius", 0.4)["least_clearance"], 0.2, 9)

    def test_frames_that_are_missing_make_gaps(self):
        people = [row for row in PEOPLE if not (10 < row[1] < 14)]
        for path in self.every_kind(people):
            found = self.check(path, "--radius", 0.4, status=7)
            self.assertEqual((found["verdict"], found["gaps"]), ("incomplete", 2))
        out = self.convert(self.path("a.txt", text_of(people)), "a.sqlite")
        self.assertEqual(len(self.rows(out)), len(people))

    def test_frames_may_be_some_apart(self):
        path = self.path("a.txt", text_of([row for row in PEOPLE if row[1] % 5 == 0]))
        self.assertEqual(self.check(path, "--radius", 0.4)["verdict"], "safe")
        self.convert(path, "a.h5", "--to", "pedestrian-hdf5")
        with h5py.File(self.folder / "a.h5") as file:
            self.assertEqual(file["trajectory"].attrs["fps"], 2)
            self.assertEqual(sorted(set(file["trajectory"]["frame"])), list(range(9)))

    def test_walls_of_a_scene_without_robots_go_out(self):
        walls = self.path("walls.yaml", "version: 1\nobstacles: [{disc: {center: [0, -5], radius: 1}}]\n")
        out = self.convert(self.path("a.txt", text_of(PEOPLE)), "a.sqlite", "--scene", walls)
        with sqlite3.connect(out) as base:
            self.assertGreater(len(base.execute("SELECT wkt FROM geometry").fetchone()[0]), 500)
        self.assertEqual(self.refusal(self.folder / "a.txt", self.folder / "a.mcap", "--scene", walls, verb="convert", status=2),
                         "avo: --scene: found no robots in it, must have them: MCAP shows radii\n")

    def test_a_scene_without_robots_is_no_run(self):
        walls = self.path("walls.yaml", "version: 1\nobstacles: []\n")
        self.assertIn("found no robots", self.refusal(walls, verb="run"))
        self.assertIn("--radius: found neither it nor robots in --scene",
                      self.refusal(self.path("a.txt", text_of(PEOPLE)), "--scene", walls, status=2))

    def test_damaged_text_is_refused(self):
        head = "# framerate: 10\n"
        for name, text, message in (
                ("rate", "1 0 0 0 0\n1 1 0 0 0\n", "1: found no frame rate, must be in a line before, such as \"# framerate: 16\""),
                ("bad_rate", "# framerate: -3\n1 0 0 0\n", "1: found \"# framerate: -3\", must be a frame rate, such as \"# framerate: 16\""),
                ("one_frame", head + "1 0 0 0\n2 0 0 0\n", " found rows of one frame, must be of two or more"),
                ("nothing", head, " found rows of no frames, must be of two or more"),
                ("nan", head + "1 0 nan 0\n1 1 0 0\n", "2: x: found \"nan\", must be a finite number"),
                ("huge", head + "1 0 1e13 0\n1 1 0 0\n", "2: found 10000000000000, must be a finite number from -1e+12 to 1e+12"),
                ("word", head + "1 0 x 0\n", "2: x: found \"x\", must be a finite number"),
                ("negative", head + "-1 0 0 0\n", "2: id: found \"-1\", must be an integer >= 0"),
                ("half", head + "1 0.5 0 0\n", "2: frame: found \"0.5\", must be an integer >= 0"),
                ("cut", head + "1 0 0 0\n1 1 0", "3: found 3 columns, must be 4 as in the rows before"),
                ("few", head + "1 0 0\n", "2: found 3 columns, must be id, frame, x, y and at most 3 more, or frame, id, x, z, y, vx, vz, vy"),
                ("twice", head + "1 0 0 0\n1 1 0 0\n1 1 5 5\n", "4: found id 1 again in frame 1, must be once")):
            with self.subTest(name):
                path = self.path(f"{name}.txt", text)
                self.assertEqual(self.refusal(path, "--radius", 1), f"{name}.txt:{message}\n")
        path = self.path("a.txt", text_of(PEOPLE))
        self.assertIn("found id 7, must be 0 to 1, the robots of the scene",
                      self.refusal(path, "--scene", self.path("two.yaml", "version: 1\nrobots: [{position: [0, 0], goal: [1, 0]}, "
                                                              "{position: [5, 5], goal: [1, 0]}]\n")))

    def test_damaged_databases_are_refused(self):
        def changed(*statements, version=2, fps=FPS):
            path = self.folder / "bad.sqlite"
            write_sqlite(path, PEOPLE, version, fps)
            with sqlite3.connect(path) as base:
                for statement in statements:
                    base.execute(statement)
            base.close()
            return self.refusal(path, "--radius", 1)

        self.assertEqual(changed(version=3), "bad.sqlite: metadata: version: found \"3\", must be 1 or 2\n")
        self.assertEqual(changed(fps="fast"), "bad.sqlite: metadata: fps: found \"fast\", must be > 0\n")
        self.assertIn("found no fps", changed("DELETE FROM metadata WHERE key = 'fps'"))
        self.assertIn("found no table trajectory_data", changed("DROP TABLE trajectory_data"))
        self.assertIn("found no table trajectory_data", changed(
            "ALTER TABLE trajectory_data RENAME TO other", "CREATE VIEW trajectory_data AS WITH RECURSIVE c(frame, id, "
            "pos_x, pos_y) AS (SELECT 1, 1, 1, 1 UNION ALL SELECT frame + 1, 1, 1, 1 FROM c) SELECT * FROM c"))
        self.assertIn("no such column", changed("ALTER TABLE trajectory_data RENAME COLUMN pos_x TO x"))
        self.assertIn("found a row [\"3\", \"7\", \"\", \"0.0\"]", changed("UPDATE trajectory_data SET pos_x = NULL WHERE frame = 3 AND id = 7"))
        self.assertIn("found a row", changed("UPDATE trajectory_data SET id = 'Bob' WHERE frame = 3"))
        self.assertIn("found a row", changed("UPDATE trajectory_data SET id = -7 WHERE id = 7"))
        self.assertIn("found rows of no frames", changed("DELETE FROM trajectory_data"))
        self.assertIn("frame 3, id 9: found id 9 again in frame 3",
                      changed("UPDATE trajectory_data SET id = 9 WHERE frame = 3 AND id = 7"))
        whole = self.folder / "2.sqlite"
        write_sqlite(whole, PEOPLE, 2)
        data = whole.read_bytes()
        for length in (17, 100, 2000, len(data) // 2):
            cut = self.folder / "cut.sqlite"
            cut.write_bytes(data[:length])
            self.assertIn("cut.sqlite: ", self.refusal(cut, "--radius", 1))

    def test_damaged_archives_are_refused(self):
        path = self.folder / "bad.h5"

        def refusal():
            return self.refusal(path, "--radius", 1).replace("bad.h5: ", "")

        write_hdf5(path, PEOPLE, fps=None)
        self.assertEqual(refusal(), "trajectory: found no attribute fps, must be there\n")
        for fps, found in ((-1.0, "-1"), (float("nan"), "nan"), ("16", "no number"), ([16, 16], "no number")):
            write_hdf5(path, PEOPLE, fps)
            self.assertEqual(refusal(), f"trajectory: fps: found {found}, must be a number > 0\n")
        write_hdf5(path, [(1, 0, float("nan"), 0), (1, 1, 0, 0)])
        self.assertIn("frame 0, id 1: found nan, must be a finite number", refusal())
        write_hdf5(path, [(0.5, 0, 0, 0), (1, 1, 0, 0)], types=("<f8", "<f8"))
        self.assertIn("row 0: found id 0.5, frame 0, must be integers >= 0", refusal())
        write_hdf5(path, [(-1, 0, 0, 0), (1, 1, 0, 0)], types=("<i4", "<i4"))
        self.assertIn("found id -1", refusal())
        write_hdf5(path, [])
        self.assertEqual(refusal().split(": ")[-1], "found rows of no frames, must be of two or more\n")
        with h5py.File(path, "w") as file:
            file.create_dataset("trajectory", data=np.zeros((4, 4))).attrs["fps"] = 16
        self.assertEqual(refusal(), "trajectory: found no list of rows, must be one\n")
        with h5py.File(path, "w") as file:
            file.create_dataset("trajectory", data=np.zeros(4)).attrs["fps"] = 16
        self.assertEqual(refusal(), "trajectory: found no columns, must be id, frame, x and y\n")
        with h5py.File(path, "w") as file:
            file.create_group("trajectory")
        self.assertEqual(refusal(), "trajectory: found no list of rows, must be one\n")
        kinds = [("id", "<i8"), ("frame", "<i8"), ("x", "<f8")]
        with h5py.File(path, "w") as file:
            file.create_dataset("trajectory", data=np.zeros(4, dtype=kinds)).attrs["fps"] = 16
        self.assertEqual(refusal(), "trajectory: found no column of numbers \"y\", must be there\n")
        with h5py.File(path, "w") as file:
            file.create_dataset("trajectory", shape=(40_000_000,), chunks=(1000,), dtype=kinds + [("y", "<f8")]).attrs["fps"] = 16
        self.assertEqual(refusal(), "trajectory: found bytes of a part of its 40000000 rows, must be all\n")
        with h5py.File(path, "w") as file:
            file.create_dataset("trajectory", shape=(10**15,), chunks=(1000,), dtype=kinds + [("y", "<f8")])
        self.assertIn("must be 50000000 at most", refusal())
        write_hdf5(path, PEOPLE)
        data = path.read_bytes()
        for length in (9, 100, len(data) // 2, len(data) - 1):
            path.write_bytes(data[:length])
            self.assertIn("cut off or damaged, must be whole", refusal())


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
