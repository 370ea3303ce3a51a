#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Compiles and runs the C example of docs/c.md, and runs the one in LuaJIT.

usage: documents.py COMPILER LIBRARY FOLDER LUAJIT

FOLDER holds avo_ffi.h.
"""
import os
import pathlib
import re
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]


def example(language):
    found = re.findall(rf"```{language}\n(.*?)```", (ROOT / "docs" / "c.md").read_text(), re.S)
    assert len(found) == 1, f"docs/c.md has {len(found)} examples in {language}"
    return found[0]


def output(command, **options):
    said = subprocess.run(command, check=True, stdout=subprocess.PIPE, text=True, **options).stdout
    print(said, end="")
    return said


def main():
    compiler, library, folder, luajit = sys.argv[1:]
    folder, library = pathlib.Path(folder), pathlib.Path(library)
    source = folder / "document.c"
    source.write_text(example("c"))
    output([compiler, "-std=c99", "-Wall", "-Wextra", "-Wpedantic", "-Werror", f"-I{ROOT}/bindings/c/include", source,
            f"-L{library.parent}", "-lavo_c", "-o", folder / "document"])
    where = dict(os.environ, LD_LIBRARY_PATH=str(library.parent))
    assert "arrived after" in output([folder / "document"], env=where)
    (folder / "document.lua").write_text(example("lua"))
    assert output([luajit, "document.lua"], cwd=folder, env=where)


if __name__ == "__main__":
    main()
