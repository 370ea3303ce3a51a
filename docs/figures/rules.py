#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Draws the figures of docs/arrival.md, one of each rule, to scale with the constants of the sources,
which are read. With --check it only tells which figures no longer agree with the sources."""
import pathlib
import sys

import rules_among_walls as walls
import rules_in_the_open as free

FIGURES = (free.keep_right, free.give_way, free.settle, free.detour, free.come_to_rest, walls.passages, walls.lanes,
           walls.right_of_way, walls.wait, walls.go_back, walls.make_room,
           walls.go_around, walls.go_back_from_a_jam, walls.behind_walls, walls.beside_walls)


def main():
    is_check = sys.argv[1:] == ["--check"]
    if sys.argv[1:] and not is_check:
        sys.exit(f"rules.py: unknown argument '{sys.argv[1]}', only --check is known")
    stale = []
    for draw in FIGURES:
        figure = draw()
        path = pathlib.Path(__file__).parent / f"rule-{figure.name}.svg"
        if not is_check:
            path.write_text(figure.svg(), encoding="utf-8")
        elif not path.exists() or path.read_text(encoding="utf-8") != figure.svg():
            stale.append(path.name)
    if stale:
        sys.exit(f"docs/figures: draw again by docs/figures/rules.py: {', '.join(stale)}")


if __name__ == "__main__":
    main()
