#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""A compiler launcher that copies what the same command has made in a finished build.

usage: reuse.py BUILD FOLDER COMMAND...

BUILD is finished, FOLDER is where the same sources, or a copy of them, are built now. The same is a command
that differs in nothing but the folders of builds and sources, in where it writes, in the definition that CMake
adds for a shared library, and in whether warnings are errors. Any other command is run.
"""
import filecmp
import json
import os
import pathlib
import re
import shlex
import shutil
import subprocess
import sys


def sources_of(build, otherwise):
    """The folder that BUILD was configured for, if it is a project of its own."""
    cache = pathlib.Path(build) / "CMakeCache.txt"
    found = re.search(r"^CMAKE_HOME_DIRECTORY:INTERNAL=(.*)$", cache.read_text(), re.M) if cache.exists() else None
    return found[1] if found else otherwise


def parts(words, working, build, source):
    """What is written, and all else that the outcome depends on."""
    output, rest, words = None, [], iter(words)
    for word in words:
        if word == "-o":
            output = os.path.join(working, next(words))
        elif word in ("-MT", "-MF"):
            next(words)
        elif word not in ("-MD", "-Werror") and not (word.startswith("-D") and word.endswith("_EXPORTS")):
            rest.append(word.replace(build + "/", "BUILD/").replace(source + "/", "SOURCE/"))
    return output, rest


def is_current(output, entry, build, folder):
    """Made after all that it is made from, of which the generated headers are the same in FOLDER."""
    made = os.path.getmtime(output)
    known = subprocess.run(["ninja", "-C", build, "-t", "deps", os.path.relpath(output, build)],
                           capture_output=True, text=True, check=True).stdout
    for line in known.splitlines()[1:]:
        source = pathlib.Path(entry["directory"], line.strip())
        if not line.strip():
            continue
        if os.path.getmtime(source) > made:
            return False
        if build in str(source) and source.suffix == ".h" and "cmake_pch" not in source.name:
            own = pathlib.Path(str(source).replace(build + "/", folder + "/"))
            if not own.exists() or not filecmp.cmp(source, own, shallow=False):
                return False
    return True


def made_before(build, folder, command):
    """The file in BUILD, or None."""
    database = pathlib.Path(build) / "compile_commands.json"
    if not database.exists():  # where this project is a part of another one
        return None
    source = sources_of(build, "")
    wanted = parts(command, os.getcwd(), folder, sources_of(folder, source))[1]
    for entry in json.loads(database.read_text()):
        if parts([entry["file"]], "", build, source)[1] == wanted[-1:]:
            output, rest = parts(shlex.split(entry["command"]), entry["directory"], build, source)
            if rest == wanted and os.path.exists(output) and is_current(output, entry, build, folder):
                return output
    return None


def main():
    build, folder, *command = sys.argv[1:]
    before = made_before(build, folder, command)
    if before is None:
        os.execvp(command[0], command)
    shutil.copyfile(before, parts(command, os.getcwd(), folder, folder)[0])


if __name__ == "__main__":
    main()
