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

/// Queues the selected neighbors of robot i.
template <bool kUnlike, typename Real>
AVO_KERNEL void push(const RobotColumns& robots, const BrakingColumns& a, std::size_t i,
                     const PackRobot<Real>& other, Real neighbor, decltype(Real() < Real()) chosen,
                     NearQueue& queue) {
  const std::size_t first = queue.count;
  const auto all = [first](double value, NearQueue::Column& column) {
    Real(value).store(&column[first]);
  };
  all(static_cast<double>(i), queue.robot);
  all(robots.x[i], queue.x), all(robots.y[i], queue.y);
  all(robots.v_x[i], queue.v_x), all(robots.v_y[i], queue.v_y);
  all(robots.radius[i], queue.radius), all(robots.max_acceleration[i], queue.max_acceleration);
  all(a.full_steps[i], queue.full_steps), all(a.length[i], queue.length);
  all(a.direction_x[i], queue.direction_x), all(a.direction_y[i], queue.direction_y);
  all(a.reach[i], queue.reach), all(a.intervals[i], queue.intervals);
  all(a.most_ahead[i], queue.most_ahead), all(a.most_aside[i], queue.most_aside);
  if constexpr (kUnlike) {
    all(robots.priority[i], queue.priority), all(robots.max_braking[i], queue.max_braking);
  }
  const auto some = [&](Real value, NearQueue::Column& column) {
    return store_chosen(chosen, value, &column[first]);
  };
  some(other.position.x, queue.other_x), some(other.position.y, queue.other_y);
  some(other.velocity.x, queue.other_v_x), some(other.velocity.y, queue.other_v_y);
  some(other.radius, queue.other_radius),
      some(other.max_acceleration, queue.other_max_acceleration);
  if constexpr (kUnlike) {
    some(other.priority, queue.other_priority), some(other.max_braking, queue.other_max_braking);
  }
  queue.count += some(neighbor, queue.neighbor);
}

template <bool kUnlike, typename Real>
AVO_KERNEL NearPair lane_of(const PackPair<Real>& pair, const PackClearance<Real>& clearance,
                            std::size_t lane, double robot, double neighbor) {
  const auto number = [lane](Real value) {
    alignas(64) double lanes[Real::kLanes];
    value.store(lanes);
    return lanes[lane];
  };
  const PackBraking<Real>& b = pair.b;
  return {.robot = static_cast<std::uint32_t>(robot),
          .neighbor = static_cast<std::uint32_t>(neighbor),
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

/// Keeps the pairs of the queue that may meet and can refuse a candidate of A, and empties the
/// queue.
template <typename Real, bool kUnlike>
void judge(const StepLaw& law, NearQueue& queue, std::vector<NearPair>& kept) {
  const bool exact = law.is_exact();
  for (std::size_t i = 0; i < queue.count; i += Real::kLanes) {
    const auto load = [i](const NearQueue::Column& column) { return Real::load(&column[i]); };
    const auto is_pair = lane_numbers<Real>() < Real(static_cast<double>(queue.count - i));
    const auto limit_of = [&](const NearQueue::Column& column) {
      return select(is_pair, load(column), Real(1.0));  // a divisor must not be 0
    };
    PackRobot<Real> other{
        {load(queue.other_x), load(queue.other_y)},
        {load(queue.other_v_x), load(queue.other_v_y)},
        load(queue.other_radius),
        limit_of(queue.other_max_acceleration),
        limit_of(kUnlike ? queue.other_max_braking : queue.other_max_acceleration),
        load(queue.other_priority)};
    other.braking = braking_of(other.velocity, other.max_acceleration, other.max_braking, law);
    const PackRobot<Real> self{{load(queue.x), load(queue.y)},
                               {load(queue.v_x), load(queue.v_y)},
                               load(queue.radius),
                               load(queue.max_acceleration),
                               load(kUnlike ? queue.max_braking : queue.max_acceleration),
                               load(queue.priority),
                               {{{}, {}, load(queue.full_steps)},
                                {},
                                {load(queue.direction_x), load(queue.direction_y)},
                                load(queue.length),
                                load(queue.reach),
                                load(queue.intervals)}};
    const PackPair<Real> pair = pair_of<kUnlike>(self, other, law);
    const auto apart = pair.distance - (self.braking.reach + pair.b.reach);
    auto chosen = is_pair & !(apart > pair.inflated + pair.error);
    PackClearance<Real> clearance = clearance_of(self, pair, other, law);
    if (!exact) clearance.gap = Real(-std::numeric_limits<double>::infinity());
    chosen = chosen &
             !(clearance.gap > clearance.against * load(queue.most_ahead) + load(queue.most_aside));
    for (std::uint32_t lanes = bits(chosen); lanes != 0; lanes &= lanes - 1) {
      const auto lane = static_cast<std::size_t>(std::countr_zero(lanes));
      kept.push_back(
          lane_of<kUnlike>(pair, clearance, lane, queue.robot[i + lane], queue.neighbor[i + lane]));
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
  const std::vector<double>& of_braking =
      kUnlike && columns.has_max_braking ? columns.max_braking : columns.max_acceleration;
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
      push<kUnlike>(robots, own, i, other, Real::numbers_from(k), near, pairs.queue);
      if (pairs.queue.count >= NearQueue::kSize) judge<Real, kUnlike>(law, pairs.queue, pairs.kept);
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
  judge<Real, kUnlike>(law, pairs.queue, pairs.kept);
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
