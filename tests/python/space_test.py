# SPDX-License-Identifier: Apache-2.0
"""Robots in space: the same bits as C++ and the command line, one decision, set points, types of the stub."""
import inspect
import json
import re
import pathlib

import avo
import avo.env
import avo.space
import numpy as np
import pytest

SCENE = """version: 1
space: 3
duration: 8
groups:
  - {count: 20, sphere: {radius: 6}, goal: antipodal, jitter: 0.1, downwash: 0.4}
obstacles:
  - {floor: -9}
"""


@pytest.fixture
def scene(tmp_path):
    path = tmp_path / "drones.yaml"
    path.write_text(SCENE)
    return path


def test_a_fleet_moves_as_the_command_line_moves_it(scene, tmp_path, command_line):
    csv, summary = tmp_path / "c.csv", tmp_path / "c.json"
    assert command_line("run", scene, "--record", csv, "--summary", summary).returncode == 0
    mine = tmp_path / "mine.csv"
    found = avo.space.run(scene, record=mine, threads=2)
    told = json.loads(summary.read_text())
    for timed in ("step_milliseconds_median", "metrics"):
        found.pop(timed), told.pop(timed)
    assert found == told
    assert mine.read_text() == csv.read_text()
    simulation = avo.space.Simulation(scene)
    simulation.step(80)
    rows = np.loadtxt(csv, delimiter=",", skiprows=1)
    assert np.array_equal(simulation.position(), rows[-20:, 2:5])
    assert np.array_equal(simulation.velocity(), rows[-20:, 5:8])
    assert avo.space.check(mine, scene)["safe"] and simulation.time == pytest.approx(8.0)


def test_hdf5_contains_its_scene(scene, tmp_path, command_line):
    h5 = tmp_path / "run.h5"
    avo.space.run(scene, record=h5, until_arrived=True)
    assert avo.space.check(h5)["robots"] == 20
    assert command_line("replay", h5).returncode == 0
    with pytest.raises(avo.Error, match="record: found HDF5 without a scene file"):
        avo.space.run(avo.space.Scenario(scene), record=h5)
    with pytest.raises(avo.Error, match="scene: found none"):
        avo.space.check(scene)
    with pytest.raises(avo.Error, match="recording: found one of space, .*avo.space.check judges those"):
        avo.check(h5)
    with pytest.raises(avo.Error, match="space: found 3, must be 2 here; scenes of space: avo.space.run"):
        avo.run(scene)


def test_scenes_come_from_text_and_dicts_and_have_overrides(scene):
    one = {"version": 1, "space": 3, "robots": [{"position": np.zeros(3), "goal": [9, 0, 2], "climb": 0.5}]}
    made = avo.space.Scenario(one, overrides={"robots.0.radius": 0.25})
    assert made.robots[0].radius == 0.25 and made.robots[0].climb == 0.5 and made.robots[0].sink is None
    assert (made.certificate, made.motion, made.navigation, made.control_time) == (None, "held", True, None)
    assert avo.space.Scenario(one, ["certificate=none", "control_time=1.5"]).certificate == "none"
    with pytest.raises(avo.Error, match="margin: space has no margin"):
        avo.space.Planner(margin=0.1)
    text = avo.space.Scenario.from_yaml(SCENE)
    assert len(text.robots) == 20 and text.boxes[0].max[2] == -9.0
    assert avo.space.Simulation(text).state_hash() == avo.space.Simulation(scene).state_hash()
    with pytest.raises(avo.Error, match="must be one; see avo.Scenario"):
        avo.space.Scenario("circle-10")
    with pytest.raises(avo.Error, match=r"position: found a list of 2, must be \[x, y, z\]"):
        avo.space.Scenario({"version": 1, "space": 3, "robots": [{"position": [0, 0], "goal": [9, 0, 2]}]})


