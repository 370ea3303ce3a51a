# SPDX-License-Identifier: Apache-2.0
"""One robot's decision, and batches of them."""
import math
import pickle

import avo
import numpy as np
import pytest

N = 60


def crowd(seed=7):
    """A dense crowd in which robots hinder each other."""
    random = np.random.default_rng(seed)
    grid = np.stack(np.meshgrid(np.arange(10), np.arange(6)), axis=-1).reshape(-1, 2) * 1.6
    return avo.Robots(position=grid + random.uniform(-0.2, 0.2, (N, 2)), velocity=random.uniform(-0.5, 0.5, (N, 2)),
                      preferred_velocity=random.uniform(-1.5, 1.5, (N, 2)), radius=random.uniform(0.3, 0.5, N),
                      max_acceleration=1.5, distance_to_goal=10.0)


def same(plans, k, plan):
    assert tuple(plans.new_velocity()[k]) == plan.new_velocity
    assert tuple(plans.next_velocity()[k]) == plan.next_velocity
    assert tuple(plans.acceleration()[k]) == plan.acceleration
    assert plans.violation()[k] == plan.violation
    assert avo.PLAN_STATUS[plans.status()[k]] == plan.status
    assert avo.SAFETY_STATE[plans.state()[k]] == plan.state


def test_one_robot_gives_way_to_one_that_comes():
    plan = avo.Planner().plan(avo.Robot(position=(0, 0), velocity=(1.5, 0), preferred_velocity=(1.5, 0)),
                              [avo.Neighbor(position=(6, 0.1), velocity=(-1.5, 0))])
    assert plan.status == "optimal" and plan.state == "safe"
    assert plan.acceleration[1] < -0.5
    assert math.hypot(*plan.acceleration) <= 1.0 + 1e-12


def test_a_contact_is_named_with_its_depth():
    planner, robot = avo.Planner(), avo.Robot(position=(10, 4), velocity=(0, 0), preferred_velocity=(0, 0))
    far, near = (avo.Neighbor(position=(x, 4), velocity=(0, 0)) for x in (15, 10.97))
    plan = planner.plan(robot, [far, near])
    assert (plan.status, plan.neighbor, plan.wall) == ("overlapping", 1, -1)
    assert plan.depth == pytest.approx(0.03, abs=1e-6)
    report = planner.state(robot, [far, near])
    assert (report.neighbor, report.wall) == (1, -1) and report.depth == pytest.approx(0.03)
    plan = planner.plan(robot, [far], [avo.Wall((0, 9), (20, 9)), avo.Wall((0, 4.4), (20, 4.4))])
    assert (plan.status, plan.neighbor, plan.wall) == ("overlapping", -1, 1)
    plan = planner.plan(robot, [far])
    assert (plan.neighbor, plan.wall, plan.depth) == (-1, -1, 0.0)


@pytest.mark.parametrize("method", ["avo", "avo_paper", "velocity_obstacle", "orca", "orca_clamped",
                                    "reciprocal_velocity_obstacle", "buffered_voronoi", "external",
                                    "external_clamped"])
def test_batches_have_the_bits_of_single_decisions(method):
    planner, robots = avo.Planner(method=method), crowd()
    neighbors = avo.Neighbors.among(robots, 5.0)
    walls = [avo.Wall((-1, -1), (20, -1)), avo.Wall((3.0, 12.0), (3.0, 12.0), radius=0.5)]
    plans = planner.plan(robots, neighbors, walls)
    for k in range(N):
        same(plans, k, planner.plan(robots[k], neighbors.of(k), walls))
    if method == "avo":
        assert len(set(plans.status().tolist())) > 1, "the crowd is too easy to tell batches apart"


def test_batches_remember_as_single_robots_do():
    planner, robots = avo.Planner(), crowd()
    neighbors = avo.Neighbors.among(robots, 5.0)
    detours, single = avo.Detours(N), [avo.Detour() for _ in range(N)]
    for _ in range(20):
        plans = planner.plan(robots, neighbors, detour=detours)
        for k in range(N):
            same(plans, k, planner.plan(robots[k], neighbors.of(k), detour=single[k]))
            assert (detours[k].angle, detours[k].congestion) == (single[k].angle, single[k].congestion)
    assert any(detour.angle > 0.0 or detour.congestion > 0.0 for detour in single)


