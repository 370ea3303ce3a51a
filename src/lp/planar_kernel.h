// SPDX-License-Identifier: Apache-2.0
// solve_planar() of lp/planar_program.h, one robot per lane, by the same operations in the same
// order: all lanes look at the same half-plane, and those that it concerns move. Included after
// lens_kernel.h, once per instruction set.

template <typename Real>
using Row = typename ProgramBatch<typename Real::Number>::Row;

template <typename Real>
struct Plane {
  Vec<Real> normal;
  Real offset;
};

template <typename Real>
AVO_KERNEL Plane<Real> plane_at(const Row<Real>& row, std::size_t lane) {
  return {{Real::load(row.n_x + lane), Real::load(row.n_y + lane)}, Real::load(row.offset + lane)};
}

template <typename Real>
struct Line {
  Vec<Real> normal, along;
  Real offset;
};

/// What is left of a line, lo <= t <= hi.
template <typename Real>
struct Range {
  Real lo, hi;
  Mask<Real> left;
};

template <typename Real>
AVO_KERNEL Range<Real> clip_to_discs(const Lens<Real>& lens, const Line<Real>& line) {
  const Real zero = 0.0;
  const Real gap = lens.radius - abs(line.offset);
  const Real half = select(gap > zero, sqrt(gap * (lens.radius + abs(line.offset))), zero);
  Range<Real> range{-half, half, !(gap < zero)};
  if (!any(lens.two_arcs)) return range;
  const Real offset = abs(line.offset - dot(line.normal, lens.larger_center));
  const Real larger_gap = lens.larger_radius - offset;
  const Real larger_half =
      select(larger_gap > zero, sqrt(larger_gap * (lens.larger_radius + offset)), zero);
  const Real middle = dot(line.along, lens.larger_center);
  const Real lo = middle - larger_half, hi = middle + larger_half;
  range.lo = select(lens.two_arcs & (lo > range.lo), lo, range.lo);
  range.hi = select(lens.two_arcs & (hi < range.hi), hi, range.hi);
  range.left = range.left & !(lens.two_arcs & (larger_gap < zero));
  return range;
}

template <typename Real>
AVO_KERNEL void clip_to_plane(const Lens<Real>& lens, const Line<Real>& line,
                              const Plane<Real>& plane, Range<Real>& range) {
  const Real zero = 0.0;
  const Real slope = dot(plane.normal, line.along);
  const Real excess = plane.offset - line.offset * dot(plane.normal, line.normal);
  const Mask<Real> steep = abs(slope) * lens.radius > lens.tolerance;
  const Real t = excess / slope;
  range.lo = select(steep & (slope > zero) & (t > range.lo), t, range.lo);
  range.hi = select(steep & (slope < zero) & (t < range.hi), t, range.hi);
  range.left = range.left & (steep | (excess <= lens.tolerance));
}

/// The best point of the plane's boundary within the discs and all planes before it.
template <typename Real>
AVO_KERNEL Mask<Real> move_to_boundary(const Lens<Real>& lens, const Row<Real>* rows,
                                       std::size_t before, std::size_t lane,
                                       const Plane<Real>& plane, Vec<Real> preferred,
                                       Vec<Real>& point) {
  const Real length = norm(plane.normal);
  const Vec<Real> normal = plane.normal / length;
  const Line<Real> line{normal, perpendicular(normal), plane.offset / length};
  Range<Real> range = clip_to_discs(lens, line);
  for (std::size_t j = 0; j < before; ++j) {
    clip_to_plane(lens, line, plane_at<Real>(rows[j], lane), range);
  }
  Real t = dot(preferred, line.along);
  t = select(t <= range.lo, range.lo, t);
  t = select(t >= range.hi, range.hi, t);
  point = line.offset * line.normal + t * line.along;
  return (length > Real(0.0)) & range.left & (range.lo <= range.hi);
}

template <typename Real>
AVO_KERNEL void solve_lanes(ProgramBatch<typename Real::Number>& batch, std::size_t g,
                            std::size_t lane) {
  auto& group = batch.groups[g];
  auto* rows = batch.rows.data() + group.first;
  const Discs<Real> discs{{Real::load(group.c_x + lane), Real::load(group.c_y + lane)},
                          Real::load(group.radius + lane),
                          Real::load(group.top_speed + lane)};
  const Lens<Real> lens = make_lens(discs);
  const Vec<Real> wish{Real::load(group.p_x + lane), Real::load(group.p_y + lane)};
  const Vec<Real> target = wish - lens.origin;
  const LensPoint<Real> start = nearest(lens, target);
  const Real largest = kLargest<typename Real::Number>;
  Mask<Real> active = lens.ordinary & (abs(wish.x) <= largest) & (abs(wish.y) <= largest);
  Mask<Real> moved = start.moved;
  Vec<Real> point = start.point;
  for (std::size_t i = 0; i < group.count; ++i) {
    Plane<Real> plane = plane_at<Real>(rows[i], lane);
    plane.offset = plane.offset - dot(plane.normal, lens.origin);
    plane.offset.store(rows[i].offset + lane);
    const Real violation = plane.offset - dot(plane.normal, point);
    const Mask<Real> moves = active & (violation > lens.tolerance);
    if (!any(moves)) continue;
    Vec<Real> next;
    const Mask<Real> found = move_to_boundary(lens, rows, i, lane, plane, target, next);
    point = select(moves, next, point);
    active = active & !(moves & !found);
    moved = moved | moves;
  }
  point = absolute_point(lens, discs, point);
  point.x.store(group.x + lane);
  point.y.store(group.y + lane);
  group.settled |= bits(active) << lane;
  group.moved |= bits(moved) << lane;
}

template <typename Real>
void solve_programs(ProgramBatch<typename Real::Number>& batch) {
  constexpr std::size_t kGroup = ProgramBatch<typename Real::Number>::kLanes;
  for (std::size_t g = 0; g < batch.groups.size(); ++g) {
    batch.groups[g].settled = batch.groups[g].moved = 0;
    for (std::size_t lane = 0; lane < kGroup; lane += Real::kLanes) {
      solve_lanes<Real>(batch, g, lane);
    }
  }
}
