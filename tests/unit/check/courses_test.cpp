// SPDX-License-Identifier: Apache-2.0
// The tests check discs of robots with headings on their true paths, against dense samples of
// closed forms.
#include <algorithm>
#include <cmath>
#include <functional>
#include <gtest/gtest.h>
#include <vector>

#include "support/generators.h"
#include "unit/check/headings.h"
#include "unit/check/sampled.h"

namespace avo::test {
namespace {

// Where its disc is at a time of the step.
using Way = std::function<Vec2(double)>;

struct Course {
  CheckedRobot robot;
  CheckedState from, to;
  Way way;
};

CheckedRobot disc(const CheckedKinematics& kinematics, double radius) {
  CheckedRobot robot = free_robot(radius);
  robot.kinematics = kinematics;
  return robot;
}

Course random_car(Random& random, double step) {
  const double offset = random.below(3) == 0 ? 0.0 : random.uniform(-1.5, 1.5);
  const double speed = random.uniform(0.0, 4.0), next = random.uniform(0.0, 4.0);
  const double sign = random.below(2) == 0 ? 1.0 : -1.0;
  const Held controls{sign * (next - speed) / step, random.uniform(-2.5, 2.5) / (4.0 * step)};
  const Vec2 place{random.uniform(-2, 2), random.uniform(-2, 2)};
  const CheckedState from = pose(place, random.uniform(-3, 3), sign * speed);
  return {disc(CheckedCar{.body_offset = offset, .reverse = true, .exact_set = true},
               random.uniform(0.1, 0.6)),
          from, driven(from, controls, step), [=](double t) {
            const CheckedState at = driven(from, controls, t);
            return at.position + offset * along(at.heading->angle);
          }};
}

// About its axle, by an angle that grows with the square of the time.
Course random_turn(Random& random, double step) {
  const double offset = random.uniform(-1.5, 1.5), angle = random.uniform(-3, 3);
  const double turn = random.uniform(-2, 2);
  const Vec2 place{random.uniform(-2, 2), random.uniform(-2, 2)};
  return {disc(CheckedCar{.body_offset = offset}, random.uniform(0.1, 0.6)),
          pose(place, angle, 0.0), pose(place, angle + turn, 0.0),
          [=](double t) { return place + offset * along(angle + turn * (t / step) * (t / step)); }};
}

Course random_drive(Random& random, double step) {
  const Towed towed{{random.uniform(-2, 2), random.uniform(-2, 2)},
                    random.uniform(0.1, 2.0) * random.direction(),
                    random.uniform(-2.5, 2.5),
                    random.uniform(0.2, 0.6)};
  CheckedRobot robot = disc(CheckedDrive{.offset = towed.offset}, random.uniform(0.1, 0.6));
  return {robot, towed.row(0.0), towed.row(step), [=](double t) { return towed.axle(t); }};
}

Course random_holonomic(Random& random, double step) {
  const Vec2 place{random.uniform(-2, 2), random.uniform(-2, 2)};
  const Vec2 v = test::in_disc(random, 4.0), a = test::in_disc(random, 4.0);
  const auto way = [=](double t) { return place + t * v + (0.5 * t * t) * a; };
  return {disc({}, random.uniform(0.1, 0.6)), {0, place, v}, {0, way(step), v + step * a}, way};
}

Course random_course(Random& random, int kind, double step) {
  switch (kind) {
    case 0:
      return random_car(random, step);
    case 1:
      return random_turn(random, step);
    case 2:
      return random_drive(random, step);
    default:
      return random_holonomic(random, step);
  }
}

double least_by_samples(const std::function<double(double)>& distance, double step) {
  return static_cast<double>(judge::least_by_samples([&](judge::Real u) {
    return static_cast<judge::Real>(distance(step * static_cast<double>(u)));
  }));
}

TEST(CheckCourses, clearances_of_pairs) {
  Random random(1);
  int overlaps = 0;
  for (int k = 0; k < 800 && !HasFailure(); ++k) {
    const double step = random.log_uniform(0.05, 0.3);
    const Course a = random_course(random, k % 4, step), b = random_course(random, k / 4 % 4, step);
    CheckedState from = b.from, to = b.to;
    from.robot = to.robot = 1;
    const CheckReport report =
        report_of({a.robot, b.robot}, {{0.0, {a.from, from}}, {step, {a.to, to}}});
    const double contact = a.robot.radius + b.robot.radius;
    const double least =
        least_by_samples([&](double t) { return norm(a.way(t) - b.way(t)); }, step) - contact;
    const double error = 2.0 * report.interpolation_error + 1e-12;
    EXPECT_NEAR(*report.least_clearance, least, error) << k;
    EXPECT_LE(error, 1e-5) << k;
    EXPECT_EQ(report.jumps.count, 0) << k;
    if (std::abs(least) < 2.0 * error + 1e-8) continue;
    EXPECT_EQ(report.overlaps.count, least < 0.0 ? 1 : 0) << k;
    if (least > 0.0) continue;
    EXPECT_NEAR(report.overlaps.worst, -least, 2.0 * error + 3e-9) << k;
    const double first = report.overlaps.first->time;
    EXPECT_LE(norm(a.way(first) - b.way(first)) - contact, error + 1e-8) << k;
    ++overlaps;
  }
  EXPECT_GT(overlaps, 50);
}

TEST(CheckCourses, clearances_from_walls) {
  Random random(2);
  int contacts = 0;
  for (int k = 0; k < 600 && !HasFailure(); ++k) {
    const double step = random.log_uniform(0.05, 0.3);
    const Course a = random_course(random, k % 3, step);
    const Vec2 p{random.uniform(-2, 2), random.uniform(-2, 2)}, q = p + 3.0 * random.direction();
    Check check({a.robot});
    check.set_walls({{p, q, 0.1}});
    check.add(0.0, std::vector{a.from});
    check.add(step, std::vector{a.to});
    const CheckReport report = check.report();
    const auto distance = [&](double t) {
      const Vec2 seen = a.way(t) - p, side = q - p;
      const double along_it = std::clamp(dot(seen, side) / dot(side, side), 0.0, 1.0);
      return norm(seen - along_it * side);
    };
    const double least = least_by_samples(distance, step) - a.robot.radius - 0.1;
    EXPECT_NEAR(*report.least_static_clearance, least, report.interpolation_error + 1e-12) << k;
    if (std::abs(least) < 1e-8) continue;
    EXPECT_EQ(report.static_contacts.count, least < 0.0 ? 1 : 0) << k;
    if (least < 0.0) ++contacts;
  }
  EXPECT_GT(contacts, 50);
}

// At speeds and limits of real ones.
TEST(CheckCourses, ways_are_known_to_a_tenth_of_a_nanometer) {
  const auto error = [](const CheckedRobot& robot, const CheckedState& from,
                        const CheckedState& to) {
    return report_of({robot}, {{0.0, {from}}, {0.1, {to}}}).interpolation_error;
  };
  const CheckedState start = pose({3, 4}, 1.0, 2.0);
  const double car =
      error(disc(CheckedCar{.body_offset = 0.5}, 0.5), start, driven(start, {-1.0, 0.8}, 0.1));
  EXPECT_LE(car, 1e-10);
  EXPECT_GT(car, 0.0);
  const Towed towed{{3, 4}, {0.4, 0.1}, 1.0, 0.2};
  EXPECT_LE(error(disc(CheckedDrive{.offset = 0.2}, 0.3), towed.row(0.0), towed.row(0.1)), 1e-10);
}

// The body swings out: its axle stays away, and both rows are clear.
TEST(CheckCourses, a_body_that_swings_touches_between_the_rows) {
  const CheckedRobot car = disc(CheckedCar{.body_offset = 1.0}, 0.5);
  const std::vector<Moment> recording{{0.0, {pose({0, 0}, -1.0, 0.0)}},
                                      {1.0, {pose({0, 0}, 1.0, 0.0)}}};
  const auto touched = [&](double x) {
    Check check({car});
    check.set_walls({{{x, 0}, {x, 0}, 0.1}});
    for (const Moment& moment : recording) check.add(moment.time, moment.rows);
    return check.report().static_contacts;
  };
  EXPECT_EQ(touched(1.6001).count, 0);
  EXPECT_EQ(touched(1.5999).count, 1);
  EXPECT_NEAR(touched(1.5999).first->time, std::sqrt(0.5), 0.02) << "half the angle";
}

// Seen though others are so near each other that nothing farther away tells anything new.
TEST(CheckCourses, a_body_that_swings_is_looked_for_all_along_its_way) {
  const std::vector<CheckedRobot> robots{disc(CheckedCar{.body_offset = 3.0}, 0.5), disc({}, 0.1),
                                         disc({}, 0.5), disc({}, 0.5)};
  const CheckedState post{1, {3, 0}, {}}, one{2, {0, 50}, {}}, other{3, {0, 51}, {}};
  const CheckReport report = report_of(robots, {{0.0, {pose({0, 0}, -1.5, 0.0), post, one, other}},
                                                {1.0, {pose({0, 0}, 1.5, 0.0), post, one, other}}});
  EXPECT_EQ(report.overlaps.count, 1);
  EXPECT_NEAR(*report.least_clearance, -0.6, 1e-6);
}

// One that turns in place moves its body: a contact meanwhile is one in motion.
TEST(CheckCourses, whoever_turns_its_body_moves) {
  const auto contacts = [](double offset) {
    Check check({disc(CheckedCar{.body_offset = offset}, 0.5)}, {{{0, 0}, {}, {}, 0.6}});
    check.add(0.0, std::vector{pose({0, 0}, 0.0, 0.0)});
    check.add(0.1, std::vector{pose({0, 0}, 0.01, 0.0)});
    return check.report();
  };
  EXPECT_EQ(contacts(0.3).mover_contacts_moving.count, 1);
  EXPECT_EQ(contacts(0.0).mover_contacts_moving.count, 0);
  EXPECT_EQ(contacts(0.0).mover_contacts_at_rest, 1);
}

// In its first row, and where it comes back after a gap.
TEST(CheckCourses, a_body_is_ahead_in_single_rows_too) {
  const CheckedRobot car = disc(CheckedCar{.body_offset = 1.0}, 0.5);
  const CheckReport report =
      report_of({car, disc({}, 0.5)}, {{0.0, {pose({0, 0}, 0.0, 0.0), {1, {1.9, 0}, {}}}}});
  EXPECT_EQ(report.overlaps.count, 1);
  EXPECT_NEAR(*report.least_clearance, -0.1, 1e-12);
}

}  // namespace
}  // namespace avo::test