def test_neighbors_in_csr_form_are_those_within_the_radius():
    robots = crowd()
    position = np.array([robots[k].position for k in range(N)])
    velocity = np.array([robots[k].velocity for k in range(N)])
    radius = np.array([robots[k].radius for k in range(N)])
    rows, offsets = [], [0]
    for k in range(N):
        away = np.linalg.norm(position - position[k], axis=1)
        near = [j for j in np.argsort(away, kind="stable") if j != k and away[j] <= 5.0]
        rows += near
        offsets.append(len(rows))
    mine = avo.Neighbors(position=position[rows], velocity=velocity[rows], offsets=offsets, radius=radius[rows],
                         max_acceleration=1.5)
    theirs = avo.Neighbors.among(robots, 5.0)
    assert np.array_equal(mine.offsets, theirs.offsets)
    assert np.array_equal(avo.Planner().plan(robots, mine).new_velocity(),
                          avo.Planner().plan(robots, theirs).new_velocity())


def test_movers_of_a_batch_move_on():
    robot = avo.Robots(position=[[0, 0]], velocity=[[1, 0]], preferred_velocity=[[1, 0]])
    mover = dict(position=[[4, 0.2]], velocity=[[-1, 0]], offsets=[0, 1])
    one = avo.Neighbor(position=(4, 0.2), velocity=(-1, 0), behavior="moves_on", acceleration=(0.1, 0))
    plans = avo.Planner().plan(robot, avo.Neighbors(**mover, moves_on=True, acceleration=[[0.1, 0]]))
    same(plans, 0, avo.Planner().plan(robot[0], [one]))
    assert plans[0].acceleration != avo.Planner().plan(robot, avo.Neighbors(**mover))[0].acceleration


def test_the_likely_deviation_of_a_mover_counts_in_evasions():
    planner, robot = avo.Planner(), avo.Robots(position=[[0, 0]], velocity=[[2, 0]], preferred_velocity=[[2, 0]])
    mover = dict(position=(3, 2.5), velocity=(0, -0.5))
    plans = {likely: planner.plan(robot[0], [avo.Neighbor(**mover, behavior="moves_on", likely_deviation=likely)])
             for likely in (0.0, 0.3, 0.6)}
    assert len({plan.acceleration for plan in plans.values()}) == 3
    column = {key: [value] for key, value in mover.items()}
    for likely, plan in plans.items():
        same(planner.plan(robot, avo.Neighbors(**column, offsets=[0, 1], moves_on=True, likely_deviation=likely)), 0, plan)
    assert avo.Neighbor(**mover, likely_deviation=0.3).likely_deviation == 0.3
    negative = avo.Neighbor(**mover, behavior="moves_on", likely_deviation=-1)
    assert planner.plan(robot[0], [negative]).status == "invalid_input"


def test_those_who_cooperate_do_their_share_and_promise_nothing():
    robot = avo.Robots(position=[[0, 0]], velocity=[[1.5, 0]], preferred_velocity=[[1.5, 0]])
    other = dict(position=[[4, 0.2]], velocity=[[-1.5, 0]], offsets=[0, 1])
    plans = {word: avo.Planner().plan(robot[0], [avo.Neighbor(position=(4, 0.2), velocity=(-1.5, 0), behavior=word)])
             for word in ("decides", "moves_on", "cooperates")}
    assert len({plan.acceleration for plan in plans.values()}) == 3
    same(avo.Planner().plan(robot, avo.Neighbors(**other, cooperates=True)), 0, plans["cooperates"])
    paper = avo.Planner(method="avo_paper")
    assert paper.plan(robot, avo.Neighbors(**other, cooperates=True))[0].acceleration == \
        paper.plan(robot, avo.Neighbors(**other))[0].acceleration
    with pytest.raises(avo.Error, match="cooperates: found True for a neighbor that moves on, must be False"):
        avo.Neighbors(**other, cooperates=True, moves_on=True)
    with pytest.raises(ValueError):
        avo.Neighbor(position=(0, 0), behavior="helps")


