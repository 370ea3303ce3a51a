// SPDX-License-Identifier: Apache-2.0
// The rules for arriving (docs/arrival.md), for as many neighbors or robots at once as Pack has
// lanes.
#ifndef AVO_PLANNER_ARRIVAL_KERNEL_H
#define AVO_PLANNER_ARRIVAL_KERNEL_H

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>

#include "certificate/plan_kernel.h"
#include "core/share_kernel.h"
#include "planner/decision_columns.h"
#include "planner/execution_kernel.h"
#include "planner/rules/arrival.h"
#include "planner/stages/certified.h"

AVO_BEGIN_KERNELS

/// m: half of L, the distance to stop from v_max.
template <typename Real>
AVO_KERNEL Real stopping_distance(Real max_speed, Real braking) {
  return Real(0.5) * max_speed * (max_speed / braking);
}

/// m, the range in which traffic counts.
template <typename Real>
AVO_KERNEL Real traffic_range(Real max_speed, Real braking, Real radius) {
  const Real stopping = stopping_distance(max_speed, braking);
  return max(Real(3.0) * stopping, Real(8.0) * radius);
}

/// a turned clockwise by an angle in [0, π) rad, approximately; its length is kept.
template <typename Real>
AVO_KERNEL Vec<Real> turned_right(Vec<Real> a, Real angle) {
  // tan(angle / 2) = t/u by its continued fraction; any t and u make a rotation
  const Real x = Real(0.5) * angle, xx = x * x;
  const Real t = x * (Real(945.0) - xx * (Real(105.0) - xx));
  const Real u = Real(945.0) - xx * (Real(420.0) - Real(15.0) * xx);
  const Real both = t * t + u * u, c = (u * u - t * t) / both, s = Real(2.0) * t * u / both;
  return {c * a.x + s * a.y, c * a.y - s * a.x};
}

/// The weight of a neighbor of another priority in the rules. It is twice the part of the avoidance
/// of both that priorities leave to the robot; 1 where they are equal.
template <typename Real>
AVO_KERNEL Real deference(Real own, Real other) {
  return Real(2.0) * room_share(Real(1.0), Real(1.0), other, own);
}

/// See Traffic.
template <typename Real>
AVO_KERNEL Traffic look_around(const RobotColumns& robots, std::size_t i, double range) {
  const Neighbors& neighbors = robots.neighbors[i];
  const NeighborColumns& columns = *neighbors.columns;
  const Real zero(0.0), one(1.0), per_range(1.0 / range), range_squared(range * range);
  const Real per_slow(1.0 / (kSlow * robots.max_speed[i]));
  const Real per_closing(1.0 / (kCloses * robots.max_speed[i]));
  const Real most_squared(neighbors.range * neighbors.range);
  const Vec<Real> p = constant<Real>(robots.position(i)), v = constant<Real>(robots.velocity(i));
  const Vec2 preferred{robots.preferred_x[i], robots.preferred_y[i]};
  const double pace = norm(preferred);
  const Vec<Real> preferred_velocity = constant<Real>(preferred);
  const Real per_front(pace > 0.0 ? 1.0 / (kInFront * pace) : 0.0);
  const Real priority = robots.priority[i];
  const bool has_priorities = columns.has_priorities || robots.priority[i] != 1.0;
  Traffic traffic;
  alignas(64) double weights[8] = {};
  for (std::size_t k = 0; k < neighbors.count; k += Real::kLanes) {
    const auto load = [at = neighbors.first + k](const std::vector<double>& column) {
      return Real::load(&column[at]);
    };
    const auto counted = lane_numbers<Real>() < Real(static_cast<double>(neighbors.count - k));
    const Vec<Real> towards = Vec<Real>{load(columns.x), load(columns.y)} - p;
    const Vec<Real> velocity{load(columns.v_x), load(columns.v_y)};
    const Real squared = dot(towards, towards);
    const bool last = k + Real::kLanes >= neighbors.count || any(squared > most_squared);
    const Real distance = sqrt(squared);
    const Real per_distance = one / select(distance > zero, distance, one);
    // all neighbors that drive alongside count, so that the rear of a block learns about obstacles
    // before its front
    const Real closes = one + per_distance * dot(towards, v - velocity) * per_closing;
    const Real rests = Real(2.0) - norm(velocity) * per_slow;
    const Real in_front = per_distance * dot(towards, preferred_velocity) * per_front;
    const auto near = (squared < range_squared) & (in_front > zero);
    Real weight =
        (one - per_range * distance) * min(max(max(closes, rests), zero), one) * min(in_front, one);
    Real defers = one;
    if (has_priorities) {  // a mover never yields
      const Real kind = load(columns.kinds);
      defers =
          select((kind < zero) | (kind > zero), deference(priority, load(columns.priority)), one);
      weight = weight * defers;
    }
    // sums of eight in a fixed order: the number of lanes and zeros at the end have no influence
    select(counted & near, weight, zero).store(weights + k % 8);
    if ((k + Real::kLanes) % 8 == 0 || last) {
      traffic.ahead += ((weights[0] + weights[4]) + (weights[2] + weights[6])) +
                       ((weights[1] + weights[5]) + (weights[3] + weights[7]));
      if (Real::kLanes < 8) std::fill_n(weights, 8, 0.0);
    }

    const Real contact = Real(robots.radius[i]) + load(columns.radius);
    const Real reach = contact + Real(kRoom) * contact;
    const auto beside = counted & (squared < reach * reach) & (squared > zero);
    if (std::uint32_t lanes = bits(beside); lanes != 0) {
      traffic.is_beside = true;
      const Robot robot = robots.robot(i);
      alignas(64) double defer[Real::kLanes];
      defers.store(defer);
      for (; lanes != 0; lanes &= lanes - 1) {
        const auto lane = static_cast<std::size_t>(std::countr_zero(lanes));
        const Neighbor neighbor = neighbors[k + lane];
        const Vec2 push = defer[lane] * push_of(robot, neighbor);
        const double motion = motion_of(robot, neighbor);
        traffic.push = traffic.push + motion * push;
        traffic.push_at_rest = traffic.push_at_rest + (1.0 - motion) * push;
      }
    }
    if (last) break;
  }
  return traffic;
}

