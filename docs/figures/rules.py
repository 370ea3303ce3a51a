#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Draws the figures of docs/arrival.md, one of each rule: docs/figures/rules.py [FOLDER]

Lengths are in radii r of the robots and to scale with the constants of the sources, which are read."""
import math
import pathlib
import re
import sys

from drawing import BLACK, BLUE, GRAY, RED, ROOT, Figure, arc, constants, polar

K = constants("planner/arrival.h", "planner/arrival_kernel.h", "planner/arrival.cpp", "navigation/gaps.cpp",
              "navigation/passages.cpp", "navigation/right_of_way.h", "navigation/right_of_way.cpp")
DOOR = 3.2  # r, the width of a door: 1.6 m for r = 0.5 m


def keep_right():
    figure = Figure("keep-right", "The wish is turned to the right by traffic ahead", 760, 320)
    figure.view((110, 150), 48)
    reach = 12.0  # 1.5 L for r = 0.5 m, v_max = 2 m/s, a_max = 1 m/s²
    figure.area(arc((0, 0), reach, -math.pi / 2, math.pi / 2), BLUE, 0.5)
    figure.line([(0, -3), (0, 3)], GRAY, 1, dashed=True)
    figure.line(arc((0, 0), reach, -0.25, 0.25), GRAY, 1, dashed=True)
    congestion = 0.0
    for place, velocity in (((3.8, 1.8), None), ((5.6, -1.7), (-1.6, 0.2)), ((7.9, 0.5), (-1.6, -0.2)),
                            ((9.9, -1.4), (-1.6, 0.0)), ((6.6, 2.1), (1.7, 0.1)), ((-1.2, -2.0), (1.6, 0.0))):
        counts = place[0] > 0 and (velocity is None or velocity[0] < 0)
        weight = 1.0 - math.hypot(*place) / reach if counts else 0.0
        congestion += weight
        figure.robot(place, RED if counts else GRAY, f"{weight:.2f}" if counts else "0", velocity, shift=(0, -14))
    angle = -K.kMostKeepRight * min(congestion / K.kCongestion, 1.0)
    figure.robot((0, 0), BLUE)
    figure.arrow((0, 0), (3, 0), GRAY, dashed=True)
    figure.arrow((0, 0), polar(angle, 3), BLUE)
    figure.line(arc((0, 0), 1.8, 0, angle), BLUE, 1)
    figure.text((3, 0), "preferred velocity", GRAY, dx=6, dy=4)
    figure.text(polar(angle, 3), "wish", BLUE, dx=4, dy=14)
    figure.text((3.8, 1.8), "at rest", RED, "middle", dy=66)
    figure.text((12, 2.6), "range 1.5 L", GRAY, "middle", dx=10)
    figure.text((12, 2.6), "(or 6 r)", GRAY, "middle", dx=10, dy=17)
    figure.text((-2, -3.3), f"angle = {math.degrees(K.kMostKeepRight):.0f}° · min(Σ / {K.kCongestion}, 1), with Σ the sum "
                f"of the weights 1 − d/range: here Σ = {congestion:.2f}, {-math.degrees(angle):.0f}°")
    return figure


def graph(figure, origin, width, xs, points, x_name, y_name):
    """y from 0 to 1 over x; xs: (x, text) of the ticks."""
    figure.view(origin, 1.0)
    scale = width / xs[-1][0]
    figure.line([(0, 0), (width + 12, 0)], BLACK, 1, False, "end")
    figure.line([(0, 0), (0, 78)], BLACK, 1, False, "end")
    figure.line([(0, 60), (-4, 60)], BLACK, 1)
    figure.text((0, 60), "1", BLACK, "end", -8, 5)
    for x, text in xs:
        figure.line([(scale * x, 0), (scale * x, -4)], BLACK, 1)
        figure.text((scale * x, 0), text, BLACK, "middle", 0, 18)
    figure.line([(scale * x, 60 * y) for x, y in points], BLUE, 2.5)
    figure.text((width, 0), x_name, BLACK, "end", 0, 36)
    figure.text((10, 78), y_name, BLACK, "start", 0, 4)


def give_way():
    figure = Figure("give-way", "A robot gives way to a neighbor that is nearly in contact", 760, 330)
    figure.view((150, 185), 52)
    a, b = (0, 0), (1.66, 1.62)
    figure.circle(a, 1 + 2 * K.kRoom, GRAY, dashed=True)
    figure.robot(b, RED, "B", (-1.5, 0.1), shift=(16, 0))
    figure.robot(a, BLUE, "A", shift=(16, 0))
    figure.cross(a, BLUE, 0.15)
    away = (-1.7 * b[0] / math.hypot(*b), -1.7 * b[1] / math.hypot(*b))
    figure.arrow(a, away, BLUE)
    figure.text((-1.7, -2.0), f"added to the wish: up to {K.kPush:g} v_max,", BLUE, dx=-40, dy=0)
    figure.text((-1.7, -2.0), "times nearness, weight and patience", BLUE, dx=-40, dy=18)
    figure.length((1, 0), (1 + 2 * K.kRoom, 0), f"{K.kRoom:g} (r_A + r_B)", "start", 18, 5)
    least = K.kLeastWeight
    graph(figure, (430, 130), 290, ((0, "0"), ((1 - least) * K.kLeash, f"{(1 - least) * K.kLeash:g}"), (K.kLeash, f"{K.kLeash:g}"), (6, "6")),
          ((0, 1), ((1 - least) * K.kLeash, least), (6, least)),
          "distance to the goal / (r_A + r_B)", f"weight: 1 at the goal, {least:g} on the way")
    last = K.kSettled * K.kYields
    graph(figure, (430, 282), 290, ((0, "0"), (K.kYields, f"{K.kYields:g} T"), (last, f"{last:g} T: stays")),
          ((0, 1), (K.kYields, 0), (last, 0)), "time beside others", "patience near the goal")
    return figure


def detour():
    figure = Figure("detour", "A blocked robot turns its wish to the right, more and more", 760, 360)
    figure.view((150, 130), 36)
    for place in ((2.2, 0.5), (4.3, 0.9), (3.1, 2.4), (1.0, 2.2), (4.4, -1.3)):
        figure.robot(place, GRAY)
    figure.robot((0, 0), BLUE)
    for k in range(5):
        angle = k * K.kMostDetour / 4
        figure.arrow((0, 0), polar(-angle, 3.3), GRAY if k == 0 else BLUE, dashed=k == 0)
        x, y = polar(-angle, 3.3)
        name = "wish" if k == 0 else f"{angle / K.kTurnOff:.1f} T"
        figure.text((x, y), name, GRAY if k == 0 else BLUE, "middle", 14 if k < 2 else -6, -8 if k == 0 else 18)
    figure.line(arc((0, 0), 1.6, -0.05, -K.kMostDetour), BLUE, 1, False, "end")
    figure.text((-3.7, -5), f"while blocked: {K.kTurnOff:g} rad per T, up to {K.kMostDetour:g} rad", BLUE)
    figure.text((-3.7, -5.5), f"once free: back by {K.kTurnBack:g} rad per T", BLUE)
    figure.text((-3.7, 3.1), "(a) the detour")

    figure.view((525, 180), 56)
    reach, h, m = 2.0, 0.45, polar(0.35)
    side = lambda along, off=0.0: (h * m[0] + off * m[0] - along * m[1], h * m[1] + off * m[1] + along * m[0])
    half = math.sqrt(reach ** 2 - h ** 2)
    figure.area(arc((0, 0), reach, 0.35 - math.acos(h / reach), 0.35 + math.acos(h / reach)), RED)
    figure.circle((0, 0), reach, BLACK, dashed=True)
    figure.line([side(-half), side(half)], RED, 2)
    figure.arrow((0, 0), (3.3, 0), GRAY, dashed=True)
    figure.line([(K.kBlocked * reach, -2.4), (K.kBlocked * reach, 2.4)], BLUE, 1.5, dashed=True)
    gain = reach * m[0] - h
    chosen = (reach - gain * m[0], -gain * m[1])
    figure.dot((0, 0)), figure.dot((reach, 0), GRAY, 4.5), figure.dot(chosen, BLUE, 4.5)
    figure.text((0, 0), "v", BLACK, "end", -6, 14)
    figure.text((reach, 0), "unhindered", GRAY, dx=6, dy=18)
    figure.text((3.3, 0), "wish", GRAY, "middle", 0, -8)
    figure.text(chosen, "next", BLUE, "end", -8, 10)
    figure.text((1.15, 1.1), "not admitted", RED, dx=-4)
    figure.text((K.kBlocked * reach, 2.4), "half of unhindered", BLUE, "middle", 0, -6)
    figure.text((-1.1, 0.9), "admitted", BLACK, "middle")
    figure.text((-2.3, -2.9), f"(b) velocities of one step: blocked, as next")
    figure.text((-2.3, -3.2), "has less than half of unhindered along the wish", dx=24)
    figure.text((-3.0, 2.75), "")
    return figure


def office_walls():
    text = (ROOT / "scenarios/office.yaml").read_text()
    walls = []
    for chain in re.findall(r"\(([-\d.,\s]+)\)", text):
        points = [tuple(map(float, point.split())) for point in chain.split(",")]
        walls += list(zip(points, points[1:]))
    return walls


def nearest_on(wall, p):
    (ax, ay), (bx, by) = wall
    d = (bx - ax, by - ay)
    t = ((p[0] - ax) * d[0] + (p[1] - ay) * d[1]) / (d[0] ** 2 + d[1] ** 2)
    t = min(max(t, 0.0), 1.0)
    return ax + t * d[0], ay + t * d[1]


def side_of(line, p):
    (ax, ay), (bx, by) = line
    return (bx - ax) * (p[1] - ay) - (by - ay) * (p[0] - ax)


def cross_each_other(one, other):
    return side_of(one, other[0]) * side_of(one, other[1]) < 0 and side_of(other, one[0]) * side_of(other, one[1]) < 0


def middle(gap):
    return (gap[0][0] + gap[1][0]) / 2, (gap[0][1] + gap[1][1]) / 2


def gaps_between(walls, radius):
    """As src/navigation/gaps.cpp finds them for robots of one radius."""
    all_gaps = set()
    for end in {end for wall in walls for end in wall}:
        for wall in walls:
            gap = tuple(sorted((end, nearest_on(wall, end))))
            width = math.dist(*gap)
            if not 2 * radius <= width + 1e-9 < K.kTwoLanes * radius:
                continue
            m = middle(gap)
            if min(math.dist(m, nearest_on(other, m)) for other in walls) >= width / 2 - 1e-9:
                all_gaps.add(gap)
    return sorted(gap for gap in all_gaps
                  if not any(cross_each_other(gap, other) and math.dist(*other) <= math.dist(*gap) for other in all_gaps))


def passages():
    figure = Figure("passages", "The passages of an office with doors of one lane and a corridor of two", 760, 330)
    radius = 0.5
    walls = office_walls()
    figure.view((20, 140), 15.5)
    for wall in walls:
        figure.line(wall, BLACK, 3)
    corridor = []
    for gap in gaps_between(walls, radius):
        two_lanes = math.dist(*gap) >= K.kOneLane * radius
        color, (x, y) = BLUE if two_lanes else RED, middle(gap)
        figure.line(gap, color, 2)
        if two_lanes:
            corridor.append((x, y))
            continue
        reach = K.kMouth * radius  # the doors lead up and down
        figure.line([(x, y - reach), (x, y + reach)], RED, 1.5, False)
        figure.dot((x, y - reach), RED, 3), figure.dot((x, y + reach), RED, 3)
    reach = K.kMouth * radius
    ends = [(corridor[0][0] - reach, 0), (corridor[-1][0] + reach, 0)]
    figure.line(ends, BLUE, 1.5, dashed=True)
    for end in ends:
        figure.dot(end, BLUE, 3)
    figure.view((20, 310), 1)
    figure.line([(0, 32), (24, 32)], RED, 3), figure.line([(0, 8), (24, 8)], BLUE, 3)
    figure.text((32, 27), f"gap of one lane, 2 r ≤ width &lt; {K.kOneLane:g} r: a door", RED)
    figure.text((32, 3), f"gap of two lanes, {K.kOneLane:g} r ≤ width &lt; {K.kTwoLanes:g} r; together they make the corridor", BLUE)

    figure.view((635, 150), 31)
    half = DOOR / 2
    figure.wall((-3.4, 0), (-half, 0)), figure.wall((half, 0), (3.4, 0))
    figure.line([(-half, 0), (half, 0)], RED, 3)
    figure.line([(0, -K.kMouth), (0, K.kMouth)], RED, 2)
    for sign in (-1, 1):
        figure.dot((0, sign * K.kMouth), RED, 4.5)
    figure.text((0, K.kMouth), "mouth", RED, "middle", 0, -10)
    figure.text((0, -K.kMouth), "mouth", RED, "middle", 0, 20)
    figure.text((0, -0.65), "axis", RED, "end", -6, 4)
    figure.text((-half, 0), "gap", RED, "middle", 20, -8)
    figure.length((0.8, 0), (0.8, K.kMouth), f"{K.kMouth:g} r", "start", 8, 4)
    figure.length((-half, -2.5), (half, -2.5), "width", "middle", 0, 18)
    return figure


def lanes():
    figure = Figure("lanes", "Each direction of a passage of two lanes keeps to its right-hand lane", 760, 300)
    figure.view((70, 140), 46)
    half = 2.4  # r: 2.4 m for r = 0.5 m
    offset = max(0.5 * half, min(K.kLane, half - 1 - K.kLaneRoom))
    figure.wall((-1.4, half), (14.5, half)), figure.wall((-1.4, -half), (14.5, -half))
    figure.line([(-1.4, 0), (14.5, 0)], GRAY, 1, dashed=True)
    for sign, color in ((-1, BLUE), (1, RED)):
        figure.line([(-1.4, sign * offset), (14.5, sign * offset)], color, 1, dashed=True)
    figure.robot((0.3, 0.5), BLUE, "A", shift=(-18, 0))
    target = (3.3, -offset)
    figure.dot((3.3, 0), GRAY), figure.dot(target, BLUE, 4.5)
    figure.line([(0.3, 0.5), (3.3, 0.0)], GRAY, 1.5, dashed=True)
    figure.arrow((0.3, 0.5), target, BLUE)
    figure.line([(3.3, 0), target], GRAY, 1)
    figure.text((1.9, 0.35), "3 r of the way", GRAY, "start", -6, -10)
    figure.text(target, "where A heads", BLUE, dx=-20, dy=26)
    figure.robot((8.2, -offset), BLUE, "", (2.0, 0))
    figure.robot((9.4, offset), RED, "", (-2.0, 0))
    figure.robot((6.0, offset), RED, "", (-2.0, 0))
    figure.length((12.0, 0), (12.0, -offset), f"lane, {offset:g} r from the axis", "middle", 0, 46)
    figure.length((13.6, -half), (13.6, half), "", "start")
    figure.text((13.6, half), f"{2 * half:g} r", BLACK, "middle", 0, -10)
    figure.text((10.6, 0), "axis", GRAY, "middle", 0, -5)
    figure.length((8.2, -half), (8.2, -offset - 1), "", "start")
    figure.text((8.2, -half), f"{half - offset - 1:.1f} r", BLACK, "middle", 0, 20)
    return figure


def doorway(figure, top, bottom):
    """A door in a wall across x = 0, its mouths at x = ±kMouth."""
    half = DOOR / 2
    figure.wall((0, half), (0, top)), figure.wall((0, -half), (0, bottom))
    figure.line([(-K.kMouth, 0), (K.kMouth, 0)], GRAY, 1, dashed=True)
    figure.dot((-K.kMouth, 0), GRAY), figure.dot((K.kMouth, 0), GRAY)


def right_of_way():
    figure = Figure("right-of-way", "Who enters a passage of one lane", 760, 300)
    for x, inside in ((195, False), (570, True)):
        figure.view((x, 125), 26)
        doorway(figure, 3.6, -3.6)
        a, b = ((0.3, 0.0) if inside else (-4.4, -0.9)), ((4.4, 0.9) if inside else (6.0, 1.3))
        figure.robot(a, BLUE, "A", (2.2, 0.0 if inside else 0.4), shift=(-10, -14) if inside else (-8, -12))
        figure.robot(b, RED, "B", (-2.0, -0.5), shift=(8, -12))
        if not inside:
            figure.line([a, (-K.kMouth, 0)], BLUE, 1, dashed=True)
            figure.text((-2.6, -0.5), "d_A", BLUE, "middle", 0, 22)
        figure.line([b, (K.kMouth, 0)], RED, 1, dashed=True)
        figure.text((2.4, 0.3), "d_B", RED, "middle", 0, -8)
    figure.view((195, 125), 26)
    figure.text((-6.6, -4.5), f"(a) within {K.kClaimRange:g} r of their mouths, both")
    figure.text((-6.6, -4.5), "claim it by moving there: A enters and", dx=24, dy=19)
    figure.text((-6.6, -4.5), "B waits, as d_A &lt; d_B", dx=24, dy=38)
    figure.view((570, 125), 26)
    figure.text((-6.2, -4.5), "(b) A is inside: B waits, at whatever")
    figure.text((-6.2, -4.5), "distance; who follows A may enter", dx=24, dy=19)
    return figure


def wait():
    figure = Figure("wait", "Where to wait before a passage of one lane", 760, 440)
    figure.view((450, 175), 40)
    mouth = K.kMouth  # the mouth lies in 0, the door behind it
    top, bottom = 4.2, -6.4
    figure.area([(-K.kDeep, top), (mouth, top), (mouth, -K.kLeft), (-K.kDeep, -K.kLeft)], RED)
    figure.line([(-K.kDeep, top), (-K.kDeep, -K.kLeft), (mouth, -K.kLeft)], RED, 1.5, dashed=True)
    figure.wall((mouth, DOOR / 2), (mouth, top)), figure.wall((mouth, -DOOR / 2), (mouth, bottom))
    figure.line([(0, 0), (2 * mouth, 0)], GRAY, 1, dashed=True)
    figure.dot((0, 0))
    figure.text((0, 0), "mouth", BLACK, "start", -6, -8)
    figure.line(arc((0, 0), K.kQueue, -math.pi / 2 - 0.75, -math.pi / 2 + 0.6), BLUE, 1.5, dashed=True)
    figure.text((-3.3, 3.5), "kept clear for those who come out", RED, "middle", 20)
    figure.robot((2.0, 0.2), RED, "", (-2.2, 0.9))
    out = 2.6
    figure.robot((-out, -0.2), BLUE, "A", shift=(-18, 0))
    figure.line([(-K.kLeastBay, -K.kBay), (-7.6, -K.kBay)], BLUE, 1.5)
    figure.dot((-K.kLeastBay, -K.kBay), BLUE, 4.5)
    figure.arrow((-out, -0.2), (-out, -K.kBay), BLUE)
    figure.ghost((-out, -K.kBay), BLUE)
    figure.text((-5.6, -K.kBay), "bay: A goes there, straight aside", BLUE, "middle", -4, 20)
    figure.robot((-K.kDeep - 1.6, 0.3), BLUE, "C", (1.5, -0.1), shift=(-18, 0))
    figure.text((-K.kDeep, 1.9), "C stops", BLUE, "end", -8, 0)
    figure.text((-K.kDeep, 1.9), "before this line", BLUE, "end", -8, 18)
    figure.robot((-0.9, -5.3), BLUE, "D", (0.3, 1.6), shift=(-18, 0))
    figure.text((-2.1, -5.3), "D stops before this arc", BLUE, "end", 0, 0)
    figure.line([(-2.0, -5.0), (-1.35, -2.0)], BLUE, 1) if False else None
    figure.length((-K.kDeep, 2.7), (0, 2.7), f"{K.kDeep:g} r")
    figure.line([(0, 0.5), (0, 3.0)], GRAY, 1, dashed=True)
    figure.length((-5.2, 0), (-5.2, -K.kLeft), f"{K.kLeft:g} r", "start", 8, 5)
    figure.line([(-5.5, 0), (0, 0)], GRAY, 1, dashed=True)
    figure.length((0.75, 0), (0.75, -K.kBay), f"{K.kBay:g} r", "start", 8, 30)
    figure.line([(-K.kLeastBay, -K.kBay), (1.0, -K.kBay)], GRAY, 1, dashed=True)
    figure.length((-K.kLeastBay, -3.7), (0, -3.7), f"{K.kLeastBay:g} r", "middle", 0, 18)
    return figure


def go_back():
    figure = Figure("go-back", "Where both directions are inside, the one that has come less far goes back", 760, 300)
    figure.view((60, 130), 34)
    length, half = 15.0, DOOR / 2
    first, last = K.kMouth, length - K.kMouth
    for sign in (-1, 1):
        figure.wall((first, sign * 3.2), (first, sign * half), (last, sign * half), (last, sign * 3.2))
    figure.line([(0, 0), (length, 0)], GRAY, 1, dashed=True)
    figure.dot((0, 0)), figure.dot((length, 0))
    figure.robot((7.9, 0), BLUE, "A", (1.7, 0), shift=(-16, 0))
    figure.robot((5.2, 0), BLUE, "", (1.7, 0))
    figure.robot((11.4, 0), RED, "B", (1.5, 0), shift=(-16, 0))
    figure.robot((14.4, 0.0), RED, "C", shift=(-14, 0))
    straight, aside = (length + K.kBack, 0), (length + K.kBack, K.kBackAside)
    figure.arrow((14.4, 0.0), aside, RED)
    figure.dot(straight, RED, 4.5), figure.dot(aside, RED, 4.5)
    figure.length((0, -2.5), (7.9, -2.5), "")
    figure.length((length, -2.5), (11.4, -2.5), "")
    return figure


def behind_walls():
    figure = Figure("behind-walls", "A neighbor behind a wall does not count where the way round is long", 760, 330)
    figure.view((150, 170), 40)
    return figure


FIGURES = (keep_right, give_way, detour, passages, lanes, right_of_way, wait, go_back, behind_walls)


def main():
    folder = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else ROOT / "docs/figures")
    for draw in FIGURES:
        figure = draw()
        (folder / f"rule-{figure.name}.svg").write_text(figure.svg(), encoding="utf-8")


if __name__ == "__main__":
    main()
