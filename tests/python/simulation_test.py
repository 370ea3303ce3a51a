# SPDX-License-Identifier: Apache-2.0
"""Fleets: the bits of C++, arrays, edits, save and restore."""
import copy
import pickle

import avo
import numpy as np
import pytest
from conftest import run_to_the_end


@pytest.mark.parametrize("name", ["circle_100", "circle_100_by_avo_paper", "uniform_1000", "cars_100", "planes_12",
                                  "person", "moving_obstacle_exponential"])
def test_runs_have_the_bits_of_c_plus_plus(pinned, name):
    scene, overrides, steps, bits = pinned[name]
    assert run_to_the_end(avo.Scenario(scene, overrides), steps).state_hash() == bits


def test_many_steps_are_one_after_the_other():
    one, many = avo.Simulation("circle-20"), avo.Simulation("circle-20", threads=1)
    for _ in range(40):
        one.step()
    many.step(40)
    many.step(0)
    assert one.state_hash() == many.state_hash() and one.steps == many.steps == 40
    assert one.time == pytest.approx(4.0)


@pytest.mark.parametrize("column", ["position", "velocity", "goal", "new_velocity", "next_velocity", "acceleration",
                                    "heading", "radius", "max_speed", "max_acceleration", "preferred_speed",
                                    "violation", "applied_acceleration"])
def test_columns_are_copies_and_fill_out(column):
    simulation = avo.Simulation("cars-100")
    simulation.step(5)
    get = getattr(simulation, column)
    array = get()
    assert array.dtype == np.float64 and len(array) == 100 and array.ndim == (1 if array.shape == (100,) else 2)
    before = array.copy()
    simulation.step(5)
    assert np.array_equal(array, before), "a copy does not follow step()"
    array[...] = -1.0
    assert not np.any(get() == -1.0), "nor does the simulation follow a copy"
    out = np.full_like(array, np.nan)
    assert get(out=out) is out and np.array_equal(out, get())
    wide = np.full((100, 4) if array.ndim == 2 else 200, np.nan)
    strided = wide[:, ::2] if array.ndim == 2 else wide[::2]
    get(out=strided)
    assert np.array_equal(strided, get()) and np.isnan(wide).sum() == wide.size // 2


def test_columns_are_what_the_scene_says():
    scene = avo.Scenario("circle-10")
    simulation = avo.Simulation(scene)
    assert np.array_equal(simulation.position(), [robot.position for robot in scene.robots])
    assert np.array_equal(simulation.goal(), [robot.goal for robot in scene.robots])
    assert np.array_equal(simulation.radius(), [robot.radius for robot in scene.robots])
    assert simulation.ids().tolist() == list(range(10)) and len(simulation) == 10
    simulation.step()
    assert np.all(np.linalg.norm(simulation.velocity(), axis=1) > 0.0)
    assert {avo.PLAN_STATUS[s] for s in simulation.plan_status()} == {"optimal"}
    assert {avo.SAFETY_STATE[s] for s in simulation.plan_state()} == {"safe"}


@pytest.mark.parametrize("out", [np.zeros((9, 2)), np.zeros((10, 3)), np.zeros(20), np.zeros((10, 2), np.float32)])
def test_out_of_another_kind_is_refused(out):
    with pytest.raises(avo.Error, match=r"^out: found \(.*\) of float\d\d, must be \(10, 2\) of float64"):
        avo.Simulation("circle-10").position(out=out)
    assert np.all(out == 0.0)


def test_out_that_cannot_be_written_is_refused():
    out = np.zeros((10, 2))
    out.setflags(write=False)
    with pytest.raises(avo.Error, match="that cannot be written, must be"):
        avo.Simulation("circle-10").position(out=out)


def test_save_and_restore_go_back_to_the_same_bits():
    simulation = avo.Simulation("office")
    simulation.step(50)
    saved, bits = simulation.save(), simulation.state_hash()
    simulation.step(30)
    later = simulation.state_hash()
    assert isinstance(saved, bytes) and later != bits
    simulation.restore(saved)
    assert simulation.state_hash() == bits and simulation.steps == 50
    copies = [avo.Simulation.from_saved(saved, threads=1), pickle.loads(pickle.dumps(simulation)),
              copy.deepcopy(simulation), copy.copy(simulation)]
    for one in copies:
        assert one.state_hash() == bits
        one.step(30)
        assert one.state_hash() == later
    assert copies[1].name == "office"


