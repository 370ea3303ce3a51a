# SPDX-License-Identifier: Apache-2.0
"""What happened in a step."""
import gc

import avo
import pytest

SCENE = {"version": 1, "sensing_radius": 40.0,
         "robots": [{"position": [0, 10], "goal": [6, 10]}, {"position": [0, 15], "goal": [0, 15]},
                    {"position": [0, 0], "goal": [0, 0], "max_speed": 1e-3, "preferred_speed": 1e-3},
                    {"position": [-10, 0], "goal": [12, 0]}],
         "obstacles": [{"polyline": [[-20, 0.8], [20, 0.8]]}, {"polyline": [[-20, -0.8], [20, -0.8]]},
                       {"polyline": [[-20, -0.8], [-20, 0.8]]}]}


def next_events(simulation, events):
    for _ in range(500):
        simulation.step()
        if found := events.observe():
            return found
    return []


def test_each_kind_has_its_names():
    simulation = avo.Simulation(avo.Scenario(SCENE))
    events = avo.Events(simulation)
    assert events.observe() == []
    arrived, = next_events(simulation, events)
    assert (arrived.kind, arrived.robot, arrived.moving_obstacle) == ("arrived", 0, None)
    assert arrived.at_rest is None and arrived.sentence is None and repr(arrived) == "<avo.Event arrived 0>"
    stuck, = next_events(simulation, events)
    assert (stuck.kind, stuck.robot) == ("stuck", 3)
    assert stuck.sentence == simulation.explain(3)["sentence"] and stuck.sentence in repr(stuck)

    player = simulation.add_moving_obstacle(avo.MovingObstacle(position=(0, 22)))
    simulation.step()
    simulation.change_moving_obstacle(player, avo.MovingObstacle(position=(0, 15.2)))
    simulation.remove_robot(0)
    simulation.step()
    gone, contact = events.observe()
    assert (gone.kind, gone.robot) == ("gone", 0)
    assert (contact.kind, contact.robot, contact.moving_obstacle) == ("contact", 1, player)
    assert isinstance(contact.at_rest, bool) and "contact 1 with moving obstacle 0" in repr(contact)

    added = simulation.add_robot(avo.RobotSetup(position=(-9, -20), goal=(-9, -20)))
    simulation.set_goal(1, (0, 30))
    simulation.step()
    assert [(event.kind, event.robot) for event in events.observe()] == \
        [("left", 1), ("came", added), ("arrived", added)]


def test_a_player_of_the_host_runs_into_a_robot():
    simulation = avo.Simulation({"version": 1, "robots": [
        {"position": [0, 0], "goal": [0, 0], "max_acceleration": 10},
        {"position": [3, 0], "goal": [3, 0], "max_speed": 1e-3, "preferred_speed": 1e-3}]})
    events = avo.Events(simulation)
    simulation.set_velocity(0, (1, 0))
    left, = next_events(simulation, events)
    assert (left.kind, left.robot, left.moved_robot) == ("left", 0, None)
    contact, = next_events(simulation, events)
    assert (contact.kind, contact.robot, contact.moved_robot) == ("contact", 1, 0)
    assert contact.moving_obstacle is None and "contact 1 with moved robot 0" in repr(contact)


def test_events_keep_their_simulation():
    events = avo.Events(avo.Simulation("circle-10"), stuck_after=1)
    gc.collect()
    assert events.observe() == []


def test_a_time_that_is_none_is_refused():
    with pytest.raises(avo.Error, match="stuck_after: found 0, must be > 0 s"):
        avo.Events(avo.Simulation("circle-10"), stuck_after=0)
    with pytest.raises(TypeError):
        avo.Events("circle-10")
