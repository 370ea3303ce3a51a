# SPDX-License-Identifier: Apache-2.0
"""The rules for arriving among walls, one function for each figure.

r is the radius of the robots, and R that of a passage: of the largest robots that fit."""
import math
import re

from drawing import BLACK, BLUE, GRAY, RED, ROOT, Figure, arc, constants, polar

WALLS = constants("navigation/gaps.cpp", "navigation/join_gaps.cpp",
                  "navigation/passages.h", "navigation/passages.cpp", "navigation/rules/keep_lane.cpp",
                  "navigation/right_of_way.h", "navigation/right_of_way.cpp", "navigation/rules/passage_rules.h",
                  "navigation/rules/passage_rules.cpp", "navigation/rules/wait_beside.cpp",
                  "guidance/rules/go_around.cpp", "guidance/rules/go_back.cpp")
DOOR = 3.2  # r, the width of a door: 1.6 m for r = 0.5 m


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
            if not 2 * radius <= width + 1e-9 < WALLS.kTwoLanes * radius:
                continue
            m = middle(gap)
            if min(math.dist(m, nearest_on(other, m)) for other in walls) >= width / 2 - 1e-9:
                all_gaps.add(gap)
    return sorted(gap for gap in all_gaps
                  if not any(cross_each_other(gap, other) and math.dist(*other) <= math.dist(*gap)
                             for other in all_gaps))


def passages():
    figure = Figure("passages", "The passages of an office with doors of one lane and a corridor of two", 760, 330)
    radius = 0.5
    walls = office_walls()
    figure.view((20, 140), 15.5)
    for wall in walls:
        figure.line(wall, BLACK, 3)
    corridor = []
    for gap in gaps_between(walls, radius):
        two_lanes = math.dist(*gap) >= WALLS.kOneLane * radius
        color, (x, y) = BLUE if two_lanes else RED, middle(gap)
        figure.line(gap, color, 2)
        if two_lanes:
            corridor.append((x, y))
            continue
        reach = WALLS.kMouth * radius  # the doors lead up and down
        figure.line([(x, y - reach), (x, y + reach)], RED, 1.5, False)
        figure.dot((x, y - reach), RED, 3), figure.dot((x, y + reach), RED, 3)
    reach = WALLS.kMouth * radius
    ends = [(corridor[0][0] - reach, 0), (corridor[-1][0] + reach, 0)]
    figure.line(ends, BLUE, 1.5, dashed=True)
    for end in ends:
        figure.dot(end, BLUE, 3)
    figure.view((20, 310), 1)
    figure.line([(0, 32), (24, 32)], RED, 3), figure.line([(0, 8), (24, 8)], BLUE, 3)
    figure.text((32, 27), f"gap of one lane, 2 R ≤ width &lt; {WALLS.kOneLane:g} R: a door", RED)
    figure.text((32, 3), f"gap of two lanes, {WALLS.kOneLane:g} R ≤ width &lt; {WALLS.kTwoLanes:g} R: "
                "one after the other they make the corridor", BLUE)

    figure.view((635, 150), 31)
    half = DOOR / 2
    figure.wall((-3.4, 0), (-half, 0)), figure.wall((half, 0), (3.4, 0))
    figure.line([(-half, 0), (half, 0)], RED, 3)
    figure.line([(0, -WALLS.kMouth), (0, WALLS.kMouth)], RED, 2)
    for sign in (-1, 1):
        figure.dot((0, sign * WALLS.kMouth), RED, 4.5)
    figure.text((0, WALLS.kMouth), "mouth", RED, "middle", 0, -10)
    figure.text((0, -WALLS.kMouth), "mouth", RED, "middle", 0, 20)
    figure.text((0, -0.65), "axis", RED, "end", -6, 4)
    figure.text((-half, 0), "gap", RED, "middle", 20, -8)
    figure.length((0.8, 0), (0.8, WALLS.kMouth), f"{WALLS.kMouth:g} R", "start", 8, 4)
    figure.length((-half, -2.5), (half, -2.5), "width", "middle", 0, 18)
    return figure