def test_bad_bytes_are_refused_and_change_nothing():
    simulation = avo.Simulation("circle-10")
    saved, bits = simulation.save(), simulation.state_hash()
    for bad in (b"", saved[:-1], saved[:40] + b"x" + saved[41:], avo.Simulation("circle-12").save()[:99]):
        with pytest.raises(avo.Error):
            simulation.restore(bad)
        assert simulation.state_hash() == bits


def test_one_robot_is_a_row_of_the_arrays():
    simulation = avo.Simulation("mixed-fleet")
    simulation.step(20)
    for index, id in enumerate(simulation.ids()):
        robot = simulation.robot(id)
        assert robot.id == id and simulation.index_of(id) == index
        assert robot.position == tuple(simulation.position()[index])
        assert robot.velocity == tuple(simulation.velocity()[index])
        assert robot.goal == tuple(simulation.goal()[index])
        assert robot.heading == simulation.heading()[index]
        assert robot.applied_acceleration == simulation.applied_acceleration()[index]
        assert robot.plan.new_velocity == tuple(simulation.new_velocity()[index])
    before = simulation.robot(0)
    simulation.set_goal(0, (1, 2))
    assert simulation.robot(0).goal == tuple(simulation.goal()[0]) == (1.0, 2.0)
    assert before.goal != (1.0, 2.0), "it is a copy"
    with pytest.raises(avo.Error, match="found none of that id"):
        simulation.robot(len(simulation))


def test_robots_come_and_go():
    simulation = avo.Simulation("circle-10")
    added = simulation.add_robot(avo.RobotSetup(position=(50, 0), goal=(60, 0), max_speed=1.5))
    assert added == 10 and simulation.index_of(added) == 10 and simulation.setup(10).preferred_speed == 1.5
    simulation.remove_robot(3)
    assert simulation.index_of(3) is None and simulation.index_of(added) == 9
    assert simulation.robot(added).id == added and simulation.setup(added).max_speed == 1.5
    assert simulation.ids().tolist() == [0, 1, 2, 4, 5, 6, 7, 8, 9, 10]
    simulation.set_goal(added, (70, 0))
    assert tuple(simulation.goal()[9]) == (70.0, 0.0)
    simulation.step(3)
    assert simulation.position().shape == (10, 2) and simulation.velocity()[9, 0] > 0.0
    simulation.move_robot(added, (55, 1))
    assert tuple(simulation.position()[9]) == (55.0, 1.0) and not simulation.velocity()[9].any()
    assert tuple(simulation.goal()[9]) == (70.0, 0.0) and simulation.index_of(added) == 9


def test_goals_out_of_reach_are_told_before_the_start():
    scene = avo.Scenario({"version": 1, "obstacles": [{"polyline": [[5, -9], [5, 9]]}],
                          "robots": [{"position": [0, 0], "goal": [5, 0], "radius": 0.4},
                                     {"position": [0, 3], "goal": [3, 3], "radius": 0.4}]})
    told, = scene.out_of_reach()
    assert told["robot"] == 0 and told["is_in_wall"] and told["counts_as_there"]
    assert abs(told["distance_left"] - 0.4) < 1e-5 and abs(told["nearest"][0] - 4.6) < 1e-5


def test_doors_close_and_open():
    simulation = avo.Simulation("circle-2")
    cage = avo.StaticObstacle([avo.Chain([(-1.5, -1.5), (1.5, -1.5), (1.5, 1.5), (-1.5, 1.5)], closed=True)])
    goal = simulation.goal()[0]
    simulation.set_goal(0, (0, 0))
    door = simulation.add_obstacle(cage)
    assert simulation.unreachable() == [0]
    assert 1.5 < simulation.distance_left(0) < 3.0 and simulation.wait(0) is None
    assert simulation.route(0).length == float("inf")
    assert simulation.route(0).distance_left == simulation.distance_left(0)
    assert [(i, o.fill, len(o.chains)) for i, o in simulation.obstacles()] == [(door, "none", 1)]
    simulation.remove_obstacle(door)
    assert simulation.unreachable() == [] and simulation.obstacles() == []
    route = simulation.route(0)
    assert route.length == pytest.approx(np.linalg.norm(simulation.position()[0]))
    assert route.next == (0, 0) and route.distance_left == 0 and not simulation.is_at_goal(0)
    simulation.set_goal(0, goal)
    while not simulation.all_at_goal():
        simulation.step()
    assert simulation.at_goal().dtype == bool and simulation.at_goal().all() and simulation.is_at_goal(0)