def test_an_evasion_is_told():
    planner, robot = avo.Planner(), avo.Robot(position=(0, 0), velocity=(2, 0), preferred_velocity=(2, 0))
    others = [avo.Neighbor(position=(9, 9), velocity=(1, 0), behavior="moves_on"),
              avo.Neighbor(position=(2, 3), velocity=(0, -1), behavior="moves_on")]
    assert planner.plan(robot, others).evading
    way = planner.evasion(robot, others)
    assert way.neighbor == 1 and way.duration > 0 and np.hypot(*way.velocity) > 0
    assert planner.has_evasive_maneuver(robot, others)
    assert not planner.plan(robot, others[:1]).evading and planner.evasion(robot, others[:1]) is None
    late = avo.Neighbor(position=(-1.5, 0), velocity=(20, 0), behavior="moves_on")
    assert not planner.has_evasive_maneuver(robot, [late])
    batch = avo.Robots(position=[[0, 0]], velocity=[[2, 0]], preferred_velocity=[[2, 0]])
    plans = planner.plan(batch, avo.Neighbors(position=[[2, 3]], velocity=[[0, -1]], offsets=[0, 1], moves_on=True))
    assert plans.evading().dtype == bool and plans.evading().tolist() == [True]


def test_movers_may_be_met_at_rest_only():
    assert not avo.Planner().never_swerves and avo.Planner(never_swerves=True).never_swerves
    with pytest.raises(avo.Error, match="never_swerves: found true, must be false with method orca"):
        avo.Planner(method="orca", never_swerves=True)


def test_batches_have_the_fields_of_single_robots():
    """Each column changes decisions, and as it does for one robot."""
    n = 6
    at = dict(position=[[0.0, 0.0]] * n, velocity=[[1.2, 0.0]] * n)
    others = dict(position=[[2.2, 0.3]] * n, velocity=[[-0.6, 0.0]] * n)
    braking, ages, errors = np.linspace(0.3, 1.0, n), 2 * np.arange(n), np.linspace(0.0, 0.5, n)
    columns = [({"max_braking": braking}, {}), ({}, {"max_braking": braking}), ({}, {"age": ages}),
               ({}, {"position_error": errors}), ({"max_braking": 0.5}, {"max_braking": 0.4, "age": 2})]
    planner = avo.Planner()
    plain = planner.plan(avo.Robots(preferred_velocity=at["velocity"], **at),
                         avo.Neighbors(offsets=range(n + 1), **others)).acceleration()
    for of_robots, of_neighbors in columns:
        robots = avo.Robots(preferred_velocity=at["velocity"], **at, **of_robots)
        neighbors = avo.Neighbors(offsets=range(n + 1), **others, **of_neighbors)
        plans = planner.plan(robots, neighbors)
        assert not np.array_equal(plans.acceleration(), plain), (of_robots, of_neighbors)
        for k in range(n):
            def own(columns):
                return {name: column if np.ndim(column) == 0 else column[k].item() for name, column in columns.items()}
            one = avo.Robot(position=(0, 0), velocity=(1.2, 0), preferred_velocity=(1.2, 0), **own(of_robots))
            seen = avo.Neighbor(position=(2.2, 0.3), velocity=(-0.6, 0), **own(of_neighbors))
            assert neighbors.of(k)[0].age == seen.age and robots[k].max_braking == one.max_braking
            same(plans, k, planner.plan(one, [seen]))


def test_those_who_sense_each_other_know_how_they_brake():
    robots = avo.Robots(position=[[0, 0], [4, 0]], velocity=[[0, 0]] * 2, preferred_velocity=[[0, 0]] * 2,
                        max_braking=[0.5, 0.7])
    neighbors = avo.Neighbors.among(robots, 5.0)
    assert [neighbors.of(k)[0].max_braking for k in range(2)] == [0.7, 0.5]


def test_a_planner_decides_what_the_simulation_decides():
    scene = avo.Scenario("circle-20")
    simulation = avo.Simulation(scene, threads=1)
    simulation.step(60)
    planner = avo.Planner(**scene.planner_options())
    seen = [simulation.perceive(k) for k in range(20)]
    simulation.step()
    for k, perception in enumerate(seen):
        plan = planner.plan(perception.robot, perception.neighbors, perception.walls, perception.detour)
        assert plan.acceleration == tuple(simulation.acceleration()[k])


def test_options_are_those_customary_for_the_method():
    assert (avo.Planner().control_time, avo.Planner().certificate) == (2.0, "braking_trajectories")
    orca = avo.Planner(method="orca")
    assert (orca.control_time, orca.time_horizon, orca.certificate) == (4.0, 10.0, "none")
    assert (avo.Planner().response_time, orca.response_time) == (0.1, 0.0)
    assert (avo.Planner().comfort_acceleration, avo.Planner().comfort_jerk, avo.Planner().margin) == (None, None, 0.0)