def lanes():
    figure = Figure("lanes", "Each direction of a passage of two lanes keeps to its right-hand lane", 760, 290)
    figure.view((70, 142), 46)
    half = 2.4  # r: a corridor of 2.4 m for r = 0.5 m
    offset = max(0.5 * half, min(WALLS.kLane, half - 1 - WALLS.kLaneRoom))
    figure.wall((-1.4, half), (14.9, half)), figure.wall((-1.4, -half), (14.9, -half))
    figure.line([(-1.4, 0), (14.9, 0)], GRAY, 1, dashed=True)
    for sign, color in ((-1, BLUE), (1, RED)):
        figure.line([(-1.4, sign * offset), (14.9, sign * offset)], color, 1, dashed=True)
    ahead, target = (3.3, 0), (3.3, -offset)
    figure.robot((0.3, 0.1), BLUE, "A", shift=(-18, 0))
    figure.line([(0.3, 0.1), ahead], GRAY, 2)
    figure.line([ahead, target], GRAY, 1)
    figure.arrow((0.3, 0.1), target, BLUE)
    figure.dot(ahead, GRAY), figure.dot(target, BLUE, 4.5)
    figure.text((2.3, 0.1), f"{WALLS.kAhead:g} r of the way", GRAY, "middle", 12, -10)
    figure.text(target, "where A heads", BLUE, dx=-20, dy=26)
    figure.robot((8.2, -offset), BLUE, "", (2.0, 0))
    figure.robot((8.2, offset), RED, "", (-2.0, 0))
    figure.robot((4.8, offset), RED, "", (-2.0, 0))
    figure.length((11.4, 0), (11.4, -offset), f"{offset:g} R", "start", 8, 5)
    figure.length((13.7, -half), (13.7, half), f"{2 * half:g} R", "start", 8, -12)
    figure.text((10.2, 0), "axis", GRAY, "middle", 0, -5)
    figure.length((8.2, 1 - offset), (8.2, offset - 1), f"{2 * (offset - 1):g} R", "start", 8, 5)
    figure.text((8.2, -half), f"{half - offset - 1:.1f} R to the wall", BLACK, "middle", 0, 20)
    return figure


def doorway(figure, top, bottom):
    """A door in a wall across x = 0, its mouths at x = ±kMouth."""
    half = DOOR / 2
    figure.wall((0, half), (0, top)), figure.wall((0, -half), (0, bottom))
    figure.line([(-WALLS.kMouth, 0), (WALLS.kMouth, 0)], GRAY, 1, dashed=True)
    figure.dot((-WALLS.kMouth, 0), GRAY), figure.dot((WALLS.kMouth, 0), GRAY)


def right_of_way():
    figure = Figure("right-of-way", "Who enters a passage of one lane", 760, 270)
    outside = ((-4.6, -1.0), (6.0, 1.3))
    figure.view((205, 100), 26)
    doorway(figure, 3.5, -3.5)
    for (x, y), mouth, color, name in zip(outside, (-WALLS.kMouth, WALLS.kMouth), (BLUE, RED), "AB"):
        figure.line([(x, y), (mouth, 0)], color, 1, dashed=True)
        figure.text(((x + mouth) / 2, y / 2), f"d_{name}", color, "middle", 8, 22)
        figure.robot((x, y), color, name, polar(math.atan2(-y, mouth - x), 1.8), shift=(3 * x / 2, -12))
    figure.text((WALLS.kMouth, 0), "mouth", GRAY, "start", -4, 20)
    figure.view((560, 100), 26)
    doorway(figure, 3.5, -3.5)
    figure.robot((-0.4, 0.0), BLUE, "A", (2.4, 0.0), shift=(-10, -12))
    figure.robot((4.6, 1.2), RED, "B", (-1.7, -0.6), shift=(8, -12))
    figure.view((0, 270), 1)
    for x, lines in ((30, (f"(a) Both come, within {WALLS.kClaimRange:g} R of their mouths.",
                           "A enters and B waits, as d_A &lt; d_B.")),
                     (420, ("(b) A is inside: B waits,", "however near it is."))):
        for k, line in enumerate(lines):
            figure.text((x + 24 * k, 46 - 20 * k), line)
    return figure


