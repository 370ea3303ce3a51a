// SPDX-License-Identifier: Apache-2.0
// Many pairs: simple cases are decided at once. The other pairs wait in a queue for their case, so
// that all lanes work on the same case. docs/half_plane.md, "The order of the cases".
#ifndef AVO_OBSTACLES_HALF_PLANES_KERNEL_H
#define AVO_OBSTACLES_HALF_PLANES_KERNEL_H

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <limits>

#include "obstacles/contact_kernel.h"
#include "obstacles/half_planes.h"
#include "obstacles/horn_hull_kernel.h"

AVO_BEGIN_KERNELS

/// A pair's own frame (see Local), and what is known without further computation.
template <typename Real>
struct LocalFrame {
  using Mask = decltype(Real() < Real());
  Local<Real> local;
  Vec<Real> e;  // first axis, p/|p|
  Real side;    // the side of p on which v is counted: 1 left, -1 right
  Mask in_contact, too_far, on_collision_course;

  AVO_KERNEL Vec<Real> turned_back(Vec<Real> n) const {
    const Real y = side * n.y;
    return {n.x * e.x - y * e.y, n.x * e.y + y * e.x};
  }
};

// Parallel vectors are a tie, which goes to the left of p: A passes B on its own right. A tie must
// survive rounding, or robots on a circle would each choose a side at random.
template <typename Real>
AVO_KERNEL LocalFrame<Real> frame_of(Vec<Real> p, Vec<Real> v, Real r, Real R,
                                     const ResponseAt& end) {
  const Real d = norm(p), per_d = inverse(d), v2 = dot(v, v);
  const Real across = (p.x * v.y - p.y * v.x) * per_d;
  const Real across2 = across * abs(across);
  LocalFrame<Real> frame;
  frame.side = select(across2 < Real(-kTie * kTie) * v2, Real(-1.0), Real(1.0));
  frame.e = per_d * p;
  frame.local = {d, {dot(p, v) * per_d, frame.side * across}, r, R};
  frame.in_contact = (d < r) | !(d > Real(0.0));
  // too far to touch before τ for any motion of both: |p + t v| > r + R g(t) on the whole window
  const Real gap = d - r - R * Real(end.gain), sine = r * per_d;
  frame.too_far = gap * abs(gap) > v2 * Real(end.time * end.time);
  frame.on_collision_course = (frame.local.v.x < Real(0.0)) & (abs(across2) < sine * sine * v2);
  return frame;
}

template <typename Real>
AVO_KERNEL LocalFrame<Real> frame_at(const PairColumns& pairs, std::size_t i,
                                     const ResponseAt& end) {
  const auto of = [i](const std::vector<double>& column) { return Real::load(&column[i]); };
  return frame_of<Real>({of(pairs.p_x), of(pairs.p_y)}, {of(pairs.v_x), of(pairs.v_y)},
                        of(pairs.radius), of(pairs.reach), end);
}

/// The frames of the pairs with the numbers of a pack of the queue.
template <typename Real>
AVO_KERNEL LocalFrame<Real> queued(const PairColumns& pairs, const HalfPlaneQueue& queue,
                                   std::size_t i, const ResponseAt& end) {
  const Real index = Real::load(&queue.index[i]);
  const auto of = [index](const std::vector<double>& column) {
    return lookup(column.data(), index);
  };
  return frame_of<Real>({of(pairs.p_x), of(pairs.p_y)}, {of(pairs.v_x), of(pairs.v_y)},
                        of(pairs.radius), of(pairs.reach), end);
}

/// Appends the chosen lanes of a pack to the queue, as many as are pairs. The pack may have been
/// read from the same queue: whole packs are written, and never past the old end of it.
template <typename Real>
AVO_KERNEL void push(HalfPlaneQueue& queue, Real index, typename LocalFrame<Real>::Mask chosen,
                     std::uint32_t pairs) {
  store_chosen(chosen, index, &queue.index[queue.count]);
  queue.count += static_cast<std::size_t>(std::popcount(pairs));
}

/// Repeats the last entry, as far as the last pack reads.
template <typename Real>
AVO_KERNEL void fill_up(HalfPlaneQueue& queue) {
  if (queue.count > 0)
    std::fill_n(&queue.index[queue.count], Real::kLanes, queue.index[queue.count - 1]);
}

