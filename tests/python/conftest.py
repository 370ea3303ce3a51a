# SPDX-License-Identifier: Apache-2.0
"""What the tests share."""
import os
import pathlib
import re
import subprocess

import avo
import pytest


@pytest.fixture
def source():
    """The folder of the sources."""
    return pathlib.Path(os.environ["AVO_SOURCE"])


@pytest.fixture
def command_line():
    """Runs the command line and returns what it did."""
    def run(*arguments):
        return subprocess.run([os.environ["AVO_BINARY"], *map(str, arguments)], capture_output=True, text=True)
    return run


@pytest.fixture
def pinned(source):
    """name: (scene, overrides, steps, hash), as C++ pins them."""
    text = (source / "tests/hashes/pinned_runs.cpp").read_text()
    runs = re.findall(r'\{"(\w+)",\s*"([\w-]+)",\s*\{("[^}]*")?\},\s*(\d+),\s*(0x[0-9a-f]+)\}', text)
    return {name: (scene, [o.strip().strip('"') for o in overrides.split(",") if o.strip()], int(steps), int(bits, 16))
            for name, scene, overrides, steps, bits in runs}


def run_to_the_end(scene, steps=0, threads=0):
    simulation = avo.Simulation(scene, threads=threads)
    if steps > 0:
        simulation.step(steps)
    while steps == 0 and simulation.can_step_by(scene.duration):
        simulation.step()
    return simulation
