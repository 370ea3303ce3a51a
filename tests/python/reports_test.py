# SPDX-License-Identifier: Apache-2.0
"""Decisions, recordings and runs are told as the command line tells them."""
import json
import math

import avo
import avo.space
import numpy as np
import pytest


@pytest.mark.parametrize("scene, robot, time", [("circle-10", 3, 8.0), ("office", 5, 3.0), ("person", 0, 2.0),
                                                ("planes-12", 2, 5.0)])
def test_explain_is_the_command_lines(command_line, scene, robot, time):
    said = command_line("explain", scene, "--robot", robot, "--time", time, "--json").stdout
    told = avo.explain(scene, robot, time)
    assert json.dumps(told) == json.dumps(json.loads(said))
    simulation = avo.Simulation(scene)
    while simulation.can_step_by(time):
        simulation.step()
    assert simulation.explain(robot) == told


@pytest.mark.parametrize("robot, time", [(10, 0.0), (-1, 0.0), (0, 1e6), (0, -1.0), (0, float("nan"))])
def test_what_cannot_be_explained_is_refused_alike(command_line, robot, time):
    with pytest.raises(ValueError) as error:
        avo.explain("circle-10", robot, time)
    said = command_line("explain", "circle-10", f"--robot={robot}", f"--time={time}")
    assert said.stderr == f"avo: --{error.value}\n"


@pytest.mark.parametrize("scene", ["circle-10", "cars-100"])
def test_check_is_the_command_lines(command_line, tmp_path, scene):
    recording = tmp_path / "run.csv"
    avo.run(scene, record=recording)
    said = command_line("check", recording, "--scene", scene, "--json")
    assert avo.check(recording, scene) == json.loads(said.stdout) and said.returncode == 0
    assert avo.check(str(recording), scene, require_arrival=True)["passed"]


def test_check_finds_what_is_broken(command_line, tmp_path):
    recording = tmp_path / "run.csv"
    recording.write_text("time,robot,x,y,vx,vy\n0,0,0,0,1,0\n0,1,3,0,-1,0\n1,0,1,0,1,0\n1,1,1.5,0,-1,0\n")
    report = avo.check(recording, radius=0.5, max_acceleration=1, max_speed=2)
    said = command_line("check", recording, "--radius", 0.5, "--max-acceleration", 1, "--max-speed", 2, "--json")
    assert report == json.loads(said.stdout) and said.returncode == 1
    assert report["overlaps"]["count"] == 1 and not report["safe"]


def test_check_finds_who_is_run_over(command_line, tmp_path):
    recording, scene = tmp_path / "run.csv", tmp_path / "scene.yaml"
    recording.write_text("time,robot,x,y,vx,vy\n" + "".join(f"{0.1 * k:.1f},0,0,0,0,0\n" for k in range(41)))
    scene.write_text("version: 1\nduration: 4\nrobots: [{position: [0, 0], goal: [0, 0]}]\n"
                     "moving_obstacles: [{position: [-3, 0], velocity: [1, 0], radius: 0.3}]\n")
    for word, safe in (("collision", False), ("ok", True)):
        report = avo.check(recording, scene, movers_at_rest=word)
        said = command_line("check", recording, "--scene", scene, "--movers-at-rest", word, "--json")
        assert report == json.loads(said.stdout) and said.returncode == (0 if safe else 1)
        assert report["safe"] == safe and report["movers_at_rest"] == word
        assert [(hit["robot"], hit["moving_obstacle"], hit["moved"]) for hit in report["mover_hits"]] == [(0, 0, False)]
    assert not avo.check(recording, scene)["safe"]
    with pytest.raises(avo.Error, match='^movers_at_rest: found "fine", must be "ok" or "collision"'):
        avo.check(recording, scene, movers_at_rest="fine")


def test_check_knows_stronger_braking(command_line, tmp_path):
    recording = tmp_path / "run.csv"
    recording.write_text("time,robot,x,y,vx,vy\n0,0,0,0,1.5,0\n0.5,0,0.375,0,0,0\n")
    limits = {"radius": 0.5, "max_acceleration": 1, "max_speed": 2}
    assert not avo.check(recording, **limits)["safe"]
    assert avo.check(recording, **limits, max_braking=3)["safe"]
    with pytest.raises(avo.Error, match="^max_braking: found 0, must be > 0"):
        avo.check(recording, **limits, max_braking=0)
    with pytest.raises(avo.Error, match="^max_braking: found besides the robots of scene"):
        avo.check(recording, "circle-10", max_braking=3)


