#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Fails unless figures, Python and the lab have the same colors: figures/colors.h is what the others follow.

usage: palette_test.py
"""
import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
NAMES = {"blue", "sky", "green", "yellow", "orange", "vermilion", "purple"}
OTHERS = ("bindings/python/avo/_colors.py", "lab/page/map/colors.ts")


def words(path, pattern):
    return re.findall(pattern, (ROOT / path).read_text())


def named(path):
    """{name: rrggbb} of all constants in capitals, also of those that Python lists side by side."""
    found = {}
    for names, values in words(path, r'(?m)^(?:const )?([A-Z]+(?:, [A-Z]+)*) = ((?:0x|"#)[0-9a-fA-F]{6}.*)$'):
        for name, value in zip(names.split(", "), re.findall(r"(?:0x|#)([0-9a-fA-F]{6})", values), strict=True):
            found[name.lower()] = value.lower()
    return found


def order(path, pattern):
    """The names of a list of colors, in its order."""
    text, = words(path, pattern)
    return [name.lower() for name in re.findall(r"k?([A-Za-z]+)", text)]


def main():
    source = {name.lower(): value for name, value in words("figures/colors.h", r"Color k(\w+) = rgb\(0x([0-9a-f]{6})\)")}
    if set(source) != NAMES:
        sys.exit(f"figures/colors.h: found {sorted(source)}, must be {sorted(NAMES)}")
    for path in OTHERS:
        if named(path) != source:
            sys.exit(f"{path}: found {named(path)}, must be {source}, as in figures/colors.h")
    circle = order("figures/colors.cpp", r"kCircle\{([^}]*)\}")
    for path, pattern in (("bindings/python/avo/_colors.py", r"_CIRCLE = \(([^)]*)\)"),
                          ("lab/page/map/colors.ts", r"CIRCLE = \[([^\]]*)\]")):
        if order(path, pattern) != circle:
            sys.exit(f"{path}: found the circle {order(path, pattern)}, must be {circle}")
    few = order("figures/colors.h", r"kFew\{([^}]*)\}")
    if order("bindings/python/avo/_colors.py", r"_FEW = \(([^)]*)\)") != few:
        sys.exit("bindings/python/avo/_colors.py: _FEW is not kFew of figures/colors.h")
    light, _ = words("lab/page/inspector/palette.ts", r'preferred: "#([0-9a-f]{6})", decided: "#([0-9a-f]{6})"')
    if light != (source["blue"], source["vermilion"]):
        sys.exit(f"lab/page/inspector/palette.ts: found {light}, must be blue and vermilion, as in velocity_space.cpp")
    print(f"{len(source)} colors are the same in figures, Python and the lab")


if __name__ == "__main__":
    main()
