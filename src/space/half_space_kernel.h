// SPDX-License-Identifier: Apache-2.0
// The half-spaces of pairs, as many at once as Pack has lanes: docs/space.md, "The half-space of a
// pair".
#ifndef AVO_SPACE_HALF_SPACE_KERNEL_H
#define AVO_SPACE_HALF_SPACE_KERNEL_H

#include <cstddef>
#include <limits>
#include <vector>

#include "core/scalar.h"
#include "space/half_spaces.h"

AVO_BEGIN_KERNELS

// |v_2| below this part of |v|: p and v are parallel as far as rounding tells.
constexpr double kParallelCourse = 1e-9;
// (horizontal/vertical)² of p below this: p is vertical as far as rounding tells.
constexpr double kVerticalPlace = 1e-12;

/// See PairFrame.
template <typename Real>
struct PackFrame {
  Real distance;
  Vec<Real, 3> along, across;
  Vec<Real> velocity;
};

// A unit vector across p, odd in p.
template <typename Real>
AVO_RARE_KERNEL Vec<Real, 3> side_of(Vec<Real, 3> p) {
  const Real zero(0.0), horizontal = p.x * p.x + p.y * p.y;
  const auto is_steep = !(horizontal > Real(kVerticalPlace) * (p.z * p.z));
  const Real length = sqrt(select(is_steep, p.y * p.y + p.z * p.z, horizontal));
  return {select(is_steep, zero, -p.y / length), select(is_steep, -p.z / length, p.x / length),
          select(is_steep, p.y / length, zero)};
}

/// Requires p != 0. See space::frame_of().
template <typename Real>
AVO_KERNEL PackFrame<Real> frame_of(Vec<Real, 3> p, Vec<Real, 3> v) {
  PackFrame<Real> frame;
  frame.distance = norm(p);
  frame.along = p / frame.distance;
  const Real along = dot(frame.along, v);
  const Vec<Real, 3> rest = v - along * frame.along;
  const Real across = norm(rest);
  const auto is_parallel = !(across > Real(kParallelCourse) * norm(v));
  const Vec<Real, 3> first = rest / select(is_parallel, Real(1.0), across);
  const Vec<Real, 3> second = first - dot(first, frame.along) * frame.along;  // rounding was left
  frame.across = second / select(is_parallel, Real(1.0), norm(second));
  frame.velocity = {along, select(is_parallel, Real(0.0), across)};
  if (any(is_parallel)) frame.across = select(is_parallel, side_of(p), frame.across);
  return frame;
}

/// The pairs in their own planes, and the axes of these planes.
template <typename Real>
void find_frames(const space::SpacePairs& pairs, space::HalfSpaces& half_spaces) {
  PairColumns& plane = half_spaces.plane_pairs;
  for (std::size_t k = 0; k < pairs.count; k += Real::kLanes) {
    const PackFrame<Real> frame =
        frame_of(load_vector<Real, 3>(pairs.p, k), load_vector<Real, 3>(pairs.v, k));
    frame.distance.store(&plane.p_x[k]), Real(0.0).store(&plane.p_y[k]);
    frame.velocity.x.store(&plane.v_x[k]), frame.velocity.y.store(&plane.v_y[k]);
    Real::load(&pairs.radius[k]).store(&plane.radius[k]);
    Real::load(&pairs.reach[k]).store(&plane.reach[k]);
    store_vector(frame.along, half_spaces.along, k);
    store_vector(frame.across, half_spaces.across, k);
  }
  plane.count = pairs.count;
}

/// Appends the half-spaces of A that can cut, Eqs. (17) to (20), in its own space.
template <typename Real>
void turn_back(const space::SpacePairs& pairs, const space::OwnLimits& own,
               space::HalfSpaces& half_spaces) {
  const PlaneColumns& planes = half_spaces.planes;
  space::HalfSpaceColumns& soft = half_spaces.columns;
  const Vec<Real, 3> velocity = constant<Real>(own.velocity);
  const Real vertical(own.vertical), change(-(own.change + 1e-9)), speed(-(own.speed + 1e-9));
  const Vec<Real, 3> own_velocity{velocity.x, velocity.y, velocity.z / vertical};
  for (std::size_t k = 0; k < pairs.count; k += Real::kLanes) {
    const auto counted = lane_numbers<Real>() < Real(static_cast<double>(pairs.count - k));
    const Vec<Real, 3> n = Real::load(&planes.n_x[k]) * load_vector<Real, 3>(half_spaces.along, k) +
                           Real::load(&planes.n_y[k]) * load_vector<Real, 3>(half_spaces.across, k);
    const Real h = Real::load(&planes.h[k]);
    const Real offset = dot(n, velocity) + Real::load(&pairs.share[k]) * h;
    const Vec<Real, 3> own_n{n.x, n.y, vertical * n.z};
    const Real length = norm(own_n);
    const Vec<Real, 3> unit = own_n / length;
    const Real own_offset = offset / length;
    // there is none where h is -infinity
    const auto cuts =
        counted & (own_offset > speed) & (own_offset - dot(unit, own_velocity) > change);
    const std::size_t at = soft.count;
    store_chosen(cuts, unit.x, &soft.normal[0][at]),
        store_chosen(cuts, unit.y, &soft.normal[1][at]);
    store_chosen(cuts, unit.z, &soft.normal[2][at]),
        store_chosen(cuts, own_offset, &soft.offset[at]);
    soft.count += store_chosen(cuts, Real::load(&pairs.number[k]), &soft.number[at]);
  }
}

/// Sets the violation of each half-space by the point. Returns the largest one, or -infinity.
template <typename Real>
double find_violations(Vec3 point, space::HalfSpaceColumns& half_spaces) {
  const Vec<Real, 3> at = constant<Real>(point);
  const Real none(-std::numeric_limits<double>::infinity());
  Real most = none;
  for (std::size_t k = 0; k < half_spaces.count; k += Real::kLanes) {
    const auto counted = lane_numbers<Real>() < Real(static_cast<double>(half_spaces.count - k));
    const Real violation =
        Real::load(&half_spaces.offset[k]) - dot(load_vector<Real, 3>(half_spaces.normal, k), at);
    violation.store(&half_spaces.violation[k]);
    most = select(counted & (violation > most), violation, most);
  }
  alignas(64) double lanes[Real::kLanes];
  most.store(lanes);
  return *std::max_element(lanes, lanes + Real::kLanes);
}

AVO_END_KERNELS

#endif  // once per pass
