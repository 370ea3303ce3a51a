// SPDX-License-Identifier: Apache-2.0
// Finds the neighbors that are near enough that a robot may have to brake for them:
// docs/certificate/left_out.md.
#ifndef AVO_CERTIFICATE_NEAR_KERNEL_H
#define AVO_CERTIFICATE_NEAR_KERNEL_H

#include <bit>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "certificate/bound_kernel.h"
#include "certificate/clearance_kernel.h"
#include "certificate/near_pairs.h"

AVO_BEGIN_KERNELS

template <typename Real>
void fill(const RobotColumns& robots, const StepLaw& law, BrakingColumns& own) {
  for (std::size_t i = 0; i < robots.count; i += Real::kLanes) {
    const auto load = [i](const std::vector<double>& column) { return Real::load(&column[i]); };
    const auto store = [i](Real value, std::vector<double>& column) { value.store(&column[i]); };
    const PackBraking<Real> a =
        braking_of({load(robots.v_x), load(robots.v_y)}, load(robots.max_acceleration),
                   load(robots.max_braking), law);
    store(a.profile.speed, own.speed), store(a.profile.decrement, own.decrement);
    store(a.increment, own.increment);
    store(a.profile.full_steps, own.full_steps);
    store(a.direction.x, own.direction_x), store(a.direction.y, own.direction_y);
    store(a.length, own.length), store(a.reach, own.reach), store(a.intervals, own.intervals);

    const PackDeviation<Real> deviation =
        deviation_of(a, load(own.stray_velocity), load(own.stray_distance), law);
    const auto& [ahead, across, anyhow, fast, slow, most_ahead, most_aside] = deviation;
    store(ahead.start, own.ahead_start), store(ahead.per_distance, own.ahead_slope);
    store(across.start, own.across_start), store(across.per_distance, own.across_slope);
    store(anyhow.start, own.anyhow_start), store(anyhow.per_distance, own.anyhow_slope);
    store(fast.speed, own.fast_speed), store(fast.full_steps, own.fast_steps);
    store(slow.speed, own.slow_speed), store(slow.full_steps, own.slow_steps);
    store(most_ahead, own.most_ahead), store(most_aside, own.most_aside);

    const PackBound<Real> bound = bound_of({load(robots.x), load(robots.y)}, load(robots.radius), a,
                                           deviation, load(robots.max_speed), law);
    store(bound.far_distance, own.far_distance), store(bound.speed_squared, own.far_speed_squared);
    for (std::size_t k = 0; k < 3; ++k) store(bound.reach[k], own.far_reach[k]);
    store(bound.clear_distance, own.clear_distance);
    store(bound.per_decrement, own.per_decrement);
  }
}

template <bool kUnlike, typename Real>
AVO_KERNEL NearPair lane_of(const PackPair<Real>& pair, const PackClearance<Real>& clearance,
                            std::size_t lane, std::uint32_t robot, std::uint32_t neighbor) {
  const auto number = [lane](Real value) {
    alignas(64) double lanes[Real::kLanes];
    value.store(lanes);
    return lanes[lane];
  };
  const PackBraking<Real>& b = pair.b;
  return {.robot = robot,
          .neighbor = neighbor,
          .p = {number(pair.p.x), number(pair.p.y)},
          .contact = number(pair.contact),
          .inflated = number(pair.inflated),
          .error = number(pair.error),
          .share = number(pair.share),
          .b = {.profile = {.speed = number(b.profile.speed),
                            .decrement = number(b.profile.decrement),
                            .full_steps = number(b.profile.full_steps)},
                .increment = number(kUnlike ? b.increment : b.profile.decrement),
                .direction = {number(b.direction.x), number(b.direction.y)},
                .length = number(b.length),
                .reach = number(b.reach),
                .intervals = number(b.intervals)},
          .gap = number(clearance.gap),
          .against = number(clearance.against)};
}

/// The limits of braking of all neighbors, m/s².
template <bool kUnlike>
const std::vector<double>& braking_limits(const NeighborColumns& columns) {
  return kUnlike && columns.has_max_braking ? columns.max_braking : columns.max_acceleration;
}

