// SPDX-License-Identifier: Apache-2.0
// Cars of one lane pass road works. A traffic control center lowers the limit of each car, by its
// id, in time before the zone, and raises it behind the zone.
#include <algorithm>
#include <cstdio>
#include <vector>

#include <avo/avo.h>

namespace {

constexpr int kCars = 12;
constexpr double kFast = 8.0, kSlow = 3.0, kBraking = 2.0;  // m/s, m/s, m/s^2
constexpr double kBegin = 60.0, kEnd = 90.0;                // m: the zone
// m: where a car has to begin to brake, with a length of its own to spare
constexpr double kNotice = kBegin - (kFast * kFast - kSlow * kSlow) / (2.0 * kBraking) - 8.0;

}  // namespace

int main() {
  avo::Scenario scene;
  scene.duration = 90;
  for (const double y : {-2.0, 2.0}) scene.obstacles.push_back({{{{{-120, y}, {260, y}}, false}}});
  for (int k = 0; k < kCars; ++k) {
    avo::RobotSetup car;
    car.model = avo::Car{.wheelbase = 2.5, .max_curvature = 0.2};
    car.radius = 1.2;
    car.max_speed = car.preferred_speed = kFast;
    car.max_acceleration = kBraking;
    car.position = {-9.0 * k, 0};
    car.goal = {250, 0};
    scene.robots.push_back(car);
  }
  avo::Simulation simulation(scene);
  avo::Metrics metrics(scene);
  metrics.observe(simulation);
  std::vector<bool> is_slow(kCars, false), has_passed(kCars, false);
  double fastest = 0.0;  // m/s, in the zone
  int passed = 0;
  while (passed < kCars && simulation.can_step_by(scene.duration)) {
    for (std::size_t k = 0; k < simulation.size(); ++k) {
      const avo::RobotState car = simulation.robot({k});
      if (!has_passed[k] && car.position.x > kEnd) has_passed[k] = true, ++passed;
      const bool slow = car.position.x > kNotice && car.position.x < kEnd;
      if (car.position.x > kBegin && car.position.x < kEnd)
        fastest = std::max(fastest, norm(car.velocity));
      if (slow == is_slow[k]) continue;
      avo::RobotSetup setup = simulation.setup(car.id);
      setup.max_speed = setup.preferred_speed = slow ? kSlow : kFast;
      simulation.change_robot(car.id, setup);
      is_slow[k] = slow;
    }
    simulation.step();
    metrics.observe(simulation);
  }
  const avo::RunSummary summary = metrics.summary();
  std::printf(
      "%d of %d cars passed, the last after %.1f s, at most %.2f m/s in the zone, %d pairs "
      "touched, %d walls\n",
      passed, kCars, simulation.time(), fastest, int(summary.collision_pairs),
      int(summary.static_collisions));
  const bool is_safe = summary.collision_pairs == 0 && summary.static_collisions == 0;
  return passed == kCars && is_safe && fastest < kSlow + 0.01 ? 0 : 1;
}
