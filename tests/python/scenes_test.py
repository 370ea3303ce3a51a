# SPDX-License-Identifier: Apache-2.0
"""Scenes, wherever they come from."""
import copy
import json
import os
import pickle

import avo
import numpy as np
import pytest

YAML = """
version: 1
name: two
robots:
  - {position: [-10, 0], goal: [10, 0], radius: 0.5}
  - {position: [10, 0], goal: [-10, 0], radius: 0.5}
"""
TWO = {"version": 1, "name": "two",
       "robots": [{"position": [-10, 0], "goal": [10, 0], "radius": 0.5},
                  {"position": [10, 0], "goal": [-10, 0], "radius": 0.5}]}


def bits(scene):
    simulation = avo.Simulation(scene, threads=1)
    simulation.step(50)
    return simulation.state_hash()


def test_bases_that_do_not_execute_exactly():
    late = avo.Scenario(dict(TWO, execution={"time_constant": 0.2, "dead_time": 0.1, "deadband": 0.04}))
    assert bits(late) != bits(TWO)
    assert bits(pickle.loads(pickle.dumps(late))) == bits(copy.copy(late)) == bits(late)
    assert avo.run(late)["collision_pairs"] == 0
    with pytest.raises(avo.Error, match="execution.dead_time: found -1"):
        avo.Scenario(dict(TWO, execution={"dead_time": -1}))


def test_all_sources_make_the_same_scene(tmp_path):
    path = tmp_path / "two.yaml"
    path.write_text(YAML)
    arrays = dict(TWO, robots=[dict(TWO["robots"][0], position=np.array([-10.0, 0.0]), radius=np.float64(0.5)),
                               TWO["robots"][1]])
    scenes = [avo.Scenario(path), avo.Scenario(str(path)), avo.Scenario.from_yaml(YAML), avo.Scenario(TWO),
              avo.Scenario(arrays)]
    assert len({bits(scene) for scene in scenes}) == 1
    assert [scene.name for scene in scenes] == ["two"] * 5
    assert bits(TWO) == bits(avo.Scenario(TWO)) == bits(path)


def test_overrides_are_those_of_the_command_line():
    by_dict = avo.Scenario("circle-10", overrides={"method": "orca", "robots.0.radius": 0.4, "robots.1.goal": [1, 2]})
    by_list = avo.Scenario("circle-10", ["method=orca", "robots.0.radius=0.4", "robots.1.goal=[1, 2]"])
    for scene in (by_dict, by_list):
        assert scene.method == "orca" and scene.robots[0].radius == 0.4 and scene.robots[1].goal == (1.0, 2.0)


def test_errors_have_the_text_of_the_command_line(tmp_path, command_line):
    path = tmp_path / "bad.yaml"
    for text in ("version: 1\nrobots: [{position: [0, 0], goal: [1, 2], radius: -1}]\n",
                 "version: 1\nrobots: [{position: [0, 0], gaol: [1, 2]}]\n", "version: 2\n", "[", ""):
        path.write_text(text)
        with pytest.raises(ValueError) as error:
            avo.Scenario(path)
        assert command_line("validate", path).stderr.removeprefix("avo: ") == f"{error.value}\n"
    for name in ("circle", "circle-1", str(tmp_path / "nowhere.yaml")):
        with pytest.raises(ValueError) as error:
            avo.Scenario(name)
        assert command_line("validate", name).stderr.removeprefix("avo: ") == f"{error.value}\n"
    with pytest.raises(ValueError) as error:
        avo.Scenario("circle-10", {"methd": "orca"})
    assert command_line("run", "circle-10", "--set", "methd=orca").stderr.removeprefix("avo: ") == f"{error.value}\n"


@pytest.mark.parametrize("overrides", ["method=orca", b"x", 5, [1], {1, 2}])
def test_overrides_of_another_type_are_refused(overrides):
    with pytest.raises(TypeError, match="overrides: "):
        avo.Scenario("circle-10", overrides=overrides)


@pytest.mark.parametrize("value", [{1, 2}, object(), 1j, b"x"])
def test_values_that_no_scene_has_are_refused(value):
    with pytest.raises(TypeError, match="found a value that is no number"):
        avo.Scenario({"version": 1, "duration": value})


