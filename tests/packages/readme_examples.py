#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Compiles and runs every C++ example of the documents by README.md's line of pkg-config, and
validates their scenes.

usage: readme_examples.py PREFIX AVO [--compiler COMPILER] [--flags FLAGS]
"""
import argparse
import os
import pathlib
import re
import subprocess

ROOT = pathlib.Path(__file__).resolve().parents[2]


def blocks(document, language):
    found = re.findall(rf"```{language}\n(.*?)```", (ROOT / document).read_text(), re.S)
    assert found, f"{document} has lost its examples in {language}"
    return found


def run_program(arguments, source):
    """As README.md says, at the user's shell."""
    line = re.search(r"`g\+\+ (-std=\S+) robot\.cpp (\$\(pkg-config .*?\))`",
                     (ROOT / "README.md").read_text())
    assert line, "README.md has lost its line of pkg-config"
    folder = next(pathlib.Path(arguments.prefix).rglob("pkgconfig"))
    environment = dict(os.environ, PKG_CONFIG_PATH=str(folder), LD_LIBRARY_PATH=str(folder.parent))
    program = source.with_suffix("")
    subprocess.run(f"{arguments.compiler} {arguments.flags} -Wall -Wextra -Werror {line[1]} "
                   f"{source} {line[2]} -o {program}", shell=True, check=True, env=environment)
    said = subprocess.run([program], env=environment, check=True, capture_output=True, text=True,
                          timeout=60).stdout
    assert said.strip(), f"{source} prints nothing"
    print(said, end="")


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n\n")[0])
    parser.add_argument("prefix")
    parser.add_argument("avo")
    parser.add_argument("--compiler", default="c++")
    parser.add_argument("--flags", default="")
    arguments = parser.parse_args()
    folder = pathlib.Path(arguments.prefix).parent / "readme"
    folder.mkdir(exist_ok=True)

    examples = blocks("README.md", "cpp")
    assert len(examples) >= 2, "README.md has lost an example"
    for number, text in enumerate(examples + blocks("docs/on_board.md", "cpp")):
        source = folder / f"example_{number}.cpp"
        source.write_text(text)
        run_program(arguments, source)
    for name in ("arena.map", "arena.scen"):
        text = subprocess.run([arguments.avo, "scenes", name], check=True, capture_output=True).stdout
        (folder / name).write_bytes(text)
    for number, text in enumerate(blocks("README.md", "yaml") + blocks("docs/scenes.md", "yaml")):
        scene = folder / f"scene_{number}.yaml"
        scene.write_text(text)
        subprocess.run([arguments.avo, "validate", scene], check=True)


if __name__ == "__main__":
    main()