def test_limits_may_be_unknown_and_walls_alone_be_known(tmp_path):
    recording, walls = tmp_path / "people.txt", tmp_path / "walls.yaml"
    recording.write_text("# framerate: 10\n" + "".join(f"7 {k} {k / 10} 0 0\n" for k in range(9)))
    walls.write_text("version: 1\nobstacles: [{polyline: [[-9, 0.3], [9, 0.3]]}]\n")
    found = avo.check(recording, radius=0.2)
    assert found["verdict"] == "safe" and found["speeds"]["count"] is None and found["estimated"]
    assert avo.check(recording, walls, radius=0.4)["static_contacts"]["first"]["robot"] == 7
    with pytest.raises(avo.Error, match="^radius: found neither it nor robots in scene"):
        avo.check(recording, walls)
    with pytest.raises(avo.Error, match="^max_braking: found without max_acceleration"):
        avo.check(recording, radius=0.2, max_braking=1)


def test_wrong_recordings_are_refused_alike(command_line, tmp_path):
    recording = tmp_path / "run.csv"
    for text in ("time,robot,x,y,vx\n", "time,robot,x,y,vx,vy\n0,0,0,0,nan,0\n1,0,0,0,0,0\n", ""):
        recording.write_text(text)
        with pytest.raises(ValueError) as error:
            avo.check(recording, "circle-10")
        said = command_line("check", recording, "--scene", "circle-10")
        assert said.stderr.removeprefix("avo: ") == f"{error.value}\n"
    with pytest.raises(avo.Error, match="^radius: found besides the robots of scene"):
        avo.check(recording, "circle-10", radius=1.0)
    with pytest.raises(avo.Error, match="^radius: found neither it nor robots in scene"):
        avo.check(recording)
    with pytest.raises(avo.Error, match="^tolerance: found 1"):
        avo.check(recording, "circle-10", tolerance=1.0)


@pytest.mark.parametrize("limits", [(math.inf, 1, 1), (0, 1, 1), (math.nan, 1, 1), (1, -1, 1), (1, 1, 0)])
def test_wrong_limits_are_refused_alike(command_line, tmp_path, limits):
    recording = tmp_path / "run.csv"
    recording.write_text("time,robot,x,y,vx,vy\n0,0,0,0,1,0\n1,0,1,0,1,0\n")
    names = ("radius", "max_acceleration", "max_speed")
    with pytest.raises(ValueError) as error:
        avo.check(recording, **dict(zip(names, limits)))
    options = [f"--{name.replace('_', '-')}={value}" for name, value in zip(names, limits)]
    said = command_line("check", recording, *options)
    assert said.stderr.replace("-", "_") == f"avo: __{str(error.value).replace('-', '_')}\n" and said.returncode == 2


def without_times(summary):
    kept = {key: value for key, value in summary.items() if key != "step_milliseconds_median"}
    kept["metrics"] = {key: value for key, value in summary["metrics"].items() if not key.startswith("step_ms")}
    return kept


def test_summaries_are_the_command_lines(command_line, tmp_path):
    path, by_command, by_python = tmp_path / "out.json", tmp_path / "command.csv", tmp_path / "python.csv"
    command_line("run", "circle-10", "--summary", path, "--record", by_command)
    said = json.loads(path.read_text())
    told = avo.run("circle-10", record=by_python)
    assert without_times(told) == without_times(said) and list(told) == list(said)
    assert told["step_milliseconds_median"] == told["metrics"]["step_ms_p50"] > 0.0
    assert list(told["metrics"]) == list(said["metrics"])
    assert by_python.read_bytes() == by_command.read_bytes()
    scene = avo.Scenario("circle-10")
    simulation, metrics = avo.Simulation(scene), avo.Metrics(scene)
    metrics.observe(simulation)
    while simulation.can_step_by(scene.duration):
        simulation.step()
        metrics.observe(simulation)
    assert without_times(metrics.summary()) == without_times(said)