AVO_KERNEL void set_state(PlaneColumns& planes, std::size_t first, std::uint32_t lanes,
                          PairState state) {
  for (; lanes != 0; lanes &= lanes - 1) {
    planes.state[first + static_cast<std::size_t>(std::countr_zero(lanes))] = state;
  }
}

/// Sets the states of all lanes; lanes with set bits are free.
template <typename Real>
AVO_KERNEL void set_states(PlaneColumns& planes, std::size_t first, std::uint32_t free) {
  std::copy_n(kFreeOrNot[free].begin(), Real::kLanes, &planes.state[first]);
}

/// Computes the frames of all pairs, the half-planes of pairs in contact and of pairs that the tip
/// decides, and the queues of the others.
template <typename Real>
void classify(const PairColumns& pairs, const Horizon& horizon, HalfPlaneWorkspace& work,
              PlaneColumns& planes) {
  const ResponseAt& end = horizon.end();
  for (std::size_t i = 0; i < pairs.count; i += Real::kLanes) {
    const LocalFrame<Real> frame = frame_at<Real>(pairs, i, end);
    const Real R = frame.local.R, index = Real::numbers_from(i);
    const Tip<Real> last = tip(frame.local, end);
    // equal centers have no normal
    const auto overlapping = frame.in_contact & (frame.local.d > Real(kTiniest));
    Vec<Real> n = frame.turned_back(last.plane.n);
    Real h = last.plane.h;
    if (any(overlapping)) {
      const Real depth = frame.local.r - frame.local.d;
      n = select(overlapping, frame.e, n);
      h = select(overlapping, separating(depth, frame.local.v.x, R, horizon), h);
    }
    n.x.store(&planes.n_x[i]);
    n.y.store(&planes.n_y[i]);
    const auto free = (!overlapping) & (frame.too_far | (last.nearest & (h <= -R)));
    const auto beyond_reach = (h > R) & (!free);
    const Real none = -std::numeric_limits<double>::infinity();
    select(free, none, select(beyond_reach, R, h)).store(&planes.h[i]);
    select(beyond_reach, h - R, Real(0.0)).store(&planes.excess[i]);
    const std::uint32_t free_lanes = bits(free);
    set_states<Real>(planes, i, free_lanes);

    const std::size_t left = pairs.count - i;
    std::uint32_t open = left < Real::kLanes ? (1U << left) - 1U
                                             : 0xffffffffU >> (32U - std::uint32_t{Real::kLanes});
    const auto take = [&open](std::uint32_t lanes) {
      lanes &= open;
      open &= ~lanes;
      return lanes;
    };
    const std::uint32_t in_contact = take(bits(frame.in_contact));
    if (in_contact != 0) {
      const std::uint32_t settled = in_contact & bits(overlapping);
      set_state(planes, i, settled, PairState::overlapping);
      push(work.rest, index, frame.in_contact & (!overlapping), in_contact & ~settled);
      work.cases.contact += static_cast<std::size_t>(std::popcount(in_contact));
    }
    take(free_lanes);
    const std::uint32_t tips = take(bits(last.nearest));
    set_state(planes, i, tips & bits(beyond_reach), PairState::unavoidable);
    work.cases.tip += static_cast<std::size_t>(std::popcount(tips));
    if (open == 0) continue;
    const auto waits = !(frame.in_contact | free | last.nearest);
    const std::uint32_t convex = open & bits(frame.on_collision_course);
    push(work.convex, index, waits & frame.on_collision_course, convex);
    push(work.horn, index, waits & (!frame.on_collision_course), open & ~convex);
  }
}