def wait():
    figure = Figure("wait", "Where to wait before a passage of one lane", 620, 470)
    figure.view((425, 180), 44)
    wall = WALLS.kMouth  # the mouth is the origin, and the door lies behind it
    top, bottom, queue = 3.9, -6.4, -math.pi / 2
    figure.area([(-WALLS.kDeep, top), (wall, top), (wall, -WALLS.kAside), (-WALLS.kDeep, -WALLS.kAside)], RED)
    figure.line([(-WALLS.kDeep, top), (-WALLS.kDeep, -WALLS.kAside), (wall, -WALLS.kAside)], RED, 1.5, dashed=True)
    figure.wall((wall, DOOR / 2), (wall, top)), figure.wall((wall, -DOOR / 2), (wall, bottom))
    figure.line([(-5.9, 0), (2 * wall, 0)], GRAY, 1, dashed=True)
    figure.line([(0, 0), (0, 3.1)], GRAY, 1, dashed=True)
    figure.robot((2.1, 0.1), RED, "", (-2.2, 1.0))
    figure.dot((0, 0))
    figure.text((0, 0), "mouth", BLACK, "end", -6, -8)
    figure.text((-2.4, 3.35), "kept clear for those who come out", RED, "middle")
    figure.length((-WALLS.kDeep, 2.7), (0, 2.7), f"{WALLS.kDeep:g} R", dy=18)

    a = (-3.2, -0.3)
    figure.line([(-WALLS.kBayOut, -WALLS.kBayAside), (-8.4, -WALLS.kBayAside)], BLUE, 1.5)
    figure.line([(-WALLS.kBayOut, -WALLS.kBayAside), (0, -WALLS.kBayAside)], GRAY, 1, dashed=True)
    figure.dot((-WALLS.kBayOut, -WALLS.kBayAside), BLUE, 4.5)
    figure.robot(a, BLUE, "A", shift=(-18, 0))
    figure.ghost((a[0], -WALLS.kBayAside), BLUE)
    figure.arrow(a, (a[0], -WALLS.kBayAside), BLUE)
    figure.text((-8.4, -WALLS.kBayAside), "bay: A goes there,", BLUE, dy=20)
    figure.text((-8.4, -WALLS.kBayAside), "straight aside", BLUE, dy=38)
    figure.robot((-WALLS.kDeep - 1.7, 0.3), BLUE, "C", (1.6, -0.1), shift=(-18, 0))
    figure.text((-WALLS.kDeep, 1.9), "C stops before", BLUE, "end", -8, 0)
    figure.text((-WALLS.kDeep, 1.9), "this line", BLUE, "end", -8, 18)
    figure.line(arc((0, 0), WALLS.kQueue, queue - 0.75, queue + 0.6), BLUE, 1.5, dashed=True)
    figure.robot((0.1, -5.2), BLUE, "D", (0.0, 1.5), shift=(-18, 0))
    figure.text((-1.0, -5.2), "D stops before the arc", BLUE, "end", -6, 5)

    figure.length((-5.8, 0), (-5.8, -WALLS.kAside), f"{WALLS.kAside:g} R", "start", 8, 5)
    figure.length((-4.45, 0), (-4.45, -WALLS.kBayAside), f"{WALLS.kBayAside:g} R", "end", -8, 36)
    figure.length((0, 0), (0, -WALLS.kQueue), f"{WALLS.kQueue:g} R", "start", 6, 0)
    figure.length((-WALLS.kBayOut, -3.5), (0, -3.5), f"{WALLS.kBayOut:g} R", "middle", 0, 18)
    return figure


def go_back():
    figure = Figure("go-back", "Where both directions are inside, the one that has come less far goes back", 760, 285)
    figure.view((45, 120), 35)
    length, half, below = 15.0, DOOR / 2, -3.5
    for sign in (-1, 1):
        figure.wall((WALLS.kMouth, sign * 3.0), (WALLS.kMouth, sign * half),
                    (length - WALLS.kMouth, sign * half), (length - WALLS.kMouth, sign * 3.0))
    mouths = (0, 0), (length, 0)
    straight, aside = (length + WALLS.kBack, 0), (length + WALLS.kBack, WALLS.kBackAside)
    a, b, c = (8.2, 0), (11.6, 0), (length - WALLS.kOut / 2, 0)
    figure.line([mouths[0], straight], GRAY, 1, dashed=True)
    for x in (mouths[0][0], a[0], b[0], length):
        figure.line([(x, 0), (x, below)], GRAY, 1, dashed=True)
    figure.dot(mouths[0]), figure.dot(mouths[1])
    figure.robot((5.4, 0), BLUE, "", (1.5, 0))
    figure.robot(a, BLUE, "A", (1.7, 0), shift=(-16, 0))
    figure.robot(b, RED, "B", (1.7, 0), shift=(-16, 0))
    figure.robot(c, RED, "C", shift=(-16, 0))
    figure.arrow(c, aside, RED)
    figure.dot(straight, RED, 4.5), figure.dot(aside, RED, 4.5)
    figure.length((0, below), (a[0], below), "A has come farther, and goes on", dy=20)
    figure.length((b[0], below), (length, below), "B less far: it goes back, as does C", "middle", 0, 20)
    figure.length((length, -1.5), (length + WALLS.kBack, -1.5), f"{WALLS.kBack:g} R", dy=18)
    figure.line([straight, (straight[0], -1.5)], GRAY, 1, dashed=True)
    right = straight[0] + 0.9
    figure.line([straight, (right, 0)], GRAY, 1, dashed=True)
    figure.line([aside, (right, aside[1])], GRAY, 1, dashed=True)
    figure.length((right, 0), (right, aside[1]), f"{WALLS.kBackAside:g} R", "start", 8, 5)
    figure.text(straight, "B", RED, dx=4, dy=18), figure.text(aside, "C", RED, dx=4, dy=-6)
    return figure


