#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Compiles and runs every example of the documents, as their readers would.

usage: snippets.py PREFIX AVO --folder FOLDER [--compiler COMPILER] [--flags FLAGS] [--python FOLDER] [DOCUMENT...]

PREFIX has the installed library, AVO is the command line, FOLDER is emptied and gets a folder for each document,
--python says where the built module is. C++ is compiled by README.md's line of pkg-config and run, C likewise,
scenes are validated, Python is run. Commands are run one after the other, without those that build and install: other
tests try these. The loader finds shared libraries only where the document's own commands tell it of them. A comment
before a block, which nobody is shown, may say:

<!-- file: NAME -->       the block is this file, or goes on with it; for all commands of the document
<!-- frame: NAME -->      it is a part: it stands in place of the line that says so in tests/manual/frames/NAME
<!-- first: COMMAND -->   is run before
<!-- exits: STATUS -->    the exit status of its last command
<!-- prints -->           a text: what the block before it has just printed; a line ... stands for any lines
<!-- not run: REASON -->  it is not tried
"""
import argparse
import concurrent.futures
import os
import pathlib
import re
import shutil
import subprocess
import sys

from blocks import blocks

ROOT = pathlib.Path(__file__).resolve().parents[2]
FIGURES = ROOT / "docs/manual/figures"
FRAMES = pathlib.Path(__file__).resolve().parent / "frames"
PLAIN = {"", "text", "json", "xml", "cmake"}  # shown, not tried
# commands that build and install, and those of them that tell the loader
BUILDS = re.compile(r"(apt-get|cmake|git|sudo|cd|export|(\S*/)?pip|\./scripts/\S+|/usr/bin/python3 -m venv)(\s|$)")
TELLS_LOADER = re.compile(r"^(\./scripts/install$|sudo ldconfig\b)", re.M)
RUN = {"avo", "g++", "gcc", "c++", "cc", "for", "zcat", "python3", "luajit"}  # and programs of the document's folder
CLONE = ("bindings", "examples")  # what commands name of it
# also of a number with a sign that is printed as one without, as clang warns by itself
WARNINGS = "-Wall -Wextra -Wformat-signedness -Wno-unknown-warning-option -Werror"


class Failed(Exception):
    pass


def run(command, folder, environment, status=0):
    done = subprocess.run(["bash", "-euo", "pipefail", "-c", command], cwd=folder, env=environment,
                          stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
    if done.returncode != status:
        raise Failed(f"{command}\nexit status {done.returncode}, {status} expected\n{done.stdout}")
    return done.stdout


def environment_of(arguments):
    package = next(arguments.prefix.rglob("pkgconfig"))
    environment = dict(os.environ, PKG_CONFIG_PATH=str(package), PATH=f"{arguments.avo.parent}:{os.environ['PATH']}")
    return environment | ({"PYTHONPATH": str(arguments.python)} if arguments.python else {})


def by_pkg_config():
    """README.md's line: what stands before the source, and what behind it."""
    line = re.search(r"`g\+\+ (-std=\S+) robot\.cpp (\$\(pkg-config .*?\))`", (ROOT / "README.md").read_text())
    assert line, "README.md has lost its line of pkg-config"
    return line[1], line[2]


