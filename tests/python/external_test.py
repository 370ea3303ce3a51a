# SPDX-License-Identifier: Apache-2.0
"""Methods of one's own: what their functions see, and what becomes of what they return."""
import copy
import pickle

import numpy as np
import pytest

import avo

SCENE = {"version": 1, "obstacles": [{"polyline": [[-3, -3], [3, -3]]}], "robots": [
    {"position": [-4, 0], "goal": [4, 0]}, {"position": [4, 0.1], "goal": [-4, 0]},
    {"position": [0, 5], "goal": [0, 9], "method": "avo"}]}


def keep(batch):
    return batch.preferred_velocity


def test_a_function_sees_its_robots_as_arrays():
    seen = []

    def look(batch):
        seen.append(batch)
        return keep(batch)

    scene = avo.Scenario(SCENE).with_method("mine", look)
    assert (scene.method, scene.external_method) == ("external_clamped", "mine")
    avo.Simulation(scene).step(2)
    batch = seen[1]
    assert isinstance(batch, avo.MethodBatch) and len(batch) == 2 and batch.id.tolist() == [0, 1]
    assert (batch.time, batch.time_step) == (0.1, 0.1)
    assert batch.goal.tolist() == [[4, 0], [-4, 0]]
    assert batch.max_speed.tolist() == [2, 2] and batch.max_braking.tolist() == [1, 1]
    assert batch.preferred_velocity[0][0] > 0 and batch.heading.shape == (2,)
    assert batch.first_neighbor.tolist() == [0, 2, 4] and batch.neighbor_robot.tolist() == [0, 0, 1, 1]
    assert np.allclose(batch.neighbor_position[batch.first_neighbor[0]], (0, 5), atol=0.1)
    assert batch.wall_robot.tolist() == [0, 1] and batch.wall_a.tolist() == [[-3, -3]] * 2


def test_choices_are_clamped_adopted_at_once_or_accelerations():
    def turned(batch):
        return np.array([[0.0, 1.0], [0.0, 1.0]])

    def after_a_step(**options):
        simulation = avo.Simulation(avo.Scenario(SCENE).with_method("mine", turned, **options))
        simulation.step()
        return simulation.velocity()[0]

    assert np.allclose(after_a_step(), (0, 0.1)) and np.allclose(after_a_step(clamped=False), (0, 1))
    assert np.allclose(after_a_step(output="acceleration", clamped=False), (0, 0.1))


@pytest.mark.parametrize("function, message", [
    (lambda batch: [[np.nan, 0.0]] * 2, "external_method mine: velocity of robot 0.0: found nan, must be a finite number"),
    (lambda batch: np.zeros((3, 2)), "external method: found shape (3, 2), must be (2, 2)"),
    (lambda batch: "north", "external method: found "),
    (lambda batch: 1 // 0, "by zero"),
    (None, "external_method mine: found no function"),
])
def test_what_is_no_velocity_moves_nobody(function, message):
    simulation = avo.Simulation(avo.Scenario(SCENE).with_method("mine", function))
    before = simulation.state_hash()
    with pytest.raises((avo.Error, ZeroDivisionError)) as raised:
        simulation.step()
    assert message in str(raised.value) and simulation.state_hash() == before
    simulation.set_external(keep)
    simulation.step()
    assert simulation.steps == 1


def test_a_function_may_not_call_the_simulation_that_asks_it():
    def meddles(batch):
        simulation.position()

    simulation = avo.Simulation(avo.Scenario(SCENE).with_method("mine", meddles))
    with pytest.raises(avo.Error, match="simulation: found a call within its step, must be after the step"):
        simulation.step()


def test_copies_keep_the_function_and_pickles_need_it_again():
    simulation = avo.Simulation(avo.Scenario(SCENE).with_method("mine", keep, certified=True))
    simulation.step(3)
    again = pickle.loads(pickle.dumps(simulation))
    with pytest.raises(avo.Error, match="found no function"):
        again.step()
    again.set_external(keep)
    both = [simulation, again, copy.copy(simulation)]
    for one in both:
        one.step(5)
    assert len({one.state_hash() for one in both}) == 1
    scene = pickle.loads(pickle.dumps(avo.Scenario(SCENE).with_method("mine", keep)))
    assert scene.external_method == "mine"


@pytest.mark.parametrize("options, message", [
    ({"name": ""}, "external_method: found none"),
    ({"name": "orca"}, "external_method: found orca, must be another name than avo's own"),
    ({"clamped": False, "certified": True}, "certificate: found braking_trajectories, must be none with method external"),
    ({"output": "force"}, 'output: found "force", must be "velocity" or "acceleration"'),
])
def test_methods_that_no_scene_can_have_are_refused(options, message):
    with pytest.raises(avo.Error) as raised:
        avo.Scenario(SCENE).with_method(**{"name": "mine", "function": keep, **options})
    assert message in str(raised.value)


def test_sweeps_name_methods_of_ones_own(tmp_path):
    spec = {"version": 1, "scenes": ["circle-12"], "methods": ["orca", "straight", "straight behind"], "until_arrived": True}
    own = {"straight": avo.OwnMethod(keep), "straight behind": avo.OwnMethod(keep, certified=True)}
    rows = avo.sweep(spec, own=own, jobs=2, out=tmp_path / "runs.csv")
    assert [row["method"] for row in rows] == spec["methods"]
    assert rows[1]["collision_pairs"] > 0 and rows[2]["collision_pairs"] == 0 and rows[2]["arrived"] == 12
    assert (tmp_path / "runs.csv").read_text().count("straight behind") == 1
    again = avo.sweep(spec, own=own, jobs=1)
    assert [row["state_hash"] for row in again] == [row["state_hash"] for row in rows]
    with pytest.raises(avo.Error, match="methods.1"):
        avo.sweep(spec)
    with pytest.raises(avo.Error, match="must be one of avo, avo_paper"):
        avo.sweep({**spec, "methods": ["external"]})


def test_a_planner_may_be_the_certificate_behind_anybody():
    planner = avo.Planner(method="external_clamped", certificate="braking_trajectories", time_step=0.1)
    robot = avo.Robot(position=(0, 0), velocity=(1.9, 0), preferred_velocity=(2, 0))
    wall = [avo.Wall((2.6, -5), (2.6, 5))]
    plan = planner.plan(robot, [], wall)
    assert plan.status in ("braking", "refused", "detour") and plan.next_velocity[0] < 2
    assert planner.plan(robot, []).next_velocity == (2, 0)
