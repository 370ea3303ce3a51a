// SPDX-License-Identifier: Apache-2.0
// Eqs. (22), (23) for many robots at once, one robot per lane.
#pragma once
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "avo/geometry.h"
#include "lp/program_columns.h"

namespace avo::inline lp {

/// Robots whose programs' numbers lie side by side: a multiple of every instruction set's lanes.
inline constexpr std::size_t kProgramLanes = 16;

struct Programs {
  std::size_t robots = 0, groups = 0, rows = 0;  // in use
  std::vector<ProgramGroup<kProgramLanes>> group;
  std::vector<ProgramRow<kProgramLanes>> row;

  void clear() { robots = groups = rows = 0; }

  /// The group of the next robot; its lane is robots % kProgramLanes before the call.
  ProgramGroup<kProgramLanes>& add_robot();
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

  [[nodiscard]] const ProgramGroup<kProgramLanes>& group(std::size_t robot) const {
    return programs_.group[robot / kProgramLanes];
  }
  static bool bit(std::uint32_t bits, std::size_t robot) {
    return (bits >> robot % kProgramLanes & 1U) != 0;
  }

  Programs programs_;
  std::vector<Vec2> preferred_;      // as given
  Programs infeasible_;              // those that failed, side by side
  std::vector<std::size_t> robots_;  // whose these are
  std::vector<ProgramRow<kProgramLanes>> scratch_;
};

/// Solves all programs of the batch: nearest_point() of lp/linear_program.h, and what it says in
/// state optimal or least_unsafe, bit for bit, by every instruction set.
void nearest_points(ProgramBatch& batch);

}  // namespace avo::inline lp
