# SPDX-License-Identifier: Apache-2.0
"""Python's lock is given up while the library computes, and threads that share a simulation wait for each other."""
import sys
import threading

import avo
import numpy as np


def in_thread(act):
    """Runs act() in a thread; returns what waits for it and raises what it has raised."""
    raised = []

    def run():
        try:
            act()
        except BaseException as error:  # told below
            raised.append(error)
    thread = threading.Thread(target=run)
    thread.start()

    def wait():
        thread.join()
        if raised:
            raise raised[0]
    return thread, wait


def counted_while(act):
    """How often this thread gets to run from the beginning to the end of act() in another one: not at all, if that
    keeps Python's lock. Python takes the lock away from nobody before the switch interval is over."""
    count, seen = [0], []
    usual = sys.getswitchinterval()
    sys.setswitchinterval(0.5)

    def run():
        seen.append(count[0])
        act()
        seen.append(count[0])
    thread, wait = in_thread(run)
    while thread.is_alive():
        count[0] += 1
    wait()
    sys.setswitchinterval(usual)
    return seen[1] - seen[0]


def is_ever(holds, act):
    """Whether the count is ever such, in twenty attempts: a machine that stalls for the switch interval spoils one."""
    return any(holds(counted_while(act)) for _ in range(20))


def lets_others_run(act):
    return is_ever(lambda count: count > 100, act)  # with the lock held: 0


def test_what_keeps_the_lock_is_told_from_what_does_not():
    numbers = list(range(1000000))
    assert is_ever(lambda count: count == 0, lambda: sorted(numbers))


def test_other_threads_run_during_a_step():
    simulation = avo.Simulation("uniform-20000", threads=1)
    assert lets_others_run(simulation.step)


def test_other_threads_run_during_a_batch():
    random = np.random.default_rng(1)
    robots = avo.Robots(position=random.uniform(0, 60, (3000, 2)), velocity=np.zeros((3000, 2)),
                        preferred_velocity=random.uniform(-1, 1, (3000, 2)), radius=0.2)
    neighbors = avo.Neighbors.among(robots, 6.0)
    planner = avo.Planner()
    assert lets_others_run(lambda: planner.plan(robots, neighbors))


def test_other_threads_run_while_a_simulation_is_made():
    scene = avo.Scenario("uniform-20000")
    assert lets_others_run(lambda: avo.Simulation(scene, threads=1))


def test_threads_may_share_a_simulation():
    simulation = avo.Simulation("circle-50", threads=1)
    stops = threading.Event()

    def read():
        out = np.empty((50, 2))
        while not stops.is_set():
            assert simulation.position().shape[1] == 2 and np.all(np.isfinite(simulation.velocity()))
            assert len(simulation.ids()) in (50, 51) and simulation.time >= 0.0
            simulation.perceive(0), simulation.save(), simulation.state_hash()
            try:
                simulation.position(out=out)
            except avo.Error:  # 51 robots now
                pass

    def edit():
        for _ in range(50):
            robot = simulation.add_robot(avo.RobotSetup(position=(200, 0), goal=(210, 0)))
            simulation.step()
            simulation.remove_robot(robot)
    waits = [in_thread(read)[1] for _ in range(3)]
    steps = [in_thread(edit)[1], in_thread(lambda: simulation.step(100))[1]]
    try:
        for wait in steps:
            wait()
    finally:
        stops.set()
    for wait in waits:
        wait()
    assert simulation.steps == 150 and len(simulation) == 50


def test_threads_may_share_what_a_batch_remembers():
    """Each of their decisions updates the whole of it, so that twice as many by one thread have the same bits."""
    n, rounds = 300, 40
    random = np.random.default_rng(1)
    position = np.stack(np.meshgrid(np.arange(20), np.arange(15)), axis=-1).reshape(-1, 2) * 1.3
    robots = avo.Robots(position=position, velocity=random.uniform(-0.3, 0.3, (n, 2)), radius=0.4,
                        preferred_velocity=random.uniform(-1.5, 1.5, (n, 2)), distance_to_goal=10.0)
    neighbors, planner = avo.Neighbors.among(robots, 5.0), avo.Planner()
    shared, alone = avo.Detours(n), avo.Detours(n)

    def remembered(detours):
        return [(d.angle, d.beside, d.congestion, d.has_arrived) for d in map(detours.__getitem__, range(n))]

    def decide():
        for _ in range(rounds):
            planner.plan(robots, neighbors, detour=shared)
            assert shared[n - 1].angle >= 0.0
    for k in range(2 * rounds):
        planner.plan(robots, neighbors, detour=alone)
        if k == rounds:
            halfway = remembered(alone)
    for _, wait in [in_thread(decide) for _ in range(2)]:
        wait()
    assert remembered(shared) == remembered(alone) != halfway


def test_two_simulations_in_two_threads_have_their_bits():
    simulations = [avo.Simulation("circle-50", threads=1) for _ in range(2)]
    alone = avo.Simulation("circle-50", threads=1)
    alone.step(200)
    for _, wait in [in_thread(lambda s=s: s.step(200)) for s in simulations]:
        wait()
    assert {s.state_hash() for s in simulations} == {alone.state_hash()}
