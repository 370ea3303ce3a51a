// SPDX-License-Identifier: Apache-2.0
// A simulation that an independent judge looks at.
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "avo/check.h"
#include "avo/checked.h"
#include "avo/simulation.h"

namespace avo::test {

/// Judges every step by the walls that stand in it, by the judge's own arithmetic.
class Judged {
 public:
  Judged(const Scenario& scene, int threads) : simulation(scene, threads), check_({}) { look(); }

  void step() {
    std::vector<CheckedWall> walls;
    for (const StaticObstacle& obstacle : simulation.obstacles().setup)
      for (const Wall& wall : walls_of(std::span(&obstacle, 1)))
        walls.push_back({wall.a, wall.b, wall.radius, obstacle.layers.bits});
    check_.set_walls(walls);
    simulation.step();
    look();
  }
  void run(double seconds) {
    const double end = simulation.time() + seconds;
    while (simulation.time() < end - 1e-9) step();
  }
  [[nodiscard]] CheckReport report() const { return check_.report(); }

  Simulation simulation;

 private:
  void look() {
    const FleetView fleet = simulation.fleet();
    for (std::size_t k = 0; k < fleet.id.size(); ++k) {
      CheckedRobot robot = checked_robot(fleet.setup[k]);
      robot.goal.reset();
      for (; known_ <= static_cast<std::int64_t>(fleet.id[k].value); ++known_)
        check_.add_robot(robot);
    }
    check_.add(simulation.time(), checked_states(fleet));
  }
  Check check_;
  std::int64_t known_ = 0;  // robots that the judge knows
};

}  // namespace avo::test
