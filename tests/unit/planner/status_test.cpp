// SPDX-License-Identifier: Apache-2.0
// How a decision was made: every status, bad input, bad options (paper §IV-D and beyond).
#include <cfenv>
#include <cmath>
#include <functional>
#include <gtest/gtest.h>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "avo/error.h"
#include "unit/planner/crowds.h"

namespace avo {
namespace {

using test::as_neighbor;
using test::paper_robot;

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

Plan decide(const PlannerOptions& options, const Robot& robot,
            const std::vector<Neighbor>& neighbors) {
  PlanWorkspace workspace;
  return Planner(options).plan(robot, neighbors, workspace);
}

bool finite(const Plan& plan) {
  return is_finite(plan.new_velocity) && is_finite(plan.acceleration) &&
         std::isfinite(plan.violation);
}

TEST(Status, optimal_takes_the_preferred_velocity_where_nothing_is_near) {
  const Robot robot = paper_robot({3, 4}, {0.3, -0.1}, {1.1, 0.7});
  const Plan plan = decide({}, robot, {});
  EXPECT_EQ(plan.status, PlanStatus::optimal);
  EXPECT_EQ(plan.new_velocity, robot.preferred_velocity);
  EXPECT_EQ(plan.violation, 0.0);
  const Vec2 expected = (robot.preferred_velocity - robot.velocity) / 4.0;  // Eq. (7)
  EXPECT_EQ(plan.acceleration, expected);
}

TEST(Status, at_rest_among_robots_at_rest_is_finite_and_optimal) {
  std::vector<Neighbor> neighbors;
  for (const Vec2 p : {Vec2{3, 0}, Vec2{-3, 0}, Vec2{0, 3}, Vec2{0, -3}}) {
    neighbors.push_back(as_neighbor(paper_robot(p, {}, {})));
  }
  const Plan plan = decide({}, paper_robot({}, {}, {}), neighbors);
  EXPECT_TRUE(finite(plan));
  EXPECT_EQ(plan.status, PlanStatus::optimal);
  EXPECT_EQ(plan.new_velocity, Vec2{});
}

TEST(Status, least_unsafe_where_all_come_at_once) {
  std::vector<Neighbor> neighbors;
  for (const Vec2 n : {Vec2{1, 0}, Vec2{-0.6, 0.8}, Vec2{-0.6, -0.8}}) {
    neighbors.push_back(as_neighbor(paper_robot(2.0 * n, -2.0 * n, {})));
  }
  const Robot robot = paper_robot({}, {}, {1, 0});
  const Plan plan = decide({}, robot, neighbors);
  EXPECT_EQ(plan.status, PlanStatus::least_unsafe);
  EXPECT_GT(plan.violation, 0.1);

  // the violation is that of the worst half-plane
  const Planner planner{PlannerOptions{}};
  PlanWorkspace workspace;
  planner.collect_half_planes(robot, neighbors, workspace);
  ASSERT_EQ(workspace.planes.size(), 3u);
  double worst = 0.0;
  for (const NeighborPlane& each : workspace.planes) {
    worst = std::max(worst, violation(each.plane, plan.new_velocity));
  }
  EXPECT_NEAR(plan.violation, worst, 1e-12);
}

TEST(Status, overlapping_separates) {
  const Robot robot = paper_robot({}, {0.5, 0}, {1, 0});
  const Neighbor other = as_neighbor(paper_robot({0.9, 0.1}, {-0.5, 0}, {}));
  for (const double delta : {0.2, 4.0}) {
    PlannerOptions options;
    options.control_time = delta;
    const Plan plan = decide(options, robot, {other});
    EXPECT_EQ(plan.status, PlanStatus::overlapping);
    EXPECT_LT(dot(plan.new_velocity - robot.velocity, other.position), 0.0);
  }
}

TEST(Status, overlapping_with_equal_centers_and_velocities_is_finite) {
  const Robot robot = paper_robot({1, 2}, {0.5, 0}, {1, 0});
  for (const Method method : {Method::avo_paper, Method::velocity_obstacle, Method::orca}) {
    PlannerOptions options;
    options.method = method;
    const Plan plan = decide(options, robot, {as_neighbor(robot)});
    EXPECT_EQ(plan.status, PlanStatus::overlapping);
    EXPECT_TRUE(finite(plan));
    // no direction can be told: no plane, rather than one that is not a number
    PlanWorkspace workspace;
    Planner(options).collect_half_planes(robot, std::vector<Neighbor>{as_neighbor(robot)},
                                         workspace);
    EXPECT_TRUE(workspace.planes.empty());
    EXPECT_TRUE(workspace.overlapping);
  }
}

// |v| beyond v_max + δ a_max: no velocity keeps both limits.
TEST(Status, braking_where_the_speed_limit_is_out_of_reach) {
  for (const Motion motion : {Motion::held, Motion::exponential}) {
    PlannerOptions options;
    options.motion = motion;
    options.control_time = 2.0;
    const Robot robot = paper_robot({}, {0, -5}, {0, -2});  // v_max 2, δ a_max 2
    const Plan plan = decide(options, robot, {});
    EXPECT_EQ(plan.status, PlanStatus::braking);
    EXPECT_NEAR(plan.violation, 1.0, 1e-12);
    EXPECT_NEAR(plan.acceleration.y, 1.0, 1e-12);
    EXPECT_EQ(plan.acceleration.x, 0.0);
    const Robot within = paper_robot({}, {0, -3.999}, {0, -2});
    EXPECT_EQ(decide(options, within, {}).status, PlanStatus::optimal);
  }
}

using Change = std::function<void(Robot&, Neighbor&, double)>;

struct Field {
  std::string name;
  Change set;
  bool positive = false;      // must be > 0
  bool not_negative = false;  // must be >= 0
  bool braking_needs_it = false;
};

std::vector<Field> all_fields() {
  return {
      {"position.x", [](Robot& A, Neighbor&, double x) { A.position.x = x; }},
      {"position.y", [](Robot& A, Neighbor&, double x) { A.position.y = x; }},
      {"velocity.x", [](Robot& A, Neighbor&, double x) { A.velocity.x = x; }, false, false, true},
      {"velocity.y", [](Robot& A, Neighbor&, double x) { A.velocity.y = x; }, false, false, true},
      {"preferred.x", [](Robot& A, Neighbor&, double x) { A.preferred_velocity.x = x; }},
      {"preferred.y", [](Robot& A, Neighbor&, double x) { A.preferred_velocity.y = x; }},
      {"radius", [](Robot& A, Neighbor&, double x) { A.radius = x; }, true},
      {"max_acceleration", [](Robot& A, Neighbor&, double x) { A.max_acceleration = x; }, true,
       false, true},
      {"max_speed", [](Robot& A, Neighbor&, double x) { A.max_speed = x; }, true, false, true},
      {"B.position.x", [](Robot&, Neighbor& B, double x) { B.position.x = x; }},
      {"B.position.y", [](Robot&, Neighbor& B, double x) { B.position.y = x; }},
      {"B.velocity.x", [](Robot&, Neighbor& B, double x) { B.velocity.x = x; }},
      {"B.velocity.y", [](Robot&, Neighbor& B, double x) { B.velocity.y = x; }},
      {"B.radius", [](Robot&, Neighbor& B, double x) { B.radius = x; }, true},
      {"B.max_acceleration", [](Robot&, Neighbor& B, double x) { B.max_acceleration = x; }, false,
       true},
      {"B.acceleration.x", [](Robot&, Neighbor& B, double x) { B.acceleration.x = x; }},
      {"B.acceleration.y", [](Robot&, Neighbor& B, double x) { B.acceleration.y = x; }},
  };
}

std::vector<double> bad_values(const Field& field) {
  std::vector<double> bad{kNaN, -kNaN, kInfinity, -kInfinity, 1e300, -1e300};
  if (field.positive) bad.insert(bad.end(), {0.0, -0.0, -1.0, 5e-324});
  if (field.not_negative) bad.push_back(-1e-300);
  return bad;
}

// In release builds as well: this file is compiled with the flags of the build it belongs to.
TEST(Status, invalid_input_is_told_and_brakes_whatever_field_it_is) {
  for (const Method method : {Method::avo_paper, Method::velocity_obstacle, Method::orca}) {
    PlannerOptions options;
    options.method = method;
    const Planner planner(options);
    for (const Field& field : all_fields()) {
      for (const double value : bad_values(field)) {
        Robot robot = paper_robot({1, 2}, {1.2, -0.9}, {2, 0});
        Neighbor other = as_neighbor(paper_robot({5, 2}, {-1, 0}, {}));
        field.set(robot, other, value);
        const std::vector<Neighbor> neighbors{as_neighbor(paper_robot({-4, 2}, {}, {})), other};
        PlanWorkspace workspace;
        for (const bool among_movers : {false, true}) {
          const Plan plan = among_movers ? planner.plan_among_obstacles(robot, neighbors, workspace)
                                         : planner.plan(robot, neighbors, workspace);
          SCOPED_TRACE(field.name + " = " + std::to_string(value));
          EXPECT_EQ(plan.status, PlanStatus::invalid_input);
          EXPECT_TRUE(finite(plan));
          if (field.braking_needs_it) continue;
          // straight back, within the limits
          EXPECT_LT(dot(plan.acceleration, robot.velocity), -0.5);
          EXPECT_LE(norm(plan.new_velocity), robot.max_speed * (1.0 + 1e-12));
          EXPECT_NEAR(cross(plan.acceleration, robot.velocity), 0.0, 1e-15);
          if (method != Method::avo_paper) continue;
          EXPECT_LE(norm(plan.acceleration), robot.max_acceleration * (1.0 + 1e-12));
        }
      }
    }
  }
}

// A robot that knows nothing useful of itself: the command is a stop, and a number.
TEST(Status, invalid_velocity_or_limits_command_rest) {
  Robot robot = paper_robot({}, {kNaN, 1}, {1, 0});
  const Plan plan = decide({}, robot, {});
  EXPECT_EQ(plan.new_velocity, Vec2{});
  EXPECT_EQ(plan.acceleration, Vec2{});
}

TEST(Status, braking_comes_to_rest_within_the_step_where_it_can) {
  for (const Motion motion : {Motion::held, Motion::exponential}) {
    PlannerOptions options;
    options.motion = motion;
    const Planner planner(options);
    Robot robot = paper_robot({kNaN, 0}, {0.03, 0.04}, {1, 0});
    PlanWorkspace workspace;
    const Plan plan = planner.plan(robot, {}, workspace);
    const Vec2 next = robot.velocity + planner.step_rate() * (plan.new_velocity - robot.velocity);
    EXPECT_NEAR(norm(next), 0.0, 1e-15);
  }
}

// Any number that passes is a number that can be planned with: 300 decades and more.
TEST(Status, extreme_numbers_never_make_a_NaN) {
  test::Random random(30);
  const auto extreme = [&]() -> double {
    const double sign = random.below(2) == 0 ? 1.0 : -1.0;
    switch (random.below(4)) {
      case 0:
        return 0.0;
      case 1:
        return sign * std::pow(10.0, random.uniform(-320.0, 12.0));
      case 2:
        return sign * 1e12;
      default:
        return sign * random.uniform(0.0, 3.0);
    }
  };
  const auto positive = [&] { return std::max(std::abs(extreme()), 1e-60); };
  int decided = 0;
  for (int k = 0; k < 30'000 && !HasFailure(); ++k) {
    test::Crowd crowd;
    crowd.options.control_time = random.log_uniform(0.1, 8.0);
    crowd.options.method = static_cast<Method>(k % 3);
    crowd.robot = {{extreme(), extreme()},
                   {extreme(), extreme()},
                   {extreme(), extreme()},
                   positive(),
                   positive(),
                   positive()};
    for (int j = random.below(4); j > 0; --j) {
      crowd.neighbors.push_back({{extreme(), extreme()},
                                 {extreme(), extreme()},
                                 positive(),
                                 std::abs(extreme()),
                                 {extreme(), extreme()}});
    }
    PlanWorkspace workspace;
    const Planner planner(crowd.options);
    for (const bool alone : {false, true}) {
      const Plan plan = alone
                            ? planner.plan_among_obstacles(crowd.robot, crowd.neighbors, workspace)
                            : planner.plan(crowd.robot, crowd.neighbors, workspace);
      EXPECT_TRUE(finite(plan)) << to_string(plan.status) << (alone ? " alone\n" : "\n") << crowd;
      EXPECT_NE(plan.status, PlanStatus::invalid_input);
      ++decided;
    }
  }
  EXPECT_EQ(decided, 60'000);
}

// No 0/0, no root of a negative number, no comparison with a NaN on the way to any decision: what
// is undefined is asked for before, not afterwards by how NaN compares.
TEST(Status, no_decision_rests_on_an_invalid_operation) {
#ifdef __clang__
  GTEST_SKIP() << "this compiler may compute both sides of a branch";
#endif
  test::Random random(31);
  for (int k = 0; k < 30'000 && !HasFailure(); ++k) {
    test::Crowd crowd = test::random_crowd(random, -0.9);
    if (k % 8 == 0) crowd.robot.velocity = 3.0 * crowd.robot.velocity;
    crowd.options.method = k % 4 == 3 ? Method::orca : Method::avo_paper;
    const Planner planner(crowd.options);
    PlanWorkspace workspace;
    std::feclearexcept(FE_ALL_EXCEPT);
    const Plan plan = planner.plan(crowd.robot, crowd.neighbors, workspace);
    EXPECT_FALSE(std::fetestexcept(FE_INVALID | FE_DIVBYZERO)) << to_string(plan.status) << crowd;
    if (k % 20 > 0) continue;
    const Plan alone = planner.plan_among_obstacles(crowd.robot, crowd.neighbors, workspace);
    EXPECT_FALSE(std::fetestexcept(FE_INVALID)) << to_string(alone.status) << "\n" << crowd;
  }
}

TEST(Status, names) {
  EXPECT_STREQ(to_string(PlanStatus::optimal), "optimal");
  EXPECT_STREQ(to_string(PlanStatus::least_unsafe), "least_unsafe");
  EXPECT_STREQ(to_string(PlanStatus::overlapping), "overlapping");
  EXPECT_STREQ(to_string(PlanStatus::braking), "braking");
  EXPECT_STREQ(to_string(PlanStatus::invalid_input), "invalid_input");
}

void expect_refused(const PlannerOptions& options, const std::string& field) {
  try {
    const Planner planner(options);
    FAIL() << field << " was accepted";
  } catch (const Error& error) {
    const std::string what = error.what();
    EXPECT_NE(what.find("PlannerOptions." + field), std::string::npos) << what;
    EXPECT_NE(what.find("must be"), std::string::npos) << what;
  }
}

TEST(Options, out_of_range_are_refused_by_name) {
  for (const double bad : {0.0, -0.0, -1.0, kNaN, kInfinity, -kInfinity}) {
    PlannerOptions options;
    options.control_time = bad;
    expect_refused(options, "control_time");
    options = {};
    options.time_horizon = bad;
    expect_refused(options, "time_horizon");
    options = {};
    options.time_step = bad;
    expect_refused(options, "time_step");
  }
  for (const int bad : {-1, 1, -1000}) {
    PlannerOptions options;
    options.samples = bad;
    expect_refused(options, "samples");
  }
  PlannerOptions options;
  options.samples = 2;
  EXPECT_NO_THROW(const Planner planner(options));
}

}  // namespace
}  // namespace avo
