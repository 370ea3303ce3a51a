// SPDX-License-Identifier: Apache-2.0
// Programs in lanes, for every instruction set; the best one is chosen at run time.
#include "lp/programs.h"

#include <algorithm>
#include <bit>

namespace avo::inline lp {
struct ProgramKernels {
  void (*solve)(Programs&, ProgramRow<kProgramLanes>*, bool);
};
}  // namespace avo::inline lp

#define AVO_KERNEL_HEADER "lp/program_kernel.h"
#define AVO_KERNEL_STRUCT ProgramKernels
#define AVO_KERNEL_FUNCTIONS planar::solve_programs<Pack<double>>
#include "core/kernel_passes.h"

namespace avo::inline lp {
namespace {

using Group = ProgramGroup<kProgramLanes>;
using Row = ProgramRow<kProgramLanes>;

std::size_t most_rows(const Programs& programs) {
  std::size_t most = 0;
  for (std::size_t g = 0; g < programs.groups; ++g) most = std::max(most, programs.group[g].count);
  return most;
}

// The number of half-planes of a robot cannot be predicted. A mispredicted branch costs more than
// writing a few unused rows.
constexpr std::size_t kRowsAtOnce = 4;

// Copies one robot's program to the end of others.
void copy(const Programs& from, std::size_t robot, Programs& to) {
  const Group& source = from.group[robot / kProgramLanes];
  const std::size_t lane = robot % kProgramLanes;
  const std::size_t new_lane = to.robots % kProgramLanes;
  Group& target = to.add_robot();
  for (auto column : {&Group::c_x, &Group::c_y, &Group::radius, &Group::top_speed, &Group::p_x,
                      &Group::p_y, &Group::planes}) {
    (target.*column)[new_lane] = (source.*column)[lane];
  }
  const auto planes = static_cast<std::size_t>(source.planes[lane]);
  to.add_rows(planes);
  for (std::size_t i = 0; i < planes; ++i) {
    const Row& row = from.row[source.first + i];
    Row& copied = to.row[target.first + i];
    copied.n_x[new_lane] = row.n_x[lane];
    copied.n_y[new_lane] = row.n_y[lane];
    copied.offset[new_lane] = row.offset[lane];
  }
}

}  // namespace

ProgramGroup<kProgramLanes>& Programs::add_robot() {
  if (robots++ % kProgramLanes == 0) {
    if (groups == group.size()) group.emplace_back();
    Group& next = group[groups++];
    std::fill_n(next.planes, kProgramLanes, 0.0);
    next.first = rows;
    next.count = 0;
  }
  return group[groups - 1];
}

void Programs::add_rows(std::size_t count) {
  Group& last = group[groups - 1];
  last.count = std::max(last.count, count);
  rows = last.first + last.count;
  if (row.size() < rows + kRowsAtOnce) row.resize(rows + kRowsAtOnce);
}

void ProgramBatch::clear() {
  programs_.clear();
  preferred_.clear();
}

void ProgramBatch::reserve(std::size_t robots, std::size_t planes_each, std::size_t planes) {
  const std::size_t groups = robots / kProgramLanes + 1;
  for (Programs* programs : {&programs_, &infeasible_}) {
    programs->group.reserve(groups);
    programs->row.reserve(std::min(groups * planes_each, planes) + kRowsAtOnce);
  }
  preferred_.reserve(robots);
  robots_.reserve(robots);
  scratch_.reserve(3 * most_taken(planes_each));
}

void ProgramBatch::add(const Disc& acceleration, double top_speed, Vec2 preferred,
                       std::span<const HalfPlane> planes) {
  const std::size_t lane = programs_.robots % kProgramLanes;
  Group& group = programs_.add_robot();
  group.c_x[lane] = acceleration.center.x;
  group.c_y[lane] = acceleration.center.y;
  group.radius[lane] = acceleration.radius;
  group.top_speed[lane] = top_speed;
  group.p_x[lane] = preferred.x;
  group.p_y[lane] = preferred.y;
  group.planes[lane] = static_cast<double>(planes.size());
  preferred_.push_back(preferred);
  programs_.add_rows(planes.size());
  Row* const rows = programs_.row.data() + group.first;
  for (std::size_t first = 0; first < planes.size(); first += kRowsAtOnce) {
    for (std::size_t i = first; i < first + kRowsAtOnce; ++i) {
      const HalfPlane& plane = planes[std::min(i, planes.size() - 1)];
      rows[i].n_x[lane] = plane.normal.x;
      rows[i].n_y[lane] = plane.normal.y;
      rows[i].offset[lane] = plane.offset;
    }
  }
}

// Programs that half-planes leave no solution take far more time: gathered, they fill lanes of
// their own, unless they nearly do already.
void nearest_points(ProgramBatch& batch) {
  Programs& all = batch.programs_;
  Programs& infeasible = batch.infeasible_;
  std::vector<std::size_t>& robots = batch.robots_;
  std::vector<Row>& scratch = batch.scratch_;
  scratch.resize(std::max(scratch.size(), 3 * most_taken(most_rows(all))));
  kKernels->solve(all, scratch.data(), false);
  infeasible.clear();
  robots.clear();
  for (std::size_t g = 0; g < all.groups; ++g) {
    for (std::uint32_t left = all.group[g].failed; left != 0; left &= left - 1) {
      robots.push_back(g * kProgramLanes + static_cast<std::size_t>(std::countr_zero(left)));
      copy(all, robots.back(), infeasible);
    }
  }
  kKernels->solve(infeasible, scratch.data(), true);
  for (std::size_t k = 0; k < robots.size(); ++k) {
    const std::size_t from_lane = k % kProgramLanes, lane = robots[k] % kProgramLanes;
    const Group& from = infeasible.group[k / kProgramLanes];
    Group& to = all.group[robots[k] / kProgramLanes];
    to.x[lane] = from.x[from_lane];
    to.y[lane] = from.y[from_lane];
    to.violation[lane] = from.violation[from_lane];
    to.settled |= 1U << lane;
  }
}

}  // namespace avo::inline lp
