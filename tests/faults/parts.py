# SPDX-License-Identifier: Apache-2.0
"""Parts of the library of a finished build, compiled anew from a copy of its sources, and tests linked with them.

A unit of the library becomes its files that change, each alone, those that include a header that changes, and the
rest of them: so little is compiled where one of them changes. The text of a kernel is the same for all instruction
sets, so parts have the scalar instance alone; little optimization is enough, and what is checked in debug builds only
is not checked.
"""
import functools
import pathlib
import re
import shlex
import shutil
import subprocess
import sys

OF_THE_BUILD = {"-Werror", "-MD"}
OWN = ["-O1", "-DNDEBUG", "-w"]
CHOOSES_INSTRUCTION_SETS = "core/simd_target.cpp"  # compiled anew as well: it offers the scalar instance alone


def run(command, folder):
    return subprocess.run([str(word) for word in command], cwd=folder, stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                          text=True)


def output_of(command, folder):
    done = run(command, folder)
    if done.returncode != 0:
        sys.exit(f"{' '.join(map(str, command))}\n{done.stdout}")
    return done.stdout


class Part:
    """The object that COMMAND, words, makes in FOLDER."""

    def __init__(self, command, name, folder):
        self.folder = folder
        self.object, self.depends = folder / f"{name}.o", folder / f"{name}.d"
        self.command = command

    def compile(self, to):
        """Object TO, from what the sources are now."""
        return run([*self.command, "-MF", self.depends, "-o", to], self.folder)

    def needs(self, files):
        """Whether it was made from one of FILES, paths of the copy."""
        return not files.isdisjoint(self.depends.read_text().split())


class Parts:
    """Of all units with a file that changes or includes a header that does. BUILD is finished, ROOT has its sources,
    FOLDER a copy of them; CHANGED are files below src."""

    def __init__(self, build, root, folder, changed):
        self.build, self.source, self.folder = build, root / "src", folder
        self.changed = {self.source / file for file in [*changed, CHOOSES_INSTRUCTION_SETS]}
        self.headers = self.including({file for file in self.changed if file.suffix == ".h"})
        self.targets = output_of(["ninja", "-t", "targets", "all"], build)
        self.all = []
        shutil.copytree(self.source, folder / "src")
        (folder / "scalar.h").write_text("#undef AVO_HIGHWAY\n")
        for unit, files in self.made_from().items():
            if re.search(r"(^|/)src/CMakeFiles/avo", unit) and not self.changed.isdisjoint(files):
                self.split(unit)
        for part in self.all:
            done = part.compile(part.object)
            if done.returncode != 0:
                sys.exit(done.stdout)

    def made_from(self):
        """{object of the build: its files}"""
        found = {}
        for block in output_of(["ninja", "-t", "deps"], self.build).strip().split("\n\n"):
            first, *files = block.splitlines()
            found[first.split(": #deps")[0]] = {self.build / file.strip() for file in files}
        return found

    @functools.cache
    def command_of(self, target):
        """Words of the last command that makes TARGET."""
        commands = output_of(["ninja", "-t", "commands", "-s", target], self.build)
        return shlex.split(next(command for command in commands.split("&&") if " -o " in command))

    def split(self, unit):
        command = self.command_of(unit)
        source = pathlib.Path(command[command.index("-c") + 1])
        files = [source]
        if "Unity" in source.parts:
            files = [pathlib.Path(file) for file in re.findall(r'^#include "(.*\.cpp)"$', source.read_text(), re.M)]
        groups = [[file] for file in files if file in self.changed]
        users = [file for file in files if file not in self.changed and self.mentions(file, self.headers)]
        rest = [file for file in files if file not in self.changed and file not in users]
        if groups or users:
            groups += [group for group in (users, rest) if group]
        for group in groups:
            part = self.folder / f"part_{len(self.all)}.cpp"
            part.write_text("".join(f'#include "{self.copy_of(file)}"\n' for file in group))
            self.all.append(self.part(command, part))

    def mentions(self, file, headers):
        text = file.read_text()
        return any(f'"{header.relative_to(self.source)}"' in text for header in headers)

    def including(self, headers):
        """HEADERS and all that include one of them, at whatever distance."""
        more = {file for file in self.source.rglob("*.h") if file not in headers and self.mentions(file, headers)}
        return self.including(headers | more) if more else headers

    def copy_of(self, file):
        return self.folder / "src" / file.relative_to(self.source)

    def part(self, command, source):
        words, kept = iter(command), []
        for word in words:
            if word in ("-c", "-o", "-MT", "-MF"):
                next(words)
            elif word == f"-I{self.source}":
                kept.append(f"-I{self.folder / 'src'}")
            elif word.endswith("cmake_pch.hxx"):
                kept.append(self.precompiled(word, kept[:-1]))
            elif word not in OF_THE_BUILD and not re.fullmatch(r"-O.|-g", word):
                kept.append(word)
        return Part([*kept, *OWN, "-include", self.folder / "scalar.h", "-MMD", "-c", source], source.stem, self.folder)

    def precompiled(self, headers, command):
        """A copy of HEADERS; what is precompiled with other optimization can crash g++ 12."""
        own = self.folder / "headers.h"
        if not own.exists():
            shutil.copyfile(headers, own)
            output_of([*command, *OWN, "-x", "c++-header", own, "-o", f"{own}.gch"], self.folder)
        return own

    def link(self, executable, instead):
        """EXECUTABLE of the build with all parts, or with an object INSTEAD of a part; its path."""
        words = self.command_of(re.search(rf"^(\S*/{executable}): CXX_EXECUTABLE", self.targets, re.M)[1])
        start, linked = words.index("-o"), self.folder / executable
        objects = [instead.get(part, part.object) for part in self.all]
        # the archive's units are not linked: parts come first and define all that these do
        output_of([words[0], *objects, *words[1:start], "-o", linked, *words[start + 2:]], self.build)
        return linked
