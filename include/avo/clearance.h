// SPDX-License-Identifier: Apache-2.0
// How far each robot of a fleet is from the nearest other one: of recordings and of figures.
#pragma once
#include <memory>
#include <span>

#include "avo/export.h"
#include "avo/scenario.h"

namespace avo {

/// Where all robots of a scenario are at one time, a column each, by their numbers. Not a number: a
/// robot that is not there.
struct FleetColumns {
  std::span<const double> x;        ///< m, see disc_center()
  std::span<const double> y;        ///< m
  std::span<const double> heading;  ///< rad; empty where all are holonomic
};

/// Finds clearances on a grid, in a time that is linear in the number of robots.
class AVO_API ClearanceFinder {
 public:
  explicit ClearanceFinder(const Scenario& scenario);
  ~ClearanceFinder();
  ClearanceFinder(ClearanceFinder&&) noexcept;
  ClearanceFinder& operator=(ClearanceFinder&&) noexcept;

  /// m, of each robot: the least distance of its disc from that of another robot, of those of which
  /// both avoid the other, less than 0 where they overlap. Two parked robots are no such pair.
  /// Infinite where there is nobody, not a number of who is not there. All spans are as long as
  /// the scenario has robots.
  void find(const FleetColumns& fleet, std::span<float> clearance);

 private:
  struct AVO_LOCAL State;
  std::unique_ptr<State> state_;
};

}  // namespace avo
