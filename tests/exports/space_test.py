# SPDX-License-Identifier: Apache-2.0
"""Exports of recordings of space: MCAP, and glTF taken to pieces by the tables of its specification."""
import json
import math
import struct
import sys
import unittest

from exported import Exported
from mcap_test import Mcap, message, one

SCENE = """version: 1
space: 3
name: drones
duration: 3
robots:
  - {position: [-6, 0, 1], goal: [6, 0, 2], radius: 0.4}
  - {position: [6, 0.1, 1], goal: [-6, 0, 1], downwash: 0.5}
  - {position: [0, -5, 2], goal: [0, 5, 0.5], radius: 0.3}
moving_obstacles:
  - {position: [0, 20, 3], velocity: [0, -2, 4], acceleration: [0, 0, -9.81], radius: 0.2}
  - {trajectory: [[0, -30, 3, 2], [1.55, 0, 12, 2], [3, 30, 12, 4]], radius: 1.5}
obstacles:
  - {floor: -1}
  - {box: {min: [2, 3, 0], max: [3, 4, 2], heading: 0.5}}
"""
BALLS = ("robot", 0, 0.4), ("robot", 1, 0.5), ("robot", 2, 0.3), ("moving", 0, 0.2), ("moving", 1, 1.5)


def movers_at(t):
    """Places and velocities of the moving obstacles."""
    ball = (0, 20 - 2 * t, 3 + 4 * t - 9.81 * t * t / 2), (0, -2, 4 - 9.81 * t)
    part = t / 1.55 if t < 1.55 else (t - 1.55) / 1.45
    legs = (-30, 3, 2), (0, 12, 2), (30, 12, 4)
    a, b = legs[:2] if t < 1.55 else legs[1:]
    time = 1.55 if t < 1.55 else 1.45
    way = [v - u for u, v in zip(a, b)]
    return ball, ([u + part * w for u, w in zip(a, way)], [w / time if t < 3 - 1e-9 else 0 for w in way])


WIDTH = {"SCALAR": 1, "VEC3": 3}


def glb(data):
    """The JSON and the bytes of a .glb."""
    magic, version, length = struct.unpack_from("<4sII", data)
    assert (magic, version, length) == (b"glTF", 2, len(data))
    size, kind = struct.unpack_from("<I4s", data, 12)
    assert kind == b"JSON" and size % 4 == 0
    tree = json.loads(data[20:20 + size])
    rest, kind = struct.unpack_from("<I4s", data, 20 + size)
    assert kind == b"BIN\0" and rest % 4 == 0 and 28 + size + rest == len(data)
    return tree, data[28 + size:]