def test_what_is_left_out_is_warned_of(tmp_path):
    (tmp_path / "m.pgm").write_text("P2 1 1 255 254\n")
    (tmp_path / "m.yaml").write_text("image: m.pgm\nresolution: 9\norigin: [0, 0, 0]\nnegate: 0\n"
                                     "occupied_thresh: 0.65\nfree_thresh: 0.196\nmap_type: occupancy\n")
    (tmp_path / "s.yaml").write_text("version: 1\nobstacles: [{ros_map: m.yaml}]\n"
                                     "robots: [{position: [4, 4], goal: [5, 5]}]\n")
    with pytest.warns(UserWarning, match='unknown key "map_type" is left out, as ROS does'):
        assert len(avo.Scenario(tmp_path / "s.yaml").robots) == 1


def test_paths_are_those_of_the_system(tmp_path):
    name = os.fsencode(tmp_path) + b"/\xff.csv"
    avo.run("circle-10", record=os.fsdecode(name))
    assert os.path.exists(name)
    with pytest.raises(avo.Error, match="null character"):
        avo.run("circle-10", record=str(tmp_path / "a\0b.csv"))
    assert not (tmp_path / "a").exists()


def test_dicts_are_refused_by_the_reader():
    with pytest.raises(avo.Error, match=r'^dict:1:\d+: robots.0.radius: found -1, must be > 0 m$'):
        avo.Scenario({"version": 1, "robots": [{"position": [0, 0], "goal": [1, 2], "radius": -1}]})
    with pytest.raises(avo.Error, match="NaN"):
        avo.Scenario({"version": 1, "robots": [{"position": [float("nan"), 0], "goal": [1, 2]}]})
    assert avo.Scenario(dict(TWO, name='é "quoted" \U0001f600')).name == 'é "quoted" \U0001f600'


def test_a_text_may_name_built_in_maps(tmp_path, command_line, monkeypatch):
    text = command_line("scenes", "arena").stdout
    assert "arena.map" in text
    monkeypatch.chdir(tmp_path)
    assert bits(avo.Scenario.from_yaml(text)) == bits("arena")
    (tmp_path / "arena.map").write_text("its own")
    with pytest.raises(avo.Error, match="arena.map:1"):
        avo.Scenario.from_yaml(text, file="text")


# Every field of a scene and of what is in it differs from what it is by default.
RICH = {
    "version": 1, "name": "rich", "time_step": 0.05, "duration": 7, "control_time": 1.5, "time_horizon": 4,
    "response_time": 0.2, "comfort_acceleration": 0.7, "comfort_jerk": 3, "margin": 0.1, "never_swerves": True,
    "sensing_radius": 60, "max_neighbors": 7, "motion": "held", "arrival_distance": 0.7, "seed": 5,
    "sensing": {"delay": 1, "dropped": 0.1, "occlusion": True,
                "noise": {"position": 0.01, "velocity": 0.02, "distribution": "uniform"}},
    "robots": [{"position": [0, 0], "goal": [9, 0], "priority": 2, "layers": [3], "avoids": [0, 3], "method": "orca",
                "time_horizon": 5, "behavior": "cooperates", "start_time": 3},
               {"position": [0, 9], "goal": [0, 9], "parked": True},
               {"position": [0, 20], "goal": [9, 20], "heading": 1, "car": {"wheelbase": 0.7, "reverse": True}}],
    "moving_obstacles": [{"position": [0, 40], "velocity": [0.1, 0], "radius": 0.3},
                         {"trajectory": [[0, 0, 50], [1, 1, 50]]}],
    "obstacles": [{"polyline": [[-9, -9], [9, -9]]}],
}


@pytest.mark.parametrize("scene", [RICH, "person", "office", "cars-100", "drives-100", "planes-12", "crossing-streams",
                                   {**TWO, "clock": "free", "right_of_way": "none"}])
def test_scenes_can_be_pickled(scene):
    first = avo.Scenario(scene)
    for again in pickle.loads(pickle.dumps(first)), copy.deepcopy(first):
        assert bits(again) == bits(first)
        assert again.planner_options() == first.planner_options() and again.duration == first.duration
        assert again.__getstate__() == first.__getstate__()


