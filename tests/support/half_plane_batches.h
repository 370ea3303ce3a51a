// SPDX-License-Identifier: Apache-2.0
// Pairs for half_planes(), which share a horizon, and the expected answers one by one.
#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "core/simd_target.h"
#include "obstacles/half_planes.h"
#include "support/generators.h"

namespace avo::test {

/// Sizes around every number of lanes, and one size of many packs.
inline constexpr std::array<std::size_t, 10> kBatchSizes{0, 1, 2, 7, 8, 9, 15, 16, 17, 640};

/// Selects one instruction set during its lifetime.
class OnTarget {
 public:
  explicit OnTarget(const char* name) : before_(simd_target()) { use_simd_target(name); }
  ~OnTarget() { use_simd_target(before_); }
  OnTarget(const OnTarget&) = delete;
  OnTarget& operator=(const OnTarget&) = delete;

 private:
  std::string before_;
};

/// Returns a pair in contact, overlapping, or with one center.
inline Situation touching(Random& random, Situation s) {
  Vec2& p = s.pair.position;
  const double d = norm(p);
  switch (random.below(8)) {
    case 0:
      p = {0.0, 0.0};
      break;
    case 1:
      p = s.pair.velocity = {0.0, 0.0};
      break;
    case 2:
      p = {s.pair.radius, 0.0};
      break;
    default:
      p = (s.pair.radius * random.uniform(0.0, 1.0) / d) * p;
      break;
  }
  return s;
}

/// Returns up to `size` situations of one δ and τ, of all kinds; lengths over thirteen decades if
/// `any_scale`.
inline std::vector<Situation> situations_of_one_horizon(Random& random, std::size_t size,
                                                        bool any_scale) {
  const Situation shared = wide_situation(random);
  const double time = any_scale && random.below(2) == 0 ? random.log_uniform(1e-2, 1e2) : 1.0;
  std::vector<Situation> all(size);
  for (Situation& s : all) {
    s = random.below(2) == 0 ? wide_situation(random) : degenerate_situation(random);
    if (random.below(16) == 0) s = touching(random, s);
    s.control_time = shared.control_time;
    s.time_horizon = shared.time_horizon;
    const bool scaled_too = any_scale && random.below(2) == 0;
    s = scaled(s, scaled_too ? random.log_uniform(1e-6, 1e7) : 1.0, time);
  }
  return all;
}

/// Returns the horizon of a whole batch; Δt is 0.1 s.
inline Horizon horizon_of(const std::vector<Situation>& all) {
  return all.empty() ? Horizon(4.0, 10.0, 0.1)
                     : Horizon(all[0].control_time, all[0].time_horizon, 0.1);
}

/// Scratch memory, which only grows.
struct Batch {
  PairColumns pairs;
  HalfPlaneWorkspace workspace;
  PlaneColumns planes;

  void solve(const std::vector<Situation>& all, const Horizon& horizon) {
    pairs.count = 0;
    pairs.reserve(all.size());
    for (const Situation& s : all) {
      pairs.add(s.pair.position, s.pair.velocity, s.pair.radius, s.reach);
    }
    spoil();
    half_planes(pairs, horizon, workspace, planes);
  }

  [[nodiscard]] RelativeHalfPlane operator[](std::size_t i) const {
    if (planes.state[i] == PairState::free || planes.state[i] == PairState::coincident) {
      return {planes.state[i], {}};
    }
    return {planes.state[i], {{planes.n_x[i], planes.n_y[i]}, planes.h[i]}, planes.excess[i]};
  }

 private:
  // Overwrites memory that no pair wrote, because it must not matter: columns past the last pair,
  // and old answers.
  void spoil() {
    constexpr double other = 0.5;
    for (auto* column :
         {&pairs.p_x, &pairs.p_y, &pairs.v_x, &pairs.v_y, &pairs.radius, &pairs.reach}) {
      std::fill(column->begin() + static_cast<std::ptrdiff_t>(pairs.count), column->end(), other);
    }
    for (auto* column : {&planes.n_x, &planes.n_y, &planes.h, &planes.excess}) {
      std::fill(column->begin(), column->end(), other);
    }
    std::fill(planes.state.begin(), planes.state.end(), PairState::coincident);
    for (auto* queue : {&workspace.convex, &workspace.horn, &workspace.rest})
      std::fill(queue->index.begin(), queue->index.end(), other);
  }
};

}  // namespace avo::test
