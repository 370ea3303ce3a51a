// SPDX-License-Identifier: Apache-2.0
// The families of scenes that safety and arrival are measured over, one a row of the table.
#pragma once
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "avo/scenario.h"

namespace avo::safety {

struct Scene {
  Scenario scenario;
  double unit = 0.0;   ///< s, the time that arrivals are measured in; 0: nobody is to arrive
  double limit = 1.0;  ///< units, within which robots are to arrive
  double share = 1.0;  ///< of the robots that have to
  std::vector<Vec2> rallies = {};  ///< all robots are sent to one of them, then to another
  double rally_period = 5.0;       ///< s
};

struct Family {
  std::string name;
  std::string what;
  int scenes = 1;
  bool seeded = false;  ///< scenes differ; otherwise there is one
  std::function<Scene(std::uint64_t seed)> make;
};

/// All rows, in the order of the table. `crush_steps` is what each crush lasts in all its scenes,
/// in robot-steps.
std::vector<Family> families(double crush_steps);

/// Longest of the times that the robots, alone, take from rest to rest: d/v + v/a with v the
/// preferred speed, or 2 √(d/a) where the way is too short for it.
double straight_time(const Scenario& scenario);

/// Two robots that see each other no later than here can both stop: the largest sum of two of
/// r + v_max Δt + v_max²/(2 a_max).
double stopping_range(const Scenario& scenario);

}  // namespace avo::safety