template <typename Real>
AVO_KERNEL void put(const LocalFrame<Real>& frame, const SupportLine<Real>& plane,
                    const double* index, std::size_t lanes, PlaneColumns& planes) {
  const Vec<Real> n = frame.turned_back(plane.n);
  const auto beyond_reach = plane.h > frame.local.R;
  alignas(64) std::array<double, Real::kLanes> n_x{}, n_y{}, h{}, excess{};
  n.x.store(n_x.data());
  n.y.store(n_y.data());
  select(beyond_reach, frame.local.R, plane.h).store(h.data());
  select(beyond_reach, plane.h - frame.local.R, Real(0.0)).store(excess.data());
  const std::uint32_t unavoidable = bits(beyond_reach);
  for (std::size_t k = 0; k < lanes; ++k) {
    const auto i = static_cast<std::size_t>(index[k]);
    planes.n_x[i] = n_x[k];
    planes.n_y[i] = n_y[k];
    planes.h[i] = h[k];
    planes.excess[i] = excess[k];
    planes.state[i] =
        (unavoidable >> k & 1U) != 0 ? PairState::unavoidable : PairState::constrained;
  }
}

template <typename Real>
void solve_convex(const PairColumns& pairs, const Horizon& horizon, HalfPlaneWorkspace& work,
                  PlaneColumns& planes) {
  HalfPlaneQueue& queue = work.convex;
  const ResponseTable table = horizon.table();
  work.cases.convex = queue.count;
  fill_up<Real>(queue);
  for (std::size_t i = 0; i < queue.count; i += Real::kLanes) {
    const LocalFrame<Real> frame = queued<Real>(pairs, queue, i, horizon.end());
    put(frame, convex(frame.local, table), &queue.index[i], std::min(Real::kLanes, queue.count - i),
        planes);
  }
}

/// Solves a pack of a queue of `count`; pairs that are not settled stay in it.
template <Crossed crossed, typename Real>
AVO_KERNEL void solve_horns_at(std::size_t first, std::size_t count, const PairColumns& pairs,
                               const Horizon& horizon, HalfPlaneQueue& queue,
                               PlaneColumns& planes) {
  const double* index = &queue.index[first];
  const std::size_t lanes = std::min(Real::kLanes, count - first);
  const LocalFrame<Real> frame = queued<Real>(pairs, queue, first, horizon.end());
  const HornPlane<Real> result = horn<crossed>(frame.local, horizon.end(), horizon.table());
  put(frame, result.plane, index, lanes, planes);
  const std::uint32_t settled = bits(result.settled), all = 0xffffffffU >> (32U - lanes);
  for (std::uint32_t left = settled & bits(result.free) & all; left != 0; left &= left - 1) {
    const auto i = static_cast<std::size_t>(index[std::countr_zero(left)]);
    planes.state[i] = PairState::free;
    planes.h[i] = -std::numeric_limits<double>::infinity();
    planes.excess[i] = 0.0;
  }
  const std::uint32_t open = all & ~settled;
  if (open == 0) return;
  push(queue, Real::load(index), !result.settled, open);
}

/// Uses wide packs as long as they are more than half full. Returns the number of pairs.
template <Crossed crossed, typename Real, typename Wide>
std::size_t solve_horns(const PairColumns& pairs, const Horizon& horizon, HalfPlaneQueue& queue,
                        PlaneColumns& planes) {
  fill_up<Wide>(queue);
  const std::size_t count = queue.count;
  queue.count = 0;
  std::size_t i = 0;
  for (; i + Real::kLanes < count; i += Wide::kLanes) {
    solve_horns_at<crossed, Wide>(i, count, pairs, horizon, queue, planes);
  }
  if (i < count) solve_horns_at<crossed, Real>(i, count, pairs, horizon, queue, planes);
  return count;
}

/// Wide: a pack that hides the latency of the divisions in Newton's iterations.
template <typename Real, typename Wide>
void solve(const PairColumns& pairs, const Horizon& horizon, HalfPlaneWorkspace& work,
           PlaneColumns& planes) {
  static_assert(Wide::kLanes <= kSparePairs);
  classify<Real>(pairs, horizon, work, planes);
  solve_convex<Wide>(pairs, horizon, work, planes);
  work.cases.horn = solve_horns<Crossed::once, Real, Wide>(pairs, horizon, work.horn, planes);
  work.cases.follow = solve_horns<Crossed::often, Real, Wide>(pairs, horizon, work.horn, planes);
  std::copy_n(work.horn.index.begin(), work.horn.count, &work.rest.index[work.rest.count]);
  work.rest.count += work.horn.count;
  work.cases.rest = work.rest.count;
}

AVO_END_KERNELS

#endif  // once per pass
