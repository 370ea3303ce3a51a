# SPDX-License-Identifier: Apache-2.0
"""The host changes robots, leads them, moves a player and asks what is where."""
import pickle

import numpy as np
import pytest

import avo

LANES = {"version": 1, "robots": [{"position": [-20, 4 * k], "goal": [20, 4 * k]} for k in range(4)]}


def test_robots_change_and_are_led():
    simulation = avo.Simulation(LANES)
    simulation.change_robot(1, max_speed=0.5, preferred_speed=np.float32(0.5), priority=2, layers=[0, 3])
    setup = simulation.setup(1)
    assert (setup.max_speed, setup.preferred_speed, setup.priority, list(setup.layers)) == (0.5, 0.5, 2, [0, 3])
    assert simulation.setup(0).max_speed == 2
    simulation.set_preferred_velocity(1, (0, 1))
    assert simulation.preferred_velocity(1) == (0, 1) and simulation.preferred_velocity(0) is None
    again = pickle.loads(pickle.dumps(simulation))
    assert again.preferred_velocity(1) == (0, 1)
    simulation.step(100)
    assert simulation.position()[1][1] > 7 and not simulation.at_goal()[1]
    simulation.set_preferred_velocity(1, None)
    simulation.set_velocity(1, (0, 0.5))
    simulation.step()
    assert simulation.velocity()[1].tolist() == [0, 0.5] and list(simulation.setup(1).avoids) == []
    assert pickle.loads(pickle.dumps(simulation)).host_velocity(1) == (0, 0.5)
    with pytest.raises(avo.Error, match="at most its max_speed"):
        simulation.set_velocity(1, (9, 0))
    simulation.set_velocity(1, None)
    assert simulation.host_velocity(1) is None
    simulation.step(1200)
    assert simulation.all_at_goal()


@pytest.mark.parametrize("change, error, message", [
    ({"radius": -1}, avo.Error, "robot 1: radius: found -1, must be > 0 m"),
    ({"speed": 1}, TypeError, 'RobotSetup: found "speed", must be one of'),
    ({"max_sped": 1}, TypeError, 'did you mean "max_speed"?'),
    ({"max_speed": "fast"}, TypeError, "RobotSetup: max_speed: found 'fast', must be of another type"),
    ({"behavior": "parked", "layers": [1]}, avo.Error, "robot 1: layers: found [1], must be left out"),
    ({"parked": True}, TypeError, 'RobotSetup: found "parked", must be behavior="parked"'),
    ({"model": avo.Car()}, avo.Error, "robot 1: model: found another one, must be the one that it has"),
])
def test_changes_that_are_refused_change_nothing(change, error, message):
    simulation = avo.Simulation(LANES)
    before = simulation.save()
    with pytest.raises(error) as raised:
        simulation.change_robot(1, **change)
    assert message in str(raised.value)
    assert simulation.save() == before


def test_setups_take_the_names_of_scene_files():
    with pytest.raises(TypeError, match="found no goal, must be given"):
        avo.RobotSetup(position=(0, 0))
    with pytest.raises(TypeError, match='did you mean "max_speed"'):
        avo.RobotSetup(position=(0, 0), goal=(1, 0), max_sped=1)
    setup = avo.RobotSetup(position=(0, 0), goal=(1, 0), max_speed=3)
    assert setup.preferred_speed == 3 and setup.arrival_distance is None
    assert "m/s" in avo.RobotSetup.max_speed.__doc__


def test_many_at_once():
    simulation = avo.Simulation(LANES)
    simulation.set_goals([0, 2], np.array([[0, -9], [0, 19]]))
    assert simulation.goal().tolist()[2] == [0, 19]
    simulation.set_preferred_velocities([0, 2], [[1, 0], [0.5, 0.5]])
    new = [avo.RobotSetup(position=(50 + 3 * k, 0), goal=(50, 9)) for k in range(2)]
    roster = simulation.roster
    assert simulation.add_robots(new) == [4, 5] and simulation.roster != roster
    before = simulation.save()
    with pytest.raises(avo.Error, match="robot 6"):
        simulation.add_robots(new)
    with pytest.raises(avo.Error, match="goals: found 1, must be 2, one for each robot"):
        simulation.set_goals([0, 2], [[0, 0]])
    assert simulation.save() == before
    simulation.remove_robots([4, 5])
    assert simulation.ids().tolist() == [0, 1, 2, 3]
    before = simulation.state_hash()
    simulation.set_goals([], [])
    simulation.set_preferred_velocities([], np.empty((0, 2)))
    assert simulation.add_robots([]) == [] and simulation.state_hash() == before


