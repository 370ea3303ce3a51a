// SPDX-License-Identifier: Apache-2.0
// Which footprints a scene may have.
#include <string>
#include <variant>

#include "core/ranges.h"
#include "robots/footprint.h"
#include "sim/scene/scene_checks.h"

namespace avo::inline sim {
namespace {

void check_values(std::size_t i, const Footprint& footprint) {
  const std::string_view list = "robots";
  if (footprint.discs < 0 || footprint.discs > Footprint::kMostDiscs)
    refuse(std::string(Place{list, i, "footprint.discs"}), std::to_string(footprint.discs),
           "1 to " + std::to_string(Footprint::kMostDiscs));
  require(Place{list, i, "footprint.radius"}, footprint.radius, kPositive, "m");
  require(Place{list, i, "footprint.first"}, footprint.first, kAnyValue, "m");
  require(Place{list, i, "footprint.spacing"}, footprint.spacing, kNotNegative, "m");
}

}  // namespace

void check_footprint(std::size_t i, const RobotSetup& robot) {
  const Footprint* footprint = own_footprint(robot.model);
  if (footprint == nullptr || footprint->discs == 0) return;
  check_values(i, *footprint);
  const Car* car = std::get_if<Car>(&robot.model);
  if (car != nullptr && car->body)
    refuse(std::string(Place{"robots", i, "car.body"}), "one", "left out: it has a footprint");
}

void check_footprints(const Scenario& scenario) {
  for (std::size_t i = 0; i < scenario.robots.size(); ++i) {
    if (!has_footprint(scenario.robots[i].model)) continue;
    const std::string beside = ": " + std::string(Place{"robots", i, "footprint"}) + " is one";
    if (scenario.clock == Clock::free)
      refuse("clock", to_string(scenario.clock), "common with footprints" + beside);
    if (scenario.sensing.delay > 0)
      refuse("sensing.delay", std::to_string(scenario.sensing.delay), "0 with footprints" + beside);
    if (scenario.sensing.misses())
      refuse("sensing", "measurements that fail", "none with footprints" + beside);
  }
}

}  // namespace avo::inline sim
