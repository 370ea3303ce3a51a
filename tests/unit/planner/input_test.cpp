// SPDX-License-Identifier: Apache-2.0
// What is known or sensed may be any number: bad ones are told, and none makes a NaN.
#include <array>
#include <cfenv>
#include <cmath>
#include <cstdint>
#include <functional>
#include <gtest/gtest.h>
#include <optional>
#include <string>
#include <vector>

#include "unit/planner/crowds.h"

namespace avo {
namespace {

using test::as_neighbor;
using test::kInfinity;
using test::kNaN;
using test::paper_robot;

bool finite(const Plan& plan) {
  return is_finite(plan.new_velocity) && is_finite(plan.next_velocity) &&
         is_finite(plan.acceleration) && std::isfinite(plan.violation);
}

constexpr Method kMethods[] = {Method::avo,
                               Method::avo_paper,
                               Method::velocity_obstacle,
                               Method::orca,
                               Method::orca_clamped,
                               Method::reciprocal_velocity_obstacle,
                               Method::buffered_voronoi};

using Change = std::function<void(Robot&, Neighbor&, double)>;

struct Field {
  std::string name;
  Change set;
  bool positive = false;    // must be > 0
  bool above_zero = false;  // must be > 0, however little
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
      {"max_braking", [](Robot& A, Neighbor&, double x) { A.max_braking = x; }, true, false, true},
      {"B.max_braking", [](Robot&, Neighbor& B, double x) { B.max_braking = x; }, true},
      {"B.acceleration.x", [](Robot&, Neighbor& B, double x) { B.acceleration.x = x; }},
      {"B.acceleration.y", [](Robot&, Neighbor& B, double x) { B.acceleration.y = x; }},
      {"B.max_deviation", [](Robot&, Neighbor& B, double x) { B.age = 1, B.max_deviation = x; }},
  };
}

std::vector<double> bad_values(const Field& field) {
  std::vector<double> bad{kNaN, -kNaN, kInfinity, -kInfinity, 1e300, -1e300};
  if (field.positive) bad.insert(bad.end(), {0.0, -0.0, -1.0, 5e-324});
  if (field.above_zero) bad.insert(bad.end(), {0.0, -0.0, -1e-300});
  return bad;
}

// In release builds as well: this file is compiled with the flags of the build it belongs to.
TEST(Status, invalid_input_is_told_and_brakes_whatever_field_it_is) {
  for (const Method method : kMethods) {
    const Planner planner(default_options(method));
    for (const Field& field : all_fields()) {
      for (const double value : bad_values(field)) {
        Robot robot = paper_robot({1, 2}, {1.2, -0.9}, {2, 0});
        Neighbor other = as_neighbor(paper_robot({5, 2}, {-1, 0}, {}));
        field.set(robot, other, value);
        const std::vector<Neighbor> neighbors{as_neighbor(paper_robot({-4, 2}, {}, {})), other};
        PlanWorkspace workspace;
        for (const bool among_movers : {false, true}) {
          const Plan plan = among_movers ? planner.plan_among_movers(robot, neighbors, workspace)
                                         : planner.plan(robot, neighbors, workspace);
          SCOPED_TRACE(field.name + " = " + std::to_string(value));
          EXPECT_EQ(plan.status, PlanStatus::invalid_input);
          EXPECT_TRUE(finite(plan));
          if (field.braking_needs_it) continue;
          // straight back, within the limits
          EXPECT_LT(dot(plan.acceleration, robot.velocity), -0.5);
          EXPECT_LE(norm(plan.new_velocity), robot.max_speed * (1.0 + 1e-12));
          EXPECT_NEAR(cross(plan.acceleration, robot.velocity), 0.0, 1e-15);
          if (adopts_at_once(method)) continue;
          EXPECT_LE(norm(plan.acceleration), robot.max_acceleration * (1.0 + 1e-12));
        }
      }
    }
  }
}

// What plan() refuses has no certificate and no half-planes: that is said, not thrown.
TEST(Status, of_invalid_input_every_question_has_an_answer) {
  for (const Method method : {Method::avo, Method::avo_paper}) {
    const Planner planner(default_options(method));
    PlanWorkspace workspace;
    const auto expect_nothing = [&](const Robot& robot, const std::vector<Neighbor>& seen,
                                    const std::vector<Wall>& walls) {
      std::vector<CertificateConstraint> constraints(1);
      EXPECT_NO_THROW(planner.collect_certificate(robot, seen, workspace, constraints, walls));
      EXPECT_TRUE(constraints.empty());
      HalfPlanes half_planes{{NeighborPlane{}}, true};
      EXPECT_NO_THROW(planner.collect_half_planes(robot, seen, workspace, half_planes, walls));
      EXPECT_TRUE(half_planes.planes.empty());
      const std::array<Vec2, 1> wanted{robot.velocity};
      std::array<std::uint8_t, 1> admitted{1};
      EXPECT_NO_THROW(planner.find_admitted(robot, seen, workspace, wanted, admitted, walls));
      EXPECT_EQ(admitted[0], 0);
      EXPECT_EQ(planner.state(robot, seen, workspace, walls).state, SafetyState::unknown);
      std::vector<WallConstraint> of_walls;
      WallPlanes wall_planes;
      EXPECT_NO_THROW(planner.collect_certificate(robot, walls, workspace, of_walls));
      EXPECT_NO_THROW(planner.collect_half_planes(robot, walls, wall_planes));
    };
    const Robot good = paper_robot({1, 2}, {1.2, -0.9}, {2, 0});
    for (const Field& field : all_fields()) {
      for (const double value : bad_values(field)) {
        SCOPED_TRACE(field.name + " = " + std::to_string(value));
        Robot robot = good;
        Neighbor other = as_neighbor(paper_robot({5, 2}, {-1, 0}, {}));
        field.set(robot, other, value);
        expect_nothing(robot, {other}, {{{0, 9}, {9, 9}}});
      }
    }
    for (const double value : {kNaN, kInfinity}) {
      expect_nothing(good, {as_neighbor(good)}, {{{0, value}, {9, 9}}});
      expect_nothing(good, {}, {{{0, 9}, {9, 9}, value}});
    }
  }
}

// It cannot stop: it holds its speed and turns right, for which it need not know where it is.
TEST(Status, an_airplane_that_does_not_know_its_place_flies_on) {
  const Planner planner(default_options(Method::avo));
  PlanWorkspace workspace;
  Robot lost = paper_robot({1, 2}, {2, 0}, {2, 0});
  lost.model = Airplane{.min_speed = 1.0};
  const Plan known = planner.plan(lost, {}, workspace);
  EXPECT_NE(known.status, PlanStatus::invalid_input);
  const LoiterCircle circle = loiter_circle(Airplane{.min_speed = 1.0}, {1, 2}, {2, 0});
  for (const bool has_circle : {false, true}) {
    for (const double x : {kInfinity, -kInfinity, kNaN, 1e300}) {
      lost.position.x = x;
      lost.loiter = has_circle ? std::optional(circle) : std::nullopt;
      const Plan plan = planner.plan(lost, {}, workspace);
      EXPECT_EQ(plan.status, PlanStatus::invalid_input);
      EXPECT_TRUE(finite(plan)) << x;
      EXPECT_NEAR(norm(plan.next_velocity), 2.0, 1e-6);
      EXPECT_LT(plan.next_velocity.y, 0.0) << "to the right";
    }
  }
  lost.position = {1, 2}, lost.loiter = LoiterCircle{{kNaN, 0}, 4.0};
  const Plan plan = planner.plan(lost, {}, workspace);
  EXPECT_TRUE(finite(plan));
  EXPECT_NEAR(norm(plan.next_velocity), 2.0, 1e-6);
}

// A car brakes along its heading, and others see only the direction in which it moves.
TEST(Status, a_car_that_moves_off_its_heading_is_invalid) {
  for (const Method method : {Method::avo, Method::avo_paper}) {
    const Planner planner(default_options(method));
    PlanWorkspace workspace;
    test::Random random(33);
    for (int k = 0; k < 2000; ++k) {
      const double heading = random.uniform(-10.0, 10.0);
      const Vec2 along{std::cos(heading), std::sin(heading)}, across{-along.y, along.x};
      Robot car = paper_robot({}, {}, 1.5 * along);
      car.model = Car{1.0}, car.heading = heading;
      const std::vector<Neighbor> neighbors{
          as_neighbor(paper_robot(6.0 * along, -1.0 * along, {}))};
      const auto status = [&](Vec2 velocity) {
        car.velocity = velocity;
        const Plan plan = planner.plan(car, neighbors, workspace);
        EXPECT_EQ(planner.plan_among_movers(car, neighbors, workspace).status ==
                      PlanStatus::invalid_input,
                  plan.status == PlanStatus::invalid_input);
        return plan.status;
      };
      const double speed = random.log_uniform(1e-9, 1.9);
      const double off = kHeadingTolerance * (random.below(2) == 0 ? 1.0 : -1.0);
      EXPECT_NE(status(Vec2{}), PlanStatus::invalid_input);
      EXPECT_NE(status(speed * along), PlanStatus::invalid_input);
      EXPECT_NE(status(speed * (along + 0.9 * off * across)), PlanStatus::invalid_input);
      EXPECT_EQ(status(speed * (along + 1.1 * off * across)), PlanStatus::invalid_input);
      EXPECT_EQ(status(speed * across), PlanStatus::invalid_input);
      EXPECT_EQ(status(-speed * along), PlanStatus::invalid_input);
      // rounded to float, as some drivers have it
      const auto narrow = static_cast<float>(heading);
      car.heading = static_cast<double>(narrow);
      const Vec2 rounded{static_cast<double>(static_cast<float>(speed * along.x)),
                         static_cast<double>(static_cast<float>(speed * along.y))};
      EXPECT_NE(status(rounded), PlanStatus::invalid_input);
    }
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
  for (int k = 0; k < 40'000 && !HasFailure(); ++k) {
    test::Crowd crowd;
    const auto turn = static_cast<std::size_t>(k);
    crowd.options = default_options(kMethods[turn % std::size(kMethods)]);
    crowd.options.control_time = random.log_uniform(0.1, 8.0);
    if (crowd.options.method == Method::avo)
      crowd.options.certificate = test::kCertificates[turn / std::size(kMethods) % 3];
    crowd.robot = {{extreme(), extreme()},
                   {extreme(), extreme()},
                   {extreme(), extreme()},
                   positive(),
                   positive(),
                   positive()};
    for (int j = random.below(4); j > 0; --j) {
      Neighbor other{
          {extreme(), extreme()}, {extreme(), extreme()}, positive(), std::abs(extreme())};
      other.acceleration = {extreme(), extreme()};
      if (other.max_acceleration == 0.0) other.behavior = Behavior::moves_on;
      crowd.neighbors.push_back(other);
    }
    PlanWorkspace workspace;
    const Planner planner(crowd.options);
    for (const bool alone : {false, true}) {
      const Plan plan = alone ? planner.plan_among_movers(crowd.robot, crowd.neighbors, workspace)
                              : planner.plan(crowd.robot, crowd.neighbors, workspace);
      EXPECT_TRUE(finite(plan)) << to_string(plan.status) << (alone ? " alone\n" : "\n") << crowd;
      EXPECT_NE(plan.status, PlanStatus::invalid_input);
      ++decided;
    }
  }
  EXPECT_EQ(decided, 80'000);
}

// No decision takes 0/0, a root of a negative number or a comparison with a NaN. The planner asks
// for what is undefined before, not afterwards by how NaN compares.
TEST(Status, no_decision_rests_on_an_invalid_operation) {
#ifdef __clang__
  GTEST_SKIP() << "this compiler may compute both sides of a branch";
#endif
  test::Random random(31);
  for (int k = 0; k < 40'000 && !HasFailure(); ++k) {
    test::Crowd crowd =
        k % 2 == 0 ? test::any_crowd(random, k / 2, -0.9) : test::random_crowd(random, -0.9);
    if (k % 8 == 0) crowd.robot.velocity = 3.0 * crowd.robot.velocity;
    if (k % 4 == 3) crowd.options.method = kMethods[3 + k / 4 % 4];  // orca, and those behind it
    const Planner planner(crowd.options);
    PlanWorkspace workspace;
    std::feclearexcept(FE_ALL_EXCEPT);
    const Plan plan = planner.plan(crowd.robot, crowd.neighbors, workspace);
    EXPECT_FALSE(std::fetestexcept(FE_INVALID | FE_DIVBYZERO)) << to_string(plan.status) << crowd;
    if (k % 20 > 0) continue;
    const Plan alone = planner.plan_among_movers(crowd.robot, crowd.neighbors, workspace);
    EXPECT_FALSE(std::fetestexcept(FE_INVALID)) << to_string(alone.status) << "\n" << crowd;
  }
}

}  // namespace
}  // namespace avo
