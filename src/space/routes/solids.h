// SPDX-License-Identifier: Apache-2.0
// The boxes of a scene in a tree, for questions about places and straight lines. Routes and senses
// ask them, and for each robot the boxes near it are found here. The certificate counts the boxes
// themselves.
#pragma once
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "avo/space/box.h"
#include "avo/vec.h"
#include "space/routes/bounds.h"

namespace avo::space {

/// A box with the axes of its frame, so that no question computes an angle.
struct Solid {
  Box box;    ///< in its own frame: heading 0
  Vec2 axis;  ///< the x axis of the frame

  [[nodiscard]] Vec3 in(Vec3 a) const {
    return {axis.x * a.x + axis.y * a.y, axis.x * a.y - axis.y * a.x, a.z};
  }
  [[nodiscard]] Vec3 out(Vec3 a) const {
    return {axis.x * a.x - axis.y * a.y, axis.y * a.x + axis.x * a.y, a.z};
  }
};

/// Where the nearest surface is.
struct Away {
  double distance = 0.0;  ///< m, negative inside of a box
  Vec3 normal;            ///< unit, outwards; 0 where nothing is near
};

class Solids {
 public:
  Solids() = default;
  explicit Solids(std::span<const Box> boxes);

  [[nodiscard]] std::size_t size() const { return all_.size(); }
  [[nodiscard]] const Solid& operator[](std::size_t k) const { return all_[k]; }
  /// What the box is between, in the scene.
  [[nodiscard]] const Bounds& bounds(std::size_t k) const { return bounds_[k]; }

  /// Sets the boxes that may be within that distance, m, of a place, by ascending numbers.
  void find_near(Vec3 place, double distance, std::vector<std::uint32_t>& numbers) const;
  /// Returns whether the segment touches none of the boxes. boxes: those of which these were made.
  [[nodiscard]] bool are_apart(Vec3 a, Vec3 b, std::span<const Box> boxes) const;
  /// The nearest surface; nothing farther than `most` m is searched.
  [[nodiscard]] Away away(Vec3 place, double most) const;
  /// Returns whether the segment keeps more than that distance, m, from all boxes.
  [[nodiscard]] bool is_clear(Vec3 a, Vec3 b, double room) const;
  /// Returns whether no box is between two places. Two boxes that touch leave nothing to see.
  [[nodiscard]] bool sees(Vec3 a, Vec3 b) const { return is_clear(a, b, kSight); }
  /// m: how far a ray gets, `most` at most. direction: unit.
  [[nodiscard]] double free_length(Vec3 from, Vec3 direction, double most) const;

 private:
  static constexpr double kSight = 1e-9;  // m
  // A node of the tree. Its left child follows it; a leaf has no right child.
  struct Node {
    Bounds bounds;
    std::uint32_t first = 0, count = 0, right = 0;
  };
  std::uint32_t build(std::uint32_t first, std::uint32_t count);
  // Calls visit(number) for all boxes of leaves that enters(bounds) lets in, until it returns
  // false.
  template <typename Enters, typename Visit>
  bool all_of(const Enters& enters, const Visit& visit) const;

  std::vector<Solid> all_;
  std::vector<Bounds> bounds_;        // of each box, in the scene
  std::vector<std::uint32_t> order_;  // boxes of the leaves
  std::vector<Node> nodes_;
};

}  // namespace avo::space
