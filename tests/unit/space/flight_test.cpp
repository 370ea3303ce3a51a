// SPDX-License-Identifier: Apache-2.0
// Simulated quadrotors behind hostile references: how far each is from its reference, and whether
// any two touch.
#include "unit/space/flight.h"

#include <algorithm>
#include <cmath>
#include <deque>
#include <gtest/gtest.h>
#include <span>
#include <vector>

#include "space/own_space.h"
#include "unit/space/crush.h"

namespace avo::space::tests {
namespace {

constexpr int kSteps = 120;
constexpr double kMaxSpeed = 5.0;     // m/s
constexpr double kRadius = 0.25;      // m
constexpr double kFleetDelay = 0.12;  // s
constexpr double kTimeStep = 0.1;     // s

Airframe airframe(std::size_t k) {
  constexpr ThrustLaw kLaws[] = {ThrustLaw::projected, ThrustLaw::whole, ThrustLaw::vertical};
  Airframe result;
  result.quadrotor = {
      .mass = 1.0, .max_thrust = 20.0, .max_tilt = 0.7, .attitude_time = k % 2 == 0 ? 0.12 : 0.06};
  result.law = kLaws[k % 3];
  return result;
}

std::vector<Airframe> airframes(std::size_t count) {
  std::vector<Airframe> result;
  for (std::size_t k = 0; k < count; ++k) result.push_back(airframe(k));
  return result;
}

/// Accelerations that are bad for a vehicle that is late.
Vec3 hostile(int kind, int step, Vec3 last, Draws& draws) {
  switch (kind) {
    case 0:
      return {step / 3 % 2 == 0 ? 1.0 : -1.0, 0.0, 0.0};
    case 1:
      return draws.direction();
    case 2:
      return (step % 2 == 0 ? 1.0 : -1.0) * Vec3{0.8, 0.24, 0.55};
    default:
      return last == Vec3{} || draws.below(3) == 0 ? draws.direction() : last;
  }
}

// The largest distance from the reference of T ago, in parts of the declared deviation.
double worst_deviation(const Airframe& frame, double step, int kind) {
  const QuadrotorLimits limits = limits_of(frame.quadrotor);
  Filter filter(limits, limits.delay, step);
  Flight flight(frame, {}, 7);
  Draws draws(static_cast<std::uint64_t>(kind));
  Vec3 position, velocity, direction;
  std::deque<Vec3> past;
  const auto late = static_cast<std::size_t>(std::lround(limits.delay / Flight::kTick));
  const int ticks = static_cast<int>(std::lround(step / Flight::kTick));
  double worst = 0.0;
  for (int k = 0; k * step < 15.0; ++k) {
    direction = hostile(kind, k, direction, draws);
    Vec3 a = limits.max_acceleration * direction;
    if (norm(velocity + step * a) > kMaxSpeed)
      a = (-limits.max_acceleration / norm(velocity)) * velocity;
    filter.add(position, velocity, a);
    for (int i = 0; i < ticks; ++i) {
      past.push_back(position);
      if (past.size() > late) {
        worst = std::max(worst, norm(flight.position() - past.front()));
        past.pop_front();
      }
      flight.tick(filter.at(step * k + Flight::kTick * i));
      position = position + Flight::kTick * velocity + (0.5 * Flight::kTick * Flight::kTick) * a;
      velocity = velocity + Flight::kTick * a;
    }
  }
  return worst / limits.deviation;
}

TEST(QuadrotorFlight, stays_within_the_declared_deviation_of_hostile_references) {
  double worst = 0.0;
  for (std::size_t frame = 0; frame < 6; ++frame) {
    for (const double step : {0.05, 0.1, 0.25}) {
      for (int kind = 0; kind < 4; ++kind) {
        const double deviation = worst_deviation(airframe(frame), step, kind);
        ASSERT_LE(deviation, 1.0) << frame << " " << step << " " << kind;
        worst = std::max(worst, deviation);
      }
    }
  }
  EXPECT_LE(worst, 0.75);
  // much less would have been declared for nothing
  EXPECT_GT(worst, 0.5);
}

/// Vehicles behind the references of a crush.
class Vehicles {
 public:
  /// fleet_delay: 0: each flies after its own delay, which is wrong.
  Vehicles(const std::vector<Airframe>& frames, const std::vector<Robot>& references,
           double fleet_delay, double time_step)
      : time_step_(time_step) {
    for (std::size_t k = 0; k < frames.size(); ++k) {
      const QuadrotorLimits limits = limits_of(frames[k].quadrotor);
      filters_.emplace_back(limits, fleet_delay > 0.0 ? fleet_delay : limits.delay, time_step);
      flights_.emplace_back(frames[k], references[k].position, k);
    }
  }

  /// Flies over a step of the references.
  void fly(const std::vector<Robot>& before, const std::vector<Robot>& after) {
    for (std::size_t k = 0; k < filters_.size(); ++k)
      filters_[k].add(before[k].position, before[k].velocity,
                      (after[k].velocity - before[k].velocity) / time_step_);
    const int ticks = static_cast<int>(std::lround(time_step_ / Flight::kTick));
    for (int i = 0; i < ticks; ++i) {
      for (std::size_t k = 0; k < filters_.size(); ++k)
        flights_[k].tick(filters_[k].at(filters_[k].begin() + Flight::kTick * i));
      judge();
    }
  }

  int contacts() const { return contacts_; }
  double least_gap() const { return std::sqrt(least_squared_) - kContact; }