def test_robots_have_methods_and_movers_trajectories():
    scene = avo.Scenario(RICH)
    assert (scene.robots[0].method, scene.robots[0].time_horizon) == ("orca", 5)
    assert (scene.robots[2].method, scene.robots[2].time_horizon) == (None, None)
    assert scene.moving_obstacles[1].trajectory == [(0, 0, 50), (1, 1, 50)]
    assert scene.moving_obstacles[1].velocity == (1, 0) and scene.moving_obstacles[0].trajectory == []
    simulation = avo.Simulation(scene)
    assert simulation.planner(0).method == "orca" and simulation.planner(2).method == "avo"
    simulation.add_robot(avo.RobotSetup(position=(80, 0), goal=(80, 0), max_speed=1, method="orca_clamped"))
    assert simulation.planner(3).method == "orca_clamped"
    with pytest.raises(avo.Error, match="Must be one of avo"):
        avo.RobotSetup(position=(0, 0), goal=(0, 0), method="ocra")


def test_metrics_may_be_those_of_some_robots():
    alone = avo.run({**TWO, "duration": 1}, judged=[1])["metrics"]
    assert alone["trips"] == 1 and avo.run({**TWO, "duration": 1})["metrics"]["trips"] == 2


def test_a_drive_without_offset_takes_one_that_fits_its_robot():
    assert avo.usual_offset(radius=0.1, track=0.16) == 0.05
    drive = avo.DifferentialDrive(track=0.16)
    assert drive.offset is None and avo.DifferentialDrive(offset=0.2).offset == 0.2
    setup = avo.RobotSetup(position=(0, 0), goal=(1, 0), radius=0.1, model=drive)
    assert setup.model.offset == 0.05
    setup.model = avo.DifferentialDrive(track=0.12, offset=0.07)
    assert setup.model.offset == 0.07
    setup.model = avo.DifferentialDrive(track=0.08)
    assert setup.model.offset == 0.04
    with pytest.raises(avo.Error, match="usual_offset"):
        avo.Robot(position=(0, 0), model=drive)
    with pytest.raises(avo.Error, match="offset: found 0"):
        avo.DifferentialDrive(offset=0)


def test_footprints_cover_bodies():
    truck = avo.Footprint.rectangle(6, 2, offset=1.75)
    assert (truck.discs, truck.first, truck.spacing) == (3, -0.25, 2) and truck.radius == pytest.approx(2**0.5)
    corners = [(-1.25, -1), (4.75, -1), (4.75, 1), (-1.25, 1)]
    assert avo.Footprint.polygon(corners).radius == pytest.approx(truck.radius)
    assert avo.Car().footprint is None and avo.Car(footprint=truck).footprint == truck
    with pytest.raises(avo.Error, match="excess: found 0.25 m, must be >= 0.8 m"):
        avo.Footprint.rectangle(12, 1)


def test_others_know_footprints_by_their_poses():
    truck = avo.Footprint.rectangle(6, 2, offset=1.75)
    car = avo.Car(wheelbase=3.5, max_curvature=0.2, footprint=truck)
    robot = avo.Robot(position=(0, 0), velocity=(1, 0), radius=5.2, preferred_velocity=(2, 0), model=car)
    planner = avo.Planner()
    assert planner.braking_pose(robot) == ((1, 0), 0)
    # 2 m beside it, within the disc that covers it
    other = avo.Neighbor(position=(1, 2.5), radius=0.5)
    assert planner.plan(robot, [other]).status != "overlapping"
    other.position = (1, 1.5)
    plan = planner.plan(robot, [other])
    assert plan.status == "overlapping" and plan.depth == pytest.approx(0.5 + 2**0.5 - (0.75**2 + 1.5**2) ** 0.5, rel=0.2)
    robot.radius = 5
    assert planner.plan(robot, [other]).status == "invalid_input"