def test_one_robot_decides_as_in_a_fleet():
    scene = avo.space.Scenario(
        {"version": 1, "space": 3, "robots": [{"position": [0, 0, 0], "goal": [9, 0, 0]},
                                              {"position": [9, 0, 0.2], "goal": [0, 0, 0.2]}],
         "obstacles": [{"floor": -2}]})
    simulation = avo.space.Simulation(scene, threads=1)
    planner, memory = avo.space.Planner(), [avo.space.Detour(), avo.space.Detour()]
    for _ in range(60):
        position, velocity = simulation.position(), simulation.velocity()
        plans = []
        simulation.step()
        for k in range(2):
            robot = avo.space.Robot(position=position[k], velocity=velocity[k])
            other = avo.space.Neighbor(position=position[1 - k], velocity=velocity[1 - k])
            robot.preferred_velocity = simulation_wish(robot, simulation.goal()[k])
            robot.distance_to_goal = float(np.linalg.norm(simulation.goal()[k] - position[k]))
            plans.append(planner.plan(robot, [other], scene.boxes, memory[k]))
            assert planner.is_admitted(robot, [other], plans[-1].next_velocity, scene.boxes)
        assert all(plan.state == "safe" for plan in plans)
    away = np.linalg.norm(simulation.position()[0] - simulation.position()[1])
    assert away > 1.0


def test_one_robot_evades_what_moves_and_allows_for_ages():
    robot = avo.space.Robot(position=(0, 0, 0), velocity=(1, 0, 0), preferred_velocity=(2, 0, 0))
    reach = avo.space.evasion_range(robot)
    planner = avo.space.Planner(wall_range=reach, sensing_error=(0.0, 0.05))
    ball = avo.space.Mover(position=(2, 8, 0), velocity=(0, -4, 0), radius=1.0, max_deviation=0.05)
    assert 4.0 < planner.sensing_range(robot, ball) < 40.0 and 1.0 < reach < 20.0
    boxes, found = [avo.space.Box(max=(9e9, 9e9, -1))], set()
    robots = avo.space.Robots(position=[[0, 0, 0]], velocity=[[1, 0, 0]], preferred_velocity=[[2, 0, 0]])
    for age, ball.age in ((0, 0), (4, 0), (0, 4)):
        other = avo.space.Neighbor(position=(3, 0.1, 0), velocity=(-1, 0, 0), age=age)
        plan = planner.plan(robot, [other], boxes, movers=[ball])
        assert plan.evading and plan.mover == -1
        found.add(plan.next_velocity)
        sensed = avo.space.Neighbors(position=[[3, 0.1, 0]], velocity=[[-1, 0, 0]], offsets=[0, 1], age=age)
        together = planner.plan(robots, sensed, boxes, movers=[ball])
        assert tuple(together.next_velocity()[0]) == plan.next_velocity
    assert len(found) == 3
    ball.age = -1
    assert planner.plan(robot, movers=[ball]).status == "invalid_input"
    ball.age, ball.position = 0, (1.2, 0.1, 0)
    plan = planner.plan(robot, movers=[avo.space.Mover(position=(40, 0, 0)), ball])
    assert plan.status == "overlapping" and plan.mover == 1 and 0.2 < plan.depth < 0.3
    with pytest.raises(avo.Error, match="age: found 0.5, must be a whole number"):
        avo.space.Neighbors(position=[[6, 0, 0]], velocity=[[0, 0, 0]], offsets=[0, 1], age=0.5)


def test_batches_have_the_bits_of_single_decisions():
    random, n = np.random.default_rng(5), 40
    robots = avo.space.Robots(
        position=random.uniform(-6, 6, (n, 3)), velocity=random.uniform(-0.5, 0.5, (n, 3)),
        preferred_velocity=random.uniform(-1.5, 1.5, (n, 3)), radius=random.uniform(0.2, 0.4, n), downwash=0.1,
        vertical=0.8, max_braking=random.uniform(0.8, 1.0, n))
    sensed, planner = avo.space.Neighbors.among(robots, 9.0), avo.space.Planner()
    offsets, memories, alone = sensed.offsets, avo.space.Detours(n), [avo.space.Detour() for _ in range(n)]
    floor = [avo.space.Box(max=(9e9, 9e9, -8.0))]
    plans = planner.plan(robots, sensed, floor, memories)
    position = np.array([robots[k].position for k in range(n)])
    for k in range(n):
        near = [j for j in range(n) if j != k and np.linalg.norm(position[j] - position[k]) <= 9.0]
        assert offsets[k + 1] - offsets[k] == len(near)
        others = [avo.space.Neighbor(
            position=robots[j].position, velocity=robots[j].velocity, radius=robots[j].radius, downwash=0.1,
            vertical=0.8, max_braking=robots[j].max_braking) for j in near]
        plan = planner.plan(robots[k], others, floor, alone[k])
        assert tuple(plans.next_velocity()[k]) == plan.next_velocity == plans[k].next_velocity
        assert avo.PLAN_STATUS[plans.status()[k]] == plan.status
        assert avo.SAFETY_STATE[plans.state()[k]] == plan.state
        assert memories[k].acceleration == alone[k].acceleration
    with pytest.raises(avo.Error, match=r"velocity: found 1 rows, must be 2 as of position"):
        avo.space.Robots(position=np.zeros((2, 3)), velocity=np.zeros((1, 3)), preferred_velocity=np.zeros((2, 3)))
    with pytest.raises(avo.Error, match=r"position: found shape \(2, 2\), must be \(n, 3\)"):
        avo.space.Robots(position=np.zeros((2, 2)), velocity=np.zeros((2, 3)), preferred_velocity=np.zeros((2, 3)))
    with pytest.raises(avo.Error, match="neighbors: found those of 0 robots, must be those of 40"):
        planner.plan(robots, avo.space.Neighbors(position=np.zeros((0, 3)), velocity=np.zeros((0, 3)), offsets=[0]))


