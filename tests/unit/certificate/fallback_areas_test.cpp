// SPDX-License-Identifier: Apache-2.0
// Pairs one of which loiters: whatever is chosen of what both are allowed, they do not touch.
#include "certificate/fallback_areas.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <gtest/gtest.h>
#include <limits>
#include <numbers>
#include <optional>
#include <vector>

#include "certificate/certificate.h"
#include "core/elementary.h"
#include "robots/airplane.h"
#include "robots/model.h"
#include "support/certificates.h"

namespace avo {
namespace {

using test::Random;
using test::seen;

StepLaw law_of_run;  // held
constexpr int kParts = 8;

enum class Kind { airplane, holonomic, car };

Robot any_robot(Random& random, Kind kind) {
  Robot robot;
  robot.position = test::in_disc(random, 6.0);
  robot.heading = random.uniform(-std::numbers::pi, std::numbers::pi);
  robot.radius = random.uniform(0.2, 0.8);
  robot.max_acceleration = random.log_uniform(0.3, 3.0);
  robot.priority = random.below(2) == 0 ? 1.0 : random.log_uniform(0.001, 1000.0);
  const Vec2 heading = elementary::direction(robot.heading);
  if (kind == Kind::holonomic) {
    robot.velocity = test::in_disc(random, robot.max_speed);
    return robot;
  }
  if (kind == Kind::car) {
    const double back = random.below(2) == 0 ? -1.0 : 1.0;
    robot.model = Car{.max_curvature = 0.8,
                      .body = CarBody{random.uniform(-0.5, 0.5), robot.radius},
                      .reverse = true};
    robot.velocity = (back * random.uniform(0.0, robot.max_speed)) * heading;
    return robot;
  }
  Airplane airplane;
  airplane.min_speed = random.uniform(0.5, 1.5);
  const double most = 3.0 * airplane.min_speed / law_of_run.time_step;  // 3 rad a step
  airplane.lateral_acceleration = std::min(random.uniform(0.5, 3.0), most);
  robot.velocity = random.uniform(airplane.min_speed, robot.max_speed) * heading;
  robot.model = airplane;
  robot.loiter = loiter_circle(airplane, robot.position, robot.velocity);
  return robot;
}

// Where a robot is at the ends and within a step, and what it is then.
struct Moved {
  Robot robot;
  std::vector<Vec2> places;
};

Moved fly_on(const Robot& robot, const FlightStep& step, double next_speed) {
  Moved moved{robot, {}};
  const double speed = norm(robot.velocity), h = law_of_run.time_step;
  for (int k = 0; k <= kParts; ++k) {
    const double t = h * k / kParts;
    FlightArc part = step.arc;
    part.length = speed * t + 0.5 * (next_speed - speed) * t * t / h;
    const double half = 0.5 * part.curvature * part.length;
    const double chord = part.length * (std::abs(half) < 1e-9 ? 1.0 : std::sin(half) / half);
    const Vec2 along = elementary::direction(robot.heading + half);
    moved.places.push_back(robot.position + chord * along);
  }
  const MotionState& next = step.motion.next;
  moved.robot.position = next.position, moved.robot.velocity = next.velocity;
  moved.robot.heading = next.heading, moved.robot.loiter = next.circle;
  return moved;
}

Moved drive_on(const Robot& robot, Vec2 next_velocity) {
  Moved moved{robot, {}};
  const Plan plan = plan_to(robot, next_velocity, law_of_run);
  if (is_holonomic(robot.model)) {
    for (int k = 0; k <= kParts; ++k) {
      const double t = law_of_run.time_step * k / kParts;
      moved.places.push_back(robot.position + t * robot.velocity +
                             (0.5 * t * t / law_of_run.time_step) *
                                 (next_velocity - robot.velocity));
    }
    moved.robot.position = moved.places.back(), moved.robot.velocity = next_velocity;
    return moved;
  }
  const MotionState state{robot.position, robot.velocity, robot.heading};
  const MotionStep step = advance(robot.model, {robot.max_acceleration, robot.max_speed}, state,
                                  plan, law_of_run.time_step);
  moved.places = {robot.position, step.next.position};
  moved.robot.position = step.next.position, moved.robot.velocity = step.next.velocity;
  moved.robot.heading = step.next.heading;
  return moved;
}

// One of many candidates that are admitted: any, or that which leads nearest to the other one.
class Chooser {
 public:
  Moved choose(Random& random, const Robot& robot, const Robot& other) {
    const bool worst = random.below(4) != 0;
    std::optional<Moved> chosen;
    double nearest = std::numeric_limits<double>::infinity();
    const auto consider = [&](const Moved& moved) {
      const double away =
          gap_of(fallback_area_of(moved.robot, law_of_run), fallback_area_of(other, law_of_run));
      if (chosen && (!worst || away >= nearest)) return;
      nearest = away, chosen = moved;
    };
    const Neighbor neighbor = seen(other);
    can_rest(robot.model) ? drive(random, robot, neighbor, consider)
                          : fly(random, robot, neighbor, consider);
    return *chosen;
  }
  int admitted = 0;

