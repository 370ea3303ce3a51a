// SPDX-License-Identifier: Apache-2.0
// One look at all bodies around a robot. It finds the bodies for which the robot may have to brake,
// the half-spaces that can cut, and the traffic. What is left out changes no bit of a decision.
#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "avo/horizon.h"
#include "avo/planner.h"
#include "certificate/pair.h"
#include "space/bodies.h"

namespace avo::space {

/// A robot, and what it looks for. Distances in m, speeds in m/s.
struct Viewer {
  const Robot& robot;
  const BrakingOf<3>& braking;  ///< its own
  const Deviation& deviation;   ///< of its candidates, in its own space
  const StepLaw& law;
  const Horizon& horizon;
  double control_time = 0.0;                               ///< [δ] s
  double self = -1.0;                                      ///< its place; -1: none
  double range = std::numeric_limits<double>::infinity();  ///< others are not sensed
  double traffic_range = 0.0;                              ///< of traffic ahead
  bool certified = true;  ///< whether it looks for those for which it may have to brake
  /// Bodies beyond get no half-space: a squared distance, m², and of bodies at that distance a
  /// number.
  double farthest_squared = std::numeric_limits<double>::infinity();
  double farthest_number = std::numeric_limits<double>::infinity();

  /// Whether neither errors nor shapes nor limits along the vertical tell the pairs apart from
  /// those of the plane.
  [[nodiscard]] bool is_plain(const Bodies& bodies) const {
    return law.is_exact() && robot.downwash == 0.0 && robot.vertical == 1.0 &&
           !bodies.has_downwash && !bodies.has_vertical && !bodies.has_ages;
  }
};

/// Bodies within the range, in columns, in no order.
struct SeenColumns {
  using Column = std::vector<double>;
  std::size_t count = 0;
  Column place;                // index into the bodies
  std::array<Column, 3> p, v;  // p_A - p_B, v_A - v_B: m, m/s

  void reserve(std::size_t bodies);
};

/// Pairs that may get a half-space, in columns, in no order.
struct SpacePairs {
  using Column = std::vector<double>;
  std::size_t count = 0;
  std::array<Column, 3> p, v;  // of the ball of the pair's shape that matters: m, m/s
  Column radius, reach;        // [r_A + r_B], m; [δ (a_A + a_B)], m/s
  Column share, number;        // see reciprocal_share(); Bodies::number

  void reserve(std::size_t pairs);
};

/// See NearBody.
inline constexpr double kUnknownGap = -std::numeric_limits<double>::infinity();

/// A body for which A may have to brake, and what it can refuse, see PackClearance. Where the gap
/// is unknown, it may be nothing at all.
struct NearBody {
  std::uint32_t place;
  double number;  ///< Bodies::number
  double gap = kUnknownGap, against = 1.0;
  double inflated = 0.0, share = 0.0;  ///< of the pair; set where the gap is known
};

/// Scratch memory and result; allocates only while it grows.
struct Looked {
  SeenColumns seen;
  SeenColumns close;  ///< those that may matter for more than a half-space
  SpacePairs pairs;
  std::vector<NearBody> near;         ///< by ascending number
  double ahead = 0.0;                 ///< see Traffic::ahead
  std::vector<std::uint32_t> beside;  ///< places of bodies that may be nearly in contact, as well
  // scratch memory
  std::size_t count = 0;
  std::vector<double> places;                      // so many count
  std::vector<std::pair<double, double>> nearest;  // squared distances and numbers
};

/// Looks at the bodies of these runs, which share no place. The `max_neighbors` nearest of those
/// within the range may get half-spaces. Sets all of the result but the pairs.
void look_at(Viewer& look, const Bodies& bodies, std::span<const Run> runs,
             std::optional<int> max_neighbors, Looked& looked);

/// Sets the pairs of a look with half-spaces that may cut into what the robot can choose.
void pairs_that_cut(const Viewer& look, const Bodies& bodies, Looked& looked);
/// Sets the pairs with half-spaces that may not contain one velocity in space, m/s.
void pairs_without(const Viewer& look, Vec3 velocity, const Bodies& bodies, Looked& looked);

}  // namespace avo::space
