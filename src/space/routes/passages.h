// SPDX-License-Identifier: Apache-2.0
// Passages of space: windows, doors and shafts in which two robots cannot evade each other. The
// rules of the plane hold in the half-plane of the axis and a robot (docs/space.md, "Routes and
// passages").
#pragma once
#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "navigation/passages.h"
#include "space/routes/tubes.h"

namespace avo::space {

/// A place with respect to a passage, m.
struct PlaceInTube {
  double along = 0.0;  ///< from the first mouth
  double lanes = 0.0;  ///< from the axis, to the side of the lane of robots that go on
  double other = 0.0;  ///< from the axis, across both
  double aside = 0.0;  ///< from the axis
};

struct SpacePassage {
  /// The passage of the plane with the axis x and the same radius and lanes. Robots are beside it
  /// at positive y.
  Passage plane;
  Vec3 mouth;                                 ///< m, the first one
  Vec3 axis;                                  ///< unit, to the last mouth
  Vec3 lanes, other;                          ///< unit, across: see PlaceInTube
  double half_lanes = 0.0, half_other = 0.0;  ///< m, from the axis to the faces

  [[nodiscard]] double length() const { return plane.length(); }
  [[nodiscard]] PlaceInTube place(Vec3 a) const;
  [[nodiscard]] Vec3 point(double along, Vec3 across, double aside) const {
    return mouth + along * axis + aside * across;
  }
  [[nodiscard]] bool contains(Vec3 a) const;
};

/// The passages of robots with these radii, ascending.
class SpacePassages {
 public:
  SpacePassages() = default;
  SpacePassages(const Solids& solids, std::span<const double> radii);

  [[nodiscard]] bool empty() const { return all_.empty(); }
  [[nodiscard]] std::size_t size() const { return all_.size(); }
  [[nodiscard]] const SpacePassage& operator[](std::size_t k) const { return all_[k]; }
  /// The passage with one lane, or with two, that contains the place.
  [[nodiscard]] std::optional<std::uint32_t> at(Vec3 place, bool two_lanes) const;

  /// The first passage of one lane that a straight line leads through.
  struct Crossing {
    std::uint32_t passage = 0;
    double part = 0.0;  ///< of the line
    bool forward = true;
  };
  [[nodiscard]] std::optional<Crossing> first_crossed(Vec3 from, Vec3 to) const;

  /// Where a robot waits beside the mouth at which it would enter: the direction from the axis that
  /// is nearest to its own and free.
  [[nodiscard]] Vec3 side_of(std::uint32_t passage, bool forward, Vec3 place) const;

 private:
  static constexpr std::size_t kSides = 8;
  using Sides = std::array<bool, kSides>;

  std::vector<SpacePassage> all_;
  std::vector<std::array<Sides, 2>> free_sides_;  // of each passage, at both mouths
};

}  // namespace avo::space
