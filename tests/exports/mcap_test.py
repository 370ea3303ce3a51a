# SPDX-License-Identifier: Apache-2.0
"""Exports as MCAP, taken to pieces by the tables of https://mcap.dev/spec, messages by their wire format."""
import math
import struct
import sys
import unittest
import zlib

from exported import Exported

MAGIC = b"\x89MCAP0\r\n"
HEADER, FOOTER, SCHEMA, CHANNEL, MESSAGE, CHUNK, MESSAGE_INDEX, CHUNK_INDEX = range(1, 9)
STATISTICS, SUMMARY_OFFSET, DATA_END = 0x0B, 0x0E, 0x0F


class Fields:
    """Of a record, one after the other."""
    def __init__(self, data):
        self.data, self.at = data, 0

    def number(self, size):
        self.at += size
        return int.from_bytes(self.data[self.at - size:self.at], "little")

    def bytes(self, size=4):
        length = self.number(size)
        self.at += length
        assert self.at <= len(self.data)
        return self.data[self.at - length:self.at]

    def text(self):
        return self.bytes().decode()

    def pairs(self, first, second):
        inner = Fields(self.bytes())
        result = []
        while inner.at < len(inner.data):
            result.append((inner.number(first), inner.number(second)))
        return result

    def rest(self):
        return self.data[self.at:]


def records(data, start=0):
    """Where each begins, its opcode, its content."""
    while start < len(data):
        opcode, length = data[start], int.from_bytes(data[start + 1:start + 9], "little")
        yield start, opcode, data[start + 9:start + 9 + length]
        start += 9 + length
    assert start == len(data)


def message(data):
    """Numbers of fields, with all their values: whole numbers, doubles, bytes."""
    fields, at = {}, 0

    def varint():
        nonlocal at
        value = shift = 0
        while True:
            value |= (data[at] & 0x7F) << shift
            at, shift = at + 1, shift + 7
            if data[at - 1] < 0x80:
                return value

    while at < len(data):
        key = varint()
        if key & 7 == 0:
            value = varint()
        elif key & 7 == 1:
            value, at = struct.unpack_from("<d", data, at)[0], at + 8
        else:
            assert key & 7 == 2
            length = varint()
            value, at = data[at:at + length], at + length
        fields.setdefault(key >> 3, []).append(value)
    assert at == len(data)
    return fields


def one(fields, *numbers, default=0.0):
    """The value at the end of the way."""
    for number in numbers[:-1]:
        fields = message(fields[number][0]) if number in fields else {}
    return fields.get(numbers[-1], [default])[0]