def test_options_say_how_gently_robots_move():
    planner = avo.Planner(response_time=0.2, comfort_acceleration=0.6, comfort_jerk=2, margin=0.1)
    assert (planner.response_time, planner.comfort_acceleration) == (0.2, 0.6)
    assert (planner.comfort_jerk, planner.margin) == (2.0, 0.1)
    assert planner.response_time_of(2.0, 0.5) == pytest.approx(0.8)
    assert planner.response_time_of(2.0, 8.0) == pytest.approx(0.6 / (0.8 * 2.0)), "by comfort_jerk"
    assert avo.Planner(response_time=0).response_time_of(2.0, 0.5) == 0.0
    robot, memory = avo.Robot(position=(0, 0), velocity=(0, 0), preferred_velocity=(1.5, 0)), avo.Detour()
    for k in range(1, 4):  # 2 m/s^3
        plan = planner.plan(robot, detour=memory)
        assert plan.acceleration == pytest.approx((min(0.1875 * k, 0.6), 0.0), abs=1e-6)
        assert (memory.acceleration_x, memory.acceleration_y) == pytest.approx(plan.acceleration, abs=1e-6)
        robot.velocity = plan.next_velocity
    for wrong in {"response_time": -1}, {"comfort_acceleration": 0}, {"comfort_jerk": -1}, {"margin": -0.1}:
        with pytest.raises(avo.Error, match=next(iter(wrong))):
            avo.Planner(**wrong)
        with pytest.raises(avo.Error, match="with method orca|must be"):
            avo.Planner(method="orca", **{key: 1.0 for key in wrong})


def test_out_is_written_and_returned():
    robots = crowd()
    plans = avo.Planner().plan(robots, avo.Neighbors.among(robots, 5.0))
    out = np.zeros((N, 2))
    assert plans.new_velocity(out=out) is out
    assert np.array_equal(out, plans.new_velocity()) and np.any(out != 0.0)


def test_bad_numbers_of_a_situation_are_an_outcome():
    assert avo.Planner().plan(avo.Robot(position=(math.nan, 0))).status == "invalid_input"


def one_robot(**fields):
    return avo.Robots(**{"position": [[0, 0]], "velocity": [[0, 0]], "preferred_velocity": [[0, 0]], **fields})


def one_neighbor(**fields):
    return avo.Neighbors(**{"position": [[0, 0]], "velocity": [[0, 0]], "offsets": [0, 1], **fields})


