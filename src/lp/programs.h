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

/// Number of robots with program numbers side by side: a multiple of every instruction set's lanes.
inline constexpr std::size_t kProgramLanes = 16;

struct Programs {
  std::size_t robots = 0, groups = 0, rows = 0;  // in use
  std::vector<ProgramGroup<kProgramLanes>> group;
  std::vector<ProgramRow<kProgramLanes>> row;

  void clear() { robots = groups = rows = 0; }

  /// The group of the next robot; its lane is robots % kProgramLanes before the call.
  ProgramGroup<kProgramLanes>& add_robot();
  /// Reserves so many rows in the last group.
  void add_rows(std::size_t count);
};

/// Programs that are solved together, filled robot by robot; allocates only while it grows.
class ProgramBatch {
 public:
  void clear();
  /// Reserves room for so many robots with at most so many half-planes each, and in all.
  void reserve(std::size_t robots, std::size_t planes_each, std::size_t planes);

  /// Adds the next robot. The only requirement on the numbers is |normal| = 1.
  void add(const Disc& acceleration, double top_speed, Vec2 preferred,
           std::span<const HalfPlane> planes);

  [[nodiscard]] std::size_t size() const { return programs_.robots; }

  /// False: the program is not ordinary, and is left to nearest_point(); its results are
  /// meaningless.
  [[nodiscard]] bool settled(std::size_t robot) const { return bit(group(robot).settled, robot); }
  /// The preferred point, bit for bit, if it violates nothing.
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
  Programs infeasible_;              // the failed ones, side by side
  std::vector<std::size_t> robots_;  // the robots of these programs
  std::vector<ProgramRow<kProgramLanes>> scratch_;
};

/// Solves all programs of the batch: the results equal nearest_point() of lp/linear_program.h in
/// state optimal or least_unsafe, bit for bit, for every instruction set.
void nearest_points(ProgramBatch& batch);

}  // namespace avo::inline lp
