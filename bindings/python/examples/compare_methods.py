# SPDX-License-Identifier: Apache-2.0
"""The methods on one scene: which robots arrive, which collide, and how long it takes."""
import avo

print(f"{'method':<28} {'arrived':>8} {'collisions':>11} {'last arrival':>13} {'largest |a|':>12}")
for method in ("avo", "avo_paper", "velocity_obstacle", "orca", "orca_clamped",
               "reciprocal_velocity_obstacle", "buffered_voronoi"):
    summary = avo.run(avo.Scenario("circle-50", overrides={"method": method}))
    last = summary["last_arrival"]
    print(f"{method:<28} {summary['arrived']:>8} {summary['collision_pairs']:>11} "
          f"{'-' if last is None else f'{last:.1f} s':>13} {summary['max_acceleration']:>7.2f} m/s^2")
