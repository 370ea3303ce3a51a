// SPDX-License-Identifier: Apache-2.0
// Robots as others sense them, in columns, and their braking: what does not depend on the robot
// that decides is computed here once.
#pragma once
#include <array>
#include <cstddef>
#include <vector>

#include "avo/space/robot.h"
#include "certificate/pair.h"

namespace avo::space {

/// Allocates only while it grows.
struct Bodies {
  using Column = std::vector<double>;
  /// The columns have room for so many extra entries, which are read but do not count.
  static constexpr std::size_t kSpare = 8;

  std::size_t count = 0;
  std::array<Column, 3> position, velocity;  // m, m/s, by axis
  Column number;                             // by which the robot that decides knows the body
  Column radius, max_acceleration, max_braking, vertical, downwash, priority;  // see Neighbor
  std::vector<int> age;
  // see BrakingOf; set by fill_braking()
  std::array<Column, 3> direction;
  Column speed, decrement, full_steps, increment, length, reach, intervals;
  Column error;  // m, of the path of a body that brakes, relative to the sensed one
  // some have downwash; limits that differ along the vertical
  bool has_downwash = false, has_vertical = false;
  bool has_ages = false;   // some were sensed steps ago
  bool is_uniform = true;  // all have the same radius, limits, downwash and priority
  // the largest of all; set by fill_braking()
  double most_reach = 0.0, most_full_steps = 0.0, most_intervals = 0.0, most_error = 0.0;
  double most_downwash = 0.0;

  void clear();
  void reserve(std::size_t bodies);
  /// Requires room for one more. The braking is not set.
  void add(const Neighbor& body, std::size_t body_number);
  [[nodiscard]] Neighbor neighbor(std::size_t k) const;
  [[nodiscard]] Vec3 place_of(std::size_t k) const {
    return {position[0][k], position[1][k], position[2][k]};
  }
  [[nodiscard]] BrakingOf<3> braking(std::size_t k) const;
};

/// Sets the braking of all bodies.
void fill_braking(const StepLaw& law, Bodies& bodies);

/// The law with the errors of that neighbor (docs/certificate/errors.md, "Age"), as large in every
/// direction of its own space.
StepLaw law_against(const Neighbor& neighbor, const StepLaw& law);

/// The vector to A's center from the nearest point of B's body, m, where neither may be in the other
/// one's downwash.
Vec3 away_from(Vec3 a, double downwash_a, Vec3 b, double downwash_b);

/// Bodies at consecutive places [first, last).
struct Run {
  std::size_t first = 0, last = 0;
};

}  // namespace avo::space
