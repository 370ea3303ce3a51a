// SPDX-License-Identifier: Apache-2.0
// A fleet for those who look at it from outside.
#pragma once
#include <cstddef>
#include <vector>

#include "avo/simulation.h"

namespace avo::inline sim {

struct Fleet;

/// Columns by ascending id, for those who look at a fleet from outside. They are copied when
/// somebody asks for them, each by itself.
struct FleetMirror {
  std::vector<RobotId> id;
  std::vector<Vec2> position, velocity, goal;
  std::vector<double> heading, applied_acceleration;
  std::vector<RobotSetup> setup;
  std::vector<Detour> detour;
  std::vector<Plan> plan;

  void copy(const Fleet& fleet, Columns wanted);
  /// What has been copied, of one robot anew. Throws nothing.
  void renew(const Fleet& fleet, std::size_t rank_of_it, Columns copied);
  FleetView view(Columns wanted) const;

 private:
  template <typename Action>
  void for_each_column(Columns wanted, const Action& action);
};

}  // namespace avo::inline sim
