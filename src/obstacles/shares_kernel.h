// SPDX-License-Identifier: Apache-2.0
// Eqs. (2), (3), (17)-(20) for many robots. Lanes may write beyond a robot's last pair; the next
// robot overwrites this.
#ifndef AVO_OBSTACLES_SHARES_KERNEL_H
#define AVO_OBSTACLES_SHARES_KERNEL_H

#include <algorithm>
#include <cstddef>
#include <span>
#include <vector>

#include "core/scalar.h"
#include "obstacles/half_planes.h"

AVO_BEGIN_KERNELS

template <typename Real>
void relate(const RobotColumns& robots, const NeighborColumns& neighbors,
            std::span<const std::size_t> pair_end, double control_time, PairColumns& pairs,
            std::vector<double>& share) {
  const Real delta = control_time;
  std::size_t i = 0;
  for (std::size_t r = 0; r < robots.count; ++r) {
    const Real x = robots.x[r], y = robots.y[r], v_x = robots.v_x[r], v_y = robots.v_y[r];
    const Real radius = robots.radius[r], acceleration = robots.max_acceleration[r];
    std::size_t k = robots.neighbors[r].first;
    for (; i < pair_end[r]; i += Real::kLanes, k += Real::kLanes) {
      (x - Real::load(&neighbors.x[k])).store(&pairs.p_x[i]);
      (y - Real::load(&neighbors.y[k])).store(&pairs.p_y[i]);
      (v_x - Real::load(&neighbors.v_x[k])).store(&pairs.v_x[i]);
      (v_y - Real::load(&neighbors.v_y[k])).store(&pairs.v_y[i]);
      (radius + Real::load(&neighbors.radius[k])).store(&pairs.radius[i]);
      const Real both = acceleration + Real::load(&neighbors.max_acceleration[k]);
      (delta * both).store(&pairs.reach[i]);
      (acceleration / both).store(&share[i]);
    }
    i = pair_end[r];
  }
  pairs.count = i;
}

/// See Reserve.
template <typename Real>
AVO_KERNEL Real reserved_radius(Vec<Real> p, Vec<Real> v, Real radius, const Reserve& reserve) {
  const Real zero(0.0), towards = -dot(p, v), squared = dot(v, v);
  // whether they approach each other, and until when
  const Real latest = select(towards > zero, Real(reserve.horizon), zero);
  const auto sooner = towards < latest * squared;
  const Real time = select(sooner, towards / select(sooner, squared, Real(1.0)), latest);
  const Real wanted =
      radius + Real(reserve.quantile) * (Real(reserve.position) + time * Real(reserve.velocity));
  return max(radius, min(wanted, norm(p)));
}

template <typename Real>
void reserve_room(const Reserve& reserve, PairColumns& pairs) {
  for (std::size_t i = 0; i < pairs.count; i += Real::kLanes) {
    const auto load = [i](const auto& column) { return Real::load(&column[i]); };
    const Real radius = load(pairs.radius);
    reserved_radius<Real>({load(pairs.p_x), load(pairs.p_y)}, {load(pairs.v_x), load(pairs.v_y)},
                          radius, reserve)
        .store(&pairs.radius[i]);
  }
}

/// {A's plane is n . v' >= n . v_A + α h}; kept unless D(0, v_max) or D(v_A, δ a_max) lies inside
/// it.
template <typename Real>
void share_out(const RobotColumns& robots, std::span<const std::size_t> pair_end,
               std::span<const double> raise, double control_time, std::span<const double> share,
               const PlaneColumns& relative, SharedPlanes& shared) {
  const Real lane = lane_numbers<Real>();
  std::size_t i = 0, kept = 0;
  auto exceeding = lane < Real(0.0);  // none
  for (std::size_t r = 0; r < robots.count; ++r) {
    const Real v_x = robots.v_x[r], v_y = robots.v_y[r], raised = raise[r];
    const Real change = control_time * robots.max_acceleration[r], slowest = -robots.max_speed[r];
    const Real end(static_cast<double>(pair_end[r]));
    for (; i < pair_end[r]; i += Real::kLanes) {
      const Real along = Real::load(&relative.n_x[i]) * v_x + Real::load(&relative.n_y[i]) * v_y;
      const Real offset = along + Real::load(&share[i]) * Real::load(&relative.h[i]);
      offset.store(&shared.offset[i]);
      const Real pair = Real(static_cast<double>(i)) + lane;
      const auto exceeds = (Real::load(&relative.excess[i]) > Real(0.0)) & (pair < end);
      const auto cuts = ((offset + raised > max(slowest, along - change)) & (pair < end)) | exceeds;
      exceeding = exceeding | exceeds;
      kept += store_chosen(cuts, pair, &shared.kept[kept]);
    }
    i = pair_end[r];
    shared.kept_end[r] = kept;
  }
  shared.exceeding = any(exceeding);
}

AVO_END_KERNELS

#endif  // once per pass