def test_a_robot_waits_for_another_at_a_passage():
    sides = [{"polyline": [[-3, y], [3, y]]} for y in (-0.8, 0.8)] + \
        [{"polyline": [[x, y], [x, 12 * y]]} for x in (-3, 3) for y in (-0.8, 0.8)]
    simulation = avo.Simulation({"version": 1, "obstacles": sides, "robots": [
        {"position": [-7, 0], "goal": [10, 3]}, {"position": [12, 0], "goal": [-10, 3]}]})
    while simulation.wait(1) is None:
        assert simulation.can_step_by(20) and simulation.wait(0) is None
        simulation.step()
    wait = simulation.wait(1)
    assert wait.robot == 0 and not wait.inside and abs(wait.passage[0]) < 3
    assert sorted(side[1] for side in (wait.a, wait.b)) == pytest.approx([-0.8, 0.8])
    seen = simulation.perceive(1)
    assert seen.wait.robot == 0 and seen.guide == "passage"


@pytest.mark.parametrize("act, message", [
    (lambda s: s.remove_robot(99), "robot 99: found none of that id"),
    (lambda s: s.set_goal(-1, (0, 0)), "robot -1: found none of that id"),
    (lambda s: s.set_goal(0, (float("nan"), 0)), "goal"),
    (lambda s: s.move_robot(0, (float("inf"), 0)), "position"),
    (lambda s: s.remove_obstacle(5), "obstacle 5: found none of that id"),
    (lambda s: s.add_robot(avo.RobotSetup(position=(50, 0), goal=(0, 0), radius=-1)), "radius: found -1"),
    (lambda s: s.add_obstacle(avo.StaticObstacle([avo.Chain([(60, 0)])], radius=-1)), "radius: found -1"),
    (lambda s: s.perceive(10), "robot 10: found none of that id"),
    (lambda s: s.setup(-1), "robot -1: found none of that id"),
    (lambda s: s.explain(99), "robot 99: found none of that id"),
    (lambda s: s.step(-1), "n: found -1, must be >= 0"),
    (lambda s: avo.Simulation("circle-10", threads=-1), "threads: found -1"),
])
def test_wrong_edits_are_value_errors_that_change_nothing(act, message):
    simulation = avo.Simulation("circle-10")
    bits = simulation.state_hash()
    with pytest.raises(ValueError) as error:
        act(simulation)
    assert message in str(error.value)
    assert simulation.state_hash() == bits


def test_moving_obstacles_move():
    simulation = avo.Simulation("moving-obstacle")
    start = simulation.moving_obstacle_position()
    simulation.step(10)
    assert start.shape == (len(simulation.moving_obstacles()), 2)
    assert simulation.moving_obstacle_next_point() == [0] * len(start)
    assert np.allclose(simulation.moving_obstacle_position(), start + simulation.moving_obstacle_velocity())


def test_names_of_earlier_builds_say_the_present_ones():
    simulation = avo.Simulation("moving-obstacle")
    for act, message in [
        (lambda: simulation.obstacle_position(), "Simulation.obstacle_position: found a renamed attribute, "
                                                 "must be moving_obstacle_position"),
        (lambda: simulation.planner(0).has_way_out, "must be has_evasive_maneuver"),
        (lambda: simulation.colour, "'Simulation' object has no attribute 'colour'"),
    ]:
        with pytest.raises(AttributeError) as error:
            act()
        assert message in str(error.value)


def test_starts_that_break_assumptions_are_refused():
    scene = {"version": 1, "robots": [{"position": [0, 0], "goal": [9, 0]}, {"position": [0.75, 0], "goal": [9, 5]}]}
    overlap = "robot 0 and robot 1 overlap at the start: found 0.75 m between the centers"
    assert avo.Scenario(scene).complaints()[0].startswith(overlap)
    for refused in avo.Simulation, avo.run:
        with pytest.raises(avo.Error, match=overlap):
            refused(scene)
    scene["allow_broken_assumptions"] = True
    assert avo.Scenario(scene).allow_broken_assumptions
    assert avo.run(scene, threads=1)["robots"] == 2
    simulation = avo.Simulation("circle-4", threads=1)
    start, before = simulation.position()[0], simulation.state_hash()
    for edit in (
        lambda: simulation.add_robot(avo.RobotSetup(position=tuple(start), goal=(0, 0))),
        lambda: simulation.move_robot(1, tuple(start)),
        lambda: simulation.add_obstacle(avo.StaticObstacle([])),
    ):
        with pytest.raises(avo.Error):
            edit()
    assert simulation.state_hash() == before
