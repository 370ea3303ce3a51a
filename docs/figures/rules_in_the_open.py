# SPDX-License-Identifier: Apache-2.0
"""The rules for arriving in open space, one function for each figure."""
import math

from drawing import BLACK, BLUE, GRAY, RED, Figure, arc, constants, graph, polar

OPEN = constants("planner/rules/arrival.h", "planner/rules/arrival.cpp")


def keep_right():
    figure = Figure("keep-right", "The wish is turned to the right by traffic ahead", 760, 370)
    figure.view((110, 160), 48)
    reach, height = 12.0, 3.2  # reach: 1.5 L for r = 0.5 m, v_max = 2 m/s, a_max = 1 m/s²
    edge = arc((0, 0), reach, -math.asin(height / reach), math.asin(height / reach))
    figure.area([(0, -height), *edge, (0, height)], BLUE, 0.5)
    figure.line([(0, -height), (0, height)], GRAY, 1, dashed=True)
    figure.line(edge, GRAY, 1, dashed=True)
    congestion = 0.0
    for place, velocity in (((3.8, 1.9), None), ((5.6, -1.7), (-1.6, 0.2)), ((8.1, 0.3), (-1.6, -0.2)),
                            ((9.9, -1.8), (-1.6, 0.0)), ((6.7, 2.0), (2.3, 0.1)), ((-1.2, -2.0), (1.6, 0.0))):
        counts = place[0] > 0 and (velocity is None or velocity[0] < 0)
        weight = 1.0 - math.hypot(*place) / reach if counts else 0.0
        congestion += weight
        figure.robot(place, RED if counts else GRAY, f"{weight:.2f}" if counts else "0", velocity,
                     shift=(0, -14 if velocity else 0))
    angle = -OPEN.kMostKeepRight * min(congestion / OPEN.kCongestion, 1.0)
    figure.robot((0, 0), BLUE)
    figure.arrow((0, 0), (3, 0), GRAY, dashed=True)
    figure.arrow((0, 0), polar(angle, 3), BLUE)
    figure.line(arc((0, 0), 1.8, 0, angle), BLUE, 1)
    figure.text((3, 0), "preferred velocity", GRAY, dx=6, dy=4)
    figure.text(polar(angle, 3), "wish", BLUE, dx=4, dy=14)
    for k, line in enumerate(("range", "1.5 L", "or 8 r")):
        figure.text((reach, 0), line, GRAY, dx=8, dy=18 * k - 13)
    figure.text((-2, -3.7), f"angle = {math.degrees(OPEN.kMostKeepRight):.0f}° · min(Σ / {OPEN.kCongestion}, 1); "
                f"Σ = sum of the weights 1 − d / range, less {OPEN.kUsual:g} · usual: here {congestion:.2f} − 0, "
                f"so {-math.degrees(angle):.0f}°")
    figure.text((-2, -3.7), "red: ahead, and closing in, alongside or nearly at rest; gray: going away by 0.2 v_max or more, or behind", dy=22)
    return figure


def give_way():
    figure = Figure("give-way", "A robot gives way to a neighbor that is nearly in contact", 760, 330)
    figure.view((140, 160), 52)
    b = (1.66, 1.62)
    figure.circle((0, 0), 1 + 2 * OPEN.kRoom, GRAY, dashed=True)
    figure.robot(b, RED, "B", (-1.5, 0.1), shift=(16, 0))
    figure.robot((0, 0), BLUE, "A", shift=(16, 0))
    figure.cross((0, 0), BLUE, 0.15)
    figure.arrow((0, 0), (-1.7 * b[0] / math.hypot(*b), -1.7 * b[1] / math.hypot(*b)), BLUE)
    figure.length((1, 0), (1 + 2 * OPEN.kRoom, 0), f"{OPEN.kRoom:g} (r_A + r_B)", "start", 18, 5)
    figure.text((-2.3, -2.1), "away from B, added to the wish:", BLUE)
    figure.text((-2.3, -2.1), f"{OPEN.kPush:g} v_max · nearness · weight · min(r_B / r_A, 1)", BLUE, dy=21)
    figure.text((-2.3, -2.1), "nearness: 1 in contact, 0 on the dashed ring", dy=46)
    bend = (1 - OPEN.kLeastWeight) * OPEN.kLeash
    graph(figure, (430, 112), 290, ((0, "0"), (bend, f"{bend:g}"), (8, "8")),
          ((0, 1), (bend, OPEN.kLeastWeight), (8, OPEN.kLeastWeight)), "distance to the goal / (r_A + r_B)",
          f"weight: 1 at the goal, {OPEN.kLeastWeight:g} on the way")
    graph(figure, (430, 272), 290, ((0, "0"), (OPEN.kInMotion, f"{OPEN.kInMotion:g}"),
                                    (0.3, "0.3")),
          ((0, 0), (OPEN.kAtRest, 0), (OPEN.kInMotion, 1), (0.3, 1)), "speed of B / v_max",
          f"within {OPEN.kNear:g} r_A of the goal, if r_B ≤ r_A")
    return figure


