# SPDX-License-Identifier: Apache-2.0
"""The stubs: complete, and checked where they are used."""
import inspect
import os
import pathlib
import re
import subprocess
import sys

import avo
import avo._avo

ACCEPTED = """
import numpy as np
import avo

half, one, two = np.float32(0.5), np.int64(1), np.array([1, 2])
robot = avo.Robot(position=(half, one), velocity=[half, 1], radius=half, heading=one, max_braking=half)
robot.radius, robot.position, robot.max_braking = one, np.array([1.0, 2.0], dtype=np.float32), np.float64(1.0)
avo.RobotSetup(position=two, goal=(3, 4), time_step=half).layers = (1, 2)
avo.Neighbor(position=two, age=one)
avo.Planner(sensing_error=[0.1, half], sensing_noise=np.array([0.0, 0.0, 1.0]), max_neighbors=np.int64(4), time_step=half)
avo.Chain(np.zeros((2, 2)))
avo.Simulation(b"circle-3", threads=one).step(one)
avo.explain("circle-3", one, half)
"""
SOURCE = pathlib.Path(os.environ["AVO_SOURCE"])
PACKAGE = pathlib.Path(avo.__file__).parent


def mypy(*paths, folder):
    return subprocess.run([sys.executable, "-m", "mypy", "--strict", "--cache-dir", str(folder / "cache"),
                           "--config-file", os.devnull, *map(str, paths)],
                          env=dict(os.environ, MYPYPATH=str(PACKAGE.parent)), capture_output=True, text=True)


def test_package_examples_and_snippets_have_the_types_of_the_stubs(tmp_path):
    snippets = re.findall(r"^```python\n(.*?)^```$", (SOURCE / "docs/python.md").read_text(), re.M | re.S)
    paths = []
    for k, snippet in enumerate(snippets):
        paths.append(tmp_path / f"snippet_{k}.py")
        paths[-1].write_text(snippet)
    accepted = tmp_path / "accepted.py"
    accepted.write_text(ACCEPTED)
    paths.append(accepted)
    exec(compile(ACCEPTED, "accepted.py", "exec"), {})  # what the stubs accept runs
    wrong = tmp_path / "wrong.py"
    wrong.write_text("import avo\navo.Planner(method='avo_papr')\navo.Simulation('circle-10').stpe()\n"
                     "avo.Robot(position=(0.0, 0.0)).radius = 'wide'\n")
    result = mypy(*(SOURCE / "bindings/python/examples").glob("*.py"), *paths, wrong, PACKAGE, folder=tmp_path)
    errors = [line for line in result.stdout.splitlines() if ": error:" in line]
    assert [line for line in errors if "wrong.py" not in line] == [], result.stdout + result.stderr
    assert [re.search(r"wrong\.py:(\d)", line).group(1) for line in errors] == ["2", "3", "4"], result.stdout


def members_of_stub():
    """class or "": names, as the stub has them."""
    members, name = {"": set()}, ""
    for line in (PACKAGE / "_avo.pyi").read_text().splitlines():
        if found := re.match(r"class (\w+)", line):
            name = found.group(1)
            members[name] = set()
            members[""].add(name)
        elif found := re.match(r"def (\w+)|(\w+): ", line):
            name = None  # what follows are arguments
            members[""].add(found.group(1) or found.group(2))
        elif name and (found := re.match(r"    def (\w+)|    (\w+): ", line)):
            members[name].add(found.group(1) or found.group(2))
    return members


def test_the_stub_has_all_that_the_extension_has_and_no_more():
    stub = members_of_stub()
    assert {n for n in stub[""] if not n.startswith("_") or n == "__version__"} == \
        {n for n in vars(avo._avo) if not n.startswith("_") or n == "__version__"}
    for name in stub[""]:
        found = getattr(avo._avo, name, None)
        if not inspect.isclass(found) or name == "Error":
            continue
        public = {n for n in vars(found) if not n.startswith("_") or n == "_repr_svg_"}
        assert {n for n in stub[name] if not n.startswith("__")} == public, name


def test_everything_public_is_exported_and_told():
    assert set(avo.__all__) - {"svg", "MethodBatch"} == {n for n in vars(avo._avo) if not n.startswith("_")} | {"__version__"}
    for name in avo.__all__:
        found = getattr(avo, name)
        if callable(found):
            assert found.__doc__, name
            for member in vars(found).values() if inspect.isclass(found) else ():
                if inspect.isroutine(member) and not getattr(member, "__func__", member).__name__.startswith("_"):
                    assert member.__doc__.splitlines()[2:], member  # below its signature