@pytest.mark.parametrize("make, message", [
    (lambda: avo.Planner(method="avo_papr"), 'method: found "avo_papr", did you mean "avo_paper"? Must be one of '
     'avo, avo_paper, velocity_obstacle, orca, orca_clamped, reciprocal_velocity_obstacle, buffered_voronoi, external, '
     'external_clamped'),
    (lambda: avo.Planner(time_step=-1.0), "time_step: found -1"),
    (lambda: avo.Planner(certificate="stopping_capsules"),
     'certificate: found "stopping_capsules", must be braking_trajectories: stopping_capsules was removed'),
    (lambda: avo.Planner(certificate="unknown"),
     'certificate: found "unknown", must be one of none, braking_trajectories'),
    (lambda: avo.Planner(samples=0), "samples: found the removed option, must be left out: all half-planes are exact"),
    (lambda: avo.Planner(method="orca", certificate="braking_trajectories"), "must be none with method orca"),
    (lambda: avo.Robot(position=(1, 2, 3)), "point: found 3 numbers, must be 2: (x, y)"),
    (lambda: avo.Robots(position=[1, 2], velocity=[[0, 0]], preferred_velocity=[[0, 0]]),
     "position: found shape (2,), must be (n, 2)"),
    (lambda: avo.Robots(position=[[1, 2]], velocity=[[0, 0]] * 2, preferred_velocity=[[0, 0]]),
     "velocity: found 2 rows, must be 1 as of position"),
    (lambda: avo.Robots(position=[[1, 2]], velocity=[[0, 0]], preferred_velocity=[[0, 0]], radius=[1, 2]),
     "radius: found shape (2,), must be one number, or 1 of them"),
    (lambda: avo.Neighbors(position=[[1, 2]], velocity=[[0, 0]], offsets=[0, 2]),
     "offsets: found [0 2], must ascend from 0 to the 1 rows of position, one more than robots"),
    (lambda: avo.Neighbors(position=[[1, 2]], velocity=[[0, 0]], offsets=[0, 1.0]),
     "offsets: found [0, 1.0], must be whole numbers"),
    (lambda: avo.Neighbors(position=[[1, 2]], velocity=[[0, 0]], offsets=[0, 1], acceleration=5.0),
     "acceleration: found one number, must be (m, 2), or 0"),
    (lambda: one_neighbor(age=1.5), "age: found 1.5, must be a whole number, 0 to 1000000"),
    (lambda: one_neighbor(age=-1), "age: found -1, must be a whole number"),
    (lambda: one_neighbor(loiter=None), "loiter: found in a batch, must be left out: robots of other models than"),
    (lambda: one_robot(model=avo.Holonomic()), "model: found in a batch, must be left out"),
    (lambda: one_robot(heading=[0.0]), "heading: found in a batch, must be left out"),
    (lambda: one_robot(max_breaking=1.0), 'field: found "max_breaking", did you mean "max_braking"? Must be '
     'one of position, velocity, preferred_velocity, radius, max_acceleration, max_speed, distance_to_goal, priority, '
     'max_braking'),
    (lambda: one_neighbor(behavior="decides"), 'field: found "behavior", must be one of position, velocity, offsets'),
    (lambda: one_robot(radius=1j), "radius: found an array of complex128, must be real numbers"),
    (lambda: one_robot(position=[[1j, 2]]), "position: found an array of complex128, must be real numbers"),
    (lambda: one_robot(velocity=[["1", "2"]]), "velocity: found an array of <U1, must be real numbers"),
    (lambda: one_robot(velocity=[[None, 2]]), "velocity: found an array of object, must be real numbers"),
    (lambda: one_robot(velocity=[[1, 2], [3]]), "velocity: found "),
    (lambda: one_robot(max_braking="strong"), "max_braking: found an array of <U6, must be real numbers"),
    (lambda: one_neighbor(acceleration=[[0j, 0]]), "acceleration: found an array of complex128, must be real numbers"),
    (lambda: one_neighbor(moves_on="no"), "moves_on: found an array of <U2, must be real numbers"),
    (lambda: avo.Worlds(1, avo.Scenario("circle-2")).step([[[1j, 0]] * 2], [True]),
     "actions: found an array of complex128, must be real numbers"),
    (lambda: avo.Scenario("-"), 'scene: found "-", must be a name or a file'),
    (lambda: avo.RobotSetup(position=(0, 0), goal=(1, 0), layers=[10**30]), f"layers: found {10**30}, must be 0 to 31"),
    (lambda: avo.Planner().plan(crowd(), avo.Neighbors(position=[[1, 2]], velocity=[[0, 0]], offsets=[0, 1])),
     f"neighbors: found those of 1 robots, must be those of {N}"),
])
def test_wrong_use_is_a_value_error(make, message):
    with pytest.raises(ValueError) as error:
        make()
    assert message in str(error.value) and isinstance(error.value, avo.Error)


@pytest.mark.filterwarnings("error")
@pytest.mark.parametrize("point", [(1j, 0), np.array([1j, 0]), np.array([1, 1j], dtype="complex64"), ("1", "2"),
                                   np.array(["1", "2"])])
def test_points_are_real(point):
    with pytest.raises(TypeError):
        avo.Robot(position=point)


def test_unknown_options_are_refused_by_name():
    with pytest.raises(TypeError, match="found the unknown option time_stp"):
        avo.Planner(time_stp=0.1)
    with pytest.raises(TypeError, match="Planner: time_step: found 'soon', must be of another type"):
        avo.Planner(time_step="soon")


def test_options_come_back_and_none_is_customary():
    given = {"method": "avo", "motion": "exponential", "control_time": 1.5, "time_horizon": 4.0, "response_time": 0.2,
             "comfort_acceleration": 0.7, "comfort_jerk": 2.0, "margin": 0.1, "time_step": 0.2, "certificate": "none",
             "max_neighbors": 5, "localization_error": 0.03, "clock": "common", "longest_step": 0.0,
             "arrival_distance": 0.4, "never_swerves": True, "wall_range": math.inf}
    planner, usual = avo.Planner(**given), avo.Planner(**dict.fromkeys(given.keys() - {"method", "wall_range"}))
    assert {key: getattr(planner, key) for key in given} == given
    assert all(getattr(usual, key) == getattr(avo.Planner(), key) for key in given)
    orca = avo.Planner(certificate=None, method="orca", control_time=None)
    assert (orca.control_time, orca.certificate) == (4.0, "none")