def settle():
    figure = Figure("settle", "Near its goal a robot makes room by turns, and settles in the end", 760, 285)
    last, first, most = 45.0, OPEN.kSettleDistance, OPEN.kSettleDistance + OPEN.kMostGrowth
    figure.view((110, 200), 1.0)
    x, y = 580 / last, 36.0
    tries = round(last / OPEN.kTry)
    for k in range(tries + 1):
        begin, end = k * OPEN.kTry, min((k + OPEN.kYields) * OPEN.kTry, last)
        if begin < last:
            figure.area([(x * begin, y * first), (x * end, y * first), (x * end, 4.2 * y), (x * begin, 4.2 * y)],
                        BLUE, 0.8)
    figure.line([(0, 0), (x * last + 14, 0)], BLACK, 1, False, "end")
    figure.line([(0, 0), (0, 4.4 * y)], BLACK, 1, False, "end")
    for time in range(0, 50, 10):
        figure.line([(x * time, 0), (x * time, -4)], BLACK, 1)
        figure.text((x * time, 0), f"{time}" if time < 40 else "40 T", BLACK, "middle", 0, 18)
    for distance in range(1, 5):
        figure.line([(0, y * distance), (-4, y * distance)], BLACK, 1)
        figure.text((0, y * distance), f"{distance}", BLACK, "end", -8, 5)
    grown = OPEN.kPatience + OPEN.kMostGrowth / OPEN.kGrowth
    figure.line([(x * OPEN.kSettles, 0), (x * OPEN.kSettles, y * first), (x * OPEN.kPatience, y * first),
                 (x * grown, y * most), (x * last, y * most)], RED, 2.5)
    figure.line([(x * OPEN.kPatience, y * first), (x * last, y * first)], RED, 1.5, dashed=True)
    figure.text((x * last, y * 1.45), "below red it settles, if it has been at its goal", RED, "end", -4, 0)
    figure.text((x * last, y * first), "if not", RED, "end", -4, 18)
    figure.text((x * last, 0), "time beside others", BLACK, "end", 0, 38)
    figure.text((0, 4.4 * y), "distance to the goal / arrival distance", BLACK, dx=10, dy=-8)
    figure.text((0, 0), "on blue, as long as it has not settled, it gives way to those at rest as well", BLUE, dy=62)
    return figure