def test_values_can_be_pickled():
    circle = avo.LoiterCircle(center=(1, 2), radius=3)
    values = [
        avo.Robot(position=(1, 2), velocity=(3, 4), model=avo.Car(max_curvature=2, body=avo.CarBody(radius=0.7)),
                  max_braking=0.5, loiter=circle, priority=3),
        avo.Robot(position=(1, 2), model=avo.Airplane(min_speed=2, after_goal="leave")),
        avo.Neighbor(position=(1, 2), behavior="moves_on", age=3), avo.DifferentialDrive(track=0.3), avo.Holonomic(),
        avo.RobotSetup(position=(1, 2), goal=(3, 4), layers=[2, 31], time_step=0.2, behavior="cooperates",
                       arrival_distance=0.2, start_time=3, heading=1, model=avo.Car(wheelbase=2)),
        avo.Wall((1, 2), (3, 4), radius=5),
        avo.StaticObstacle([avo.Chain([(1, 2), (3, 4)], closed=True)], fill="solid", layers=[1, 31]), avo.Detour(),
        avo.Scenario("person").moving_obstacles[0], circle, avo.Footprint.rectangle(6, 2, offset=1),
        avo.Car(footprint=avo.Footprint(discs=2, radius=1, spacing=1.5)),
        avo.DifferentialDrive(offset=0.3, footprint=avo.Footprint.rectangle(2, 1)),
        avo.Neighbor(position=(1, 2), footprint=avo.Footprint(discs=2, radius=1), ahead=(0, 1), spread=0.1)]
    for value in values:
        again = pickle.loads(pickle.dumps(value))
        names = [name for name in dir(value) if not name.startswith("_")]
        for name in names:
            one, two = getattr(value, name), getattr(again, name)
            assert one == two, name
        assert type(again) is type(value)


def test_states_of_another_kind_are_refused():
    for state in ((), (1.0,), tuple(avo.Scenario(TWO).__getstate__()[:-1])):
        with pytest.raises(avo.Error, match="pickle: found another number of fields"):
            avo.Scenario.__new__(avo.Scenario).__setstate__(state)
    state = avo.Scenario(TWO).__getstate__()
    with pytest.raises(avo.Error, match="time_step: found -1"):
        avo.Scenario.__new__(avo.Scenario).__setstate__((state[0], -1.0, *state[2:]))


def test_a_scenario_beside_overrides_is_refused():
    with pytest.raises(avo.Error, match="^overrides: found beside a Scenario"):
        avo.Scenario(avo.Scenario(TWO), {"method": "orca"})


def test_what_a_scene_says_is_told():
    scene = avo.Scenario("office")
    assert len(scene.robots) == 20 and len(scene.walls) >= len(scene.obstacles) > 0
    assert scene.broken_assumptions() == {"starts": 0, "beside": 0, "misplaced": 0, "fast": 0, "unseen": None}
    assert avo.Scenario("circle-10", {"sensing_radius": 2}).broken_assumptions()["unseen"] > 2.0
    assert scene.advice() == []
    assert ("office" in dict(avo.builtin_scenes())) and avo.schema()["type"] == "object"
    assert avo.Scenario("cars-100").robots[0].model.wheelbase > 0.0


def test_a_sensing_radius_that_is_left_out_is_what_the_robots_need():
    scene = avo.Scenario(TWO)
    assert scene.sensing_radius == scene.needed_sensing_radius == avo.Simulation(scene).sensing_radius
    named = avo.Scenario(TWO, {"sensing_radius": 60})
    assert named.sensing_radius == 60 and named.needed_sensing_radius == scene.sensing_radius
    simulation = avo.Simulation(TWO)
    simulation.add_robot(avo.RobotSetup(position=(80, 0), goal=(90, 0), max_speed=5))
    assert simulation.sensing_radius > 2 * scene.sensing_radius
    crowd = {"version": 1, "groups": [{"number": 400, "radius": 0.3, "max_speed": 1.3, "goals": {"permutation": {}},
                                       "placement": {"grid": {"corner": [0, 0], "spacing": 1.2, "columns": 20}}}]}
    assert avo.Scenario(crowd).advice() == []
    lines = avo.Scenario(crowd, {"sensing_radius": 12}).advice()
    assert len(lines) == 1 and "times the" in lines[0] and "a step costs about" in lines[0]


def test_schema_is_the_command_lines(command_line):
    assert avo.schema() == json.loads(command_line("schema").stdout)