def test_floors_and_parked_robots():
    simulation = avo.Simulation(LANES)
    wall = avo.StaticObstacle([avo.Chain([(1, -30), (1, 30)])], layers=[1])
    assert list(wall.layers) == [1] and len(avo.StaticObstacle([avo.Chain([(0, 0)])]).layers) == 32
    simulation.add_obstacle(wall)
    assert simulation.is_in_sight((0, 0), (2, 0), layers=[0]) and not simulation.is_in_sight((0, 0), (2, 0))
    assert simulation.is_free((1, 0), 0.5, layers=[0]) and not simulation.is_free((1, 0), 0.5, [1])
    assert simulation.cast_ray((0, 0), (2, 0), layers=[1])["distance"] == pytest.approx(1)
    robot = simulation.ids()[0]
    simulation.change_robot(robot, layers=np.array([1]), avoids=[1])
    assert list(simulation.setup(0).layers) == [1]
    simulation.change_robot(robot, layers=[0], avoids=range(32))
    simulation.change_robot(robot, behavior="parked")
    with pytest.raises(AttributeError, match="RobotSetup.parked: found a renamed attribute, must be behavior"):
        simulation.setup(robot).parked
    with pytest.raises(avo.Error, match=f"robot {robot}: found a goal for it, must be one that is not parked"):
        simulation.set_goal(robot, (0, 0))
    simulation.change_robot(robot, behavior="moves_on")
    assert simulation.setup(0).behavior == "moves_on"


def test_a_player_and_what_is_near():
    simulation = avo.Simulation(LANES)
    player = simulation.add_moving_obstacle(avo.MovingObstacle(position=(5, 0), max_deviation=2, max_speed=1.5))
    simulation.change_moving_obstacle(player, avo.MovingObstacle(position=(5, 0), velocity=(0, 1)))
    simulation.step()
    assert simulation.moving_obstacle_ids() == [player]
    assert simulation.moving_obstacle_position()[0].tolist() == pytest.approx([5, 0.1])
    assert simulation.nearest_robots((-30, 0), 2) == [0, 1]
    assert simulation.robots_within((-30, 0), 10.5) == [0, 1]
    assert simulation.is_free((0, 0), 1) and not simulation.is_free((5, 0), 1)
    hit = simulation.cast_ray((0, 0), (-30, 0))
    assert hit["robot"] == 0 and "obstacle" not in hit
    assert simulation.cast_ray((0, 0), (0, 30), radius=0.5) is None
    simulation.remove_moving_obstacle(player)
    with pytest.raises(avo.Error, match="moving obstacle 0: found none of that id"):
        simulation.remove_moving_obstacle(player)
    route = avo.MovingObstacle(position=(0, 0), trajectory=[(0, 9, 9), (5, 9, 20)])
    assert route.position == (9, 9)


def test_metrics_go_on_where_the_host_changes_robots():
    scene = avo.Scenario(LANES)
    simulation, metrics = avo.Simulation(scene), avo.Metrics(scene)
    metrics.observe(simulation)
    simulation.change_robot(0, max_speed=0.5, preferred_speed=0.5, radius=0.3)
    simulation.step()
    metrics.observe(simulation)
    assert metrics.summary()["steps"] == 1
    other = avo.Scenario({**LANES, "robots": [{**robot, "radius": 0.3} for robot in LANES["robots"]]})
    with pytest.raises(avo.Error, match="found another robot 0 than in dict, must be of the same scene"):
        avo.Metrics(other).observe(simulation)
