# SPDX-License-Identifier: Apache-2.0
"""Robots may drive 0.5 m/s in a zone, and 2 m/s elsewhere."""
import avo

lanes = [{"position": [-20, 3 * k], "goal": [20, 3 * k]} for k in range(6)]
scene = avo.Scenario({"version": 1, "robots": lanes})
simulation = avo.Simulation(scene)
metrics = avo.Metrics(scene)
metrics.observe(simulation)
slow = set()
fastest = 0.0  # m/s, in the zone two seconds after entry
entered = {}
while not simulation.all_at_goal() and simulation.can_step_by(90):
    for robot, place, velocity in zip(simulation.ids(), simulation.position(), simulation.velocity()):
        inside = abs(place[0]) < 5
        if inside != (robot in slow):
            simulation.change_robot(robot, max_speed=0.5 if inside else 2.0, preferred_speed=0.5 if inside else 2.0)
            slow ^= {robot}
            entered[robot] = simulation.time
        if inside and simulation.time > entered[robot] + 2:
            fastest = max(fastest, float(abs(velocity[0])))
    simulation.step()
    metrics.observe(simulation)
touched = metrics.summary()["collision_pairs"]
print(f"all there after {simulation.time:.1f} s, at most {fastest:.2f} m/s in the zone, {touched} pairs touched")
assert simulation.all_at_goal() and fastest <= 0.5 and touched == 0
