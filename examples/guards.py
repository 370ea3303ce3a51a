# SPDX-License-Identifier: Apache-2.0
"""Two guards patrol a yard while robots cross it."""
import avo

robots = [{"position": [-12, 2.0 * k - 7], "goal": [12, 7 - 2.0 * k], "radius": 0.4} for k in range(8)]
guards = [{"position": [0, -9], "goal": [0, -9], "radius": 0.4}, {"position": [0, 9], "goal": [0, 9], "radius": 0.4}]
simulation = avo.Simulation({"version": 1, "robots": robots + guards})
team = avo.Team([8, 9], avo.Patrol([(-6, -9), (6, -9), (6, 9), (-6, 9)]))
passed = 0
goals = None
while simulation.can_step_by(60):
    team.lead(simulation)
    now = [tuple(simulation.goal()[k]) for k in (8, 9)]
    passed += sum(a != b for a, b in zip(now, goals or now))
    goals = now
    simulation.step()
arrived = sum(abs(place[0] - 12) < 0.5 for place in simulation.position()[:8])
print(f"{arrived} of 8 crossed, the guards passed {passed} points")