/// Keeps the pairs of the queue that may meet and can refuse a candidate of A, and empties the
/// queue.
template <typename Real, bool kUnlike>
void examine(const RobotColumns& robots, const StepLaw& law, NearPairs& pairs) {
  NearQueue& queue = pairs.queue;
  if (queue.count == 0) return;
  const bool exact = law.is_exact();
  const BrakingColumns& own = pairs.own;
  const NeighborColumns& columns = *robots.neighbors[0].columns;
  for (std::size_t i = 0; i < queue.count; i += Real::kLanes) {
    const auto is_pair = lane_numbers<Real>() < Real(static_cast<double>(queue.count - i));
    const auto entry = [&](const NearQueue::Column& column) {
      return select(is_pair, Real::load(&column[i]), Real(0.0));
    };
    const auto of = [](Real number) {
      return [number](const std::vector<double>& column) { return lookup(column.data(), number); };
    };
    const auto of_a = of(entry(queue.robot)), of_b = of(entry(queue.place));
    const PackRobot<Real> self{{of_a(robots.x), of_a(robots.y)},
                               {of_a(robots.v_x), of_a(robots.v_y)},
                               of_a(robots.radius),
                               of_a(robots.max_acceleration),
                               of_a(kUnlike ? robots.max_braking : robots.max_acceleration),
                               kUnlike ? of_a(robots.priority) : Real(1.0),
                               {.profile = {{}, {}, of_a(own.full_steps)},
                                .increment = {},
                                .direction = {of_a(own.direction_x), of_a(own.direction_y)},
                                .length = of_a(own.length),
                                .reach = of_a(own.reach),
                                .intervals = of_a(own.intervals)}};
    PackRobot<Real> other{{of_b(columns.x), of_b(columns.y)},
                          {of_b(columns.v_x), of_b(columns.v_y)},
                          of_b(columns.radius),
                          of_b(columns.max_acceleration),
                          of_b(braking_limits<kUnlike>(columns)),
                          kUnlike ? of_b(columns.priority) : Real(1.0)};
    other.braking = braking_of(other.velocity, other.max_acceleration, other.max_braking, law);
    const PackPair<Real> pair = pair_of<kUnlike>(self, other, law);
    const auto apart = pair.distance - (self.braking.reach + pair.b.reach);
    auto chosen = is_pair & !(apart > pair.inflated + pair.error);
    PackClearance<Real> clearance = clearance_of(self, pair, other, law);
    if (!exact) clearance.gap = Real(-std::numeric_limits<double>::infinity());
    chosen =
        chosen & !(clearance.gap > clearance.against * of_a(own.most_ahead) + of_a(own.most_aside));
    for (std::uint32_t lanes = bits(chosen); lanes != 0; lanes &= lanes - 1) {
      const auto lane = static_cast<std::size_t>(std::countr_zero(lanes));
      const auto robot = static_cast<std::uint32_t>(queue.robot[i + lane]);
      const std::size_t neighbor =
          static_cast<std::size_t>(queue.place[i + lane]) - robots.neighbors[robot].first;
      pairs.kept.push_back(
          lane_of<kUnlike>(pair, clearance, lane, robot, static_cast<std::uint32_t>(neighbor)));
    }
  }
  queue.count = 0;
}

/// Queues the neighbors of robot i that are not far. Returns whether there are neighbors that the
/// lanes leave out: movers, and neighbors with an age or a footprint.
template <typename Real, bool kUnlike>
AVO_KERNEL bool look_for(const RobotColumns& robots, std::size_t i, const StepLaw& law,
                         NearPairs& pairs) {
  const Neighbors& neighbors = robots.neighbors[i];
  const NeighborColumns& columns = *neighbors.columns;
  const BrakingColumns& own = pairs.own;
  const bool exact = law.is_exact();
  const Real range_squared(neighbors.range * neighbors.range);
  const PackRobot<Real> self{constant<Real>(robots.position(i)),
                             constant<Real>(robots.velocity(i)),
                             robots.radius[i],
                             robots.max_acceleration[i],
                             robots.max_braking[i],
                             robots.priority[i],
                             {.profile = {own.speed[i], {}, {}},
                              .increment = {},
                              .direction = {own.direction_x[i], own.direction_y[i]},
                              .length = {},
                              .reach = {},
                              .intervals = {}}};
  const PackBound<Real> bound{own.far_distance[i],
                              {own.far_reach[0][i], own.far_reach[1][i], own.far_reach[2][i]},
                              own.far_speed_squared[i],
                              own.clear_distance[i],
                              own.per_decrement[i],
                              own.most_ahead[i],
                              exact ? own.most_aside[i] : std::numeric_limits<double>::infinity()};
  const Real zero(0.0);
  const std::vector<double>& of_braking = braking_limits<kUnlike>(columns);
  auto others = zero < zero;
  for (std::size_t k = 0; k < neighbors.count; k += Real::kLanes) {
    const auto load = [at = neighbors.first + k](const std::vector<double>& column) {
      return Real::load(&column[at]);
    };
    const PackRobot<Real> other{{load(columns.x), load(columns.y)},
                                {load(columns.v_x), load(columns.v_y)},
                                load(columns.radius),
                                load(columns.max_acceleration),
                                load(of_braking),
                                load(columns.priority)};
    const auto counted = lane_numbers<Real>() < Real(static_cast<double>(neighbors.count - k));
    const auto prompt = load(columns.kinds) > zero;
    others = others | (counted & !prompt);
    auto near = counted & prompt & !are_far(bound, self, other);
    if (any(near)) near = near & !are_clear(bound, self, other, law);
    if constexpr (kUnlike) {
      const auto unlike = (other.priority < self.priority) | (other.priority > self.priority) |
                          (other.max_braking < self.max_braking) |
                          (other.max_braking > self.max_braking);
      near = near | (counted & prompt & unlike);
    }
    if (any(near)) {
      NearQueue& queue = pairs.queue;
      Real(static_cast<double>(i)).store(&queue.robot[queue.count]);
      queue.count +=
          store_chosen(near, Real::numbers_from(neighbors.first + k), &queue.place[queue.count]);
      if (queue.count >= NearQueue::kSize) examine<Real, kUnlike>(robots, law, pairs);
    }
    const Vec<Real> p = self.position - other.position;
    if (any(dot(p, p) > range_squared)) break;
  }
  return any(others);
}

