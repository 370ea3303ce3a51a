// SPDX-License-Identifier: Apache-2.0
// Passages: narrow routes from mouth to mouth, made of the gaps between walls (docs/navigation.md).
#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "avo/wall.h"
#include "navigation/clearance_grid.h"
#include "navigation/gap_pairs.h"
#include "walls/segment.h"

namespace avo::inline navigation {

/// Where robots that want to enter a passage wait for robots that come out. Both are radii of the
/// passage, from a mouth outwards, and from the axis.
inline constexpr double kBayOut = 1.2;
inline constexpr double kBayAside = 3.1;

/// Its axis begins and ends in the mouths, where the largest robots do not yet hinder a robot in
/// it. It leads straight from the middle of each gap to that of the next one.
struct Passage {
  std::vector<Vec2> axis;       // m, three points at least
  std::vector<double> along;    // m, of each point of the axis from the first one
  std::vector<Vec2> direction;  // unit, of each piece of the axis
  double half_width = 0.0;      // m, at its narrowest
  double radius = 0.0;          // m, of the largest robots that fit
  bool two_lanes = false;
  /// The side of the bay for robots that enter at the first and at the last mouth: 1 right, -1
  /// left. It is left where walls leave room for the bay only there.
  std::array<double, 2> bay_side = {1.0, 1.0};
  [[nodiscard]] double length() const { return along.back(); }
};

/// Where a point lies with respect to a passage.
struct PassagePlace {
  // m, from the first mouth; negative before it, more than length() after the last mouth
  double along = 0.0;
  double aside = 0.0;  // m, from the axis, to its left
};
PassagePlace place_in(const Passage& passage, Vec2 p);

/// Returns whether the place is between the mouths and the walls, and near the mouths not beside
/// the entrance.
bool is_inside(const Passage& passage, const PassagePlace& place);

/// A point of the axis, or of its straight prolongations.
struct AxisPoint {
  Vec2 point, direction;  // m; unit, to the other end
};
/// forward: `along` counts from the first mouth; if false, from the last mouth, backwards.
AxisPoint axis_point(const Passage& passage, bool forward, double along);

class Passages {
 public:
  Passages() = default;
  /// radii: of all robots, ascending, each > 0. watched: the range about the axis within which
  /// walls count, in radii of a passage.
  Passages(std::span<const Wall> walls, std::span<const double> radii, double watched);
  /// The same result, sooner, from the passages for the same radii, where few walls have changed
  /// since.
  Passages(std::span<const Wall> walls, std::span<const double> radii, double watched,
           Passages before);

  /// The amount of new work.
  struct Work {
    std::size_t gaps = 0, pairs = 0;
  };
  [[nodiscard]] Work work() const { return {told_.examined, pairs_.tested}; }
  [[nodiscard]] bool empty() const { return all_.empty(); }
  [[nodiscard]] std::size_t size() const { return all_.size(); }
  [[nodiscard]] const Passage& operator[](std::uint32_t number) const { return all_[number]; }

  /// The passage that contains p; one with one lane comes before one with two.
  [[nodiscard]] std::optional<std::uint32_t> at(Vec2 p) const;

  struct Crossing {
    std::uint32_t passage = 0;
    double part = 0.0;  // of the segment from p to q
    bool forward = true;
    Segment gap = {};  // the gap that it crosses
  };
  /// The first passage of one lane that the segment from p to q crosses.
  [[nodiscard]] std::optional<Crossing> first_crossed(Vec2 p, Vec2 q) const;
  /// The first passage of one lane or two.
  [[nodiscard]] std::optional<Crossing> first_narrow(Vec2 p, Vec2 q) const;

  /// The narrowest gap of the passage, which has one lane.
  [[nodiscard]] Segment narrowest_gap(std::uint32_t number) const;

  /// Calls visit(number) for each passage of one lane within `watched` radii of p, and for some
  /// others; one may come more than once.
  template <typename Visit>
  void for_each_watched(Vec2 p, const Visit& visit) const;

 private:
  // Lines with the direction of the axis to their left.
  struct GapLines {
    std::vector<Wall> walls;
    std::vector<std::uint32_t> passage_of;
    std::optional<ClearanceGrid> grid;
    [[nodiscard]] std::optional<Crossing> first_crossed(Vec2 p, Vec2 q) const;
  };

  void find(const Passages* before, double watched);
  void find_pairs(const ClearanceGrid& grid, const Passages& before, const WallChanges& changes);
  void choose_bays(const ClearanceGrid& grid);
  void keep_bays(const ClearanceGrid& grid, const Passages& before, std::span<const Zone> changed);
  void index(double watched);

  std::vector<Wall> walls_;
  std::vector<double> radii_;
  ToldGaps told_;
  GapPairs pairs_;
  std::vector<Passage> all_;
  std::vector<std::uint32_t> axis_of_, watched_of_;  // passages of the lines of each grid
  std::optional<ClearanceGrid> axes_;                // finds the passages of a point inside
  GapLines one_lane_, two_lanes_;
  std::optional<ClearanceGrid> watched_;  // of one lane
};

template <typename Visit>
void Passages::for_each_watched(Vec2 p, const Visit& visit) const {
  if (!watched_) return;
  watched_->all_near(p, p, [&](std::size_t k) {
    visit(watched_of_[k]);
    return true;
  });
}

}  // namespace avo::inline navigation
