#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Compiles and runs the C examples of docs/c.md, and runs the one in LuaJIT.

usage: documents.py COMPILER LIBRARY FOLDER LUAJIT

FOLDER holds avo_ffi.h.
"""
import os
import pathlib
import re
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]


def examples(language, count):
    found = re.findall(rf"```{language}\n(.*?)```", (ROOT / "docs" / "c.md").read_text(), re.S)
    assert len(found) == count, f"docs/c.md has {len(found)} examples in {language}"
    return found


def output(command, **options):
    said = subprocess.run(command, check=True, stdout=subprocess.PIPE, text=True, **options).stdout
    print(said, end="")
    return said


def main():
    compiler, library, folder, luajit = sys.argv[1:]
    folder, library = pathlib.Path(folder), pathlib.Path(library)
    source = folder / "document.c"
    where = dict(os.environ, LD_LIBRARY_PATH=str(library.parent))
    for example in examples("c", 2):
        source.write_text(example)
        output([compiler, "-std=c99", "-Wall", "-Wextra", "-Wpedantic", "-Werror", f"-I{ROOT}/bindings/c/include",
                source, f"-L{library.parent}", "-lavo_c", "-o", folder / "document"])
        assert "arrived after" in output([folder / "document"], env=where)
    (folder / "document.lua").write_text(examples("lua", 1)[0])
    assert output([luajit, "document.lua"], cwd=folder, env=where)


if __name__ == "__main__":
    main()