def simulation_wish(robot, goal):
    way = goal - np.array(robot.position)
    return 2.0 * way / max(np.linalg.norm(way), 2.0)


def test_a_decision_is_explained(scene, command_line):
    told = avo.space.explain(scene, 3, 2.5)
    assert told["time"] == pytest.approx(2.5) and told["robot"] == 3 and len(told["neighbors"]) == 19
    assert told == json.loads(command_line("explain", scene, "--robot", 3, "--time", 2.5, "--json").stdout)
    simulation = avo.space.Simulation(scene)
    simulation.step(25)
    assert simulation.explain(3) == told
    with pytest.raises(avo.Error, match="robot: found 20, must be 0 to 19"):
        simulation.explain(20)
    assert told["position"] == simulation.position()[3].tolist()
    simulation.step()
    assert told["next_velocity"] == simulation.velocity()[3].tolist()
    assert told["status"] == avo.PLAN_STATUS[simulation.status()[3]]
    assert told["sentence"].startswith("Robot 3 ")
    with pytest.raises(avo.Error, match="robot: found 20, must be 0 to 19"):
        avo.space.explain(scene, 20)


def test_decisions_beside_moving_obstacles_are_explained():
    simulation = avo.space.Simulation({
        "version": 1, "space": 3, "sensing": {"noise": {"position": 0.01, "velocity": 0.01}},
        "moving_obstacles": [{"position": [-6, 0, 0], "velocity": [3, 0, 0], "radius": 0.4}],
        "robots": [{"position": [0, 0, 0], "goal": [0, 0, 0]}]})
    told = []
    for _ in range(20):
        told.append(simulation.explain(0))
        simulation.step()
        assert told[-1]["next_velocity"] == simulation.velocity()[0].tolist()
    assert any("moving obstacle 0" in one["sentence"] for one in told)
    assert told[0]["neighbors"][0]["neighbor"] == "moving_obstacles.0"


def test_moving_obstacles_come_change_and_go():
    simulation = avo.space.Simulation({"version": 1, "space": 3, "robots": [{"position": [0, 0, 0], "goal": [0, 0, 0]}],
                                       "moving_obstacles": [{"trajectory": [[0, 0, 9, 0], [6, 0, 9, 6]]}]})
    assert simulation.moving_obstacles()[0].trajectory[1] == (6.0, 0.0, 9.0, 6.0)
    simulation.step(20)
    ball = avo.space.MovingObstacle(position=(12, 0, 0), velocity=(-4, 0, 0))
    assert simulation.add_moving_obstacle(ball) == 1
    assert np.allclose(simulation.moving_obstacle_position(), [[0, 9, 2], [12, 0, 0]])
    simulation.step(30)
    assert np.allclose(simulation.moving_obstacle_position()[1], 0.0)
    assert np.linalg.norm(simulation.position()[0]) > 1.0, "it has evaded the ball"
    player = avo.space.MovingObstacle(position=(40, 0, 0), max_deviation=1.0, max_speed=2.0)
    simulation.change_moving_obstacle(1, player)
    simulation.remove_moving_obstacle(0)
    assert simulation.moving_obstacle_ids() == [1] and simulation.moving_obstacles()[0].max_speed == 2.0
    assert simulation.moving_obstacle_velocity().tolist() == [[0, 0, 0]]
    for gone in (0, -1):
        with pytest.raises(avo.Error, match=f"moving obstacle {gone}: found none of that id"):
            simulation.remove_moving_obstacle(gone)
    with pytest.raises(avo.Error, match="robot 0 and moving obstacle 2 overlap at the start"):
        simulation.add_moving_obstacle(avo.space.MovingObstacle(position=simulation.position()[0]))
    with pytest.raises(avo.Error, match="robot 0 and moving obstacle 0 start too fast for their distance"):
        avo.space.Simulation({"version": 1, "space": 3, "moving_obstacles": [{"position": [2, 0, 0]}],
                              "robots": [{"position": [0, 0, 0], "velocity": [2, 0, 0], "goal": [9, 0, 0]}]})


