# SPDX-License-Identifier: Apache-2.0
"""Teams: of a scene, led by the host, and formations."""
import pickle

import avo
import numpy as np
import pytest

SCENE = {"version": 1, "groups": [
    {"number": 3, "radius": 0.3, "placement": {"grid": {"spacing": 2, "columns": 3}},
     "goals": {"offset": {"by": [9, 9]}}, "task": {"queue": {"line": [[8, 0], [0, 0]], "service": 3}}},
    {"number": 4, "radius": 0.3, "placement": {"grid": {"corner": [0, 30], "spacing": 2, "columns": 4}},
     "goals": {"offset": {"by": [20, 0]}}, "task": {"flow": {"exits": [[12, 28], [12, 34]]}}}]}


def test_the_host_leads_as_the_scene_does():
    led = avo.Simulation(avo.Scenario(SCENE))
    plain = {**SCENE, "groups": [{k: v for k, v in group.items() if k != "task"} for group in SCENE["groups"]]}
    hosted = avo.Simulation(avo.Scenario(plain))
    queue = avo.Team([0, 1, 2], avo.Queue([(8, 0), (0, 0)], service=3))
    crowd = avo.Team(range(3, 7), avo.Flow([(12, 28), (12, 34)]))
    for _ in range(300):
        led.step()
        queue.lead(hosted)
        crowd.lead(hosted)
        hosted.step()
        assert led.state_hash() == hosted.state_hash()
    assert crowd.robots == [] and len(hosted.position()) == 3


def test_a_host_serves_a_queue():
    simulation = avo.Simulation(avo.Scenario({"version": 1, "robots": [
        {"position": [-3 * k, 0], "goal": [0, 20 + 3 * k]} for k in range(3)]}))
    team = avo.Team([0, 1], avo.Queue([(10, 0), (0, 0)]))
    team.add(2)
    team.lead(simulation)
    assert tuple(simulation.goal()[2]) == (7, 0)
    assert team.serve(simulation) == 0 and team.robots == [1, 2]
    team.disband(simulation)
    assert tuple(simulation.goal()[2]) == (0, 26) and team.robots == []
    assert avo.Team([0], avo.Patrol([(0, 0)])).serve(simulation) is None


def test_teams_of_a_scene_are_reached():
    simulation = avo.Simulation(avo.Scenario(SCENE))
    queue, crowd = simulation.teams()
    assert sorted(queue.robots) == [0, 1, 2] and crowd.robots == [3, 4, 5, 6]
    assert (queue.task.service, list(queue.task.line), crowd.task.spacing) == (3, [(8, 0), (0, 0)], 1)
    simulation.step(20)
    first = queue.robots[0]
    assert queue.serve(simulation) == first and first not in queue.robots and len(queue.robots) == 2
    crowd.remove(6)
    queue.add(6)
    simulation.step()
    assert queue.robots[-1] == 6 and crowd.robots == [3, 4, 5]
    crowd.set_task(simulation, avo.Patrol([(0, 30), (9, 30)]))
    simulation.step()
    assert isinstance(crowd.task, avo.Patrol) and {tuple(simulation.goal()[k]) for k in (3, 4, 5)} <= {(0, 30), (9, 30)}
    crowd.disband(simulation)
    assert tuple(simulation.goal()[3]) == (20, 30)
    del simulation  # a team keeps its simulation
    assert crowd.robots == []
    with pytest.raises(avo.Error, match="found a team of another simulation, must be of this one"):
        queue.lead(avo.Simulation("circle-10"))
    assert avo.Simulation("circle-10").teams() == []


def test_a_robot_is_in_a_team_once():
    with pytest.raises(avo.Error, match="team: found robot 1 twice, must be each robot once"):
        avo.Team([0, 1, 1], avo.Patrol([(0, 0)]))
    team = avo.Team([0, 1], avo.Patrol([(0, 0)]))
    with pytest.raises(avo.Error, match="robot 1: found it in the team, must be another one"):
        team.add(1)
    with pytest.raises(avo.Error, match="robot 7: found it elsewhere, must be in the team"):
        team.remove(7)


def test_formations():
    slots = avo.formation_slots("wedge", 5, 1.5, center=(4, 0), heading=np.pi / 2)
    assert slots.shape == (5, 2) and np.allclose(slots.mean(axis=0), (4, 0))
    assert np.allclose(avo.place_slots([(1, 0), (0, 2)], (4, 0), np.pi / 2), [(4, 1), (2, 0)])
    assert avo.assign_slots([(0, 0), (0, 2)], [(5, 2), (5, 0)]) == [1, 0]
    simulation = avo.Simulation("circle-10")
    simulation.form_up(range(10), avo.formation_slots("block", 10, 2.0))
    assert {tuple(goal) for goal in simulation.goal()} == \
        {tuple(slot) for slot in avo.formation_slots("block", 10, 2.0)}
    assert simulation.is_in_sight((-90, 0), (90, 0))


def test_bad_values_are_refused():
    with pytest.raises(avo.Error, match="line: found 1 points, must be at least 2"):
        avo.Queue([(0, 0)])
    with pytest.raises(avo.Error, match='formation: found "wegde", did you mean "wedge".* Must be one of line'):
        avo.formation_slots("wegde", 3, 1.0)
    with pytest.raises(avo.Error, match="slots: found 1, must be at least 2"):
        avo.assign_slots([(0, 0), (1, 1)], [(0, 0)])
    with pytest.raises(TypeError):
        avo.Team([0], "queue")


def test_scenes_with_teams_are_pickled():
    scene = avo.Scenario(SCENE)
    copies = [avo.Simulation(pickle.loads(pickle.dumps(scene))), avo.Simulation(scene)]
    for simulation in copies:
        for _ in range(100):
            simulation.step()
    assert copies[0].save() == copies[1].save()
