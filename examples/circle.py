# SPDX-License-Identifier: Apache-2.0
"""Circle-100 from Python: prints how many arrive, and the state hash at the end."""
import avo

scene = avo.Scenario("circle-100")
simulation = avo.Simulation(scene)
metrics = avo.Metrics(scene)
metrics.observe(simulation)
while simulation.can_step_by(scene.duration):
    simulation.step()
    metrics.observe(simulation)
summary = metrics.summary()
print(f"{summary['arrived']} of {summary['robots']} arrived, {summary['collision_pairs']} collisions, "
      f"state hash {simulation.state_hash():#018x}")
assert summary["arrived"] == summary["robots"] and summary["collision_pairs"] == 0