def moved_beside(mover):
    """m: how far a robot at rest goes in 1.2 s, beside a mover that stands meanwhile."""
    robot, planner = avo.Robot(position=(0, 0), radius=0.4), avo.Planner()
    for step in range(12):
        mover.trajectory_time = 0.1 * step
        before, robot.velocity = robot.velocity, planner.plan(robot, [mover]).next_velocity
        robot.position = tuple(p + 0.05 * (v + w) for p, v, w in zip(robot.position, before, robot.velocity))
    return math.hypot(*robot.position)


def test_what_is_known_of_a_mover_keeps_robots_out_of_its_way():
    trajectory = avo.Trajectory([(0, 0, 4), (1.2, 0, 4), (2.2, 0, 0), (3, 0, 0)], error=0.01)
    assert trajectory.at(1.7) == pytest.approx((0, 2)) and trajectory.places[1] == (1.2, 0.0, 4.0)
    assert trajectory.error == 0.01 and trajectory.repeats_from is None
    round = pickle.loads(pickle.dumps(avo.Trajectory(trajectory.places, error=0.2, repeats_from=1.2)))
    assert round.places == trajectory.places and (round.error, round.repeats_from) == (0.2, 1.2)
    mover = avo.Neighbor(position=(0, 4), radius=0.5, behavior="moves_on", trajectory=trajectory)
    del trajectory  # the neighbor keeps it
    again = pickle.loads(pickle.dumps(mover))
    assert again.trajectory.places == mover.trajectory.places and again.trajectory is not mover.trajectory
    assert moved_beside(mover) == moved_beside(again) > 0.1
    mover.trajectory = None
    assert moved_beside(mover) == 0
    with pytest.raises(avo.Error, match="places.1.time: found 0, must be > 0 s"):
        avo.Trajectory([(0, 0, 0), (0, 1, 0)])
    with pytest.raises(avo.Error, match="repeats_from: found 1, must be the time of one of the places"):
        avo.Trajectory([(0, 0, 0)], repeats_from=1)


def test_walls_are_known_by_the_ids_of_their_obstacles():
    scene = avo.Scenario.from_yaml(
        "version: 1\nobstacles: [{polyline: [[9, -9], [9, 9]]}, {polyline: [[-3, -9], [-3, 9], [-4, 9]]}]\n"
        "robots: [{position: [0, 3], goal: [0, 3], parked: true}, {position: [0, 0], goal: [0, 0]}]\n")
    seen = avo.Simulation(scene).perceive(1)
    assert len(seen.walls) == len(seen.wall_source) and {1, -1} <= set(seen.wall_source)
    by_source = dict(zip(seen.wall_source, seen.walls))
    assert by_source[-1].a == (0, 3) and by_source[1].a[0] < 0


def test_what_is_perceived_of_paths_outlives_the_simulation():
    cart = {"position": [0, -4], "velocity": [0, 1], "max_deviation": 1, "max_speed": 1.5, "path": [[0, 4], [0, -4]]}
    scene = {"version": 1, "sensing_radius": 20, "robots": [{"position": [-5, 0], "goal": [5, 0]}],
             "moving_obstacles": [cart]}
    simulation = avo.Simulation(scene, threads=1)
    seen = simulation.perceive(0)
    plan = avo.Planner().plan(seen.robot, seen.neighbors)
    for _ in range(100):
        simulation.step()
    del simulation
    assert len(seen.neighbors[0].trajectory.places) > 100
    assert avo.Planner().plan(seen.robot, seen.neighbors).next_velocity == plan.next_velocity


def test_two_that_coincide_part_along_the_direction_of_their_ids():
    n = avo.parting_direction(7, 3)
    assert avo.parting_direction(3, 7) == (-n[0], -n[1]) and avo.parting_direction(3, 3) == (0.0, 0.0)
    robot = avo.Robot(position=(0, 0), preferred_velocity=(1, 0))
    first, second = (avo.Planner().plan(robot, [avo.Neighbor(position=(0, 0), parting=way)]).next_velocity
                     for way in (n, (-n[0], -n[1])))
    assert sum(n[k] * (first[k] - second[k]) for k in (0, 1)) > 0.19
    robots = avo.Robots(position=[(0, 0)] * 3, velocity=[(0, 0)] * 3, preferred_velocity=[(1, 0)] * 3)
    plans = avo.Planner().plan(robots, avo.Neighbors.among(robots, 10.0))
    assert len({tuple(v) for v in plans.next_velocity()}) == 3
