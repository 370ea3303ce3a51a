#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Slow reference for discs, closest approaches and half-planes of acceleration-velocity obstacles.

Written from Eqs. (9)-(12), (15) and (16) of the paper alone; shares no code with the library.

    obstacle_reference.py SEED FOLDER           writes discs.json, closest_approach.json, half_planes.json
    obstacle_reference.py --check FOLDER        compares the cases there; of half-planes every 12th
    obstacle_reference.py --check-all FOLDER    all of them, some minutes

All is relative, A minus B, in meters and seconds: p position, v velocity, r sum of the radii, delta, tau;
v' = v + w is the new velocity, of which |w| <= R = delta (a_A + a_B) can be reached. Under it

    x(t) = p + t v + g(t) w,   x'(t) = v + E(t) w,   E = 1 - e^{-t/delta},  g = t - delta E.

disc: all v' with |x(t)| < r; x is affine in v', which is told from three of them. Tangents from the
origin by bisection along the circle.
closest approach: all minima of |x| in (0, tau) by sampling x . x' and bisection, and both ends.
half-plane: of all directions n the one in which the set {w: |w| <= R, |x(t)| < r for a t in (0, tau]}
reaches the least far, and how far. The set is sampled by times; for each it is the intersection of two
discs, whose farthest point is on top of one of them or where their circles cross.
"""
import cmath
import json
import math
import pathlib
import random
import sys

COUNTS = {"discs": 200, "closest_approach": 400, "half_planes": 300}
FREE = 40  # of the half-planes, cases without one
TOLERANCE = 1e-6  # of positions, times and offsets; numbers of the discs relative to their size
GOLDEN = (math.sqrt(5.0) - 1.0) / 2.0


def response(t, delta):
    """(g, E), g without cancellation."""
    u = t / delta
    rate = -math.expm1(-u)
    if u > 0.5:
        return t - delta * rate, rate
    term, gain, n = 0.5 * u * u, 0.0, 2
    while gain + term != gain:
        gain += term
        n += 1
        term *= -u / n
    return delta * gain, rate


def position(case, v_new, t):
    """x(t), as a complex number like all vectors here."""
    gain, _ = response(t, case["delta"])
    return case["p"] + t * case["v"] + gain * (v_new - case["v"])


def dot(a, b):
    return a.real * b.real + a.imag * b.imag


def bisected(is_low, low, high):
    for _ in range(200):
        middle = 0.5 * (low + high)
        if middle in (low, high):
            break
        low, high = (middle, high) if is_low(middle) else (low, middle)
    return 0.5 * (low + high)


def maximized(f, low, high, rounds=60):
    """(largest value, its place) by golden section, of f with one maximum between low and high."""
    a, b = high - GOLDEN * (high - low), low + GOLDEN * (high - low)
    f_a, f_b = f(a), f(b)
    for _ in range(rounds):
        if f_a >= f_b:
            high, b, f_b = b, a, f_a
            a = high - GOLDEN * (high - low)
            f_a = f(a)
        else:
            low, a, f_a = a, b, f_b
            b = low + GOLDEN * (high - low)
            f_b = f(b)
    return max((f_a, a), (f_b, b))


def disc(case):
    at_zero, at_one = (position(case, v_new, case["t"]) for v_new in (0, 1))
    scale = (at_one - at_zero).real  # x per v'
    center, radius = -at_zero / scale, case["r"] / scale
    if abs(center) <= radius:
        return {"centre": center, "radius": radius, "tangents": None}
    tangents = []
    towards = -center / abs(center)
    for side in (-1, 1):  # left of the way from the origin first
        def touching(angle):
            return center + radius * towards * cmath.exp(1j * side * angle)
        # before the tangent's point the circle comes nearer to the origin's side of its radius
        angle = bisected(lambda a: dot(touching(a), touching(a) - center) < 0.0, 0.0, math.pi)
        tangents.append(touching(angle))
    return {"centre": center, "radius": radius, "tangents": tangents}


def closest_approach(case, samples=1000):
    v_new, tau = case["v_new"], case["tau"]

    p, v, change, delta = case["p"], case["v"], v_new - case["v"], case["delta"]

    def closing(t):
        gain, rate = response(t, delta)
        return dot(p + t * v + gain * change, v + rate * change) < 0.0

    times = [tau * (k / samples) ** 2 for k in range(samples + 1)]
    signs = [closing(t) for t in times]
    places = [0.0, tau]
    for k in range(samples):
        if signs[k] and not signs[k + 1]:
            places.append(bisected(closing, times[k], times[k + 1]))
    distance, time = min((abs(position(case, v_new, t)), t) for t in places)
    return {"time": time, "distance": distance, "collides": distance < case["r"]}


class Reachable:
    """{w: |w| <= R, collides at a time in (0, tau]} as sampled intersections of two discs."""

    def __init__(self, case, samples=360):
        self.case = case
        self.reach = case["delta"] * (case["max_acceleration_a"] + case["max_acceleration_b"])
        self.times = [case["tau"] * (k / samples) ** 2 for k in range(1, samples + 1)]
        self.lenses = [self.lens(t) for t in self.times]
        self.empty = all(lens is None for lens in self.lenses)

    def lens(self, t):
        """Center and radius of the disc of time t, in w, and where it crosses |w| = R."""
        gain, _ = response(t, self.case["delta"])
        center = -(self.case["p"] + t * self.case["v"]) / gain
        radius, distance = self.case["r"] / gain, abs(center)
        if distance >= radius + self.reach:
            return None
        crossings = ()
        if distance > abs(radius - self.reach):
            along = (distance * distance + self.reach**2 - radius * radius) / (2.0 * distance)
            half = math.sqrt(max(0.0, self.reach**2 - along * along))
            crossings = tuple(center / distance * complex(along, side * half) for side in (-1, 1))
        return center, radius, crossings

    def farthest(self, lens, n):
        """Largest n . w in both discs."""
        if lens is None:
            return -math.inf
        center, radius, crossings = lens
        top = self.reach * n
        if abs(top - center) <= radius:
            return self.reach
        top = center + radius * n
        if abs(top) <= self.reach:
            return dot(top, n)
        return max(dot(crossing, n) for crossing in crossings)

    def support(self, angle, exact):
        n = cmath.exp(1j * angle)
        values = [self.farthest(lens, n) for lens in self.lenses]
        best = max(values)
        if not exact:
            return best
        found = best
        for k, value in enumerate(values):
            before = values[k - 1] if k > 0 else -math.inf
            after = values[k + 1] if k + 1 < len(values) else -math.inf
            if value >= max(before, after) and value > best - 1e-2 * self.reach:
                low = self.times[k - 1] if k > 0 else 0.5 * self.times[0]
                high = self.times[min(k + 1, len(self.times) - 1)]
                found = max(found, maximized(lambda t: self.farthest(self.lens(t), n), low, high, 40)[0])
        return found

    def least(self, directions=180):
        """(offset, angle) of the half-plane, and by how much the next best direction is worse."""
        step = 2.0 * math.pi / directions
        values = [self.support(k * step, False) for k in range(directions)]
        minima = [k for k in range(directions)
                  if values[k] <= min(values[k - 1], values[(k + 1) % directions])]
        found = []
        for k in sorted(minima, key=values.__getitem__)[:3]:
            value, angle = maximized(lambda a: -self.support(a, True), (k - 1) * step, (k + 1) * step, 32)
            found.append((-value, angle))
        found.sort()
        apart = [s for s, angle in found if abs(math.remainder(angle - found[0][1], 2 * math.pi)) > 0.02]
        return found[0], min(apart, default=math.inf) - found[0][0]


def half_plane(case):
    reachable = Reachable(case)
    if reachable.empty:
        return {"constraint": False}
    (offset, angle), _ = reachable.least()
    return {"constraint": True, "normal": cmath.exp(1j * angle), "offset": offset}


RESULTS = {"discs": disc, "closest_approach": closest_approach, "half_planes": half_plane}


def is_clear(name, case):
    """Does no rounding decide what the case's result is?"""
    if name == "closest_approach":
        return abs(case["distance"] - case["r"]) > 1e-3
    if name == "half_planes" and case["constraint"]:
        reachable = Reachable(case)
        (offset, _), lead = reachable.least()
        return lead > 1e-3 and abs(offset - reachable.reach) > 1e-3
    return True