class Mcap(Exported):
    movers = False  # whether the scene has moving obstacles

    def taken(self, recording, *arguments):
        """Its messages (topic, time, fields), once its structure has been looked at."""
        data = self.convert(recording, "out.mcap", *arguments).read_bytes()
        self.assertTrue(data.startswith(MAGIC) and data.endswith(MAGIC))
        found = list(records(data[:-len(MAGIC)], len(MAGIC)))
        self.assertEqual((found[0][1], found[-1][1]), (HEADER, FOOTER))
        end = next(k for k, record in enumerate(found) if record[1] == DATA_END)
        self.assertEqual(Fields(found[end][2]).number(4), zlib.crc32(data[:found[end][0]]))
        self.schemas = [Fields(content) for _, opcode, content in found[:end] if opcode == SCHEMA]
        channels = {}
        for _, opcode, content in found[:end]:
            if opcode == CHANNEL:
                fields = Fields(content)
                channel = fields.number(2)
                channels[channel] = (fields.number(2), fields.text(), fields.text(), fields.text())
        topics = [(1, "/walls"), (1, "/robots"), (2, "/poses")] + [(1, "/moving_obstacles")] * self.movers
        self.assertEqual(channels, {k: (schema, topic, "protobuf", "") for k, (schema, topic) in enumerate(topics, 1)})
        messages, indices = self.chunks(data, found[:end + 1])
        self.summary(data, found, end, messages, indices)
        return [(channels[channel][1], time, message(content)) for channel, time, content in messages]

    def chunks(self, data, found):
        messages, indices = [], []
        for k, (start, opcode, content) in enumerate(found):
            if opcode != CHUNK:
                continue
            chunk = Fields(content)
            first, last, size, crc = (chunk.number(n) for n in (8, 8, 8, 4))
            self.assertEqual(chunk.text(), "")
            inner = chunk.bytes(8)
            self.assertEqual((len(inner), zlib.crc32(inner), chunk.rest()), (size, crc, b""))
            there = {}
            for offset, inner_opcode, inner_content in records(inner):
                self.assertEqual(inner_opcode, MESSAGE)
                fields = Fields(inner_content)
                channel, sequence, time, published = (fields.number(n) for n in (2, 4, 8, 8))
                self.assertEqual(sequence, sum(1 for m in messages if m[0] == channel))
                self.assertEqual(time, published)
                there.setdefault(channel, []).append((time, offset))
                messages.append((channel, time, fields.rest()))
            times = [time for entries in there.values() for time, _ in entries]
            self.assertEqual((first, last), (min(times), max(times)))
            offsets, end = [], found[k + 1][0]
            for offset, index_opcode, index_content in found[k + 1:]:
                end = offset
                if index_opcode != MESSAGE_INDEX:
                    break
                index = Fields(index_content)
                channel = index.number(2)
                self.assertEqual(index.pairs(8, 8), there.pop(channel))
                offsets.append((channel, offset))
            self.assertEqual(there, {})
            indices.append((first, last, start, 9 + len(content), offsets, end - start - 9 - len(content), size))
        self.assertEqual([m[1] for m in messages], sorted(m[1] for m in messages))
        return messages, indices

    def summary(self, data, found, end, messages, indices):
        footer = Fields(found[-1][2])
        start, offsets_start, crc = (footer.number(n) for n in (8, 8, 4))
        self.assertEqual(start, found[end + 1][0])
        self.assertEqual(crc, zlib.crc32(data[start:found[-1][0] + 9 + 16]))
        groups, listed = {}, []
        for offset, opcode, content in found[end + 1:-1]:
            if opcode == SUMMARY_OFFSET:
                if not listed:
                    self.assertEqual(offset, offsets_start)
                fields = Fields(content)
                listed.append((fields.number(1), fields.number(8), fields.number(8)))
            else:
                groups.setdefault(opcode, []).append((offset, content))
        self.assertEqual(listed, [(opcode, group[0][0], group[-1][0] + 9 + len(group[-1][1]) - group[0][0])
                                  for opcode, group in groups.items()])
        for opcode in (SCHEMA, CHANNEL):
            self.assertEqual([content for _, content in groups[opcode]],
                             [content for _, other, content in found[:end] if other == opcode])
        statistics = Fields(groups[STATISTICS][0][1])
        self.assertEqual([statistics.number(n) for n in (8, 2, 4, 4, 4, 4, 8, 8)],
                         [len(messages), 2, 3 + self.movers, 0, 0, len(indices), messages[0][1], messages[-1][1]])
        self.assertEqual(statistics.pairs(2, 8),
                         [(k, sum(1 for m in messages if m[0] == k)) for k in range(1, 4 + self.movers)])
        told = []
        for _, content in groups[CHUNK_INDEX]:
            index = Fields(content)
            row = [index.number(8) for _ in range(4)] + [index.pairs(2, 8), index.number(8), index.text()]
            self.assertEqual(row.pop(), "")
            sizes = (index.number(8), index.number(8))
            self.assertEqual(sizes[0], sizes[1])
            told.append((*row, sizes[0]))
        self.assertEqual(told, indices)

    def test_messages_are_the_rows(self):
        recording = self.record("mixed-yard", "--duration", 30)
        messages = self.taken(recording)
        rows = self.rows(recording)
        robots = [m for m in messages if m[0] == "/robots"]
        times = sorted({row["time"] for row in rows})
        self.assertEqual([m[1] for m in robots], [round(time * 1e9) for time in times])
        entities = [message(entity) for m in robots for entity in m[2][2]]
        poses = [message(pose) for m in messages if m[0] == "/poses" for pose in m[2][3]]
        self.assertEqual((len(entities), len(poses)), (len(rows), len(rows)))
        for row, entity, pose in zip(rows, entities, poses):
            self.assertEqual(entity[3][0], str(int(row["robot"])).encode())
            self.assertEqual((one(pose, 1, 1), one(pose, 1, 2)), (row["x"], row["y"]))
            half = math.atan2(one(pose, 2, 3), one(pose, 2, 4))
            if row["heading"] is not None:
                self.assertAlmostEqual(math.cos(2 * half), math.cos(row["heading"]), places=12)
                self.assertAlmostEqual(math.sin(2 * half), math.sin(row["heading"]), places=12)
            else:
                self.assertEqual((one(entity, 10, 1, 1, 1), one(entity, 10, 1, 1, 2)), (row["x"], row["y"]))
            speed = math.hypot(row["vx"], row["vy"])
            self.assertEqual(7 in entity, speed > 1e-12)
            self.assertAlmostEqual(one(entity, 7, 2) + one(entity, 7, 4), speed, places=11)

    def test_discs_have_the_scene_s_radii_and_walls_stand_once(self):
        messages = self.taken(self.record("doorway", "--duration", 1, "--set", "robots.0.radius=0.25"))
        sizes = [one(message(entity), 10, 2, 1) for entity in messages[1][2][2]]
        self.assertEqual(sizes, [0.5] + [1.0] * 19)
        self.assertEqual([m[0] for m in messages], ["/walls"] + ["/robots", "/poses"] * 11)
        bounds, south, north = (message(entity) for entity in messages[0][2][2])
        self.assertEqual([one(wall, 11, 1, default=0) for wall in (bounds, south, north)], [1, 0, 0], "LINE_LOOP, ...")
        line = message(south[11][0])
        self.assertEqual([(one(message(p), 1), one(message(p), 2)) for p in line[5]], [(0, -8), (0, -0.8)])
        self.assertEqual(one(line, 3), 0.02)

    def test_moving_obstacles_are_where_their_scene_leads_them(self):
        self.movers = True
        recording = self.record("moving-obstacle", "--duration", 5)
        found = [m for m in self.taken(recording) if m[0] == "/moving_obstacles"]
        self.assertEqual([m[1] for m in found], sorted({round(row["time"] * 1e9) for row in self.rows(recording)}))
        for _, time, fields in found:
            entity = message(fields[2][0])
            self.assertEqual((len(fields[2]), entity[3]), (1, [b"0"]))
            self.assertAlmostEqual(one(entity, 10, 1, 1, 1), 10 - time * 1e-9, places=12)  # -1 m/s
            self.assertEqual((one(entity, 10, 1, 1, 2), one(entity, 10, 2, 1)), (0, 1))
            self.assertEqual(one(entity, 7, 2) + one(entity, 7, 4), 1)

    def test_moving_obstacles_turn_at_the_points_of_their_paths(self):
        self.movers = True
        messages = self.taken(self.record("person", "--duration", 40, "--every", 7))
        places = [one(message(fields[2][0]), 10, 1, 1, 1) for topic, _, fields in messages
                  if topic == "/moving_obstacles"]
        # its points that are farthest in that direction are (3, -3), (3, 3) and (-7, 2); its radius is 0.3
        self.assertLess(abs(max(places) - 3), 0.3)
        self.assertLess(abs(min(places) + 7), 0.3)

    def test_whoever_leaves_is_deleted(self):
        recording = self.record("planes-12", "--duration", 300, "--until-arrived")
        there, gone = set(), []
        for topic, time, fields in self.taken(recording):
            if topic != "/robots":
                continue
            deleted = {one(message(each), 3) for each in fields.get(1, [])}
            now = {message(entity)[3][0] for entity in fields.get(2, [])}
            self.assertEqual(deleted, there - now)
            there, gone = now, gone + sorted(deleted)
        self.assertGreater(len(gone), 0)

    def test_times_of_free_clocks_are_exact(self):
        recording = self.record("circle-5", "--duration", 3, "--set", "clock=free")
        times = sorted({row["time"] for row in self.rows(recording)})
        robots = [m for m in self.taken(recording) if m[0] == "/robots"]
        self.assertEqual([m[1] for m in robots], [round(time * 1e9) for time in times])
        self.assertGreater(len(times), 60)
        for topic, time, fields in robots:
            stamp = message(message(fields[2][0])[1][0])
            self.assertEqual(one(stamp, 1, default=0) * 10**9 + one(stamp, 2, default=0), time)

    def test_csv_with_its_scene_gives_the_same_bytes(self):
        recording = self.record("circle-10", "--duration", 3)
        first = self.convert(recording, "a.mcap").read_bytes()
        table = self.convert(recording, "a.csv")
        self.assertEqual(self.convert(table, "b.mcap", "--scene", "circle-10").read_bytes(), first)

    def test_schemas_name_all_fields_of_foxglove(self):
        self.taken(self.record("circle-3", "--duration", 0.5))
        self.assertEqual([(s.number(2), s.text(), s.text()) for s in self.schemas],
                         [(1, "foxglove.SceneUpdate", "protobuf"), (2, "foxglove.PosesInFrame", "protobuf")])
        sets = [s.bytes() for s in self.schemas]
        self.assertEqual(sets[0], sets[1])
        files = [message(file) for file in message(sets[0])[1]]
        self.assertEqual([(file[1][0], file[2][0], file[12][0]) for file in files],
                         [(b"google/protobuf/timestamp.proto", b"google.protobuf", b"proto3"),
                          (b"google/protobuf/duration.proto", b"google.protobuf", b"proto3"),
                          (b"foxglove/SceneUpdate.proto", b"foxglove", b"proto3")])
        fields = {}
        for each in map(message, files[2][4]):
            numbers = {one(message(field), 1).decode(): one(message(field), 3) for field in each[2]}
            self.assertEqual(sorted(numbers.values()), list(range(1, len(numbers) + 1)))
            fields[each[1][0].decode()] = list(numbers)
        self.assertEqual(fields["SceneEntity"],
                         ["timestamp", "frame_id", "id", "lifetime", "frame_locked", "metadata", "arrows", "cubes",
                          "spheres", "cylinders", "lines", "triangles", "texts", "models"])
        self.assertEqual(fields["ModelPrimitive"],
                         ["pose", "scale", "color", "override_color", "url", "media_type", "data"])
        self.assertEqual(len(fields), 18)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
