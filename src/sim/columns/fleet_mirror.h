// SPDX-License-Identifier: Apache-2.0
// A fleet for readers outside the simulation.
#pragma once
#include <cstddef>
#include <vector>

#include "avo/simulation.h"

namespace avo::inline sim {

struct Base;
struct Fleet;

/// Columns by ascending id, for readers outside the simulation. Each column is copied on demand.
struct FleetMirror {
  std::vector<RobotId> id;
  std::vector<Vec2> position, velocity, goal;
  std::vector<double> heading, applied_acceleration;
  std::vector<RobotSetup> setup;
  std::vector<Detour> detour;
  std::vector<Plan> plan;

  void copy(const Fleet& fleet, Columns wanted);
  /// Copies one robot again in the columns that have been copied. Throws nothing.
  void renew(const Fleet& fleet, std::size_t rank_of_it, Columns copied);
  FleetView view(Columns wanted) const;

 private:
  void show_body(const Base& base, std::size_t rank, Columns wanted);
  template <typename Action>
  void for_each_column(Columns wanted, const Action& action);
};

}  // namespace avo::inline sim