def test_contact_at_rest_with_a_moving_obstacle_is_told():
    corner = [[0, -10, 0, 4], [4, -3, 0, 4], [5, -1, 0, 0.5], [12, 10, 0, 0]]
    simulation = avo.space.Simulation({"version": 1, "space": 3, "robots": [{"position": [0, 0, 0], "goal": [0, 0, 0]}],
                                       "moving_obstacles": [{"trajectory": corner, "radius": 0.6}]})
    simulation.step(60)
    told = simulation.explain(0)
    assert told["status"] == "overlapping" and told["state"] == "unknown"
    assert told["contact_with"] == "moving_obstacles.0" and told["contact_depth"] > 0.3
    assert "in contact with moving obstacle 0" in told["sentence"] and "(safe)" not in told["sentence"]


def test_goals_out_of_reach_are_told():
    scene = avo.space.Scenario({"version": 1, "space": 3, "obstacles": [{"floor": -1}], "robots": [
        {"position": [0, 0, 0], "goal": [2, 0, 1]}, {"position": [0, 9, 0], "goal": [0, 9, -3.5]}]})
    one, = scene.out_of_reach()
    assert one["robot"] == 1 and one["is_in_box"] and one["distance_left"] == pytest.approx(3.0, abs=0.1)
    assert np.linalg.norm(np.subtract(one["nearest"], (0, 9, -3.5))) == pytest.approx(one["distance_left"])
    simulation = avo.space.Simulation(scene)
    assert simulation.unreachable() == [1] and simulation.distance_left(0) == 0.0
    assert simulation.distance_left(1) == pytest.approx(one["distance_left"], abs=1e-6)
    route = simulation.route(0)
    assert route.length == pytest.approx(5 ** 0.5) and route.next == (2, 0, 1) and route.distance_left == 0
    assert simulation.route(1).length == float("inf") and not simulation.is_at_goal(1)
    assert simulation.route(1).distance_left == simulation.distance_left(1)
    for of_robot in simulation.distance_left, simulation.route:
        with pytest.raises(avo.Error, match="robot: found 2, must be 0 to 1"):
            of_robot(2)
    simulation.set_boxes([])
    assert simulation.unreachable() == []


def test_events_have_the_names_of_the_plane():
    simulation = avo.space.Simulation(
        {"version": 1, "space": 3, "robots": [{"position": [0, 0, 0], "goal": [4, 0, 1]},
                                              {"position": [0, 9, 0], "goal": [0, 9, 5], "preferred_speed": 0}]})
    events = avo.space.Events(simulation, stuck_after=8)
    assert events.observe() == []
    found = []
    for _ in range(100):
        simulation.step()
        found += events.observe()
    arrived, stuck = found
    assert isinstance(arrived, avo.Event) and (arrived.kind, arrived.robot) == ("arrived", 0)
    assert (stuck.kind, stuck.robot) == ("stuck", 1) and stuck.sentence.startswith("Robot 1 ")
    player = simulation.add_moving_obstacle(avo.space.MovingObstacle(position=(0, 30, 0)))
    simulation.change_moving_obstacle(player, avo.space.MovingObstacle(position=(0, 9.2, 0)))
    simulation.step()
    contact, = events.observe()
    assert (contact.kind, contact.robot, contact.moving_obstacle) == ("contact", 1, player)
    with pytest.raises(avo.Error, match="stuck_after: found 0, must be > 0 s"):
        avo.space.Events(simulation, stuck_after=0)
    with pytest.raises(TypeError):
        avo.Events(simulation)


