#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Slow reference for the certificate under exponential motion, Eqs. (7)-(9), in 40 decimal digits.

Written from the equations alone; shares no code with the library. Meters, seconds.

    certificate_reference.py FOLDER          writes the two golden files
    certificate_reference.py --check FOLDER  demands that their results are right, and samples the motion

Between decisions a robot with command v + w moves by

    x(t) = p + t v + g(t) w,   x'(t) = v + E(t) w,   E = 1 - e^{-t/d},  g = t - d E,

d being the control time. Braking takes w against v: as long as the acceleration allows, |w| = d a_max, or
so much that the step ends at rest. Its three control points on a step are x, x + s v and the next x,
with s = dt - g(dt)/E(dt); `check_motion` samples x(t) to see that it never leaves their triangle.

A's candidate acceleration c (at the start of the step, w = d c), then braking, gives the path y. It is
admitted where on every step, with n from 0 to the nearest point of the triangle of x_A - x_B,

    n . (y_A - x_A) + share (n . (x_A - x_B) - r) >= 0     at all three control points.
"""
import json
import math
import pathlib
import random
import sys
from decimal import Decimal, getcontext

getcontext().prec = 40
SEED = 90317
CASES, LENGTHS = 400, 100
ZERO = Decimal(0)


class Point:
    """A point or vector of the plane with exact enough coordinates."""

    def __init__(self, x, y):
        self.x, self.y = Decimal(x), Decimal(y)

    def __add__(self, other):
        return Point(self.x + other.x, self.y + other.y)

    def __sub__(self, other):
        return Point(self.x - other.x, self.y - other.y)

    def __rmul__(self, factor):
        return Point(factor * self.x, factor * self.y)

    def dot(self, other):
        return self.x * other.x + self.y * other.y

    def cross(self, other):
        return self.x * other.y - self.y * other.x

    def norm(self):
        return self.dot(self).sqrt()


class Response:
    """E, g and s of a control time."""

    def __init__(self, control_time, time_step):
        self.d, self.h = Decimal(control_time), Decimal(time_step)
        self.rate, self.gain = self.at(self.h)
        self.lag = self.h - self.gain / self.rate

    def at(self, t):
        rate = 1 - (-t / self.d).exp()
        return rate, t - self.d * rate


def braking_command(v, a_max, response):
    """w of one step of full braking."""
    speed = v.norm()
    if speed == 0:
        return Point(0, 0)
    return -min(response.d * a_max / speed, 1 / response.rate) * v


def steps_of(robot, response, first):
    """The path, endlessly: (p, v, w) of one step after the other. `first`: command of the first one."""
    p, v, w = Point(*robot["position"]), Point(*robot["velocity"]), first
    a_max = Decimal(robot["max_acceleration"])
    while True:
        if w is None:
            w = braking_command(v, a_max, response)
        yield p, v, w
        p, v = p + response.h * v + response.gain * w, v + response.rate * w
        if v.norm() < Decimal("1e-30"):
            v = Point(0, 0)
        w = None


def control_points(robot, response, count, first=None):
    path = steps_of(robot, response, first)
    points = []
    for _ in range(count):
        p, v, w = next(path)
        points.append((p, p + response.lag * v, p + response.h * v + response.gain * w))
    return points


def nearest_to_origin(triangle):
    """Of a triangle that does not contain the origin."""
    found = []
    for k in range(3):
        a, b = triangle[k], triangle[(k + 1) % 3]
        along = b - a
        squared = along.dot(along)
        part = ZERO if squared == 0 else min(Decimal(1), max(ZERO, -a.dot(along) / squared))
        found.append(a + part * along)
    return min(found, key=lambda x: x.norm())


def contains_origin(triangle):
    turns = [triangle[k].cross(triangle[(k + 1) % 3]) for k in range(3)]
    area = (triangle[1] - triangle[0]).cross(triangle[2] - triangle[0])
    return abs(area) > Decimal("1e-25") and (min(turns) > 0 or max(turns) < 0)


def steps_to_rest(robot, response):
    decrement = Decimal(robot["max_acceleration"]) * response.d * response.rate
    return math.ceil(Decimal(robot["max_speed"]) / decrement) + 2


def judge(a, b, candidate, response):
    """(least distance beyond contact while both brake, least coefficient of A's candidate)."""
    count = max(steps_to_rest(a, response), steps_to_rest(b, response))
    contact = Decimal(a["radius"]) + Decimal(b["radius"])
    a_a, a_b = Decimal(a["max_acceleration"]), Decimal(b["max_acceleration"])
    share = a_a / (a_a + a_b)
    x_a, x_b = control_points(a, response, count), control_points(b, response, count)
    y_a = control_points(a, response, count, response.d * Point(*candidate))
    slack = least = Decimal("Infinity")
    for xs, others, ys in zip(x_a, x_b, y_a):
        q = [x - other for x, other in zip(xs, others)]
        if contains_origin(q):
            return -contact, -contact
        nearest = nearest_to_origin(q)
        slack = min(slack, nearest.norm() - contact)
        n = (1 / nearest.norm()) * nearest
        for x, y, z in zip(xs, ys, q):
            least = min(least, n.dot(y - x) + share * (n.dot(z) - contact))
    return slack, least


def stopping_length(speed, a_max, response):
    robot = {"position": (0, 0), "velocity": (speed, 0), "max_acceleration": a_max}
    for p, v, _ in steps_of(robot, response, None):
        if v.norm() == 0:
            return p.x


def draw_robot(rng):
    speed = rng.uniform(0.5, 2.5)
    angle, now = rng.uniform(-math.pi, math.pi), speed * rng.random()
    return {"position": [0.0, 0.0], "velocity": [now * math.cos(angle), now * math.sin(angle)],
            "radius": rng.uniform(0.2, 1.0), "max_acceleration": 10 ** rng.uniform(-0.5, 0.5),
            "max_speed": speed}


def draw_case(rng):
    a, b = draw_robot(rng), draw_robot(rng)
    angle = rng.uniform(-math.pi, math.pi)
    distance = 1.001 * (a["radius"] + b["radius"]) + 5.0 * rng.random() ** 3
    b["position"] = [distance * math.cos(angle), distance * math.sin(angle)]
    angle, size = rng.uniform(-math.pi, math.pi), a["max_acceleration"] * math.sqrt(rng.random())
    return {"a": a, "b": b, "control_time": 10 ** rng.uniform(-1.0, 0.7),
            "time_step": rng.choice([0.05, 0.1, 0.25]),
            "candidate": [size * math.cos(angle), size * math.sin(angle)]}


def judged(case):
    """The case with its results."""
    response = Response(case["control_time"], case["time_step"])
    slack, least = judge(case["a"], case["b"], case["candidate"], response)
    return {**case, "invariant_slack": float(slack), "smallest_coefficient": float(least),
            "admitted": bool(least >= 0)}


def measured(case):
    response = Response(case["control_time"], case["time_step"])
    length = stopping_length(Decimal(case["speed"]), Decimal(case["max_acceleration"]), response)
    return {**case, "length": float(length)}


def is_within_speed(case):
    response = Response(case["control_time"], case["time_step"])
    change = (response.d * response.rate) * Point(*case["candidate"])
    return (Point(*case["a"]["velocity"]) + change).norm() <= Decimal(case["a"]["max_speed"])


def admission_cases(rng):
    """Half of them admitted, none so near to either that rounding could decide."""
    left = {True: CASES // 2, False: CASES // 2}
    cases = []
    while len(cases) < CASES:
        case = draw_case(rng)
        if not is_within_speed(case):
            continue
        case = judged(case)
        if case["invariant_slack"] < 1e-6 or abs(case["smallest_coefficient"]) < 1e-7:
            continue
        if left[case["admitted"]] > 0:
            left[case["admitted"]] -= 1
            cases.append(case)
    return cases


def length_cases(rng):
    return [measured({"speed": rng.uniform(0.0, 4.0), "max_acceleration": rng.uniform(0.2, 4.0),
                      "time_step": rng.uniform(0.01, 0.3), "control_time": 10 ** rng.uniform(-1, 0.7)})
            for _ in range(LENGTHS)]


def barycentric_minimum(x, triangle):
    """Least weight of x in the triangle; for a flat one how far along it, from either end."""
    a, b, c = triangle
    area = (b - a).cross(c - a)
    scale = max((b - a).norm(), (c - a).norm())
    if abs(area) > Decimal("1e-25") * scale * scale:
        parts = ((b - x).cross(c - x), (c - x).cross(a - x), (a - x).cross(b - x))
        return min(part / area for part in parts)
    if scale == 0:
        return ZERO if (x - a).norm() == 0 else Decimal(-1)
    end = max((b, c), key=lambda point: (point - a).norm())
    off = abs((x - a).cross(end - a)) / scale / scale
    part = (x - a).dot(end - a) / (scale * scale)
    return min(part, 1 - part) if off < Decimal("1e-20") else -off


def check_motion(case, samples=16):
    """The relative path of candidate and braking, sampled: always in the triangle of its control points."""
    response = Response(case["control_time"], case["time_step"])
    a, b = case["a"], case["b"]
    first = response.d * Point(*case["candidate"])
    paths = [steps_of(a, response, first), steps_of(b, response, None)]
    for _ in range(6):
        (p_a, v_a, w_a), (p_b, v_b, w_b) = (next(path) for path in paths)
        p, v, w = p_a - p_b, v_a - v_b, w_a - w_b
        triangle = (p, p + response.lag * v, p + response.h * v + response.gain * w)
        for k in range(samples + 1):
            t = response.h * k / samples
            _, gain = response.at(t)
            weight = barycentric_minimum(p + t * v + gain * w, triangle)
            assert weight > Decimal("-1e-20"), (case, k, weight)


TRAJECTORIES = "braking_trajectories_exponential.json"
STOPPING = "stopping_lengths_exponential.json"


def write(folder):
    rng = random.Random(SEED)
    for name, cases in ((TRAJECTORIES, admission_cases(rng)), (STOPPING, length_cases(rng))):
        rows = ",\n".join(json.dumps(case) for case in cases)
        (folder / name).write_text(f'{{"seed": {SEED}, "cases": [\n{rows}\n]}}\n')


def check(folder):
    for name, again in ((TRAJECTORIES, judged), (STOPPING, measured)):
        for number, case in enumerate(json.loads((folder / name).read_text())["cases"]):
            if again(case) != case:
                sys.exit(f"{folder / name}: case {number} differs from what the reference computes")
            if name == TRAJECTORIES and number % 8 == 0:
                check_motion(case)


if __name__ == "__main__":
    (check if sys.argv[1] == "--check" else write)(pathlib.Path(sys.argv[-1]))
