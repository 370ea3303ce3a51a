// SPDX-License-Identifier: Apache-2.0
// One look at all bodies around a robot: for which of them it may have to brake, whose half-spaces
// can cut, and who is traffic. What is left out changes no bit of a decision.
#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "avo/horizon.h"
#include "avo/planner.h"
#include "certificate/pair.h"
#include "space/bodies.h"

namespace avo::space {

/// A robot, and what it looks for. Distances in m, speeds in m/s.
struct Look {
  const Robot& robot;
  const BrakingOf<3>& braking;  ///< its own
  const Deviation& deviation;   ///< of its candidates, in its own space
  const StepLaw& law;
  const Horizon& horizon;
  double control_time = 0.0;                                       ///< [δ] s
  double self = -1.0;                                              ///< its place; -1: none
  double range = std::numeric_limits<double>::infinity();          ///< others are not sensed
  double traffic_range = std::numeric_limits<double>::infinity();  ///< of traffic ahead
  bool certified = true;  ///< whether it looks for those for which it may have to brake
  /// Bodies beyond get no half-space: a squared distance, m², and of bodies at that distance a
  /// number.
  double farthest_squared = std::numeric_limits<double>::infinity();
  double farthest_number = std::numeric_limits<double>::infinity();
};

/// Pairs that may get a half-space, in columns: B's place and velocity relative to A.
struct SpacePairs {
  using Column = std::vector<double>;
  std::size_t count = 0;
  std::array<Column, 3> p, v;  ///< p_A - p_B, v_A - v_B: m, m/s
  Column radius, reach;        ///< [r_A + r_B], m; [δ (a_A + a_B)], m/s
  Column share, number;        ///< see reciprocal_share(); Bodies::number

  void reserve(std::size_t pairs);
};

/// Scratch memory and result; allocates only while it grows.
struct Looked {
  std::vector<std::uint32_t> near, traffic;  ///< places, by ascending number
  SpacePairs pairs;                          ///< in no order
  std::vector<double> distance_squared;      ///< of those within the range, in no order
  std::vector<double> number;
  std::size_t found = 0;           ///< the entries of these two
  std::vector<std::size_t> order;  ///< of them
};

/// Looks at the bodies of these runs, which share no place.
void look_at(const Look& look, const Bodies& bodies, std::span<const Run> runs, Looked& looked);

/// Limits the half-spaces to those of the nearest `most` bodies within the range.
void limit_to_nearest(std::size_t most, const Bodies& bodies, std::span<const Run> runs, Look& look,
                      Looked& looked);

}  // namespace avo::space
