#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Compiles and runs every C++ example of the documents, and validates their scenes.

usage: readme_examples.py COMPILER PREFIX LIBDIR FOLDER FLAGS [AVO]
"""
import os
import pathlib
import re
import subprocess
import sys

compiler, prefix, libdir, folder, flags = sys.argv[1:6]
avo = sys.argv[6] if len(sys.argv) > 6 else None
root = pathlib.Path(__file__).resolve().parents[2]
folder = pathlib.Path(folder)
folder.mkdir(parents=True, exist_ok=True)
library = pathlib.Path(prefix) / libdir
environment = dict(os.environ, PKG_CONFIG_PATH=str(library / "pkgconfig"),
                   LD_LIBRARY_PATH=str(library))
package = subprocess.run(
    ["pkg-config", f"--define-variable=prefix={prefix}", "--cflags", "--libs", "avo"],
    env=environment, check=True, capture_output=True, text=True).stdout.split()

examples = []
for name, least in (("README.md", 2), ("docs/on_board.md", 1)):
    found = re.findall(r"```cpp\n(.*?)```", (root / name).read_text(), re.S)
    assert len(found) >= least, f"{name} has lost its examples"
    examples += found
for number, text in enumerate(examples):
    source = folder / f"example_{number}.cpp"
    program = folder / f"example_{number}"
    source.write_text(text)
    subprocess.run([compiler, *flags.split(), "-Wall", "-Wextra", "-Werror", str(source), *package,
                    "-o", str(program)], check=True)
    run = subprocess.run([str(program)], env=environment, check=True, capture_output=True,
                         text=True, timeout=60)
    assert run.stdout.strip(), f"example {number} prints nothing"
    print(run.stdout, end="")

scenes = []
for name in ("README.md", "docs/scenes.md"):
    found = re.findall(r"```yaml\n(.*?)```", (root / name).read_text(), re.S)
    assert found, f"{name} has lost its scenes"
    scenes += found
if avo:
    for number, text in enumerate(scenes):
        scene = folder / f"scene_{number}.yaml"
        scene.write_text(text)
        subprocess.run([avo, "validate", str(scene)], check=True)
