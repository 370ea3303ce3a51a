// SPDX-License-Identifier: Apache-2.0
// Decisions of the methods for comparison: ORCA clamped, RVO, buffered Voronoi cells
// (docs/baselines.md).
#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <limits>
#include <vector>

#include "avo/error.h"
#include "avo/half_plane.h"
#include "planner/methods/buffered_voronoi.h"
#include "planner/methods/reciprocal_obstacles.h"
#include "unit/planner/crowds.h"

namespace avo {
namespace {

using test::Crowd;
using test::Random;

constexpr double kRounding = 1e-9;

Crowd crowd_by(Random& random, Method method, double least_gap = 0.001) {
  Crowd crowd = test::random_crowd(random, least_gap);
  crowd.options.method = method;
  if (crowd.neighbors.size() > 5) crowd.neighbors.resize(5);
  return crowd;
}

Plan plan_by(Crowd crowd, Method method) {
  crowd.options.method = method;
  return test::plan_of(crowd);
}

TEST(OrcaClamped, goes_towards_orcas_choice_as_far_as_the_acceleration_allows) {
  Random random(1);
  int is_clamped = 0, is_orca = 0;
  for (int k = 0; k < 2'000; ++k) {
    const Crowd crowd = crowd_by(random, Method::orca_clamped);
    const Plan plan = test::plan_of(crowd), orca = plan_by(crowd, Method::orca);
    const Vec2 change = plan.new_velocity - crowd.robot.velocity;
    const Vec2 wanted = orca.new_velocity - crowd.robot.velocity;
    const double most = crowd.robot.max_acceleration * crowd.options.time_step;
    EXPECT_NEAR(norm(plan.next_velocity - plan.new_velocity), 0.0, 1e-15) << crowd;
    if (norm(wanted) <= most) {
      EXPECT_EQ(plan.new_velocity, orca.new_velocity) << crowd;
      ++is_orca;
      continue;
    }
    ++is_clamped;
    EXPECT_NEAR(norm(change), most, kRounding * most) << crowd;
    EXPECT_NEAR(norm(change - (most / norm(wanted)) * wanted), 0.0, kRounding) << crowd;
    EXPECT_NEAR(norm(plan.acceleration), crowd.robot.max_acceleration, 1e-6) << crowd;
  }
  EXPECT_GT(is_clamped, 500);
  EXPECT_GT(is_orca, 100);
}

TEST(OrcaClamped, with_boundless_acceleration_is_orca) {
  Random random(2);
  for (int k = 0; k < 1'000; ++k) {
    Crowd crowd = crowd_by(random, Method::orca_clamped, k % 2 == 0 ? 0.001 : -0.2);
    crowd.robot.max_acceleration = 1e6;
    for (Neighbor& neighbor : crowd.neighbors) neighbor.max_acceleration = 1e6;
    const Plan plan = test::plan_of(crowd), orca = plan_by(crowd, Method::orca);
    EXPECT_EQ(plan.new_velocity, orca.new_velocity) << crowd;
    EXPECT_EQ(plan.violation, orca.violation) << crowd;
    EXPECT_EQ(plan.status, orca.status) << crowd;
  }
}

// ORCA finds a velocity and cannot reach it: the plan says how much is missed.
TEST(OrcaClamped, tells_by_how_much_its_velocity_misses_the_half_planes) {
  const Robot robot{.velocity = {2, 0}, .preferred_velocity = {2, 0}};
  const std::vector<Neighbor> near{{.position = {1.5, 0.1}, .velocity = {-2, 0}}};
  PlanWorkspace workspace;
  const Planner planner(default_options(Method::orca_clamped));
  const Plan plan = planner.plan(robot, near, workspace);
  HalfPlanes half_planes;
  planner.collect_half_planes(robot, near, workspace, half_planes);
  ASSERT_EQ(half_planes.planes.size(), 1U);
  EXPECT_EQ(plan.status, PlanStatus::least_unsafe);
  EXPECT_GT(plan.violation, 0.1);
  EXPECT_EQ(plan.violation, violation(half_planes.planes[0].plane, plan.new_velocity));
}

// The cone of v'/α + (1 - 1/α) v_A.
Obstacle cone_of(const Crowd& crowd, const Neighbor& B) {
  return {{crowd.robot.position - B.position, {}, crowd.robot.radius + B.radius},
          Response::velocity(),
          crowd.options.time_horizon};
}
Vec2 relative_by_share(const Crowd& crowd, const Neighbor& B, Vec2 v_new) {
  const double alpha = B.behavior == Behavior::decides
                           ? reciprocal_share(crowd.robot.max_acceleration, B.max_acceleration)
                           : 1.0;
  const Vec2 v_A = crowd.robot.velocity;
  return (1.0 / alpha) * v_new + (1.0 - 1.0 / alpha) * v_A - B.velocity;
}

TEST(ReciprocalVelocityObstacle, chooses_outside_the_shifted_cones) {
  Random random(5);
  int optimal = 0, inside_the_cone_of_vo = 0;
  for (int k = 0; k < 1'500; ++k) {
    const Crowd crowd = crowd_by(random, Method::reciprocal_velocity_obstacle);
    const Plan plan = test::plan_of(crowd);
    if (plan.status != PlanStatus::optimal) continue;
    ++optimal;
    for (const Neighbor& B : crowd.neighbors) {
      const Obstacle cone = cone_of(crowd, B);
      const Vec2 u = relative_by_share(crowd, B, plan.new_velocity);
      EXPECT_GE(closest_approach(cone, u).distance, cone.pair.radius * (1.0 - kRounding)) << crowd;
      if (contains(cone, plan.new_velocity - B.velocity)) ++inside_the_cone_of_vo;
    }
  }
  EXPECT_GT(optimal, 500);
  EXPECT_GT(inside_the_cone_of_vo, 50);
}

// Scaling by α = 1/2 about v_A halves the change of velocity that leads out. Where A and B both
// make it, they just miss each other.
TEST(ReciprocalVelocityObstacle, each_of_two_equals_does_half) {
  Random random(6);
  int compared = 0;
  for (int k = 0; k < 3'000; ++k) {
    Crowd crowd;
    crowd.options = default_options(Method::reciprocal_velocity_obstacle);
    Robot& A = crowd.robot;
    A.max_speed = 100.0;  // no disc cuts
    A.velocity = A.preferred_velocity = test::in_disc(random, 2.0);
    crowd.neighbors = {
        {.position = random.uniform(1.1, 8.0) * random.direction(), .velocity = -A.velocity}};
    const Plan half = test::plan_of(crowd), whole = plan_by(crowd, Method::velocity_obstacle);
    const double way = norm(whole.new_velocity - A.velocity);
    if (!(way > 0.0)) continue;
    ++compared;
    EXPECT_NEAR(norm(half.new_velocity - A.velocity), 0.5 * way, 1e-6 * (1.0 + way)) << crowd;
    const Obstacle cone = cone_of(crowd, crowd.neighbors[0]);
    EXPECT_NEAR(closest_approach(cone, 2.0 * half.new_velocity).distance, 1.0, 1e-6) << crowd;
  }
  EXPECT_GT(compared, 200);
}

TEST(ReciprocalVelocityObstacle, does_all_for_one_that_does_not_decide) {
  Random random(7);
  for (int k = 0; k < 500; ++k) {
    Crowd crowd = crowd_by(random, Method::reciprocal_velocity_obstacle);
    for (Neighbor& B : crowd.neighbors) B.behavior = Behavior::moves_on;
    const Plan plan = test::plan_of(crowd), vo = plan_by(crowd, Method::velocity_obstacle);
    if (vo.status != PlanStatus::optimal) continue;
    EXPECT_NEAR(norm(plan.new_velocity - vo.new_velocity), 0.0, kRounding) << crowd;
  }
}

// s, by small steps.
double slow_time_to_collision(const Crowd& crowd, const Neighbor& B, Vec2 v_new) {
  const Obstacle cone = cone_of(crowd, B);
  const Vec2 u = relative_by_share(crowd, B, v_new);
  constexpr double kStep = 0.002;
  for (double t = 0.0; t < cone.time_horizon; t += kStep) {
    if (norm(cone.pair.position + t * u) < cone.pair.radius) return t;
  }
  return std::numeric_limits<double>::infinity();
}

TEST(ReciprocalVelocityObstacle, times_to_collision_are_those_of_small_steps) {
  Random random(12);
  int collisions = 0;
  for (int k = 0; k < 500; ++k) {
    const Crowd crowd = crowd_by(random, Method::reciprocal_velocity_obstacle);
    const Vec2 v_new = test::in_disc(random, crowd.robot.max_speed);
    for (const Neighbor& B : crowd.neighbors) {
      const double slow = slow_time_to_collision(crowd, B, v_new);
      const double time = time_to_collision(reciprocal_obstacle(crowd.options, crowd.robot, B),
                                            crowd.options.time_horizon, v_new);
      if (std::isfinite(slow) && std::isfinite(time)) {
        EXPECT_NEAR(time, slow, 0.003) << crowd;
        ++collisions;
      } else {
        EXPECT_FALSE(std::isfinite(slow)) << crowd;  // small steps may miss a fly-by
      }
    }
  }
  EXPECT_GT(collisions, 100);
}

double penalty_of(const Crowd& crowd, Vec2 v_new) {
  double first = std::numeric_limits<double>::infinity();
  for (const Neighbor& B : crowd.neighbors)
    first = std::min(first, slow_time_to_collision(crowd, B, v_new));
  return kSafetyFactor / first + norm(crowd.robot.preferred_velocity - v_new);
}

// Closed in by others that come nearer, at different speeds.
TEST(ReciprocalVelocityObstacle, where_none_is_free_has_the_least_penalty) {
  Random random(8);
  int enclosed = 0;
  for (int k = 0; k < 12; ++k) {
    Crowd crowd;
    crowd.options = default_options(Method::reciprocal_velocity_obstacle);
    crowd.options.time_horizon = 5.0;
    crowd.robot.preferred_velocity = crowd.robot.velocity = test::in_disc(random, 2.0);
    for (int n = 0; n < 8; ++n) {
      const Vec2 away{std::cos(0.7854 * n), std::sin(0.7854 * n)};
      crowd.neighbors.push_back({.position = random.uniform(1.6, 2.4) * away,
                                 .velocity = random.uniform(-2.0, -0.5) * away,
                                 .radius = 0.6});
    }
    const Plan plan = test::plan_of(crowd);
    if (plan.status != PlanStatus::least_unsafe) continue;
    ++enclosed;
    double least = std::numeric_limits<double>::infinity();
    for (int i = -20; i <= 20; ++i) {
      for (int j = -20; j <= 20; ++j) {
        const Vec2 v{0.1 * i, 0.1 * j};
        if (norm(v) <= crowd.robot.max_speed) least = std::min(least, penalty_of(crowd, v));
      }
    }
    EXPECT_LE(penalty_of(crowd, plan.new_velocity), 1.05 * least) << crowd;
    EXPECT_GT(plan.violation, 0.0);
  }
  EXPECT_GT(enclosed, 6);
}

TEST(BufferedVoronoi, discs_of_centers_in_two_cells_are_disjoint) {
  Random random(9);
  const PlannerOptions options = default_options(Method::buffered_voronoi);
  for (int k = 0; k < 10'000; ++k) {
    Robot A, B;
    A.radius = random.log_uniform(0.1, 5.0), B.radius = random.log_uniform(0.1, 5.0);
    const double contact = A.radius + B.radius;
    A.position = test::in_disc(random, 20.0);
    B.position = A.position + contact * random.uniform(1.0, 3.0) * random.direction();
    const CellSide of_A = cell_side(options, A, test::as_neighbor(B));
    const CellSide of_B = cell_side(options, B, test::as_neighbor(A));
    EXPECT_GE(of_A.gap, 0.0);  // both are in their cells
    EXPECT_GE(of_B.gap, 0.0);
    const auto in_cell = [&](const Robot& robot, const CellSide& side) {
      const double part = random.below(2) == 0 ? 0.0 : random.uniform(0.0, 5.0);
      return robot.position + (side.gap - part) * side.normal +
             random.uniform(-5.0, 5.0) * perpendicular(side.normal);
    };
    EXPECT_GE(norm(in_cell(A, of_A) - in_cell(B, of_B)), contact * (1.0 - kRounding));
    EXPECT_NEAR(of_A.gap + of_B.gap, norm(A.position - B.position) - contact, 1e-12);
  }
}

// m: with the acceleration held in every step, the last one to rest.
double way_of_braking(double speed, double max_braking, double time_step) {
  double way = 0.0;
  while (speed > 0.0) {
    const double next = std::max(0.0, speed - max_braking * time_step);
    way += 0.5 * time_step * (speed + next);
    speed = next;
  }
  return way;
}

TEST(BufferedVoronoi, speeds_are_the_largest_that_stop_within_the_cell) {
  Random random(10);
  for (int k = 0; k < 5'000; ++k) {
    const double time_step = random.log_uniform(0.01, 1.0), b = random.log_uniform(0.1, 20.0);
    const double speed = random.uniform(0.0, 3.0);
    const double gap = 0.5 * time_step * speed + random.log_uniform(1e-3, 10.0);
    const auto way = [&](double V) {
      return 0.5 * time_step * (speed + V) + way_of_braking(V, b, time_step);
    };
    const double V = speed_within(gap, speed, b, time_step);
    EXPECT_LE(way(V), gap * (1.0 + kRounding));
    EXPECT_GT(way(V * (1.0 + 1e-6) + 1e-6), gap);
    EXPECT_LE(V, std::sqrt(2.0 * b * gap) * (1.0 + kRounding));
    const double beyond = speed_within(0.25 * time_step * speed, speed, b, time_step);
    EXPECT_NEAR(0.5 * time_step * (speed + beyond), 0.25 * time_step * speed, kRounding);
  }
}

// B is 4 m ahead: A's cell ends 1.5 m ahead, and its point nearest the goal is beside A's course.
TEST(BufferedVoronoi, heads_for_the_point_of_its_cell_nearest_the_goal) {
  const Planner planner(default_options(Method::buffered_voronoi));
  PlanWorkspace workspace;
  Robot robot{.preferred_velocity = 2.0 / std::sqrt(109.0) * Vec2{10, 3}};
  robot.distance_to_goal = std::sqrt(109.0);
  Neighbor B{.position = {4, 0}};
  const Plan plan = planner.plan(robot, std::vector<Neighbor>{B}, workspace);
  EXPECT_NEAR(cross(plan.new_velocity, Vec2{1.5, 3.0}), 0.0, 1e-9);
  EXPECT_NEAR(norm(plan.new_velocity), 0.1, 1e-9);  // a_max Δt
  // a mover leaves all of the room to A, which ends 3 m ahead
  B.behavior = Behavior::moves_on;
  const Plan beside = planner.plan(robot, std::vector<Neighbor>{B}, workspace);
  EXPECT_NEAR(cross(beside.new_velocity, Vec2{3.0, 3.0}), 0.0, 1e-9);
  // in the cell: as preferred
  robot.preferred_velocity = {0.05, 0.0}, robot.distance_to_goal = 1.2;
  EXPECT_EQ(planner.plan(robot, std::vector<Neighbor>{B}, workspace).new_velocity,
            robot.preferred_velocity);
}

TEST(BufferedVoronoi, keeps_the_acceleration) {
  Random random(11);
  for (int k = 0; k < 2'000; ++k) {
    Crowd crowd = crowd_by(random, Method::buffered_voronoi, k % 2 == 0 ? 0.001 : -0.2);
    const Plan plan = test::plan_of(crowd);
    EXPECT_LE(norm(plan.acceleration), crowd.robot.max_acceleration * (1.0 + kRounding)) << crowd;
    EXPECT_EQ(Planner(crowd.options).options().control_time, crowd.options.time_step);
  }
}

TEST(Baselines, of_held_steps_refuse_exponential_motion) {
  for (const Method method : {Method::orca_clamped, Method::buffered_voronoi}) {
    PlannerOptions options = default_options(method);
    options.motion = Motion::exponential;
    EXPECT_THROW(Planner{options}, Error);
  }
}

}  // namespace
}  // namespace avo