def test_bad_numbers_are_a_status_and_other_points_are_refused():
    planner = avo.space.Planner()
    assert planner.plan(avo.space.Robot(position=(0, 0, float("nan")))).status == "invalid_input"
    with pytest.raises(avo.Error, match=r"point: found 2 numbers, must be 3: \(x, y, z\)"):
        avo.space.Robot(position=(0, 0))
    with pytest.raises(avo.Error, match="time_step"):
        avo.space.Planner(time_step=0.0)
    simulation = avo.space.Simulation({"version": 1, "space": 3, "robots": [{"position": [0, 0, 0], "goal": [9, 0, 0]}]})
    simulation.set_goal(0, (0, 5, 0))
    assert simulation.goal().tolist() == [[0, 5, 0]]
    for robot in (-1, 1):
        with pytest.raises(avo.Error, match="robot: found"):
            simulation.set_goal(robot, (0, 0, 0))
    with pytest.raises(avo.Error, match="robot 0 is in it"):
        simulation.set_boxes([avo.space.Box(max=(1, 1, 1))])
    with pytest.raises(avo.Error, match="boxes.0.box: found nan in min or max, must be numbers"):
        simulation.set_boxes([avo.space.Box(min=(float("nan"), 9, 9))])


def test_what_a_robot_touches_and_when_a_run_ends():
    balloon = {"position": [0, 20, 0], "velocity": [0, -8, 0], "radius": 3}  # faster than the robot evades
    lone = {"version": 1, "space": 3, "duration": 3, "time_step": 0.07, "moving_obstacles": [balloon],
            "robots": [{"position": [0, 0, 0], "goal": [0, 0, 0]}]}
    simulation = avo.space.Simulation(lone)
    touched = []
    while simulation.can_step_by(3):
        simulation.step()
        touched.append(simulation.touched(0))
    assert simulation.time <= 3 < simulation.time + 0.07
    assert None in touched and {"moving_obstacle": 0} in touched
    with pytest.raises(avo.Error, match="robot"):
        simulation.touched(1)


def test_set_points_follow_the_reference_one_delay_late():
    quadrotor = avo.space.Quadrotor(mass=1.2, max_thrust=26.0, attitude_time=0.12)
    assert 4.0 < quadrotor.max_acceleration < 7.0
    assert quadrotor.deviation == pytest.approx(quadrotor.max_acceleration * 0.12**2)
    points = avo.space.Filter(quadrotor, fleet_delay=0.12, time_step=0.1)
    for k in range(30):  # along x with 2 m/s²
        t = 0.1 * k
        points.add((t * t, 0, 1), (2 * t, 0, 0), (2, 0, 0))
    with pytest.raises(avo.Error, match="velocity.2: found nan, must be a finite number"):
        points.add((0, 0, 1), (0, 0, float("nan")), (0, 0, 0))
    late = points.at(points.end)
    then = points.end - 0.12
    assert late.position == pytest.approx((then**2, 0, 1), abs=quadrotor.deviation / 4)
    assert late.acceleration == pytest.approx((2, 0, 0), abs=1e-6)
    with pytest.raises(avo.Error):
        avo.space.Quadrotor(max_tilt=2.0)

    px4 = avo.space.px4_set_point(late, 1.5)  # along x, which is east
    assert px4.timestamp == 1_500_000 and px4.position == pytest.approx((0, late.position[0], -1))
    assert px4.velocity[1] == pytest.approx(late.velocity[0]) and px4.acceleration[1] == pytest.approx(2)
    assert np.isnan((*px4.jerk, px4.yaw, px4.yawspeed)).all()
    crazyflie = avo.space.crazyflie_set_point(late)
    assert crazyflie.position == pytest.approx(late.position) and crazyflie.orientation == (0, 0, 0, 1)
    assert (crazyflie.roll_rate, crazyflie.pitch_rate, crazyflie.yaw_rate) == (0, 0, 0)
    with pytest.raises(avo.Error, match="time: found -1, must be >= 0 s"):
        avo.space.px4_set_point(late, -1)


