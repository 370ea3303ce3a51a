# SPDX-License-Identifier: Apache-2.0
"""Two guards patrol a yard while robots cross it."""
import avo

robots = [{"position": [-12, 2.0 * k - 7], "goal": [12, 7 - 2.0 * k], "radius": 0.4} for k in range(8)]
guards = [{"position": [0, -9], "goal": [0, -9], "radius": 0.4}, {"position": [0, 9], "goal": [0, 9], "radius": 0.4}]
scene = avo.Scenario({"version": 1, "robots": robots + guards})
simulation = avo.Simulation(scene)
metrics = avo.Metrics(scene)
metrics.observe(simulation)
team = avo.Team([8, 9], avo.Patrol([(-6, -9), (6, -9), (6, 9), (-6, 9)]))
passed = 0
goals = None
while simulation.can_step_by(60):
    team.lead(simulation)
    now = [tuple(simulation.goal()[k]) for k in (8, 9)]
    passed += sum(a != b for a, b in zip(now, goals or now))
    goals = now
    simulation.step()
    metrics.observe(simulation)
arrived = sum(simulation.is_at_goal(robot) for robot in range(8))
touched = metrics.summary()["collision_pairs"]
print(f"{arrived} of 8 crossed, the guards passed {passed} points, {touched} pairs touched")
assert arrived == 8 and passed > 4 and touched == 0