def make_room():
    figure = Figure("make-room", "A robot at its goal in a passage goes on ahead of a robot that comes near", 760, 270)
    figure.view((45, 110), 35)
    length, half = 13.0, DOOR / 2
    for sign in (-1, 1):
        figure.wall((WALLS.kMouth, sign * 2.6), (WALLS.kMouth, sign * half),
                    (length - WALLS.kMouth, sign * half), (length - WALLS.kMouth, sign * 2.6))
    a, b = (7.0, 0), (7.0 - WALLS.kRestsNear, 0)
    straight, aside = (length + WALLS.kBack, 0), (length + WALLS.kBack, -WALLS.kBackAside)
    figure.line([(0, 0), straight], GRAY, 1, dashed=True)
    figure.dot((0, 0)), figure.dot((length, 0))
    figure.robot(b, RED, "B", (1.8, 0), shift=(-16, 0))
    figure.robot(a, BLUE, "A", shift=(-16, 0))
    figure.arrow((a[0] + 1.0, 0), (length - 1.5, 0), BLUE)
    figure.arrow((length, 0), aside, BLUE)
    figure.dot(a, BLUE), figure.dot(aside, BLUE, 4.5)
    figure.ghost(aside, BLUE)
    figure.text(a, "A is at its goal", BLUE, "middle", 0, -66)
    for x in (b[0], a[0]):
        figure.line([(x, 0), (x, -2.9)], GRAY, 1, dashed=True)
    figure.length((b[0], -2.9), (a[0], -2.9), f"nearer than {WALLS.kRestsNear:g} R, and on its way: A goes", "start", -130, 20)
    figure.text(aside, "A waits here,", BLUE, "middle", 0, 56)
    figure.text(aside, "and comes back in its turn", BLUE, "middle", 0, 74)
    return figure


def go_around():
    figure = Figure("go-around", "A robot that has waited longer than another route takes goes there", 760, 342)
    figure.view((40, 78), 27)
    left, right, half, other = 5.0, 17.0, DOOR / 2, -4.8  # r; both lanes lead along x, one at y = 0
    for top, bottom in ((2.4, half), (-half, other + half), (other - half, other - 2.4)):
        figure.wall((left, top), (left, bottom), (right, bottom), (right, top))
    figure.wall((left, -half), (right, -half)), figure.wall((left, other - half), (right, other - half))
    a, b, end = (8.2, 0), (10.5, 0), (22.0, 0)
    before, behind = left - 1.6, right + 1.6
    figure.line([a, end], RED, 1.5, dashed=True)
    figure.line([a, (before, 0), (before, other), (behind, other), end], BLUE, 2)
    figure.line([(right, -half), (right, half)], RED, 3)
    figure.text((right, 0), "closed gap", RED, "start", 8, -10)
    figure.robot(b, GRAY, "B"), figure.robot(a, BLUE, "A")
    figure.dot(end, BLUE, 4.5)
    figure.text(end, "goal of A", BLUE, "middle", 0, 22)
    figure.text((12.0, 0), "route, of length L", RED, dy=-8)
    figure.text(((left + right) / 2, other), "the route around, of length L'", BLUE, "middle", 0, -8)
    figure.view((0, 342), 1)
    figure.text((30, 44), f"t: since when A, with others near, has not come nearer to its goal by {WALLS.kComesNearer:g} r")
    figure.text((30, 20), f"A goes around once t ≥ {WALLS.kPatience:g} T and t ≥ (L' - L)/(its preferred speed)")
    return figure