def test_worlds_for_learning_keep_drones_apart_whatever_the_actions_are(scene):
    env = avo.env.VectorEnv(scene, 2, neighbors=3, walls=1, max_steps=60)
    seen, _ = env.reset(seed=4)
    assert seen.shape == env.observation_space.shape == (2, 20, 8 + 8 * 3 + 4) and env.dimensions == 3
    assert env.action_space.shape == (2, 20, 3)
    position, goal = env.position(), env.goal()
    assert not np.array_equal(position[0], position[1])
    assert np.allclose(seen[..., :3], goal - position, atol=1e-5)
    away = np.linalg.norm(position[0] - position[0, 7], axis=1)
    near = np.argsort(away)[1]
    assert np.allclose(seen[0, 7, 8:11], position[0, near] - position[0, 7], atol=1e-5)
    assert seen[0, 7, 14] == 1.0 and seen[0, 7, 15] == 1.0  # sum of radii, a robot
    assert np.allclose(seen[0, 7, 32:35], [0, 0, -9 - position[0, 7, 2]], atol=1e-5)
    random = np.random.default_rng(3)
    for _ in range(60):
        to_goal = env.goal() - env.position()
        actions = np.where(random.random((2, 20, 1)) < 0.7, to_goal, random.uniform(-2, 2, (2, 20, 3)))
        seen, rewards, terminated, truncated, _ = env.step(actions)
        for e in range(2):
            apart = np.linalg.norm(env.position()[e][:, None] - env.position()[e], axis=2)
            assert apart[apart > 0].min() >= 1.0
    assert truncated.any() and np.isfinite(rewards).all()
    with pytest.raises(avo.Error, match=r"actions: found shape \(2, 20, 2\), must be \(2, 20, 3\)"):
        env.step(np.zeros((2, 20, 2)))
    with pytest.raises(avo.Error, match="with a scene of space, must be None"):
        avo.env.VectorEnv(scene, render_mode="rgb_array")
    one = avo.env.ParallelEnv(scene)
    seen, _ = one.reset(seed=1)
    assert seen["robot_0"].shape == (8 + 8 * 8,)
    seen, *_ = one.step({agent: np.zeros(3) for agent in one.agents})
    assert len(seen) == 20


def test_worlds_for_learning_have_moving_obstacles(tmp_path):
    path = tmp_path / "balls.yaml"
    path.write_text("""version: 1
space: 3
duration: 8
sensing_radius: 40
robots:
  - {position: [0, 0, 0], goal: [0, 0, 50]}
  - {position: [0, 9, 0], goal: [0, 9, 50]}
moving_obstacles:
  - {position: [12, 0, 0], velocity: [-4, 0, 0]}
  - {trajectory: [[0, 6, 9, 30], [4, 6, 9, -30]], radius: 1}
""")
    env = avo.env.VectorEnv(path, 2, neighbors=3, max_steps=80)
    seen, _ = env.reset(seed=4)
    assert seen.shape == (2, 2, 8 + 8 * 3)
    nearest = seen[1, 0, 8:].reshape(3, 8)
    assert nearest[:, 7].tolist() == [1, -1, -1]
    assert np.allclose(nearest[1], [12, 0, 0, -4, 0, 0, 1.0, -1])
    assert np.allclose(nearest[2], [6, 9, 30, 0, 0, -15, 1.5, -1])
    simulation, nearest = avo.space.Simulation(path), []
    for _ in range(60):
        seen, *_ = env.step(np.zeros((2, 2, 3)))
        simulation.step()
        movers, position = simulation.moving_obstacle_position(), env.position()
        for e in range(2):
            away = np.linalg.norm(movers[:, None] - position[e], axis=2)
            assert away[0].min() >= 1.0
        rows = seen[0, 1, 8:].reshape(3, 8)
        found = rows[rows[:, 7] == -1][:, :3]
        for place in found:
            assert np.abs(place - (movers - position[0, 1])).max(axis=1).min() < 1e-5
    assert np.linalg.norm(env.position()[0, 0]) > 0.5, "it has evaded"
    env.reset(seed=4)
    assert np.allclose(env.reset(seed=5)[0][0, 0, 16:19], [12, 0, 0])


def members(tree):
    found, name = {"": set()}, ""
    for line in tree.splitlines():
        if at := re.match(r"class (\w+)", line):
            name = at.group(1)
            found[name] = set()
        elif re.match(r"\w", line):
            name = None
        elif name and (at := re.match(r"    def (\w+)|    (\w+): ", line)):
            found[name].add(at.group(1) or at.group(2))
    return found


def test_the_stub_has_all_that_there_is_and_everything_is_told():
    stub = members(pathlib.Path(avo.space.__file__).with_suffix(".pyi").read_text())
    assert set(avo.space.__all__) == {n for n in vars(avo._avo._space) if not n.startswith("_")}
    for name in avo.space.__all__:
        found = getattr(avo.space, name)
        assert found.__doc__, name
        if inspect.isclass(found):
            assert found.__module__ == "avo.space"
            assert {n for n in stub[name] if not n.startswith("__")} == {n for n in vars(found) if n[0] != "_"}, name