def detour():
    figure = Figure("detour", "A blocked robot turns its wish to the right, more and more", 760, 410)
    figure.view((150, 145), 36)
    for place in ((2.2, 0.4), (1.0, 2.3), (3.1, 2.4), (3.2, -1.8)):
        figure.robot(place, GRAY)
    figure.robot((0, 0), BLUE)
    length = 4.7
    figure.arrow((0, 0), (length, 0), GRAY, dashed=True)
    figure.text((length, 0), "wish", GRAY, dx=6, dy=4)
    for k in range(1, 5):
        angle = k * OPEN.kMostDetour / 4
        tip, is_free = polar(-angle, length), k == 2
        figure.arrow((0, 0), tip, BLUE, dashed=not is_free)
        figure.text(tip, f"{angle / OPEN.kTurnOff:.1f} T", BLUE, "middle", 20 if k < 3 else -4, 18)
    figure.line(arc((0, 0), 1.6, -0.05, -OPEN.kMostDetour), BLUE, 1, False, "end")
    figure.text((-3.7, -6.1), f"while blocked: {OPEN.kTurnOff:g} rad per T, up to {OPEN.kMostDetour:g} rad", BLUE)
    figure.text((-3.7, -6.1), f"once free: back by {OPEN.kTurnBack:g} rad per T", BLUE, dy=20)
    figure.text((-3.7, 3.4), "(a) the detour")

    figure.view((535, 175), 56)
    reach, h, tilt = 2.0, 0.45, 0.35
    half = math.acos(h / reach)
    figure.area(arc((0, 0), reach, tilt - half, tilt + half), RED)
    figure.circle((0, 0), reach, BLACK, dashed=True)
    figure.line([polar(tilt - half, reach), polar(tilt + half, reach)], RED, 2)
    figure.arrow((0, 0), (3.3, 0), GRAY, dashed=True)
    figure.line([(OPEN.kBlocked * reach, -2.4), (OPEN.kBlocked * reach, 2.4)], BLUE, 1.5, dashed=True)
    chosen = polar(tilt, h - reach * math.cos(tilt), (reach, 0))
    figure.dot((0, 0)), figure.dot((reach, 0), GRAY, 4.5), figure.dot(chosen, BLUE, 4.5)
    figure.text((0, 0), "v", BLACK, "end", -6, 14)
    figure.text((reach, 0), "unhindered", GRAY, dx=6, dy=18)
    figure.text((3.3, 0), "wish", GRAY, "middle", 0, -8)
    figure.text(chosen, "next", BLUE, "end", -8, 10)
    figure.text((1.15, 1.1), "not admitted", RED, dx=-4)
    figure.text((OPEN.kBlocked * reach, 2.4), f"{OPEN.kBlocked:g} of unhindered", BLUE, "middle", 0, -6)
    figure.text((-1.1, 0.9), "admitted", BLACK, "middle")
    figure.text((-2.6, 0), "(b) velocities after a step: it is blocked, as", dy=180)
    figure.text((-2.6, 0), f"next lies before {OPEN.kBlocked:g} of unhindered", dx=24, dy=200)
    return figure


def come_to_rest():
    figure = Figure("come-to-rest", "Where braking is needed, the preferred velocity stops at the goal", 760, 330)
    length, preferred, loss = 8.0, 0.85, 0.05  # r: L for r = 0.5 m; v_max: speeds, loss by braking in a step
    figure.view((690, 285), 60)
    figure.line([(-11, 0), (0, 0)], GRAY, 1, dashed=True)
    speeds = (preferred, preferred, preferred, 0.7 * preferred, 0)
    brakes = length * preferred * (preferred + loss) / 2
    for place, speed in zip((-8.4, -5.6, -brakes, -0.49 * brakes, 0), speeds):
        figure.circle((place, 0), 0.42, BLUE, "#ffffff")
        if speed:
            figure.arrow((place, 0), (place + 1.2 * speed, 0), BLUE)
    figure.cross((0, 0), BLUE, 0.15)
    figure.text((0, 0), "goal", BLUE, dx=30, dy=5)

    figure.view((690, 215), 60)
    figure.line([(-11, 0), (0, 0)], BLACK, 1), figure.line([(0, 0), (0, 3.2)], BLACK, 1, False, "end")
    curve, left = [(-11, 2.6 * preferred)], 0.0
    for k in range(round(preferred / loss) + 1):
        curve.insert(1, (-left, 2.6 * k * loss))
        left += length * loss * (k + 1) * loss
    figure.line(curve, BLUE, 2.5)
    figure.line([(-brakes, 0), (-brakes, 2.6 * preferred)], GRAY, 1, dashed=True)
    figure.length((-brakes, 0.45), (0, 0.45), "v² / 2a and half a step", "middle", -10, -7)
    figure.text((-7, 2.6 * preferred), "preferred speed", BLUE, "middle", 0, 20)
    figure.text((-brakes, 1.2), "braking", BLUE, dx=10)
    figure.text((0, 3.2), "preferred velocity", BLACK, "end", -10, 8)
    return figure
