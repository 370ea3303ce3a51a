// SPDX-License-Identifier: Apache-2.0
// Programs in lanes, for every instruction set: this file is compiled once for each by
// hwy/foreach_target.h, and the fittest is chosen at run time.
#include "lp/programs.h"

#include <algorithm>
#include <bit>

#include "core/kernel_table.h"
#include "lp/kernels.h"

#ifdef AVO_HIGHWAY
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "lp/programs.cpp"
#include <hwy/foreach_target.h>
#if HWY_TARGET & AVO_TARGETS
#include "core/lanes.h"

HWY_BEFORE_NAMESPACE();
namespace avo::HWY_NAMESPACE {
namespace planar {
#include "lp/program_kernels.h"
}  // namespace planar

constexpr ProgramKernels kKernels{planar::solve_programs<Pack<double>>,
                                  planar::solve_programs<Pack<float>>};
}  // namespace avo::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
#endif

#if !defined(AVO_HIGHWAY) || HWY_ONCE
namespace avo {
namespace scalar {
constexpr ProgramKernels kKernels{planar::solve_programs<Pack<double>>,
                                  planar::solve_programs<Pack<float>>};
}  // namespace scalar
namespace {

constexpr KernelTable<ProgramKernels> kKernels = AVO_KERNEL_TABLE(kKernels);

void solve(Programs<double>& programs, ProgramRow<double>* scratch, bool all) {
  kKernels->solve_double(programs, scratch, all);
}
void solve(Programs<float>& programs, ProgramRow<float>* scratch, bool all) {
  kKernels->solve_single(programs, scratch, all);
}

template <typename Number>
std::size_t most_rows(const Programs<Number>& programs) {
  std::size_t most = 0;
  for (std::size_t g = 0; g < programs.groups; ++g) most = std::max(most, programs.group[g].count);
  return most;
}

// How many half-planes a robot has cannot be foreseen, and a processor that guesses wrong loses
// more than what writing a few for nothing costs.
constexpr std::size_t kRowsAtOnce = 4;

// Copies one robot's program to the end of others.
template <typename Number>
void copy(const Programs<Number>& from, std::size_t robot, Programs<Number>& to) {
  const ProgramGroup<Number>& source = from.group[robot / kProgramLanes];
  const std::size_t lane = robot % kProgramLanes;
  const std::size_t new_lane = to.robots % kProgramLanes;
  ProgramGroup<Number>& target = to.add_robot();
  for (auto column :
       {&ProgramGroup<Number>::c_x, &ProgramGroup<Number>::c_y, &ProgramGroup<Number>::radius,
        &ProgramGroup<Number>::top_speed, &ProgramGroup<Number>::p_x, &ProgramGroup<Number>::p_y,
        &ProgramGroup<Number>::planes}) {
    (target.*column)[new_lane] = (source.*column)[lane];
  }
  const auto planes = static_cast<std::size_t>(source.planes[lane]);
  to.add_rows(planes);
  for (std::size_t i = 0; i < planes; ++i) {
    const ProgramRow<Number>& row = from.row[source.first + i];
    ProgramRow<Number>& copied = to.row[target.first + i];
    copied.n_x[new_lane] = row.n_x[lane];
    copied.n_y[new_lane] = row.n_y[lane];
    copied.offset[new_lane] = row.offset[lane];
  }
}

}  // namespace

template <typename Number>
ProgramGroup<Number>& Programs<Number>::add_robot() {
  if (robots++ % kProgramLanes == 0) {
    if (groups == group.size()) group.emplace_back();
    ProgramGroup<Number>& next = group[groups++];
    std::fill_n(next.planes, kProgramLanes, Number());
    next.first = rows;
    next.count = 0;
  }
  return group[groups - 1];
}

template <typename Number>
void Programs<Number>::add_rows(std::size_t count) {
  ProgramGroup<Number>& last = group[groups - 1];
  last.count = std::max(last.count, count);
  rows = last.first + last.count;
  if (row.size() < rows + kRowsAtOnce) row.resize(rows + kRowsAtOnce);
}

template <typename Number>
void ProgramBatch<Number>::clear() {
  programs_.clear();
  preferred_.clear();
}

template <typename Number>
void ProgramBatch<Number>::reserve(std::size_t robots, std::size_t planes_each,
                                   std::size_t planes) {
  const std::size_t groups = robots / kProgramLanes + 1;
  for (Programs<Number>* programs : {&programs_, &infeasible_}) {
    programs->group.reserve(groups);
    programs->row.reserve(std::min(groups * planes_each, planes) + kRowsAtOnce);
  }
  preferred_.reserve(robots);
  robots_.reserve(robots);
  scratch_.reserve(3 * most_taken(planes_each));
}

template <typename Number>
void ProgramBatch<Number>::add(const Disc& acceleration, double top_speed, Vec2 preferred,
                               std::span<const HalfPlane> planes) {
  const std::size_t lane = programs_.robots % kProgramLanes;
  ProgramGroup<Number>& group = programs_.add_robot();
  group.c_x[lane] = static_cast<Number>(acceleration.center.x);
  group.c_y[lane] = static_cast<Number>(acceleration.center.y);
  group.radius[lane] = static_cast<Number>(acceleration.radius);
  group.top_speed[lane] = static_cast<Number>(top_speed);
  group.p_x[lane] = static_cast<Number>(preferred.x);
  group.p_y[lane] = static_cast<Number>(preferred.y);
  group.planes[lane] = static_cast<Number>(planes.size());
  preferred_.push_back(preferred);
  programs_.add_rows(planes.size());
  ProgramRow<Number>* const rows = programs_.row.data() + group.first;
  for (std::size_t first = 0; first < planes.size(); first += kRowsAtOnce) {
    for (std::size_t i = first; i < first + kRowsAtOnce; ++i) {
      const HalfPlane& plane = planes[std::min(i, planes.size() - 1)];
      rows[i].n_x[lane] = static_cast<Number>(plane.normal.x);
      rows[i].n_y[lane] = static_cast<Number>(plane.normal.y);
      rows[i].offset[lane] = static_cast<Number>(plane.offset);
    }
  }
}

// Those that half-planes leave nothing to need far more time: gathered, they fill lanes of their
// own, unless they nearly do already.
template <typename Number>
void nearest_points(ProgramBatch<Number>& batch) {
  Programs<Number>& all = batch.programs_;
  Programs<Number>& infeasible = batch.infeasible_;
  std::vector<std::size_t>& robots = batch.robots_;
  std::vector<ProgramRow<Number>>& scratch = batch.scratch_;
  scratch.resize(std::max(scratch.size(), 3 * most_taken(most_rows(all))));
  solve(all, scratch.data(), false);
  infeasible.clear();
  robots.clear();
  for (std::size_t g = 0; g < all.groups; ++g) {
    for (std::uint32_t left = all.group[g].failed; left != 0; left &= left - 1) {
      robots.push_back(g * kProgramLanes + static_cast<std::size_t>(std::countr_zero(left)));
      copy(all, robots.back(), infeasible);
    }
  }
  solve(infeasible, scratch.data(), true);
  for (std::size_t k = 0; k < robots.size(); ++k) {
    const std::size_t from_lane = k % kProgramLanes, lane = robots[k] % kProgramLanes;
    const ProgramGroup<Number>& from = infeasible.group[k / kProgramLanes];
    ProgramGroup<Number>& to = all.group[robots[k] / kProgramLanes];
    to.x[lane] = from.x[from_lane];
    to.y[lane] = from.y[from_lane];
    to.violation[lane] = from.violation[from_lane];
    to.settled |= 1U << lane;
  }
}

template struct Programs<double>;
template struct Programs<float>;
template class ProgramBatch<double>;
template class ProgramBatch<float>;
template void nearest_points(ProgramBatch<double>&);
template void nearest_points(ProgramBatch<float>&);

}  // namespace avo
#endif
