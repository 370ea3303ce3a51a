// SPDX-License-Identifier: Apache-2.0
// Eq. (23) for many robots at once, one robot per lane: nearest_point() of lp/linear_program.h, bit
// for bit where Number is double.
#pragma once
#include <cstddef>
#include <cstdint>
#include <vector>

#include "avo/geometry.h"

namespace avo {

/// Programs in groups of kLanes robots, whose numbers lie side by side. To be filled robot by
/// robot, each with its half-planes in their order; memory is allocated only while it grows.
template <typename Number>
class ProgramBatch {
 public:
  static constexpr std::size_t kLanes = 16;  // a multiple of every instruction set's

  struct Group {
    Number c_x[kLanes], c_y[kLanes], radius[kLanes];  // acceleration disc
    Number top_speed[kLanes];                         // speed disc around 0
    Number p_x[kLanes], p_y[kLanes];                  // preferred
    Number x[kLanes], y[kLanes];                      // result
    Number violation[kLanes];                         // of the result
    std::uint32_t settled, moved;                     // bit l: lane l; moved: not the preferred one
    std::size_t first, count;                         // rows
  };
  /// One half-plane of each lane. All zeros, which every point satisfies, where a robot has fewer.
  struct Row {
    Number n_x[kLanes], n_y[kLanes], offset[kLanes];
  };

  void clear() {
    preferred_.clear();
    groups.clear();
    rows.clear();
  }

  /// The next robot. Nothing is required of the numbers.
  void add(const Disc& acceleration, double top_speed, Vec2 preferred) {
    lane_ = preferred_.size() % kLanes;
    planes_ = 0;
    if (lane_ == 0) {
      groups.emplace_back();
      groups.back().first = rows.size();
    }
    Group& group = groups.back();
    group.c_x[lane_] = static_cast<Number>(acceleration.center.x);
    group.c_y[lane_] = static_cast<Number>(acceleration.center.y);
    group.radius[lane_] = static_cast<Number>(acceleration.radius);
    group.top_speed[lane_] = static_cast<Number>(top_speed);
    group.p_x[lane_] = static_cast<Number>(preferred.x);
    group.p_y[lane_] = static_cast<Number>(preferred.y);
    preferred_.push_back(preferred);
  }

  /// The next half-plane of the robot added last.
  void add(const HalfPlane& plane) {
    Group& group = groups.back();
    if (planes_ == group.count) {
      rows.emplace_back();
      ++group.count;
    }
    Row& row = rows[group.first + planes_++];
    row.n_x[lane_] = static_cast<Number>(plane.normal.x);
    row.n_y[lane_] = static_cast<Number>(plane.normal.y);
    row.offset[lane_] = static_cast<Number>(plane.offset);
  }

  [[nodiscard]] std::size_t size() const { return preferred_.size(); }

  /// False: out of the ordinary, left to nearest_point(). Results of other robots mean nothing.
  [[nodiscard]] bool settled(std::size_t robot) const {
    return (groups[robot / kLanes].settled >> robot % kLanes & 1U) != 0;
  }
  /// The preferred one, bit for bit, where that violates nothing.
  [[nodiscard]] Vec2 point(std::size_t robot) const {
    const Group& group = groups[robot / kLanes];
    const std::size_t lane = robot % kLanes;
    if ((group.moved >> lane & 1U) == 0) return preferred_[robot];
    return {group.x[lane], group.y[lane]};
  }
  /// 0: state optimal; else least_unsafe, see ProgramResult.
  [[nodiscard]] double violation(std::size_t robot) const {
    return groups[robot / kLanes].violation[robot % kLanes];
  }

  std::vector<Group> groups;
  std::vector<Row> rows;  // kernels make the offsets relative in place

 private:
  std::vector<Vec2> preferred_;
  std::size_t lane_ = 0, planes_ = 0;  // of the robot added last
};

/// Solves the programs in the batch.
void nearest_points(ProgramBatch<double>& batch) noexcept;
void nearest_points(ProgramBatch<float>& batch) noexcept;

}  // namespace avo
