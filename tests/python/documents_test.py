# SPDX-License-Identifier: Apache-2.0
"""The snippets of docs/python.md and the examples run."""
import os
import pathlib
import re
import subprocess
import sys

import avo
import pytest

SOURCE = pathlib.Path(os.environ["AVO_SOURCE"])
EXAMPLES = sorted((SOURCE / "bindings/python/examples").glob("*.py"))


def run(path, folder, *arguments):
    result = subprocess.run([sys.executable, path, *arguments], cwd=folder, capture_output=True, text=True)
    assert result.returncode == 0, result.stderr
    return result.stdout


def test_snippets_of_the_document_run(tmp_path):
    text = (SOURCE / "docs/python.md").read_text()
    snippets = re.findall(r"^```python\n(.*?)^```$", text, re.M | re.S)
    assert len(snippets) >= 6
    for k, snippet in enumerate(snippets):
        path = tmp_path / f"snippet_{k}.py"
        path.write_text(snippet)
        run(path, tmp_path)


def test_everything_public_has_a_docstring():
    bare = []
    for name in avo.__all__:
        thing = getattr(avo, name)
        members = vars(thing).items() if isinstance(thing, type) else []
        for where, part in [(name, thing), *((f"{name}.{key}", value) for key, value in members if key[0] != "_")]:
            if (callable(part) or isinstance(part, property)) and not (part.__doc__ or "").strip():
                bare.append(where)
    assert bare == []


def test_there_are_five_examples():
    assert [path.stem for path in EXAMPLES] == ["compare_methods", "drones", "fleet", "one_robot", "own_method"]


@pytest.mark.parametrize("path", EXAMPLES, ids=lambda path: path.stem)
def test_examples_run(path, tmp_path):
    said = run(path, tmp_path)
    if path.stem == "one_robot":
        assert re.search(r"arrived after \d+\.\d s, at least \d\.\d\d m from the other", said), said
    elif path.stem == "fleet":
        assert "20 of 20 robots arrived" in said
        assert (tmp_path / "fleet.svg").read_text().count("<circle") == 20
    elif path.stem == "drones":
        assert "30 of 30 drones arrived" in said
        assert 1.0 <= float(re.search(r"nearest: (\d\.\d\d) m", said).group(1)) < 2.0, said
    elif path.stem == "own_method":
        touching = {line[:14].strip(): int(line.split()[-7]) for line in said.splitlines()}
        assert list(touching) == ["avo", "orca_clamped", "field", "field behind"]
        assert touching["field"] > 0 and touching["field behind"] == touching["avo"] == 0, said
    else:
        lines = said.splitlines()
        assert [line.split()[0] for line in lines[1:]] == [
            "avo", "avo_paper", "velocity_obstacle", "orca", "orca_clamped", "reciprocal_velocity_obstacle",
            "buffered_voronoi"]
        assert lines[1].split()[1:3] == ["50", "0"], "method avo brings all there, and none collide"
