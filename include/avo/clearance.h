// SPDX-License-Identifier: Apache-2.0
// How far each robot of a fleet is from the nearest other robot: for recordings and figures.
#pragma once
#include <memory>
#include <span>

#include "avo/export.h"
#include "avo/scenario.h"

namespace avo {

/// Places of all robots of a scenario at one time, one column each, by their numbers. NaN marks a
/// robot that is not present.
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

  /// m, for each robot: the least distance of its disc from the disc of another robot, over pairs
  /// that avoid each other. It is less than 0 where they overlap. Two parked robots are no such
  /// pair. The value is infinite without another robot, and NaN for a robot that is not present.
  /// All spans are as long as the scenario has robots.
  void find(const FleetColumns& fleet, std::span<float> clearance);

 private:
  struct AVO_LOCAL State;
  std::unique_ptr<State> state_;
};

}  // namespace avo
