# SPDX-License-Identifier: Apache-2.0
"""What Python costs: a step of 100 robots called from Python, against a loop in C++; and how long two simulations
in two threads take, against one after the other. On a machine with two idle cores:

    PYTHONPATH=build/release/python /usr/bin/python3 bench/python_steps.py
"""
import statistics
import threading
import time
from collections.abc import Callable

import avo

STEPS = 10  # so few that other programs seldom interrupt them


def seconds(act: Callable[[], object]) -> float:
    start = time.perf_counter()
    act()
    return time.perf_counter() - start


def one_by_one(simulation: avo.Simulation) -> None:
    for _ in range(STEPS):
        simulation.step()


def step_times() -> tuple[float, float]:
    """s: the shortest times of a step, in one call of many and in many calls of one."""
    simulation = avo.Simulation("circle-100", threads=1)
    simulation.step(50)
    saved, together, single = simulation.save(), [], []
    for _ in range(1000):
        for act, times in ((lambda: simulation.step(STEPS), together), (lambda: one_by_one(simulation), single)):
            simulation.restore(saved)
            simulation.step()
            times.append(seconds(act) / STEPS)
    return min(together), min(single)


def threads_ratio() -> float:
    """A few hundred milliseconds each: so long that the start of a thread counts little."""
    def together(simulations: list[avo.Simulation]) -> None:
        threads = [threading.Thread(target=simulation.step, args=(300,)) for simulation in simulations]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()

    def one_after_the_other(simulations: list[avo.Simulation]) -> None:
        for simulation in simulations:
            simulation.step(300)
    parallel, serial = ([avo.Simulation("uniform-1000", threads=1) for _ in range(2)] for _ in range(2))
    return seconds(lambda: together(parallel)) / seconds(lambda: one_after_the_other(serial))


if __name__ == "__main__":
    by_cpp, by_python = step_times()
    print(f"a step: {by_cpp * 1e6:.2f} us in C++'s loop, {by_python * 1e6:.2f} us in Python's, "
          f"{100 * (by_python / by_cpp - 1):.1f} % more")
    ratios = [threads_ratio() for _ in range(9)]
    print(f"two threads: {statistics.median(ratios):.2f} of one after the other (median of 9, least {min(ratios):.2f})")