def test_metrics_see_shaking_as_columns_do():
    scene = avo.Scenario("circle-40", {"method": "reciprocal_velocity_obstacle"})
    simulation, metrics, velocities = avo.Simulation(scene), avo.Metrics(scene), []
    for _ in range(100):  # nobody arrives
        metrics.observe(simulation)
        velocities.append(simulation.velocity().copy())
        simulation.step()
    told = metrics.summary()["metrics"]
    v = np.array(velocities)
    a = np.diff(v, axis=0) / 0.1
    strong = np.linalg.norm(a, axis=2) / simulation.max_acceleration()
    angles = np.abs((np.diff(np.arctan2(a[..., 1], a[..., 0]), axis=0) + np.pi) % (2 * np.pi) - np.pi)
    moves = np.linalg.norm(v[1:-1], axis=2) > 0.01 * simulation.preferred_speed()
    back = moves & (angles > 0.75 * np.pi) & (strong[1:] > 0.3) & (strong[:-1] > 0.3)
    assert back.sum() > 0 and told["turned_back"] == pytest.approx(back.sum() / moves.sum())
    assert told["acceleration_rms"] == pytest.approx(np.sqrt(np.mean(strong**2)))


def test_metrics_are_of_one_scene():
    metrics = avo.Metrics("circle-10")
    for scene, message in (("circle-12", "one of the scene circle-12, must be of circle-10"),
                           (avo.Scenario("circle-10", {"groups.0.radius": 0.4}), "another robot 0 than in circle-10")):
        with pytest.raises(avo.Error, match=message):
            metrics.observe(avo.Simulation(scene))
    simulation = avo.Simulation("circle-10")
    added = simulation.add_robot(avo.RobotSetup(position=(0, 0), goal=(1, 0), radius=0.2))
    simulation.remove_robot(3)
    metrics.observe(simulation)
    metrics.observe(avo.Simulation.from_saved(simulation.save()))
    assert added == 10 and metrics.summary()["robots"] == 10


def test_crowds_and_flows_are_measured_where_they_are_asked_for():
    dear = ("danger", "order", "density_mean", "density_max", "flow", "specific_flow", "crossing_times")
    plain = avo.run("circle-10")["metrics"]
    assert all(plain[key] is None for key in dear) and plain["success"] == 1.0
    told = avo.run("circle-10", crowd=True, line=((-50, 0), [50.0, 0.0]))["metrics"]
    assert all(told[key] is not None for key in dear)
    assert {key: told[key] for key in plain if key not in dear and not key.startswith(("step_ms", "danger"))} == {
        key: plain[key] for key in plain if key not in dear and not key.startswith(("step_ms", "danger"))}
    times = told["crossing_times"]
    assert times == sorted(times) and told["flow"] == pytest.approx((len(times) - 1) / (times[-1] - times[0]))
    assert told["specific_flow"] == pytest.approx(told["flow"] / 100.0)
    assert avo.Metrics("circle-10", crowd=True).summary()["metrics"]["order"] is None
    with pytest.raises(avo.Error, match="^line: found one point, must be two points"):
        avo.Metrics("circle-10", line=((1, 1), (1, 1)))


def test_recordings_are_of_the_format_of_their_ending(command_line, tmp_path):
    lanes = {"version": 1, "duration": 2, "robots": [{"position": [0, 0], "goal": [3, 0]}]}
    for scene in ("circle-10", lanes):
        h5 = tmp_path / "run.h5"
        avo.run(scene, record=h5)
        assert avo.check(h5)["safe"] and command_line("replay", h5).returncode == 0
    with pytest.raises(avo.Error, match="record: found HDF5 for a Scenario"):
        avo.run(avo.Scenario(lanes), record=tmp_path / "other.h5")
    for scene in (lanes, {"space": 3, **lanes, "robots": [{"position": [0, 0, 0], "goal": [3, 0, 0]}]}):
        run = avo.space.run if "space" in scene else avo.run
        with pytest.raises(avo.Error, match="record: found the ending .mp4, must be .csv, .h5 or none"):
            run(scene, record=tmp_path / "run.mp4")
    assert not (tmp_path / "other.h5").exists() and not (tmp_path / "run.mp4").exists()


def test_a_recording_that_cannot_be_written_is_refused(tmp_path):
    with pytest.raises(avo.Error, match="nowhere"):
        avo.run("circle-2", record=tmp_path / "nowhere" / "run.csv")
