#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Fails where a figure or a table of the documents is of an older build: check_figures.py AVO PAPER_FIGURES

What is drawn or measured by a script names what it comes from, in a comment behind it, which the script writes: a run
and the state that it ends in, a part of a run that is measured, or what its steps cost.

<!-- drawn by scripts/gallery maze: maze 0x45888d8838d7c66d -->
<!-- measured by scripts/performance steps: circle-1000 duration=5 method=avo 0xefb0288d55a657e4 -->
<!-- measured by scripts/performance steps: 8832 instructions a robot-step of circle-100 avo_paper -->

The runs are simulated again, and the paper's figures drawn again, whose captions have their numbers. Times cannot be
compared; they are stale where the counted instructions of a step (bench/instructions/expected.json) are others by more
than 10 %.
"""
import csv
import json
import pathlib
import re
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parent.parent
PAGES = ("README.md", "docs/gallery.md", "docs/figures/README.md", "docs/performance.md")
RUN = re.compile(r"<!-- (?:drawn|measured) by (?P<script>[^:]+): "
                 r"(?P<run>\S+(?: [\w.]+=\S+)*) (?P<hash>0x[0-9a-f]{16}) -->")
COST = re.compile(r"<!-- measured by (?P<script>[^:]+): (?P<count>\d+) instructions a robot-step of (?P<case>.+?) -->")
NAME = re.compile(r"!\[.*?\]\((?P<picture>.+?)\)|^#+ (?P<heading>.+)$", re.M)
MARKED = re.compile(r"<!-- (\w+) -->\n(.*?)<!-- end of \1 -->", re.S)
OTHER = 0.1  # of the instructions


def state_hashes(avo, runs):
    """{run: state hash at its end}; a run is "SCENE", "SCENE KEY=VALUE..."."""
    scenes_of, found = {}, {}
    for run in runs:
        scene, *settings = run.split(" ")
        scenes_of.setdefault(tuple(settings), set()).add(scene)
    with tempfile.TemporaryDirectory() as folder:
        spec, table = pathlib.Path(folder, "sweep.yaml"), pathlib.Path(folder, "runs.csv")
        for settings, scenes in scenes_of.items():
            values = dict(setting.split("=", 1) for setting in settings)
            text = f"version: 1\nscenes: [{', '.join(sorted(scenes))}]\nuntil_arrived: false\n"
            if "method" in values:
                text += f"methods: [{values.pop('method')}]\n"
            if values:
                text += "parameters:\n" + "".join(f"  {key}: [{value}]\n" for key, value in values.items())
            spec.write_text(text)
            subprocess.run([avo, "sweep", spec, "--out", table, "-q"], check=True)
            with open(table, newline="") as file:
                found |= {" ".join((row["scene"], *settings)): row["state_hash"] for row in csv.DictReader(file)}
    return found


def counts():
    """{case: instructions a robot-step}"""
    cases = json.loads((ROOT / "bench/instructions/expected.json").read_text())["cases"]
    return {case: round(targets["avx2"]) for case, targets in cases.items()}


def comments(done, script, hashes, cases=()):
    """The lines that stand behind what SCRIPT has made of these runs, and at these costs."""
    lines = [f"<!-- {done} by {script}: {run} {state} -->" for run, state in hashes.items()]
    costs = {case: counts()[case] for case in cases}
    return lines + [f"<!-- measured by {script}: {cost} instructions a robot-step of {case} -->"
                    for case, cost in costs.items()]


def claims_of(page):
    """(line number, what it is about, match) of each comment."""
    about, found = page, []
    for number, line in enumerate((ROOT / page).read_text().splitlines(), 1):
        for match in NAME.finditer(line):
            about = match["picture"] or match["heading"]
        found += [(number, about, match) for pattern in (RUN, COST) for match in pattern.finditer(line)]
    return found


def unnamed(page):
    """Pictures of the gallery, and marked tables of any page, that do not name what they come from."""
    text, abouts = (ROOT / page).read_text(), {about for _, about, _ in claims_of(page)}
    names = [f"the table of {name}" for name, table in MARKED.findall(text) if not RUN.search(table)]
    if not abouts and not names:
        names = ["every figure"]
    if page == "docs/gallery.md":
        names += [match["picture"] for match in NAME.finditer(text) if match["picture"] not in {None, *abouts}]
    return names


def difference(claim, hashes, now):
    """How a claim has become wrong; none where it is right."""
    if "case" in claim.groupdict():
        before, count = int(claim["count"]), now.get(claim["case"])
        if count is None or abs(count / before - 1.0) > OTHER:
            return f"a robot-step of {claim['case']} takes {count} instructions now, and took {before}"
    elif hashes[claim["run"]] != claim["hash"]:
        return f"{claim['run']} ends in {hashes[claim['run']]} now, and did in {claim['hash']}"
    return None


def problems(avo):
    claims = {page: claims_of(page) for page in PAGES}
    runs = {claim["run"] for each in claims.values() for _, _, claim in each if "run" in claim.groupdict()}
    hashes, now, lines = state_hashes(avo, runs), counts(), []
    for page, each in claims.items():
        lines += [f"{page}: {name} does not say which run it is of; scripts/figures makes it again"
                  for name in unnamed(page)]
        stale = {}  # one line each, however many runs it is of
        for number, about, claim in each:
            if reason := difference(claim, hashes, now):
                line = f"{page}:{number}: {about} is stale: {reason}; {claim['script']} makes it again"
                stale.setdefault(about, line)
        lines += stale.values()
    return lines


def captions(text):
    """{title: caption} of the figures of the paper, but for Fig. 10, whose numbers are times."""
    sections = (part.partition("\n") for part in text.split("\n## ")[1:])
    return {title: body.strip() for title, _, body in sections if not title.startswith("Fig. 10:")}


def stale_captions(paper_figures):
    with tempfile.TemporaryDirectory() as folder:
        drawn = pathlib.Path(folder, "new", "folder")
        subprocess.run([paper_figures, drawn], check=True, stdout=subprocess.DEVNULL)
        now = captions((drawn / "README.md").read_text())
    page = "docs/figures/README.md"
    before = captions((ROOT / page).read_text())
    return [f"{page}: {title} is stale: its caption is another one now; scripts/paper makes it again"
            for title in now if now[title] != before.get(title)]


def main():
    if len(sys.argv) != 3:
        sys.exit("usage: check_figures.py AVO PAPER_FIGURES")
    avo, paper_figures = (pathlib.Path(name).resolve() for name in sys.argv[1:])
    sys.exit("\n".join(problems(avo) + stale_captions(paper_figures)) or 0)


if __name__ == "__main__":
    main()