class Gltf(Exported):
    def drones(self):
        scene = self.folder / "drones.yaml"
        scene.write_text(SCENE)
        return self.record(scene)

    def numbers(self, accessor):
        """Rows of an accessor, and its structure looked at."""
        entry = self.tree["accessors"][accessor]
        view = self.tree["bufferViews"][entry["bufferView"]]
        self.assertEqual((view["buffer"], view["byteOffset"] % 4), (0, 0))
        self.assertLessEqual(view["byteOffset"] + view["byteLength"], self.tree["buffers"][0]["byteLength"])
        letter, size = {5126: ("f", 4), 5123: ("H", 2)}[entry["componentType"]]
        width = WIDTH[entry["type"]]
        self.assertEqual(entry["count"] * width * size, view["byteLength"])
        flat = struct.unpack_from(f"<{entry['count'] * width}{letter}", self.bytes, view["byteOffset"])
        rows = [flat[k:k + width] for k in range(0, len(flat), width)]
        if "min" in entry:
            self.assertEqual(entry["min"], [min(column) for column in zip(*rows)])
            self.assertEqual(entry["max"], [max(column) for column in zip(*rows)])
        return rows

    def setUp(self):
        super().setUp()
        self.recording = self.drones()
        self.tree, self.bytes = glb(self.convert(self.recording, "out.glb").read_bytes())

    def test_the_file_is_whole(self):
        tree = self.tree
        self.assertEqual(tree["asset"]["version"], "2.0")
        self.assertEqual(tree["scenes"][tree["scene"]]["nodes"], [0])
        self.assertEqual(tree["nodes"][0]["children"], list(range(1, len(tree["nodes"]))))
        self.assertEqual(tree["buffers"][0]["byteLength"], len(self.bytes))
        for mesh in tree["meshes"]:
            primitive, = mesh["primitives"]
            self.assertLess(primitive["material"], len(tree["materials"]))
            points = self.numbers(primitive["attributes"]["POSITION"])
            normals = self.numbers(primitive["attributes"]["NORMAL"])
            self.assertIn("min", tree["accessors"][primitive["attributes"]["POSITION"]])
            corners = [index for index, in self.numbers(primitive["indices"])]
            self.assertEqual((len(points), len(corners) % 3), (len(normals), 0))
            self.assertLess(max(corners), len(points))
            for k in range(0, len(corners), 3):  # seen from outside, corners are counter-clockwise
                a, b, c = (points[corner] for corner in corners[k:k + 3])
                u, v = [y - x for x, y in zip(a, b)], [y - x for x, y in zip(a, c)]
                across = (u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0])
                middle = [x + y + z for x, y, z in zip(a, b, c)]
                self.assertGreaterEqual(sum(x * y for x, y in zip(across, middle)), -1e-7)

    def test_balls_move_on_the_cubic_of_the_rows(self):
        rows = self.rows(self.recording)
        animation, = self.tree["animations"]
        self.assertEqual(len(animation["channels"]), 5)
        for channel, (kind, number, radius) in zip(animation["channels"], BALLS):
            self.assertEqual(channel["target"]["path"], "translation")
            node = self.tree["nodes"][channel["target"]["node"]]
            self.assertEqual((node["name"].split()[0], int(node["name"].split()[-1])), (kind, number))
            own = [row for row in rows if row["robot"] == number]
            self.assertEqual(node["scale"], [radius] * 3)
            if kind == "moving":
                self.assertEqual(node["mesh"], 7)
                self.follows(animation["samplers"][channel["sampler"]], number, [row["time"] for row in own])
                continue
            sampler = animation["samplers"][channel["sampler"]]
            self.assertEqual(sampler["interpolation"], "CUBICSPLINE")
            times = [time for time, in self.numbers(sampler["input"])]
            self.assertIn("min", self.tree["accessors"][sampler["input"]])
            keys = self.numbers(sampler["output"])
            self.assertEqual((len(times), len(keys)), (len(own), 3 * len(own)))
            for k, row in enumerate(own):
                self.assertAlmostEqual(times[k], row["time"], places=5)
                into, place, out = keys[3 * k:3 * k + 3]
                for found, names in ((into, "vx vy vz"), (place, "x y z"), (out, "vx vy vz")):
                    for x, name in zip(found, names.split()):
                        self.assertAlmostEqual(x, row[name], places=5)

    def follows(self, sampler, number, times):
        """A ball is on a cubic, and a moving obstacle with a trajectory goes straight."""
        keys = self.numbers(sampler["output"])
        self.assertEqual(sampler["interpolation"], ("CUBICSPLINE", "LINEAR")[number])
        if number == 0:
            self.assertEqual(len(keys), 3 * len(times))
            for k, time in enumerate(times):
                place, velocity = movers_at(time)[0]
                for found, expected in zip((*keys[3 * k], *keys[3 * k + 1]), (*velocity, *place)):
                    self.assertAlmostEqual(found, expected, places=4)
            return
        self.assertEqual(len(keys), len(times))
        for key, time in zip(keys, times):
            for found, expected in zip(key, movers_at(time)[1][0]):
                self.assertAlmostEqual(found, expected, places=4)

    def test_z_is_up_and_boxes_stand_where_they_are(self):
        x, y, z, w = self.tree["nodes"][0]["rotation"]
        up = (2 * (x * z + w * y), 2 * (y * z - w * x), 1 - 2 * (x * x + y * y))  # where z goes
        for found, expected in zip(up, (0, 1, 0)):
            self.assertAlmostEqual(found, expected)
        floor, box = self.tree["nodes"][-2:]
        self.assertAlmostEqual(floor["translation"][2] + floor["scale"][2], -1)
        self.assertTrue(all(math.isfinite(v) for v in floor["translation"] + floor["scale"]))
        self.assertGreater(floor["scale"][0], 6)
        for found, expected in zip(box["translation"] + box["scale"], (2.5, 3.5, 1, 0.5, 0.5, 1)):
            self.assertAlmostEqual(found, expected)
        self.assertAlmostEqual(2 * math.atan2(box["rotation"][2], box["rotation"][3]), 0.5)

    def test_csv_with_its_scene_gives_the_same_bytes(self):
        rows = self.convert(self.recording, "rows.csv")
        again = self.convert(rows, "again.glb", "--scene", self.folder / "drones.yaml").read_bytes()
        self.assertEqual(again, (self.folder / "out.glb").read_bytes())