def drawn(name, rng):
    r = rng.uniform(0.2, 2.0)
    case = {"p": cmath.rect(1.05 * r + 14.0 * rng.random() ** 2, rng.uniform(-math.pi, math.pi)),
            "v": complex(rng.uniform(-3, 3), rng.uniform(-3, 3)), "r": r, "delta": rng.uniform(0.3, 5.0)}
    if name == "discs":
        return {**case, "t": rng.uniform(1e-3, 12.0)}
    case["tau"] = rng.uniform(1.0, 12.0)
    if name == "closest_approach":
        return {**case, "v_new": complex(rng.uniform(-4, 4), rng.uniform(-4, 4))}
    return {**case, "max_acceleration_a": rng.uniform(0.3, 3.0), "max_acceleration_b": rng.uniform(0.3, 3.0)}


def generated(name, seed):
    rng = random.Random(f"{name} {seed}")
    cases, free = [], 0
    while len(cases) < COUNTS[name]:
        case = drawn(name, rng)
        case.update(RESULTS[name](case))
        if not is_clear(name, case) or case.get("constraint") is False and free == FREE:
            continue
        free += case.get("constraint") is False
        cases.append(case)
    return cases


def as_json(value):
    if isinstance(value, complex):
        return [value.real, value.imag]
    return [as_json(part) for part in value] if isinstance(value, list) else value


def from_json(value):
    if isinstance(value, list):
        return complex(*value) if isinstance(value[0], float) else [from_json(part) for part in value]
    return value


def differs(there, here, allowed):
    """Not the same up to `allowed`; None, true and false exactly."""
    if isinstance(there, list) and isinstance(here, list):
        return any(differs(a, b, allowed) for a, b in zip(there, here))
    if None in (there, here) or isinstance(there, bool):
        return there != here
    return not abs(there - here) <= allowed


def write(seed, folder):
    for name in COUNTS:
        cases = [{key: as_json(value) for key, value in case.items()} for case in generated(name, seed)]
        (folder / f"{name}.json").write_text(json.dumps({"seed": seed, "cases": cases}, indent=0))


def check(folder, all_of_them):
    for name, result in RESULTS.items():
        cases = json.loads((folder / f"{name}.json").read_text())["cases"]
        every = 12 if name == "half_planes" and not all_of_them else 1
        for number in range(0, len(cases), every):
            case = {key: from_json(value) for key, value in cases[number].items()}
            for key, value in result(case).items():
                # a normal is where a minimum is, which is known less well than the minimum
                allowed = TOLERANCE * max(1.0, abs(case.get("centre", 0.0))) * (2 if key == "normal" else 1)
                if differs(case.get(key), value, allowed):
                    sys.exit(f"{name}.json: case {number}: found {key} {case.get(key)}, must be {value}")
        print(f"{name}: {len(range(0, len(cases), every))} of {len(cases)} cases agree")


if __name__ == "__main__":
    first, path = sys.argv[1], pathlib.Path(sys.argv[2])
    if first.startswith("--check"):
        check(path, first == "--check-all")
    else:
        write(int(first), path)
