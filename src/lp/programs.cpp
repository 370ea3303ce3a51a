// SPDX-License-Identifier: Apache-2.0
// Programs in lanes, for every instruction set: this file is compiled once for each by
// hwy/foreach_target.h, and the fittest is chosen at run time.
#include "lp/programs.h"

#include <algorithm>

#include "core/simd_target.h"
#include "lp/kernels.h"

#ifdef AVO_HIGHWAY
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "lp/programs.cpp"
// clang-format off
#include <hwy/foreach_target.h>  // first: it sets the instruction set of what follows
#include "core/lanes.h"
// clang-format on

HWY_BEFORE_NAMESPACE();
namespace avo::HWY_NAMESPACE {
namespace planar {
#include "lp/program_kernels.h"
}  // namespace planar

void solve_feasible_double(Programs<double>& programs, ProgramRow<double>* scratch) {
  planar::solve_programs<false, Pack<double>>(programs, scratch);
}
void solve_feasible_single(Programs<float>& programs, ProgramRow<float>* scratch) {
  planar::solve_programs<false, Pack<float>>(programs, scratch);
}
void solve_infeasible_double(Programs<double>& programs, ProgramRow<double>* scratch) {
  planar::solve_programs<true, Pack<double>>(programs, scratch);
}
void solve_infeasible_single(Programs<float>& programs, ProgramRow<float>* scratch) {
  planar::solve_programs<true, Pack<float>>(programs, scratch);
}
}  // namespace avo::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif

#if !defined(AVO_HIGHWAY) || HWY_ONCE
namespace avo {
namespace {

#ifdef AVO_HIGHWAY
HWY_EXPORT(solve_feasible_double);
HWY_EXPORT(solve_feasible_single);
HWY_EXPORT(solve_infeasible_double);
HWY_EXPORT(solve_infeasible_single);
#endif

void solve_feasible(Programs<double>& programs, ProgramRow<double>* scratch) {
#ifdef AVO_HIGHWAY
  if (!simd_is_scalar()) return HWY_DYNAMIC_DISPATCH(solve_feasible_double)(programs, scratch);
#endif
  scalar::planar::solve_programs<false, scalar::Pack<double>>(programs, scratch);
}
void solve_feasible(Programs<float>& programs, ProgramRow<float>* scratch) {
#ifdef AVO_HIGHWAY
  if (!simd_is_scalar()) return HWY_DYNAMIC_DISPATCH(solve_feasible_single)(programs, scratch);
#endif
  scalar::planar::solve_programs<false, scalar::Pack<float>>(programs, scratch);
}
void solve_infeasible(Programs<double>& programs, ProgramRow<double>* scratch) {
#ifdef AVO_HIGHWAY
  if (!simd_is_scalar()) return HWY_DYNAMIC_DISPATCH(solve_infeasible_double)(programs, scratch);
#endif
  scalar::planar::solve_programs<true, scalar::Pack<double>>(programs, scratch);
}
void solve_infeasible(Programs<float>& programs, ProgramRow<float>* scratch) {
#ifdef AVO_HIGHWAY
  if (!simd_is_scalar()) return HWY_DYNAMIC_DISPATCH(solve_infeasible_single)(programs, scratch);
#endif
  scalar::planar::solve_programs<true, scalar::Pack<float>>(programs, scratch);
}

template <typename Number>
std::size_t most_rows(const Programs<Number>& programs) {
  std::size_t most = 0;
  for (const ProgramGroup<Number>& group : programs.groups) most = std::max(most, group.count);
  return most;
}

// Copies one robot's program to the end of others.
template <typename Number>
void copy(const Programs<Number>& from, std::size_t robot, Programs<Number>& to) {
  const ProgramGroup<Number>& source = from.groups[robot / kProgramLanes];
  const std::size_t lane = robot % kProgramLanes;
  const std::size_t new_lane = to.count % kProgramLanes;
  ProgramGroup<Number>& target = to.add();
  for (auto column :
       {&ProgramGroup<Number>::c_x, &ProgramGroup<Number>::c_y, &ProgramGroup<Number>::radius,
        &ProgramGroup<Number>::top_speed, &ProgramGroup<Number>::p_x, &ProgramGroup<Number>::p_y}) {
    (target.*column)[new_lane] = (source.*column)[lane];
  }
  if (target.count < source.count) {
    target.count = source.count;
    to.rows.resize(target.first + target.count);
  }
  for (std::size_t i = 0; i < source.count; ++i) {
    const ProgramRow<Number>& row = from.rows[source.first + i];
    ProgramRow<Number>& copied = to.rows[target.first + i];
    copied.n_x[new_lane] = row.n_x[lane];
    copied.n_y[new_lane] = row.n_y[lane];
    copied.offset[new_lane] = row.offset[lane];
  }
}

}  // namespace

template <typename Number>
void Programs<Number>::clear() {
  count = 0;
  groups.clear();
  rows.clear();
}

template <typename Number>
ProgramGroup<Number>& Programs<Number>::add() {
  if (count++ % kProgramLanes == 0) {
    groups.emplace_back();
    groups.back().first = rows.size();
  }
  return groups.back();
}

template <typename Number>
void ProgramBatch<Number>::clear() {
  programs_.clear();
  preferred_.clear();
}

template <typename Number>
void ProgramBatch<Number>::add(const Disc& acceleration, double top_speed, Vec2 preferred) {
  const std::size_t lane = programs_.count % kProgramLanes;
  ProgramGroup<Number>& group = programs_.add();
  planes_ = 0;
  group.c_x[lane] = static_cast<Number>(acceleration.center.x);
  group.c_y[lane] = static_cast<Number>(acceleration.center.y);
  group.radius[lane] = static_cast<Number>(acceleration.radius);
  group.top_speed[lane] = static_cast<Number>(top_speed);
  group.p_x[lane] = static_cast<Number>(preferred.x);
  group.p_y[lane] = static_cast<Number>(preferred.y);
  preferred_.push_back(preferred);
}

// Those that half-planes leave nothing to need far more time: gathered, they fill lanes of their
// own.
template <typename Number>
void ProgramBatch<Number>::solve() noexcept {
  scratch_.resize(std::max(scratch_.size(), 3 * most_taken(most_rows(programs_))));
  solve_feasible(programs_, scratch_.data());
  infeasible_.clear();
  robots_.clear();
  for (std::size_t robot = 0; robot < size(); ++robot) {
    if (!bit(group(robot).failed, robot)) continue;
    copy(programs_, robot, infeasible_);
    robots_.push_back(robot);
  }
  solve_infeasible(infeasible_, scratch_.data());
  for (std::size_t k = 0; k < robots_.size(); ++k) {
    const std::size_t robot = robots_[k], lane = robot % kProgramLanes;
    const ProgramGroup<Number>& from = infeasible_.groups[k / kProgramLanes];
    ProgramGroup<Number>& to = programs_.groups[robot / kProgramLanes];
    to.x[lane] = from.x[k % kProgramLanes];
    to.y[lane] = from.y[k % kProgramLanes];
    to.violation[lane] = from.violation[k % kProgramLanes];
    to.settled |= 1U << lane;
  }
}

template struct Programs<double>;
template struct Programs<float>;
template class ProgramBatch<double>;
template class ProgramBatch<float>;

}  // namespace avo
#endif