 private:
  template <typename Consider>
  void fly(Random& random, const Robot& robot, const Neighbor& other, const Consider& consider) {
    const Airplane& airplane = std::get<Airplane>(robot.model);
    const MotionLimits limits{robot.max_acceleration, robot.max_speed};
    const MotionState state{robot.position, robot.velocity, robot.heading, *robot.loiter};
    collect_flight(robot, in_columns(std::span(&other, 1), columns_), {}, law_of_run, flight_);
    const Vec2 h = elementary::direction(robot.heading);
    for (int k = 0; k < 24; ++k) {
      const double a_lat = usable_acceleration(airplane), a_max = robot.max_acceleration;
      const Plan plan{.acceleration = random.uniform(-a_max, a_max) * h +
                                      random.uniform(-1.5 * a_lat, 1.5 * a_lat) * perpendicular(h)};
      const FlightStep step = avo::fly(airplane, limits, state, plan, law_of_run.time_step);
      if (!keeps_flight(flight_, robot, step)) continue;
      ++admitted;
      consider(fly_on(robot, step, norm(step.motion.next.velocity)));
    }
    const FlightStep hold =
        avo::fly(airplane, limits, state, {.acceleration = loitering(airplane, state)},
                 law_of_run.time_step);
    consider(fly_on(robot, hold, norm(robot.velocity)));
  }
  template <typename Consider>
  void drive(Random& random, const Robot& robot, const Neighbor& other, const Consider& consider) {
    const CertificateLaw shared{Certificate::braking_trajectories, law_of_run};
    collect_constraints(robot, std::span(&other, 1), shared, constraints_);
    const double u = robot.max_acceleration * law_of_run.time_step;
    for (int k = 0; k < 24; ++k) {
      const Vec2 next = robot.velocity + test::in_disc(random, u);
      if (norm(next) > robot.max_speed || !admits(robot, next, shared, constraints_)) continue;
      ++admitted;
      consider(drive_on(robot, next));
    }
    consider(drive_on(robot, backup_velocity(robot, shared)));
  }

