// SPDX-License-Identifier: Apache-2.0
// Finds the neighbors for which each of many robots may have to brake. Bounds exclude most far
// pairs with little arithmetic; the rest of all robots is tested in full lanes.
#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "avo/robot.h"
#include "certificate/braking_path.h"
#include "certificate/pair.h"
#include "core/robot_columns.h"

namespace avo::inline certificate {

/// By robot: its braking path, how far its candidates' paths get from it, and the bounds that tell
/// which neighbors can refuse nothing, see PackBound.
struct BrakingColumns {
  using Column = std::vector<double>;
  Column speed, decrement, increment, full_steps, direction_x, direction_y, length, reach,
      intervals;
  Column stray_velocity, stray_distance;  // see Stray
  // see Deviation
  Column ahead_start, ahead_slope, across_start, across_slope, anyhow_start, anyhow_slope;
  Column fast_speed, fast_steps, slow_speed, slow_steps, most_ahead, most_aside;
  Column far_distance, far_speed_squared;  // m, m²/s²
  Column clear_distance, per_decrement;    // m, s/m
  Column next_ahead, next_aside;           // m, of one candidate; set by admit_next()
  std::array<Column, 3> far_reach;         // a polynomial in the other's speed: m, s, s²/m
  // whether robot i has a footprint: see collect_discs(); empty where none has a model
  std::vector<std::uint8_t> has_discs;

  void reserve(std::size_t robots);
  /// Sets how far the models of the robots stray, and which robots have footprints.
  void take_strays(const RobotColumns& robots, const StepLaw& law);
  Braking braking(std::size_t i) const;
  Deviation deviation(std::size_t i) const;
};

/// Pairs that are not far, until there are enough of them to fill the lanes.
struct NearQueue {
  static constexpr std::size_t kSize = 64, kSpare = 16;
  using Column = std::array<double, kSize + kSpare>;
  std::size_t count = 0;
  Column robot{}, place{};  ///< indices of A among the robots, and of B in the columns of neighbors
};

/// A pair that can refuse a candidate of A: see BrakingPair.
struct NearPair {
  std::uint32_t robot, neighbor;  ///< index of the robot, and index into its neighbors
  Vec2 p;
  double contact, inflated, error, share;
  Braking b;
  double gap, against;  ///< see PackClearance

  BrakingPair with(const Braking& a) const {
    return {.p = p,
            .contact = contact,
            .inflated = inflated,
            .error = error,
            .share = share,
            .decides = true,
            .a = a,
            .b = b};
  }
};

/// Scratch memory and result of find_near(); allocates only while it grows.
struct NearPairs {
  BrakingColumns own;
  NearQueue queue;
  std::vector<NearPair> kept;    ///< robot by robot, by ascending neighbor
  std::vector<std::size_t> end;  ///< one past the pairs of robot i
  /// Whether robot i has neighbors that do not decide, or have an age or a footprint: they are
  /// tested one by one. All neighbors of a robot with a footprint are.
  std::vector<std::uint8_t> has_others;
  std::vector<std::uint8_t> admits;  ///< set by admit_next()

  std::span<const NearPair> of(std::size_t i) const {
    const std::size_t first = i == 0 ? 0 : end[i - 1];
    return std::span(kept).subspan(first, end[i] - first);
  }
  void reserve(std::size_t robots, std::size_t pairs) {
    own.reserve(robots);
    kept.reserve(pairs);
    end.reserve(robots);
    has_others.reserve(robots);
    admits.reserve(robots);
  }
};

/// Finds each robot's neighbors that decide and have age 0. It keeps the neighbors that may meet
/// the robot and can refuse a candidate. The neighbors of all robots are in the same columns.
void find_near(const RobotColumns& robots, const StepLaw& law, NearPairs& near);

/// Finds whether robot i may have the next velocity whatever its near pairs demand: the velocity
/// deviates too little from braking. The robot must be no car and have no others, and find_near()
/// must have run.
void admit_next(const RobotColumns& robots, const std::vector<double>& next_x,
                const std::vector<double>& next_y, const StepLaw& law, NearPairs& near);

}  // namespace avo::inline certificate