 private:
  void judge() {
    for (std::size_t a = 0; a < flights_.size(); ++a) {
      for (std::size_t b = 0; b < a; ++b) {
        const double squared = norm_squared(flights_[a].position() - flights_[b].position());
        least_squared_ = std::min(least_squared_, squared);
        if (squared < kContact * kContact) ++contacts_;
      }
    }
  }

  static constexpr double kContact = 2.0 * kRadius;  // m
  double time_step_;
  std::vector<Filter> filters_;
  std::vector<Flight> flights_;
  double least_squared_ = 1e9;
  int contacts_ = 0;
};

/// References of quadrotors in a ball, which want contact.
Crush crush_of(int count, bool declares, std::uint64_t seed) {
  Draws draws(seed);
  std::vector<Robot> robots;
  for (int k = 0; k < count; ++k) {
    const QuadrotorLimits limits = limits_of(airframe(static_cast<std::size_t>(k)).quadrotor);
    Robot robot{.radius = kRadius + (declares ? limits.deviation : 0.0),
                .max_acceleration = limits.max_acceleration,
                .max_speed = kMaxSpeed};
    for (double within = 3.0;; within *= 1.01) {
      robot.position = draws.within(within);
      const bool is_free = std::all_of(robots.begin(), robots.end(), [&](const Robot& other) {
        return norm(robot.position - other.position) > robot.radius + other.radius + 0.01;
      });
      if (is_free) break;
    }
    robots.push_back(robot);
  }
  PlannerOptions options;
  options.time_step = kTimeStep;
  return {robots, {}, options, draws};
}

// 7.3·10⁷ ticks of pairs.
TEST(QuadrotorFleet, of_30_in_a_crush_does_not_touch) {
  double least_gap = 1e9;
  for (std::uint64_t seed = 1; seed <= 14; ++seed) {
    Crush crush = crush_of(30, true, seed);
    Vehicles vehicles(airframes(30), crush.robots(), kFleetDelay, kTimeStep);
    for (int k = 0; k < kSteps; ++k) {
      const std::vector<Robot> before = crush.robots();
      crush.step();
      vehicles.fly(before, crush.robots());
    }
    EXPECT_EQ(crush.report().overlaps.count, 0) << seed;
    EXPECT_EQ(vehicles.contacts(), 0) << seed << " " << vehicles.least_gap();
    least_gap = std::min(least_gap, vehicles.least_gap());
  }
  EXPECT_LT(least_gap, 0.06);  // they do come close
}

TEST(QuadrotorFleet, that_declares_no_deviation_touches) {
  Crush crush = crush_of(30, false, 1);
  Vehicles vehicles(airframes(30), crush.robots(), kFleetDelay, kTimeStep);
  for (int k = 0; k < kSteps && vehicles.contacts() == 0; ++k) {
    const std::vector<Robot> before = crush.robots();
    crush.step();
    vehicles.fly(before, crush.robots());
  }
  EXPECT_EQ(crush.report().overlaps.count, 0);
  EXPECT_GT(vehicles.contacts(), 0) << vehicles.least_gap();
}

// The fastest of some velocities straight ahead that is admitted; braking, if none is.
Vec3 chase(const Robot& robot, const Robot& ahead, const Planner& planner,
           PlanWorkspace& workspace) {
  const Neighbor neighbor = neighbor_of(ahead);
  const double change = (1.0 - 1e-12) * robot.max_acceleration * planner.options().time_step;
  for (double part = 1.0; part > -1.0; part -= 0.125) {
    const double speed = std::min(robot.velocity.x + part * change, robot.max_speed);
    const Vec3 next{std::max(speed, 0.0), 0.0, 0.0};
    if (planner.is_admitted(robot, std::span(&neighbor, 1), workspace, next)) return next;
  }
  return {std::max(robot.velocity.x - change, 0.0), 0.0, 0.0};
}

// A quick vehicle chases a slow one, which flees for 3 s, and then brakes as hard as it can.
Vehicles chased(double fleet_delay) {
  constexpr double kStep = 0.02;  // s
  std::vector<Airframe> frames{airframe(0), airframe(1)};
  frames[1].quadrotor.attitude_time = 0.04;
  std::vector<Robot> robots;
  for (const Airframe& frame : frames) {
    const QuadrotorLimits limits = limits_of(frame.quadrotor);
    robots.push_back({.radius = kRadius + limits.deviation,
                      .max_acceleration = limits.max_acceleration,
                      .max_speed = kMaxSpeed});
  }
  robots[1].position.x = -robots[0].radius - robots[1].radius - 0.05;
  PlannerOptions options;
  options.time_step = kStep;
  const Planner planner(options);
  PlanWorkspace workspace;
  Vehicles vehicles(frames, robots, fleet_delay, kStep);
  for (int k = 0; k < 250; ++k) {
    const std::vector<Robot> before = robots;
    const double change = robots[0].max_acceleration * kStep * (k < 150 ? 1.0 : -1.0);
    const double speed = std::clamp(robots[0].velocity.x + change, 0.0, kMaxSpeed);
    robots[1].velocity = chase(before[1], before[0], planner, workspace);
    robots[0].velocity = {speed, 0.0, 0.0};
    for (std::size_t j = 0; j < 2; ++j)
      robots[j].position =
          robots[j].position + (0.5 * kStep) * (before[j].velocity + robots[j].velocity);
    vehicles.fly(before, robots);
  }
  return vehicles;
}

TEST(QuadrotorFleet, whose_delays_are_not_equal_touches) {
  const Vehicles equal = chased(kFleetDelay), unequal = chased(0.0);
  EXPECT_EQ(equal.contacts(), 0) << equal.least_gap();
  EXPECT_GT(unequal.contacts(), 0) << unequal.least_gap();
}

}  // namespace
}  // namespace avo::space::tests
