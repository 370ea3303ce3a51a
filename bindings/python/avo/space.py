# SPDX-License-Identifier: Apache-2.0
"""Robots in three dimensions: drones, submarines, satellites (docs/space.md).

Points are triples (x, y, z), z upwards; arrays of n of them are (n, 3), float64, and copies.
"""
from . import _avo

Box = _avo._space.Box
CrazyflieSetPoint = _avo._space.CrazyflieSetPoint
Detour = _avo._space.Detour
Detours = _avo._space.Detours
Events = _avo._space.Events
Filter = _avo._space.Filter
Mover = _avo._space.Mover
MovingObstacle = _avo._space.MovingObstacle
Neighbor = _avo._space.Neighbor
Neighbors = _avo._space.Neighbors
Plan = _avo._space.Plan
Planner = _avo._space.Planner
Plans = _avo._space.Plans
Px4SetPoint = _avo._space.Px4SetPoint
Quadrotor = _avo._space.Quadrotor
Robot = _avo._space.Robot
Robots = _avo._space.Robots
RobotSetup = _avo._space.RobotSetup
Route = _avo._space.Route
Scenario = _avo._space.Scenario
SetPoint = _avo._space.SetPoint
Simulation = _avo._space.Simulation
Worlds = _avo._space.Worlds
check = _avo._space.check
crazyflie_set_point = _avo._space.crazyflie_set_point
evasion_range = _avo._space.evasion_range
explain = _avo._space.explain
px4_set_point = _avo._space.px4_set_point
run = _avo._space.run
_is_in_space = _avo._space._is_in_space

__all__ = [
    "Box",
    "CrazyflieSetPoint",
    "Detour",
    "Detours",
    "Events",
    "Filter",
    "Mover",
    "MovingObstacle",
    "Neighbor",
    "Neighbors",
    "Plan",
    "Planner",
    "Plans",
    "Px4SetPoint",
    "Quadrotor",
    "Robot",
    "Robots",
    "RobotSetup",
    "Route",
    "Scenario",
    "SetPoint",
    "Simulation",
    "Worlds",
    "check",
    "crazyflie_set_point",
    "evasion_range",
    "explain",
    "px4_set_point",
    "run",
]