class SpaceMcap(Mcap):
    movers = True

    def test_messages_are_the_rows(self):
        scene = self.folder / "drones.yaml"
        scene.write_text(SCENE)
        recording = self.record(scene)
        messages = self.taken(recording)
        rows = self.rows(recording)
        entities = [message(entity) for m in messages if m[0] == "/robots" for entity in m[2][2]]
        poses = [message(pose) for m in messages if m[0] == "/poses" for pose in m[2][3]]
        self.assertEqual((len(entities), len(poses)), (len(rows), len(rows)))
        for row, entity, pose in zip(rows, entities, poses):
            robot = int(row["robot"])
            place = (row["x"], row["y"], row["z"])
            self.assertEqual(entity[3][0], str(robot).encode())
            self.assertEqual(tuple(one(entity, 9, 1, 1, k) for k in (1, 2, 3)), place)
            self.assertEqual(tuple(one(pose, 1, k) for k in (1, 2, 3)), place)
            self.assertEqual([one(entity, 9, 2, k) for k in (1, 2, 3)], [2 * (0.4, 0.5, 0.3)[robot]] * 3)
            velocity = (row["vx"], row["vy"], row["vz"])
            speed = math.hypot(*velocity)
            self.assertEqual(7 in entity, speed > 1e-3)
            if 7 not in entity:
                continue
            self.assertAlmostEqual(one(entity, 7, 2) + one(entity, 7, 4), speed, places=11)
            x, y, z, w = (one(entity, 7, 1, 2, k) for k in (1, 2, 3, 4))
            ahead = (1 - 2 * (y * y + z * z), 2 * (x * y + w * z), 2 * (x * z - w * y))
            for found, expected in zip(ahead, velocity):
                self.assertAlmostEqual(found, expected / speed, places=9)
        moving = [[message(entity) for entity in m[2][2]] for m in messages if m[0] == "/moving_obstacles"]
        times = sorted({row["time"] for row in rows})
        self.assertEqual(len(moving), len(times))
        for entities, time in zip(moving, times):
            for entity, (place, velocity), radius in zip(entities, movers_at(time), (0.2, 1.5), strict=True):
                for k in range(3):
                    self.assertAlmostEqual(one(entity, 9, 1, 1, k + 1), place[k], places=9)
                    self.assertEqual(one(entity, 9, 2, k + 1), 2 * radius)
                speed = math.hypot(*velocity)
                if speed > 1e-3:
                    self.assertAlmostEqual(one(entity, 7, 2) + one(entity, 7, 4), speed, places=9)
        floor, box = (message(entity) for entity in messages[0][2][2])
        self.assertAlmostEqual(one(floor, 8, 1, 1, 3) + one(floor, 8, 2, 3) / 2, -1)
        for k, size in ((1, 1), (2, 1), (3, 2)):
            self.assertAlmostEqual(one(box, 8, 2, k), size)


# of the plane: their tests run in mcap_test.py
for name in [name for name in dir(Mcap) if name.startswith("test_") and name not in vars(SpaceMcap)]:
    setattr(SpaceMcap, name, None)
del Mcap

if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
