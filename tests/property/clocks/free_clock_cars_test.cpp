// SPDX-License-Identifier: Apache-2.0
// Other robots see these cars in the midst of a step. The tests check how far the rest of the step
// may lead off what the other robots expect. The other robots know a_max and the velocity of the
// axle alone.
#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <string>

#include "certificate/kernels.h"
#include "property/certificate_fleets.h"
#include "robots/model.h"

namespace avo::test {
namespace {

constexpr double kMaxSpeed = 2.0;  // m/s

Car any_car(Random& random) {
  Car car{.wheelbase = random.uniform(0.5, 1.5)};
  const int kind = random.below(3);
  if (kind != 0) car.body = CarBody{random.uniform(-1.0, 1.0), 0.9};
  if (kind != 1) car.acceleration_set = AccelerationSet::exact;
  if (random.below(2) == 0) car.max_curvature = random.log_uniform(0.2, 3.0);
  return car;
}

// A robot at p with the velocity v that holds it for `hold` s, and then brakes in steps.
Vec2 place_at(double time, Vec2 p, Vec2 v, double hold, double braking, double step) {
  const double held = std::min(time, hold);
  p = p + held * v;
  for (double left = time - held; left > 0.0 && norm(v) > 1e-12; left -= step) {
    const Vec2 a = -(std::min(braking, norm(v) / step) / norm(v)) * v;
    const double t = std::min(left, step);
    p = p + t * v + (0.5 * t * t) * a, v = v + t * a;
  }
  return p;
}

struct Step {
  Car car;
  MotionLimits limits;
  double braking = 0.0;  // m/s²
  MotionState from, to;
  double duration = 0.0;  // s
};

// With a choice at the edge of what the car may choose.
Step any_step(Random& random, double max_acceleration) {
  Step step;
  step.car = any_car(random), step.braking = max_acceleration;
  if (random.below(2) == 0) step.braking *= random.log_uniform(0.3, 3.0);
  step.limits = {std::min(step.braking, max_acceleration), kMaxSpeed};
  step.duration = random.log_uniform(0.05, 0.4);
  step.from.heading = random.uniform(-3.0, 3.0);
  const Vec2 h{std::cos(step.from.heading), std::sin(step.from.heading)};
  if (random.below(4) != 0) step.from.velocity = random.uniform(0.0, kMaxSpeed) * h;
  Robot robot;
  robot.velocity = step.from.velocity, robot.heading = step.from.heading;
  robot.max_acceleration = max_acceleration, robot.max_speed = kMaxSpeed, robot.model = step.car;
  const double reach = 2.0 * max_acceleration * step.duration;
  const Vec2 next =
      within_own_limits(robot, step.duration, robot.velocity + reach * random.direction());
  Plan plan;
  plan.acceleration = (next - robot.velocity) / step.duration;
  if (step.car.acceleration_set == AccelerationSet::incircle) {
    const double most = std::max(1.0, norm(plan.acceleration) / max_acceleration);
    plan.acceleration = plan.acceleration / most;
  }
  if (random.below(3) == 0) {  // a part of it, and for the rest braking
    const Vec2 braked_velocity = braked(robot.velocity, step.braking * step.duration);
    const Vec2 braking = (braked_velocity - robot.velocity) / step.duration;
    plan.acceleration = braking + random.uniform(0.0, 1.0) * (plan.acceleration - braking);
  }
  plan.new_velocity = robot.velocity + step.duration * plan.acceleration;
  step.to = advance(step.car, step.limits, step.from, plan, step.duration).next;
  return step;
}

struct Excess {
  double beyond_all, beyond_drift;  // m
};

// Returns the most by which the path of the disc exceeds the bounds. A robot sees the disc at
// `seen_at` within the step and decides every `own_step` s.
Excess excess_of(const Step& step, double seen_at, double own_step, double max_acceleration,
                 double longest) {
  PlannerOptions options;
  options.time_step = own_step;
  options.clock = Clock::free, options.longest_step = longest;
  const SensingError unseen = unforeseen(step.car, max_acceleration, longest);
  const MotionState now = within(step.car, step.from, step.to, seen_at, step.duration);
  using Real = scalar::Pack<double>;
  const auto drift_with = [&](const SensingError& error) {
    options.sensing_error = error;
    const StepLaw law = law_of(options).step;
    return scalar::drift_of<Real>(norm(now.velocity), increment(max_acceleration, law),
                                  increment(step.braking, law), law);
  };
  const auto drift = drift_with({}), wider = drift_with(unseen);
  const auto at = [](const auto& bound, double t) {
    return std::min(bound.start.value + bound.per_time.value * t, bound.most.value);
  };
  const double rest = step.duration - seen_at, braking = step.braking;
  Excess excess{-1.0, -1.0};
  for (double t = own_step; t < 8.0; t += 0.02) {
    const Vec2 place =
        t < rest
            ? within(step.car, step.from, step.to, seen_at + t, step.duration).position
            : place_at(t - rest, step.to.position, step.to.velocity, 0.0, braking, step.duration);
    const Vec2 expected = place_at(t, now.position, now.velocity, own_step, braking, own_step);
    const double off = norm(place - expected);
    excess.beyond_drift = std::max(excess.beyond_drift, off - at(drift, t));
    excess.beyond_all =
        std::max(excess.beyond_all, off - at(wider, t) - unseen.position - t * unseen.velocity);
  }
  return excess;
}

TEST(FreeClock, no_rest_of_a_cars_step_leads_farther_than_what_is_declared) {
  Random random(17);
  int beyond_drift = 0;
  double nearest = -1.0;
  for (int k = 0; k < 6000; ++k) {
    const double max_acceleration = random.log_uniform(0.5, 3.0);
    const Step step = any_step(random, max_acceleration);
    const double seen_at = k % 3 == 0 ? 0.0 : random.uniform(0.0, step.duration);
    const Excess excess =
        excess_of(step, seen_at, random.log_uniform(0.02, 0.4), max_acceleration, step.duration);
    ASSERT_LE(excess.beyond_all, 1e-9) << k;
    beyond_drift += excess.beyond_drift > 1e-6 ? 1 : 0;
    nearest = std::max(nearest, excess.beyond_all);
  }
  EXPECT_GT(beyond_drift, 100) << "the drift alone would do";
  RecordProperty("beyond_drift", beyond_drift);
  RecordProperty("nearest", std::to_string(nearest));
}

}  // namespace
}  // namespace avo::test