def go_back_from_a_jam():
    figure = Figure("go-back-from-a-jam", "A robot that has waited long in a jam goes back for half of the time", 760, 330)
    figure.view((40, 92), 27)
    half, rest = 2.6, (12.6, -1.5)  # r: a way of two lanes, and somebody at its goal in it
    figure.wall((0, half), (25, half)), figure.wall((0, -half), (25, -half))
    figure.robot(rest, GRAY, "C")
    figure.text(rest, "at its goal", GRAY, "middle", 0, 60)
    for place, color, name, way in (((10.6, 0.9), BLUE, "A", -1), ((8.3, 0.2), BLUE, "", -1), ((6.0, 0.9), BLUE, "", -1),
                                    ((14.2, 0.9), RED, "B", 1), ((16.5, 0.2), RED, "", 1), ((18.8, 0.9), RED, "", 1)):
        figure.robot(place, color, name)
        if place[0] in (6.0, 18.8):
            figure.arrow(place, (place[0] + 1.9 * way, place[1]), color)
    figure.text((1.6, -1.9), "those at the ends can move first", BLUE)
    period, scale = WALLS.kSteadfast, 3.2  # T; pixels for one
    figure.view((40, 245), 1)
    figure.line([(0, 0), (scale * 200, 0)], GRAY, 1)
    figure.text((scale * 200, 0), "t", GRAY, dx=6, dy=5)
    for start in (period, 2 * period, 4 * period):
        end = 2 * start * WALLS.kForth
        figure.area([(scale * start, -7), (scale * end, -7), (scale * end, 7), (scale * start, 7)], BLUE, 0.6)
        figure.text((scale * start, -7), f"{start:g} T", GRAY, "middle", 0, 18)
        figure.text((scale * end, -7), f"{end:g} T", GRAY, "middle", 0, 18)
        figure.text((scale * (start + end) / 2, 7), "goes back", BLUE, "middle", 0, -6)
    figure.view((0, 330), 1)
    figure.text((30, 20), "t: since when A, with others near, has not come nearer to its goal, and there is no other way")
    return figure


def behind_walls():
    figure = Figure("behind-walls", "A neighbor behind a wall does not count where the way round is long", 760, 350)
    figure.view((105, 172), 33)
    end, a, reach_a = (0, 0), (4.2, -1.7), 3.4
    figure.wall(end, (19, 0))
    figure.circle(a, reach_a, BLUE, dashed=True)
    figure.line([a, end], BLUE)
    for place, reach, color, name, y in (((7.6, 1.7), 2.6, GRAY, "B", -1.2), ((0.9, 1.6), 3.2, RED, "C", -2.7)):
        figure.circle(place, reach, color, dashed=True)
        figure.line([end, place], color)
        figure.robot(place, color, name)
        way = math.dist(a, end) + math.dist(end, place)
        counts = way <= reach_a + reach
        figure.text((9.3, y), f"{name} {'counts' if counts else 'does not count'}: its way round the end,", color)
        figure.text((9.3, y), f"{way:.1f} r, is {'within' if counts else 'beyond'} {reach_a} r + {reach} r", color,
                    dy=19)
    figure.robot(a, BLUE, "A")
    figure.dot(end)
    figure.text(a, "reach of A", BLUE, "middle", 0, 84)
    figure.text((9.3, -4.4), "reach: all that it can come to touch", dy=0)
    figure.text((9.3, -4.4), "before it has stopped", dy=19)
    return figure


def beside_walls():
    figure = Figure("beside-walls", "On its way, a robot does not give way beside walls", 760, 310)
    reach, b = 5.4, (-2.2, 0.3)  # reach: v_max²/2a + Δt v_max + r for r = 0.5 m
    for x, color in ((190, GRAY), (560, BLUE)):
        figure.view((x, 125), 21)
        figure.circle((0, 0), reach, BLUE, dashed=True)
        figure.robot((0, 0), BLUE, "A", shift=(0, -11))
        figure.robot(b, RED, "B")
        figure.arrow((0, 0), (3.0, -0.4), color, dashed=color == GRAY)
        figure.text((3.0, -0.4), "push", color, dx=4, dy=-8)
        figure.text((0, reach), "reach of A at v_max", BLUE, "middle", 0, 24)
        if color == GRAY:
            figure.line([(2.0, -0.9), (2.7, 0.2)], RED, 2)
            figure.wall((-8, -2.4), (8, -2.4))
    figure.view((0, 310), 1)
    figure.text((30, 30), "(a) A could touch the wall: no push")
    figure.text((420, 30), "(b) no wall within reach: it gives way")
    return figure
