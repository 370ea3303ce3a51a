// SPDX-License-Identifier: Apache-2.0
// Which rows are taken, robots that come and go, and what a path between rows may be off.
#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <limits>
#include <vector>

#include "support/generators.h"
#include "unit/check/recordings.h"

namespace avo {
namespace {

using test::free_robot;
using test::Moment;
using test::refusal;
using test::report_of;

TEST(CheckRows, are_counted) {
  const CheckReport report =
      report_of({free_robot(), free_robot(), free_robot()}, {{1.0, {{0, {}, {}}, {2, {9, 0}, {}}}},
                                                             {1.5, {{0, {}, {}}, {2, {9, 0}, {}}}},
                                                             {4.0, {{0, {}, {}}}}});
  EXPECT_EQ(report.robots, 2);
  EXPECT_EQ(report.rows, 5);
  EXPECT_EQ(report.steps, 2);
  EXPECT_EQ(report.robot_steps, 3);
  EXPECT_EQ(report.gaps, 0);
  EXPECT_EQ(report.from, 1.0);
  EXPECT_EQ(report.to, 4.0);
}

TEST(CheckRows, nothing_is_said_of_nothing) {
  const CheckReport report = Check({}).report();
  EXPECT_EQ(report.rows, 0);
  EXPECT_EQ(report.steps, 0);
  EXPECT_TRUE(report.safe());
}

// Robot 1 is away at 1 s and back elsewhere at 2 s: no jump, no step through robot 0.
TEST(CheckRows, a_robot_is_not_judged_where_it_is_missing) {
  CheckedRobot limited;
  const std::vector<Moment> recording{{0.0, {{0, {0, 0}, {}}, {1, {-3, 0}, {}}}},
                                      {1.0, {{0, {0, 0}, {}}}},
                                      {2.0, {{0, {0, 0}, {}}, {1, {3, 0}, {1, 0}}}},
                                      {3.0, {{0, {0, 0}, {}}, {1, {4, 0}, {1, 0}}}}};
  const CheckReport report = report_of({limited, limited}, recording);
  EXPECT_TRUE(report.safe());
  EXPECT_EQ(report.gaps, 1);
  EXPECT_EQ(report.robot_steps, 4);
  EXPECT_EQ(report.least_clearance, 2.0);
  std::vector<Moment> without_gap = recording;
  without_gap.erase(without_gap.begin() + 1);
  EXPECT_EQ(report_of({limited, limited}, without_gap).overlaps.count, 1);
  EXPECT_EQ(report_of({limited, limited}, without_gap).jumps.count, 1);
}

// The robots go through each other and through a wall, on a path that no row tells. The check still
// judges what the rows tell, and what a_max allows over any time.
TEST(CheckRows, the_way_to_rows_after_some_that_are_missing_is_not_judged) {
  const auto skipped = [](Vec2 to, Vec2 velocity) {
    Check check({{.goal = Vec2{9, 0}}, {}});
    check.set_walls({{{5, -3}, {5, 3}, 0.1}});
    check.skip();  // before the first rows: nothing
    check.add(0.0, std::vector<CheckedState>{{0, {0, 0}, {}}, {1, {9, 0}, {}}});
    check.skip();
    check.add(10.0, std::vector<CheckedState>{{0, to, velocity}, {1, {0, 0}, {}}});
    return check.report();
  };
  const CheckReport through = skipped({9, 0}, {});
  EXPECT_FALSE(through.broken());
  EXPECT_FALSE(through.safe());
  EXPECT_EQ(through.unjudged_steps, 1);
  EXPECT_EQ(through.steps, 1);
  EXPECT_EQ(through.robot_steps, 0);
  EXPECT_EQ(through.gaps, 0);
  EXPECT_EQ(through.arrived, 1);
  EXPECT_EQ(through.least_clearance, 8.0) << "in the rows";
  EXPECT_EQ(skipped({0.5, 0}, {}).overlaps.count, 1);
  EXPECT_EQ(skipped({4.5, 0}, {}).static_contacts.count, 1);
  EXPECT_EQ(skipped({9, 0}, {2.5, 0}).speeds.count, 1);
  EXPECT_EQ(skipped({60, 0}, {}).jumps.count, 1);
}

TEST(CheckRows, a_robot_may_not_appear_within_another) {
  const CheckReport report =
      report_of({free_robot(), free_robot()}, {{0.0, {{0, {0, 0}, {1, 0}}}},
                                               {1.0, {{0, {1, 0}, {1, 0}}, {1, {1.5, 0}, {9, 0}}}},
                                               {2.0, {{0, {2, 0}, {1, 0}}, {1, {20, 0}, {9, 0}}}}});
  EXPECT_EQ(report.overlaps.count, 1);
  EXPECT_EQ(report.overlaps.first->time, 1.0) << "it was not there before";
  EXPECT_EQ(report.least_clearance, -0.5);
}

TEST(CheckRows, robots_may_be_added_later) {
  Check check({});
  EXPECT_EQ(check.add_robot(free_robot()), 0);
  check.add(0.0, std::vector<CheckedState>{{0, {}, {}}});
  EXPECT_EQ(check.add_robot(free_robot(3.0)), 1);
  check.add(1.0, std::vector<CheckedState>{{0, {}, {}}, {1, {3, 0}, {}}});
  EXPECT_EQ(check.report().overlaps.count, 1);
}

TEST(CheckRows, bad_rows_are_refused_and_change_nothing) {
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  Check check({free_robot(), free_robot()});
  const auto add = [&check](double time, const std::vector<CheckedState>& rows) {
    return refusal([&] { check.add(time, rows); });
  };
  EXPECT_EQ(add(1.0, {{0, {}, {}}, {1, {5, 0}, {}}}), "");
  EXPECT_EQ(add(1.0, {}), "time: found 1 s, must be at least 1e-12 s after the time before, 1 s");
  EXPECT_EQ(add(kNan, {}), "time: found nan, must be a finite number");
  EXPECT_EQ(add(2.0, {{1, {}, {}}, {0, {}, {}}}),
            "robot: found 0, must be 2 to 1, each once and ascending");
  EXPECT_EQ(add(2.0, {{0, {}, {}}, {0, {}, {}}}),
            "robot: found 0, must be 1 to 1, each once and ascending");
  EXPECT_EQ(add(2.0, {{2, {}, {}}}), "robot: found 2, must be 0 to 1, each once and ascending");
  EXPECT_EQ(add(2.0, {{-1, {}, {}}}), "robot: found -1, must be 0 to 1, each once and ascending");
  EXPECT_EQ(add(2.0, {{0, {}, {}}, {1, {0, kNan}, {}}}),
            "robot 1: position.1: found nan, must be a finite number");
  EXPECT_EQ(add(2.0, {{0, {}, {-2e12, 0}}}),
            "robot 0: velocity.0: found -2e+12, must be >= -1e+12 m/s");
  EXPECT_EQ(check.report().rows, 2);
  EXPECT_EQ(add(2.0, {{0, {}, {}}, {1, {5, 0}, {}}}), "");
  EXPECT_EQ(check.report().robot_steps, 2);
}

TEST(CheckRows, bad_rules_are_refused) {
  const auto robot = [](auto change) {
    CheckedRobot result;
    change(result);
    return refusal([&] { Check({{}, result}); });
  };
  EXPECT_EQ(robot([](CheckedRobot& r) { r.radius = 0.0; }),
            "robots.1.radius: found 0, must be > 0 m");
  EXPECT_EQ(robot([](CheckedRobot& r) { r.max_speed = -1.0; }),
            "robots.1.max_speed: found -1, must be > 0 m/s");
  EXPECT_EQ(robot([](CheckedRobot& r) { r.max_acceleration = std::nan(""); }),
            "robots.1.max_acceleration: found nan, must be a finite number");
  EXPECT_EQ(robot([](CheckedRobot& r) { r.interpolation_error = -1e-9; }),
            "robots.1.interpolation_error: found -1e-09, must be >= 0 m");
  EXPECT_EQ(robot([](CheckedRobot& r) {
              r.goal = {0, 1e13};
            }),
            "robots.1.goal.1: found 1e+13, must be <= 1e+12 m");
  EXPECT_EQ(refusal([] { Check({}, {{.radius = -1.0}}); }),
            "movers.0.radius: found -1, must be > 0 m");
  EXPECT_EQ(refusal([] { Check({}, {}, {.relative_tolerance = 1.0}); }),
            "relative_tolerance: found 1, must be >= 0 and < 1");
  EXPECT_EQ(refusal([] { Check({}, {}, {.arrival_distance = 0.0}); }),
            "arrival_distance: found 0, must be > 0 m");
}

// Five thousand robots in one place are twelve million pairs.
TEST(CheckRows, more_pairs_than_anyone_wants_to_know_are_refused) {
  std::vector<CheckedState> rows;
  for (std::int64_t i = 0; i < 5'000; ++i) rows.push_back({i, {}, {}});
  Check check(std::vector<CheckedRobot>(5'000, free_robot()));
  EXPECT_EQ(refusal([&] { check.add(0.0, rows); }), "found more than 10000000 overlapping pairs");
}

// A car with speed v + a t and curvature κ, t from 0 to `step`.
Vec2 arc(double speed, double change, double curvature, double t) {
  const double way = speed * t + 0.5 * change * t * t, half = 0.5 * curvature * way;
  return (std::abs(half) < 1e-9 ? way : way * std::sin(half) / half) *
         Vec2{std::cos(half), std::sin(half)};
}

// Bounds the cubic's distance from the arc, and not much too widely unless the car is at rest.
TEST(CheckRows, the_error_of_a_car_is_reckoned_from_its_rows) {
  test::Random random(5);
  CheckedRobot car = free_robot();
  car.kinematics = CheckedCar{};
  car.max_acceleration = 1.0;
  int tight = 0;
  for (int k = 0; k < 3'000 && !HasFailure(); ++k) {
    const double step = 0.1, top = random.log_uniform(0.1, 3.0);
    const Vec2 limit = test::in_disc(random, 1.0);  // (a, v² κ)
    const double curvature = limit.y / (top * top);
    const double change = limit.x, speed = change > 0.0 ? std::max(top - change * step, 0.0) : top;
    const double next = std::max(speed + change * step, 0.0);
    const double turn = curvature * 0.5 * (speed + next) * step;
    const Vec2 to = arc(speed, change, curvature, step);
    const Vec2 v0{speed, 0}, v1 = next * Vec2{std::cos(turn), std::sin(turn)};
    const CheckReport report = report_of({car}, {{0.0, {{0, {}, v0}}}, {step, {{0, to, v1}}}});
    double error = 0.0;
    for (int i = 0; i <= 100; ++i) {
      const double u = i / 100.0, q = 1.0 - u;
      const Vec2 cubic = (3 * q * q * u * step / 3.0) * v0 +
                         (3 * q * u * u) * (to - (step / 3.0) * v1) + (u * u * u) * to;
      error = std::max(error, norm(cubic - arc(speed, change, curvature, u * step)));
    }
    EXPECT_LE(error, report.interpolation_error + 1e-15) << "top speed " << top;
    if (error > 1e-12 && report.interpolation_error < 3.0 * error) ++tight;
    EXPECT_EQ(report.jumps.count + report.accelerations.count, 0);
  }
  EXPECT_GT(tight, 1'000);
}

// A step that begins or ends at rest: no heading is known, |p''| <= a_max is.
TEST(CheckRows, the_error_of_a_car_at_rest_is_that_of_any_motion) {
  CheckedRobot car = free_robot();
  car.kinematics = CheckedCar{};
  car.max_acceleration = 2.0;
  const std::vector<Moment> start{{0.0, {{0, {}, {}}}}, {0.5, {{0, {0.25, 0}, {1, 0}}}}};
  EXPECT_EQ(report_of({car}, start).interpolation_error, 2.0 * 0.25 / 16.0);
}

}  // namespace
}  // namespace avo