template <typename Real>
void look_around(const RobotColumns& robots, DecisionColumns& columns) {
  for (std::size_t i = 0; i < robots.count; i += Real::kLanes) {
    const auto load = [i](const std::vector<double>& column) { return Real::load(&column[i]); };
    const Real braking = min(load(robots.max_acceleration), load(robots.max_braking));
    traffic_range(load(robots.max_speed), braking, load(robots.radius)).store(&columns.range[i]);
  }
  for (std::size_t i = 0; i < robots.count; ++i) {
    const Traffic traffic = look_around<Real>(robots, i, columns.range[i]);
    columns.ahead[i] = traffic.ahead;
    columns.is_beside[i] = traffic.is_beside ? 1.0 : 0.0;
    columns.push_x[i] = traffic.push.x, columns.push_y[i] = traffic.push.y;
    columns.push_at_rest_x[i] = traffic.push_at_rest.x;
    columns.push_at_rest_y[i] = traffic.push_at_rest.y;
  }
}

template <typename Real>
void keep_right(const RobotColumns& robots, DecisionColumns& columns) {
  for (std::size_t i = 0; i < robots.count; i += Real::kLanes) {
    const auto load = [i](const std::vector<double>& column) { return Real::load(&column[i]); };
    const Vec<Real> preferred_velocity{load(robots.preferred_x), load(robots.preferred_y)};
    const Real ahead = load(columns.ahead);
    const Real braking = min(load(robots.max_acceleration), load(robots.max_braking));
    const Real stopping = stopping_distance(load(robots.max_speed), braking);
    // the turn fades to 0: on the last part of its route a robot needs its acceleration to brake
    const Real left = (load(robots.distance_to_goal) - stopping) / stopping;
    const Real part = min(left, Real(1.0)) * min(ahead, Real(kCongestion)) / Real(kCongestion);
    const auto turns = (left > Real(0.0)) & (ahead > Real(0.0));
    const Vec<Real> wish = select(
        turns, turned_right(preferred_velocity, part * Real(kMostKeepRight)), preferred_velocity);
    wish.x.store(&columns.wish_x[i]);
    wish.y.store(&columns.wish_y[i]);
  }
}

template <typename Real>
void decide_freely(const StepLaw& law, const Execution& execution, const RobotColumns& robots,
                   DecisionColumns& columns) {
  const auto within = [](Vec<Real> a, Real radius) {
    const Real rounding(kLimitRounding);
    return dot(a, a) <= rounding * radius * radius;
  };
  for (std::size_t i = 0; i < robots.count; i += Real::kLanes) {
    const auto load = [i](const std::vector<double>& column) { return Real::load(&column[i]); };
    const auto store = [i](Vec<Real> a, std::vector<double>& x, std::vector<double>& y) {
      a.x.store(&x[i]);
      a.y.store(&y[i]);
    };
    const Vec<Real> v{load(robots.v_x), load(robots.v_y)};
    const Vec<Real> wish{load(columns.wish_x), load(columns.wish_y)};
    const Vec<Real> last{load(columns.last_x), load(columns.last_y)};
    const Vec<Real> target{load(columns.target_x), load(columns.target_y)};
    const Real u = load(robots.max_acceleration) * Real(law.braking_time);
    const PackHaste<Real> haste =
        haste_of(load(robots.radius), load(robots.max_speed), load(robots.max_acceleration),
                 load(robots.distance_to_goal), execution);
    const Vec<Real> next = executed(v, last, target, haste);
    const Vec<Real> aim{load(columns.aim_x), load(columns.aim_y)};
    const Vec<Real> unhindered = approach(v, aim, haste.most);
    const Real most = dot(unhindered, wish);
    const auto may_detour = load(robots.distance_to_goal) >= load(robots.radius);
    const auto blocked = may_detour & (most > Real(0.0)) &
                         (dot(approach(v, target, haste.most), wish) < Real(kFree) * most);
    const auto kept = within(next - v, u) & within(next, load(robots.max_speed));
    select(kept & !blocked, Real(1.0), Real(0.0)).store(&columns.is_free[i]);
    const PackPlan<Real> plan = plan_to(v, next, law);
    store(next, columns.next_x, columns.next_y);
    store(plan.new_velocity, columns.new_x, columns.new_y);
    store(plan.acceleration, columns.a_x, columns.a_y);
  }
}

AVO_END_KERNELS

#endif  // once per pass