/// Returns whether a robot has a priority other than 1, or a limit of braking.
inline bool are_unlike(const RobotColumns& robots) {
  for (std::size_t i = 0; i < robots.count; ++i) {
    const NeighborColumns& others = *robots.neighbors[i].columns;
    if (robots.priority[i] != 1.0 || robots.max_braking[i] != robots.max_acceleration[i] ||
        others.has_priorities || others.has_max_braking)
      return true;
  }
  return false;
}

/// kUnlike: see are_unlike(). If false, priorities and limits of braking are not read, which takes
/// fewer instructions.
template <typename Real, bool kUnlike>
AVO_KERNEL void look_for_all(const RobotColumns& robots, const StepLaw& law, NearPairs& pairs) {
  for (std::size_t i = 0; i < robots.count; ++i) {
    const bool has_discs = robots.has_models && pairs.own.has_discs[i] != 0;
    const bool has_others = has_discs || look_for<Real, kUnlike>(robots, i, law, pairs);
    pairs.has_others[i] = has_others ? 1 : 0;
  }
  examine<Real, kUnlike>(robots, law, pairs);
}

template <typename Real>
void find_near(const RobotColumns& robots, const StepLaw& law, NearPairs& pairs) {
  pairs.own.reserve(robots.count);
  pairs.own.take_strays(robots, law);
  fill<Real>(robots, law, pairs.own);
  pairs.kept.clear();
  pairs.queue.count = 0;  // entries may be left where memory ran out
  pairs.has_others.resize(robots.count);
  if (are_unlike(robots)) {
    look_for_all<Real, true>(robots, law, pairs);
  } else {
    look_for_all<Real, false>(robots, law, pairs);
  }
  pairs.end.resize(robots.count);
  std::size_t end = 0;
  for (std::size_t i = 0; i < robots.count; ++i) {
    while (end < pairs.kept.size() && pairs.kept[end].robot == i) ++end;
    pairs.end[i] = end;
  }
}

/// See admit_next().
template <typename Real>
void admit_next(const RobotColumns& robots, const std::vector<double>& next_x,
                const std::vector<double>& next_y, const StepLaw& law, NearPairs& pairs) {
  BrakingColumns& own = pairs.own;
  for (std::size_t i = 0; i < robots.count; i += Real::kLanes) {
    const auto load = [i](const std::vector<double>& column) { return Real::load(&column[i]); };
    const PackBraking<Real> a{{load(own.speed), load(own.decrement), {}},
                              load(own.increment),
                              {load(own.direction_x), load(own.direction_y)},
                              {},
                              load(own.reach),
                              {}};
    const auto [ahead, aside] = candidate_deviation(a, Vec<Real>{load(next_x), load(next_y)}, law);
    ahead.store(&own.next_ahead[i]), aside.store(&own.next_aside[i]);
  }
  pairs.admits.resize(robots.count);
  for (std::size_t i = 0; i < robots.count; ++i) {
    bool admits = robots.model[i] == nullptr && pairs.has_others[i] == 0;
    for (const NearPair& pair : pairs.of(i)) {
      admits = admits && pair.gap > pair.against * own.next_ahead[i] + own.next_aside[i];
    }
    pairs.admits[i] = admits ? 1 : 0;
  }
}

AVO_END_KERNELS

#endif  // once per pass
