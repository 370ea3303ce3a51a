# SPDX-License-Identifier: Apache-2.0
"""The loop of one robot on board: sense, decide, accelerate. Another robot comes towards it."""
import math

import avo

GOAL = (10.0, 0.0)
planner = avo.Planner()  # method avo, ten decisions a second
robot = avo.Robot(position=(-10.0, 0.0), max_speed=2.0)
other = avo.Robot(position=(10.0, 0.1), velocity=(-1.0, 0.0), preferred_velocity=(-1.0, 0.0))
memory, others_memory = avo.Detour(), avo.Detour()
step = planner.time_step


def sensed(body: avo.Robot) -> list[avo.Neighbor]:
    """A real robot has its sensors for this."""
    return [avo.Neighbor(position=body.position, velocity=body.velocity, radius=body.radius)]


def towards(goal: tuple[float, float], body: avo.Robot) -> tuple[float, float]:
    """As fast as allowed, and slower near the goal so that it can stop there, m/s."""
    (x, y), (goal_x, goal_y) = body.position, goal
    distance = math.hypot(goal_x - x, goal_y - y)
    speed = min(body.max_speed, math.sqrt(2.0 * 0.8 * body.max_acceleration * distance), distance / step)
    scale = speed / distance if distance > 0.0 else 0.0
    return (scale * (goal_x - x), scale * (goal_y - y))


def move(body: avo.Robot, plan: avo.Plan) -> None:
    """What the drives do: the velocity changes evenly over the step."""
    (x, y), (vx, vy), (ux, uy) = body.position, body.velocity, plan.next_velocity
    body.position = (x + 0.5 * step * (vx + ux), y + 0.5 * step * (vy + uy))
    body.velocity = plan.next_velocity


time, nearest = 0.0, math.inf
while math.dist(robot.position, GOAL) > planner.arrival_distance:
    robot.preferred_velocity = towards(GOAL, robot)
    robot.distance_to_goal = math.dist(robot.position, GOAL)
    plan = planner.plan(robot, sensed(other), detour=memory)
    others_plan = planner.plan(other, sensed(robot), detour=others_memory)
    move(robot, plan)
    move(other, others_plan)
    time += step
    nearest = min(nearest, math.dist(robot.position, other.position) - robot.radius - other.radius)
    if round(time / step) % 20 == 0:
        print(f"{time:4.1f} s: at ({robot.position[0]:6.2f}, {robot.position[1]:5.2f}) m, {plan.status}, {plan.state}")
print(f"arrived after {time:.1f} s, at least {nearest:.2f} m from the other")
