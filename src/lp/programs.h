// SPDX-License-Identifier: Apache-2.0
// Eqs. (22), (23) for many robots at once, one robot per lane.
#pragma once
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "avo/geometry.h"

namespace avo {

/// Robots whose programs' numbers lie side by side: a multiple of every instruction set's lanes.
inline constexpr std::size_t kProgramLanes = 16;

struct ProgramGroup {
  using Lanes = double[kProgramLanes];
  Lanes c_x, c_y, radius;    // acceleration disc
  Lanes top_speed;           // speed disc around 0
  Lanes p_x, p_y;            // preferred
  Lanes planes;              // how many
  Lanes x, y, violation;     // result
  std::uint32_t settled;     // bit l: lane l
  std::uint32_t moved;       // the result is not the preferred one
  std::uint32_t failed;      // the half-planes leave nothing
  std::size_t first, count;  // rows
};

/// One half-plane of each lane, anything where a robot has fewer.
struct ProgramRow {
  using Lanes = double[kProgramLanes];
  Lanes n_x, n_y, offset;
  Lanes relative;  // the offset, from Lens::origin
};

struct Programs {
  std::size_t robots = 0, groups = 0, rows = 0;  // in use
  std::vector<ProgramGroup> group;
  std::vector<ProgramRow> row;

  void clear() { robots = groups = rows = 0; }

  /// The group of the next robot; its lane is robots % kProgramLanes before the call.
  ProgramGroup& add_robot();
  /// Room for so many rows in the last group.
  void add_rows(std::size_t count);
};

/// Programs to be solved at once, filled robot by robot; allocates only while it grows.
class ProgramBatch {
 public:
  void clear();
  /// Room for so many robots with at most so many half-planes each, and in all.
  void reserve(std::size_t robots, std::size_t planes_each, std::size_t planes);

  /// The next robot. Nothing is required of the numbers but |normal| = 1.
  void add(const Disc& acceleration, double top_speed, Vec2 preferred,
           std::span<const HalfPlane> planes);

  [[nodiscard]] std::size_t size() const { return programs_.robots; }

  /// False: out of the ordinary, and left to nearest_point(); the results mean nothing then.
  [[nodiscard]] bool settled(std::size_t robot) const { return bit(group(robot).settled, robot); }
  /// The preferred one, bit for bit, where that violates nothing.
  [[nodiscard]] Vec2 point(std::size_t robot) const {
    const std::size_t lane = robot % kProgramLanes;
    if (!bit(group(robot).moved, robot)) return preferred_[robot];
    return {group(robot).x[lane], group(robot).y[lane]};
  }
  /// 0: state optimal; else least_unsafe, see ProgramResult.
  [[nodiscard]] double violation(std::size_t robot) const {
    return group(robot).violation[robot % kProgramLanes];
  }

 private:
  friend void nearest_points(ProgramBatch& batch);

  [[nodiscard]] const ProgramGroup& group(std::size_t robot) const {
    return programs_.group[robot / kProgramLanes];
  }
  static bool bit(std::uint32_t bits, std::size_t robot) {
    return (bits >> robot % kProgramLanes & 1U) != 0;
  }

  Programs programs_;
  std::vector<Vec2> preferred_;      // as given
  Programs infeasible_;              // those that failed, side by side
  std::vector<std::size_t> robots_;  // whose these are
  std::vector<ProgramRow> scratch_;
};

/// Solves all programs of the batch: nearest_point() of lp/linear_program.h without hard
/// half-planes, and what it says in state optimal or least_unsafe, bit for bit. The same bits for
/// every instruction set.
void nearest_points(ProgramBatch& batch);

}  // namespace avo
