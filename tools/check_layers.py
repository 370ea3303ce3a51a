#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Fails if a folder includes a layer that it may not see (ARCHITECTURE.md, "Layers")."""
import pathlib
import re
import sys

# folder of src/ -> folders of src/ whose headers it may include, besides its own
ALLOWED = {
    "core": set(),
    "fields": {"core"},
    "check": {"core"},
    "spatial": {"core"},
    "walls": {"core", "spatial"},
    "obstacles": {"core"},
    "lp": {"core"},
    "robots": {"core"},
    "navigation": {"core", "spatial", "walls"},
    "certificate": {"core", "walls", "robots"},
    "planner": {"core", "fields", "walls", "obstacles", "lp", "certificate", "robots"},
    "guidance": {"core", "walls", "robots", "navigation", "certificate", "planner"},
    "navigator": {"core", "walls", "robots", "navigation", "certificate", "planner", "guidance"},
    "sim": {"core", "spatial", "walls", "robots", "navigation", "certificate", "planner", "guidance",
            "fields"},
    "metrics": {"core", "check", "spatial", "walls"},
    "space": {"core", "fields", "spatial", "obstacles", "navigation", "certificate", "planner", "guidance",
              "metrics"},
}
# folder outside src/ -> folders and single headers of quoted includes that it may use
OUTER = {
    "include/avo": {"avo"},
    "include/avo_io": {"avo", "avo_io"},
    "io": {"avo", "avo_io", "io", "core/elementary.h", "core/ranges.h", "core/removed.h", "core/retell.h",
           "fields"},
    "bindings/c": {"avo", "avo_io", "avo_c", "core/removed.h"},
    "figures": {"avo", "figures"},
    "apps": {"avo", "avo_io", "bindings/c/external.h", "figures", "cli", "apps", "paper_figures", "arguments", "verbs", "reports",
             "completion", "system", "lab_page"},
    "bindings/python": {"avo", "avo_io", "core/removed.h"},
    "lab/wasm": {"avo", "avo_io", "io", "figures", "core/elementary.h", "core/retell.h", "planner/stages/certify.h",
                 "sim/state/saved_state.h", "walls/segment.h", "walls/wall_grid.h"},
}
INCLUDE = re.compile(r'^\s*#\s*(?:include|define\s+AVO_KERNEL_HEADER\w*)\s+"([^"]+)"', re.M)


def includes(path):
    return [name for name in INCLUDE.findall(path.read_text()) if "/" in name]


def refused(path, allowed):
    return [(path, name) for name in includes(path)
            if name not in allowed and name.split("/")[0] not in allowed]


def main():
    root = pathlib.Path(__file__).resolve().parent.parent
    bad = []
    for path in sorted(root.glob("src/*/**/*.[hc]*")):
        layer = path.relative_to(root / "src").parts[0]
        allowed = ALLOWED.get(layer, set()) | {layer, "avo"}
        bad += refused(path, allowed)
    for folder, allowed in OUTER.items():
        for path in sorted((root / folder).rglob("*.[hc]*")):
            bad += refused(path, allowed)
    for path, seen in bad:
        print(f"{path.relative_to(root)}: includes {seen}, which its layer may not see")
    return 1 if bad else 0


if __name__ == "__main__":
    sys.exit(main())
