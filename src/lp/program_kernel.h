// SPDX-License-Identifier: Apache-2.0
// Eqs. (22), (23), one robot per lane: nearest_point() is the scalar instance.
#ifndef AVO_LP_PROGRAM_KERNEL_H
#define AVO_LP_PROGRAM_KERNEL_H

#include <bit>
#include <cstddef>

#include "lp/planar_kernel.h"
#include "lp/programs.h"

AVO_BEGIN_KERNELS
namespace planar {

/// CA_A of Eq. (22) is empty, the 3-D program: the smallest s such that some point of the lens
/// violates no plane by more than s. It is incremental as well: of the planes violated by more than
/// s, the one violated most is taken next. It is then the worst of the taken planes. The new point
/// lies farthest along its normal among the points that violate none of them more than this one.
/// Where plane a is violated no more than plane b, (n_a - n_b) . u >= o_a - o_b: its violations are
/// differences of theirs, so it is not normalized. The distance to `preferred` settles ties in each
/// program, hence in the whole. It applies to the lanes in which `next` cannot be added.
template <typename Real, typename Row>
AVO_KERNEL void least_unsafe(const LensOf<Real>& lens, const Planes<Real, Row>& give,
                             Plane<Real> next, Vec<Real> preferred, Mask<Real> active,
                             Planes<Real, Row>& taken, Row* scratch, Vec<Real>& point) {
  while (any(active)) {
    Planes<Real, Row> projected{scratch, give.first, 0};
    for (std::size_t j = 0; j < taken.count; ++j) {
      const Plane<Real> before = taken[j];
      projected.add({before.normal - next.normal, before.offset - next.offset});
    }
    Planes<Real, Row> inner{scratch + most_taken(give.count), give.first, 0};
    Vec<Real> candidate = farthest_along(lens, next.normal);
    const Outcome<Real> outcome =
        solve_planar<true>(lens, projected, {preferred, next.normal}, active, inner, candidate);
    point = select(active & !outcome.failed, candidate, point);
    taken.add(next);
    const Real least = violation(next, point) + lens.tolerance;
    Real by = least;
    next = most_violated(give, point, by);
    active = active & (by > least);
    if (any(active)) active = active & !contains(taken, next);
  }
}

template <typename Real, typename Row>
AVO_KERNEL Real largest_violation(const Planes<Real, Row>& planes, Vec<Real> u) {
  Real largest = 0.0;
  for (std::size_t i = 0; i < planes.count; ++i) largest = max(violation(planes[i], u), largest);
  return largest;
}

/// How far the returned point lies outside the half-planes as given.
template <typename Real, typename Row>
AVO_KERNEL Real reported_violation(const LensOf<Real>& lens, const Planes<Real, Row>& planes,
                                   Vec<Real> relative, Vec<Real> point) {
  const Real zero = 0.0;
  const Real worst = largest_violation(planes, relative);
  Real largest = zero;
  for (std::size_t i = 0; i < planes.count; ++i) {
    const Plane<Real> plane = planes[i];
    const Real offset = Real::load(planes.rows[i].offset + planes.first);
    const Mask<Real> counts = plane.offset > none<Real>();
    largest = select(counts, max(violation({plane.normal, offset}, point), largest), largest);
  }
  return select(worst > lens.tolerance, select(largest > zero, largest, worst), zero);
}

/// Solves the programs of one pack. If at least `enough` have no solution, it also finds their
/// least unsafe points; otherwise they are marked as failed.
template <typename Real, typename Group, typename Row>
AVO_KERNEL void solve_pack(Group& group, Row* rows, Row* scratch, std::size_t first, int enough) {
  const LimitDiscs<Real> discs{{Real::load(group.c_x + first), Real::load(group.c_y + first)},
                               Real::load(group.radius + first),
                               Real::load(group.top_speed + first)};
  const Vec<Real> wish{Real::load(group.p_x + first), Real::load(group.p_y + first)};
  const LensOf<Real> lens = make_lens(discs);
  const Planes<Real, Row> planes{rows, first, group.count};
  const Real count = Real::load(group.planes + first);
  for (std::size_t i = 0; i < planes.count; ++i) {
    const Real offset = Real::load(rows[i].offset + first) - dot(planes[i].normal, lens.origin);
    select(Real(static_cast<double>(i)) < count, offset, none<Real>())
        .store(rows[i].relative + first);
  }
  const Mask<Real> ordinary = lens.ordinary & is_within(wish, kFarthest);
  const Goal<Real> goal{wish - lens.origin, {0.0, 0.0}};
  const LensPoint<Real> start = nearest(lens, goal.preferred);
  Vec<Real> u = start.point;
  Planes<Real, Row> taken{scratch, first, 0};
  const Outcome<Real> outcome = solve_planar<false>(lens, planes, goal, ordinary, taken, u);
  std::uint32_t failed = bits(outcome.failed);
  const bool to_the_end = std::popcount(failed) >= enough;
  if (to_the_end) {
    least_unsafe(lens, planes, outcome.next, goal.preferred, outcome.failed, taken,
                 scratch + most_taken(group.count), u);
  }
  const Vec<Real> point = absolute_point(lens, discs, u);
  point.x.store(group.x + first);
  point.y.store(group.y + first);
  Real worst = 0.0;
  if (to_the_end) {
    worst = select(outcome.failed, reported_violation(lens, planes, u, point), worst);
    failed = 0;
  }
  worst.store(group.violation + first);
  group.settled |= (bits(ordinary) & ~failed) << first;
  group.failed |= failed << first;
  group.moved |= bits(start.moved | outcome.moved | outcome.failed) << first;
}

/// Unless all must be solved, a few in a pack without a solution are left unsolved.
template <typename Real>
void solve_programs(Programs& programs, ProgramRow<kProgramLanes>* scratch, bool all) {
  const int enough = all ? 1 : static_cast<int>(Real::kLanes * 3 / 4 + 1);
  for (std::size_t g = 0; g < programs.groups; ++g) {
    ProgramGroup<kProgramLanes>& group = programs.group[g];
    group.settled = group.failed = group.moved = 0;
    ProgramRow<kProgramLanes>* const rows = programs.row.data() + group.first;
    for (std::size_t lane = 0; lane < kProgramLanes; lane += Real::kLanes) {
      solve_pack<Real>(group, rows, scratch, lane, enough);
    }
  }
}

}  // namespace planar
AVO_END_KERNELS

#endif  // once per pass
