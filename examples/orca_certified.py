# SPDX-License-Identifier: Apache-2.0
"""ORCA's choice under limits of acceleration, alone and with the certificate behind it."""
import avo

for scene in ("crossing-streams", "doorway", "office"):
    for certificate in ("none", "braking_trajectories"):
        summary = avo.run(avo.Scenario(scene, overrides={
            "method": "orca_clamped", "certificate": certificate, "time_horizon": 3}))
        print(f"{scene:18} {certificate:22} {summary['collision_pairs']:4} pairs collide, "
              f"{summary['arrived']} of {summary['robots']} arrive")
        assert certificate == "none" or summary["collision_pairs"] == 0
