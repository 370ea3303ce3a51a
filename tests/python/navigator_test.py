# SPDX-License-Identifier: Apache-2.0
"""A robot on board: to its goal, along routes, and in words."""
import math
import pickle

import avo
import pytest

WALL = avo.StaticObstacle([avo.Chain([(4, -3), (4, 3)])])


def drive(navigator, robot, most=300, start=0.0):
    """The base does as it is told; the decisions until the goal is reached."""
    decisions = []
    for k in range(most):
        decisions.append(navigator.step(robot, time=start + 0.1 * k))
        if decisions[-1].status == "reached":
            break
        (x, y), (v, w), (v_1, w_1) = robot.position, robot.velocity, decisions[-1].plan.next_velocity
        robot.position = (x + 0.05 * (v + v_1), y + 0.05 * (w + w_1))
        robot.velocity = (v_1, w_1)
    return decisions


def test_it_goes_around_a_wall_to_its_goal():
    navigator, robot = avo.Navigator(obstacles=[WALL]), avo.Robot(position=(0, 0), velocity=(0, 0))
    assert navigator.step(robot, time=0.0).status == "idle"
    navigator.set_goal((8, 0))
    first = navigator.step(robot, time=0.0)
    assert first.status == "under_way" and first.guide == "route" and first.wait is None
    assert first.route_left > 10 and first.stopping_distance == 0 and first.distance_left == 0
    assert navigator.route()[-1] == (8, 0) and abs(navigator.route()[0][1]) > 3
    assert navigator.explain(robot).startswith("Robot 0 starts:")
    assert navigator.detour.has_arrived is False and navigator.planner.method == "avo"
    with pytest.raises(AttributeError, match="must be wait, whose neighbor is the same"):
        first.waits_for
    decisions = drive(navigator, robot)
    assert decisions[-1].status == "reached" and len(decisions) < 120
    assert math.dist(robot.position, (8, 0)) < 0.5


def test_it_follows_a_route_and_rests_at_a_stage():
    navigator, robot = avo.Navigator(preferred_speed=1.5), avo.Robot(position=(0, 0), velocity=(0, 0))
    navigator.set_route([(0, 0), (0, 6), (9, 6)])
    assert drive(navigator, robot)[-1].status == "reached"
    navigator.set_stages([((9, 9), 1.0), ((0, 9), 0.0)])
    decisions = drive(navigator, robot, start=50.0)
    assert decisions[-1].status == "reached"
    assert sum(decision.status == "waiting" for decision in decisions) in (10, 11)


def test_what_is_out_of_range_is_refused():
    with pytest.raises(avo.Error, match=r"NavigatorOptions.yaw_goal_tolerance: found 0, must be > 0 rad"):
        avo.Navigator(yaw_goal_tolerance=0)
    with pytest.raises(avo.Error, match="route: found 1 points, must be >= 2 points"):
        avo.Navigator().set_route([(0, 0)])


def test_how_far_it_has_to_see():
    planner, robot = avo.Planner(), avo.Robot(position=(0, 0))
    assert avo.wall_range(planner, robot) == pytest.approx(2.7, abs=0.02)
    assert avo.sensing_range(planner, robot, [robot]) == pytest.approx(9.0, abs=0.5)


def test_a_base_that_is_late_stays_near_its_reference():
    model = avo.ExecutionModel(dead_time=0.1, quantum=0.01)
    navigator, body = avo.Navigator(execution=model), avo.Robot(position=(0, 0))
    most = avo.execution_error(model, body, 0.1)
    assert 0.005 < most.position < 0.02 and most.command > body.max_speed
    navigator.set_goal((4, 0))
    acting = (0.0, 0.0)
    for k in range(100):
        decision = navigator.step(body, time=0.1 * k)
        command = decision.command
        assert command.deviation <= most.position and not command.has_left
        if decision.status == "reached":
            break
        body.position = (body.position[0] + 0.1 * acting[0], body.position[1] + 0.1 * acting[1])
        body.velocity, acting = acting, command.velocity
    assert decision.status == "reached" and math.dist(body.position, (4, 0)) < 0.5
    body.position = (2, 2)
    assert navigator.step(body, time=0.1 * k + 0.1).command.has_left
    assert avo.Navigator().step(avo.Robot(position=(0, 0)), time=0).command is None


def test_what_a_base_declares():
    model = avo.ExecutionModel(time_constant=0.2, deadband=0.05)
    assert pickle.loads(pickle.dumps(model)) == model and model.deadband == 0.05
    drive = avo.Robot(position=(0, 0), model=avo.DifferentialDrive(track=0.4, offset=0.2), heading=0.0)
    assert avo.drive_command(avo.ExecutionModel(), drive, (0.3, 0.1)) == pytest.approx((0.3, 0.5))
    with pytest.raises(avo.Error, match="ExecutionModel.dead_time: found -1, must be >= 0 s"):
        avo.Navigator(execution=avo.ExecutionModel(dead_time=-1))


def test_a_reference_is_kept_beside_plan():
    planner, body = avo.Planner(), avo.Robot(position=(0, 0), preferred_velocity=(1, 0))
    tracker = avo.ReferenceTracker(avo.ExecutionModel(time_constant=0.2), planner)
    most = tracker.error(body)
    led = tracker.reference(body)
    assert led.radius == body.radius + most.position and led.position == body.position
    plan = planner.plan(led)
    command = tracker.follow(body, plan)
    assert command.next_velocity == plan.next_velocity and command.velocity[0] > plan.next_velocity[0]
    body.position = (command.next_reference[0], 0.5 * most.position)
    assert tracker.reference(body).position == command.next_reference
    tracker.forget()
    assert tracker.reference(body).position == body.position


def test_a_robot_waits_for_another_at_a_passage():
    sides = [avo.StaticObstacle([avo.Chain([(-3, y), (3, y)])]) for y in (-0.8, 0.8)] + \
        [avo.StaticObstacle([avo.Chain([(x, y), (x, 12 * y)])]) for x in (-3, 3) for y in (-0.8, 0.8)]
    ways = [((-7, 0), (10, 3)), ((12, 0), (-10, 3))]
    navigators = [avo.Navigator(obstacles=sides, id=k) for k in range(2)]
    bodies = [avo.Robot(position=start) for start, _ in ways]
    for navigator, (_, goal) in zip(navigators, ways):
        navigator.set_goal(goal)
    for cycle in range(200):
        others = [avo.Neighbor(position=body.position, velocity=body.velocity) for body in reversed(bodies)]
        decisions = [navigator.step(body, [other], time=0.1 * cycle)
                     for navigator, body, other in zip(navigators, bodies, others)]
        if decisions[1].wait:
            break
        for body, decision in zip(bodies, decisions):
            body.velocity, before = decision.plan.next_velocity, body.velocity
            body.position = [x + 0.05 * (v + w) for x, v, w in zip(body.position, before, body.velocity)]
    wait = decisions[1].wait
    assert wait.neighbor == 0 and not wait.inside and decisions[1].guide == "passage"
    assert wait.passage[1] == pytest.approx(0) and abs(wait.passage[0]) < 3
    assert sorted(side[1] for side in (wait.a, wait.b)) == pytest.approx([-0.8, 0.8])