class Trial:
    """One document, tried block by block."""

    def __init__(self, arguments, document):
        self.arguments, self.document = arguments, document
        self.folder = arguments.folder / document.replace("/", "_").removesuffix(".md")
        self.folder.mkdir(parents=True)
        for name in CLONE:
            (self.folder / name).symlink_to(ROOT / name)
        self.said = None  # by what was last run
        self.blocks = blocks(ROOT / document)
        self.commands = "".join(block.text for block in self.blocks if block.language == "sh")
        self.environment = environment_of(arguments)
        if TELLS_LOADER.search(self.commands):
            self.environment["LD_LIBRARY_PATH"] = str(next(arguments.prefix.rglob("pkgconfig")).parent)

    def run(self, command, status=0):
        return run(command, self.folder, self.environment, status)

    def all(self):
        """The failures, a line each."""
        failures = []
        for block in self.blocks:
            if "file" in block.marks:
                with open(self.folder / block.marks["file"], "a") as file:
                    file.write(block.text)
        for block in self.blocks:
            try:
                self.one(block)
            except (Failed, OSError) as failure:
                failures.append(f"{self.document}:{block.line}: {failure}")
        for drawn in self.folder.glob("*.png"):
            shown = FIGURES / drawn.name
            if self.document.startswith("docs/manual/") and shown.exists() and shown.read_bytes() != drawn.read_bytes():
                failures.append(f"{self.document}: its command draws another {drawn.name} now, see {drawn}")
        return failures

    def one(self, block):
        if "not run" in block.marks:
            return
        if "first" in block.marks:
            self.said = self.run(block.marks["first"])
        if "prints" in block.marks:
            self.compare(block.text)
        elif block.language not in PLAIN and not block.language.startswith("{"):  # nor what Sphinx reads
            attempt = getattr(self, block.language, None)
            if attempt is None:
                raise Failed(f"nobody knows how to try {block.language}")
            attempt(block)

    def source(self, block, ending):
        """The file of a block, which has a frame where it is a part."""
        if "file" in block.marks:
            return self.folder / block.marks["file"]
        path = self.folder / f"line_{block.line}.{ending}"
        text = block.text
        if "frame" in block.marks:
            frame = (FRAMES / block.marks["frame"]).read_text()
            text, count = re.subn(r"^.*\bthe block\b.*\n", lambda _: text, frame, flags=re.M)
            assert count == 1, f"no place in frame {block.marks['frame']}"
        path.write_text(text)
        return path

    def cpp(self, block):
        if "file" in block.marks and f"g++ -std=c++20 {block.marks['file']}" in self.commands:
            return  # the document compiles it
        source = self.source(block, "cpp")
        before, behind = by_pkg_config()
        program = source.with_suffix("")
        self.run(f"{self.arguments.compiler} {self.arguments.flags} {WARNINGS} {before} {source} {behind} -o {program}")
        if "frame" not in block.marks:
            self.said = self.run(str(program))
            if not self.said.strip():
                raise Failed("it prints nothing")

    def c(self, block):
        if "file" in block.marks and f"-std=c99 {block.marks['file']}" in self.commands:
            return
        source = self.source(block, "c")
        whole = "int main" in block.text
        loader = "-Wl,-rpath,$(pkg-config --variable=libdir avo_c)"
        how = f"{source} $(pkg-config --libs avo_c) {loader} -o {source.with_suffix('')}" if whole else f"-c {source}"
        self.run(f"cc -std=c99 -Wpedantic {WARNINGS} $(pkg-config --cflags avo_c) {how}")
        if whole:
            self.said = self.run(str(source.with_suffix("")))

    def yaml(self, block):
        source = self.source(block, 'yaml')
        if any(line.startswith("scenes:") for line in pathlib.Path(self.folder, source).read_text().splitlines()):
            return  # of a sweep, which the commands behind it try
        self.run(f"avo validate {source}")

    def python(self, block):
        if self.arguments.python:
            self.said = self.run(f"/usr/bin/python3 {self.source(block, 'py')}")

    def lua(self, block):
        if "file" in block.marks and f"luajit {block.marks['file']}" in self.commands:
            return
        self.said = self.run(f"luajit {self.source(block, 'lua')}")

    def sh(self, block):
        lines = [line for line in re.sub(r"\\\n\s*", "", block.text).splitlines() if line.split("#")[0].strip()]
        lines = [line for line in lines if not BUILDS.match(line)]
        if not lines:
            return
        said = []
        for line in lines:
            word = re.sub(r"^(\w+=(\$\([^)]*\)|\S+) )+", "", line).split()[0]
            if word not in RUN and not (self.folder / word).exists():
                raise Failed(f"nobody knows how to try {word}")
            if word == "python3" and not self.arguments.python:
                continue
            status = int(block.marks.get("exits", 0)) if line == lines[-1] else 0
            said.append(self.run(self.as_here(line), status))
        self.said = "".join(said)

    def as_here(self, line):
        """Measurements are made short, and are of the instructions that there are."""
        line = re.sub(r"\bavo bench (?!.*--steps)", "avo bench --steps 1 ", line)
        line = re.sub(r"\bAVO_SIMD=\w+", "AVO_SIMD=auto", line)
        line = re.sub(r"^python3 ", "/usr/bin/python3 ", line)
        line = re.sub(r"^[gc]\+\+ ", f"{self.arguments.compiler} {self.arguments.flags} {WARNINGS} ", line)
        return re.sub(r"^g?cc (?!-E)", rf"\g<0>{WARNINGS} ", line)

    def compare(self, text):
        if self.said is None:
            raise Failed("nothing was run before it")
        pattern = "".join("(?:.*\n)*" if line == "...\n" else re.escape(line) for line in text.splitlines(True))
        if not re.fullmatch(pattern, self.said):
            raise Failed(f"the document says\n{text}but what ran said\n{self.said}")


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n\n")[0])
    parser.add_argument("prefix", type=pathlib.Path)
    parser.add_argument("avo", type=pathlib.Path)
    parser.add_argument("documents", nargs="*")
    parser.add_argument("--folder", type=pathlib.Path, default=ROOT / "build" / "snippets")
    parser.add_argument("--compiler", default="c++")
    parser.add_argument("--flags", default="")
    parser.add_argument("--python", type=pathlib.Path)
    parser.add_argument("--broken", action="store_true", help="every block of broken.md has to fail")
    arguments = parser.parse_args()
    if arguments.broken:
        arguments.documents = ["tests/manual/broken.md"]
    for name in ("prefix", "avo", "folder", "python"):
        if getattr(arguments, name):
            setattr(arguments, name, getattr(arguments, name).resolve())
    shutil.rmtree(arguments.folder, ignore_errors=True)
    patterns = () if arguments.documents else ("*.md", "bench/*.md", "docs/**/*.md")
    documents = arguments.documents + [str(path.relative_to(ROOT)) for pattern in patterns
                                       for path in sorted(ROOT.glob(pattern))]
    trials = [trial for trial in (Trial(arguments, document) for document in documents) if trial.blocks]
    trials.sort(key=lambda trial: -len(trial.blocks))  # the longest first
    assert arguments.documents or len(trials) >= 7, f"examples in {len(trials)} documents only"
    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        failures = [failure for failures in pool.map(Trial.all, trials) for failure in failures]
    number = sum(len(trial.blocks) for trial in trials)
    print(f"{number} blocks of {len(trials)} documents, {len(failures)} failures")
    if arguments.broken:
        found = {failure.split(" ")[0] for failure in failures}
        sys.exit("\n".join(f"{trial.document}:{block.line}: was taken for right" for trial in trials
                           for block in trial.blocks if f"{trial.document}:{block.line}:" not in found) or 0)
    sys.exit("\n".join(failures) or 0)


if __name__ == "__main__":
    main()