  CertificateConstraints constraints_;
  FlightConstraints flight_;
  NeighborColumns columns_;
};

struct Result {
  double least = std::numeric_limits<double>::infinity();  // m between the discs
  int admitted = 0;
};

Result run(Kind first, Kind second, int situations, int steps, double time_step = 0.1) {
  law_of_run = {.time_step = time_step, .lag = 0.5 * time_step, .braking_time = time_step};
  Random random(41);
  Result result;
  Chooser chooser;
  for (int k = 0; k < situations;) {
    Robot a = any_robot(random, first), b = any_robot(random, second);
    if (gap_of(fallback_area_of(a, law_of_run), fallback_area_of(b, law_of_run)) < 1e-9) continue;
    ++k;
    for (int i = 0; i < steps; ++i) {
      const Moved next_a = chooser.choose(random, a, b), next_b = chooser.choose(random, b, a);
      const std::size_t count = std::min(next_a.places.size(), next_b.places.size());
      for (std::size_t part = 0; part < count; ++part) {
        const auto at = [&](const Moved& moved) {
          return moved.places[part * (moved.places.size() - 1) / (count - 1)];
        };
        result.least = std::min(result.least, norm(at(next_a) - at(next_b)) - a.radius - b.radius);
      }
      a = next_a.robot, b = next_b.robot;
    }
  }
  result.admitted = chooser.admitted;
  return result;
}

TEST(FallbackAreas, airplanes_do_not_touch_whatever_they_choose) {
  const Result result = run(Kind::airplane, Kind::airplane, 300, 80);
  EXPECT_GE(result.least, 0.0);
  EXPECT_GT(result.admitted, 100'000);
}

// What is between the circles before and after a step counts too: they may turn by 3 rad.
TEST(FallbackAreas, airplanes_do_not_touch_in_long_steps) {
  const Result result = run(Kind::airplane, Kind::airplane, 500, 40, 1.0);
  EXPECT_GE(result.least, 0.0);
  EXPECT_GT(result.admitted, 100'000);
}

TEST(FallbackAreas, all_of_an_admitted_step_keeps_to_the_line) {
  law_of_run = {.time_step = 1.0, .lag = 0.5, .braking_time = 1.0};
  Random random(44);
  FlightConstraints flight;
  NeighborColumns columns;
  int admitted = 0;
  for (int k = 0; k < 20'000; ++k) {
    const Robot a = any_robot(random, Kind::airplane), b = any_robot(random, Kind::airplane);
    if (gap_of(fallback_area_of(a, law_of_run), fallback_area_of(b, law_of_run)) < 1e-6) continue;
    const Neighbor other = seen(b);
    collect_flight(a, in_columns(std::span(&other, 1), columns), {}, law_of_run, flight);
    const SeparatingLine& line = flight.lines[0];
    const Vec2 h = elementary::direction(a.heading);
    const Plan plan{.acceleration = random.uniform(-3.0, 3.0) * perpendicular(h)};
    const FlightStep step = fly(std::get<Airplane>(a.model), {1.0, a.max_speed},
                                {a.position, a.velocity, a.heading, *a.loiter}, plan, 1.0);
    if (!keeps_flight(flight, a, step)) continue;
    ++admitted;
    const double bound = dot(line.normal, a.loiter->center) - a.loiter->radius - line.part;
    for (const Vec2 p : fly_on(a, step, norm(step.motion.next.velocity)).places)
      ASSERT_GE(dot(line.normal, p), bound - 1e-9);
  }
  EXPECT_GT(admitted, 3'000);
}

TEST(FallbackAreas, airplanes_and_robots_that_brake_do_not_touch_whatever_they_choose) {
  for (const Kind kind : {Kind::holonomic, Kind::car}) {
    const Result result = run(Kind::airplane, kind, 300, 80);
    EXPECT_GE(result.least, 0.0) << static_cast<int>(kind);
    EXPECT_GT(result.admitted, 100'000);
  }
}

// Both derive one line, and their parts add up to the gap.
TEST(FallbackAreas, both_of_a_pair_mean_the_same_line) {
  law_of_run = {};
  Random random(42);
  FlightConstraints of_a, of_b;
  NeighborColumns columns;
  int pairs = 0;
  while (pairs < 2'000) {
    const Robot a = any_robot(random, Kind::airplane), b = any_robot(random, Kind::airplane);
    const double gap = gap_of(fallback_area_of(a, law_of_run), fallback_area_of(b, law_of_run));
    if (gap < 1e-6) continue;
    ++pairs;
    const Neighbor seen_a = seen(a), seen_b = seen(b);
    collect_flight(a, in_columns(std::span(&seen_b, 1), columns), {}, law_of_run, of_a);
    collect_flight(b, in_columns(std::span(&seen_a, 1), columns), {}, law_of_run, of_b);
    EXPECT_EQ(of_a.lines[0].normal, -of_b.lines[0].normal);
    EXPECT_LE(of_a.lines[0].part + of_b.lines[0].part, gap);
    EXPECT_GE(of_a.lines[0].part + of_b.lines[0].part, gap - 1e-9);
  }
}

// A pair of a robot that brakes and an airplane that circles, with a gap between their fallback
// areas.
struct Beside {
  Robot robot;
  Neighbor airplane;
};

Beside beside_an_airplane(Random& random) {
  for (;;) {
    const Robot robot = any_robot(random, Kind::holonomic);
    const Robot airplane = any_robot(random, Kind::airplane);
    const double gap =
        gap_of(fallback_area_of(robot, law_of_run), fallback_area_of(airplane, law_of_run));
    if (gap > 1e-6 && gap < 2.0) return {robot, seen(airplane)};
  }
}

// p and the place where it stops, relative to the robot before its step.
std::array<Vec2, 2> next_area(const Robot& robot, Vec2 next_velocity) {
  const Vec2 moved = 0.5 * law_of_run.time_step * (robot.velocity + next_velocity);
  Robot next = robot;
  next.velocity = next_velocity;
  return {moved, moved + fallback_area_of(next, law_of_run).to_stop};
}

TEST(FallbackAreas, braking_keeps_the_next_one_in_the_present_one) {
  law_of_run = {.time_step = 0.1, .lag = 0.05, .braking_time = 0.1};
  Random random(45);
  for (int k = 0; k < 2'000; ++k) {
    const Robot robot = any_robot(random, Kind::holonomic);
    const Vec2 stop = fallback_area_of(robot, law_of_run).to_stop;
    const auto [moved, next_stop] =
        next_area(robot, braked(robot.velocity, decrement_of(robot, law_of_run)));
    EXPECT_LE(norm(next_stop - stop), 1e-13 * (1.0 + norm(stop)));
    EXPECT_NEAR(norm(moved) + norm(stop - moved), norm(stop), 1e-12);
  }
}

TEST(FallbackAreas, next_one_of_a_robot_that_brakes_is_what_is_tested) {
  law_of_run = {.time_step = 0.1, .lag = 0.05, .braking_time = 0.1};
  const CertificateLaw law{Certificate::braking_trajectories, law_of_run};
  Random random(46);
  CertificateConstraints constraints;
  int refused = 0;
  for (int k = 0; k < 3'000; ++k) {
    const auto [robot, airplane] = beside_an_airplane(random);
    collect_constraints(robot, std::span(&airplane, 1), law, constraints);
    ASSERT_EQ(constraints.loiterers.size(), 1u);
    const LoiterLine line = constraints.loiterers[0];
    const Vec2 next = robot.velocity + test::in_disc(random, robot.max_acceleration * 0.1);
    double margin = std::numeric_limits<double>::infinity();
    for (const Vec2 p : next_area(robot, next))
      margin = std::min(margin, dot(line.normal, p) - line.offset);
    if (std::abs(margin) < 1e-10) continue;
    EXPECT_EQ(admits(robot, next, law, constraints), margin > 0.0);
    refused += margin < 0.0 ? 1 : 0;
  }
  EXPECT_GT(refused, 100);
}

TEST(FallbackAreas, half_planes_of_lines_suffice_up_to_their_speed) {
  law_of_run = {.time_step = 0.1, .lag = 0.05, .braking_time = 0.1};
  const CertificateLaw law{Certificate::braking_trajectories, law_of_run};
  Random random(47);
  CertificateConstraints constraints;
  int inside = 0;
  for (int k = 0; k < 4'000; ++k) {
    const auto [robot, airplane] = beside_an_airplane(random);
    collect_constraints(robot, std::span(&airplane, 1), law, constraints);
    const double u = robot.max_acceleration * 0.1, speed = norm(robot.velocity);
    for (const double top : {speed + u, speed, std::max(speed - u, 0.0)}) {
      std::vector<HalfPlane> planes;
      append_half_planes(constraints.loiterers, robot, law_of_run, top, planes);
      ASSERT_EQ(planes.size(), 1u);
      const Vec2 next = robot.velocity + test::in_disc(random, u);
      if (violation(planes[0], next) > -1e-12 || norm(next) > top) continue;
      EXPECT_TRUE(admits(robot, next, law, constraints)) << k;
      ++inside;
    }
  }
  EXPECT_GT(inside, 1'000);
}

// The circle and the path keep off a wall that is straight ahead.
TEST(FallbackAreas, an_airplane_keeps_its_circle_off_walls) {
  law_of_run = {};
  Random random(43);
  FlightConstraints constraints;
  NeighborColumns nobody;
  int admitted = 0;
  for (int k = 0; k < 300; ++k) {
    Robot robot = any_robot(random, Kind::airplane);
    const Vec2 away = test::in_disc(random, 6.0), along = test::in_disc(random, 6.0);
    const Wall wall{robot.position + away, robot.position + away + along, random.uniform(0.0, 0.3)};
    const auto clear = [&](Vec2 p) { return distance(p, Segment{wall.a, wall.b}) - wall.radius; };
    if (clear(robot.loiter->center) - robot.loiter->radius - robot.radius < 1e-9) continue;
    const Airplane& airplane = std::get<Airplane>(robot.model);
    for (int i = 0; i < 80; ++i) {
      collect_flight(robot, {&nobody, 0, 0}, std::span(&wall, 1), law_of_run, constraints);
      const MotionState state{robot.position, robot.velocity, robot.heading, *robot.loiter};
      const Vec2 h = elementary::direction(robot.heading);
      Plan plan{.acceleration = loitering(airplane, state)};
      const auto flown = [&] {
        return fly(airplane, {robot.max_acceleration, robot.max_speed}, state, plan, 0.1);
      };
      const Vec2 backup = plan.acceleration;
      for (int tries = 0; tries < 8; ++tries) {
        plan.acceleration = test::in_disc(random, robot.max_acceleration) +
                            random.uniform(-2.0, 2.0) * perpendicular(h);
        if (keeps_flight(constraints, robot, flown())) break;
        plan.acceleration = backup;
      }
      admitted += plan.acceleration == backup ? 0 : 1;
      const FlightStep step = flown();
      const Moved moved = fly_on(robot, step, norm(step.motion.next.velocity));
      for (const Vec2 p : moved.places) ASSERT_GE(clear(p), robot.radius);
      robot = moved.robot;
      ASSERT_GE(clear(robot.loiter->center), robot.loiter->radius + robot.radius);
    }
  }
  EXPECT_GT(admitted, 5'000);
}

}  // namespace
}  // namespace avo
