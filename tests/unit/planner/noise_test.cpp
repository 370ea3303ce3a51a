// SPDX-License-Identifier: Apache-2.0
// Half-planes that keep quantiles of Gaussian noise in reserve, and what is told of the risk.
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <gtest/gtest.h>
#include <utility>
#include <vector>

#include "avo/error.h"
#include "crowds.h"
#include "obstacles/half_planes.h"
#include "support/generators.h"

namespace avo {
namespace {

using test::Random;

constexpr double kPosition = 0.05, kVelocity = 0.1;  // standard deviations, m and m/s

Planner planner_with(SensingNoise noise) {
  PlannerOptions options;
  options.sensing_noise = noise;
  return Planner(options);
}

double gaussian(Random& random) {
  double sum = 0.0;  // of twelve: nearly normal
  for (int k = 0; k < 12; ++k) sum += random.uniform(-0.5, 0.5);
  return sum;
}

// On collision course or nearly so, some seconds away.
struct Meeting {
  Robot robot;
  Neighbor neighbor;
};
Meeting any_meeting(Random& random) {
  Meeting meeting;
  const Vec2 away = random.direction();
  meeting.robot.velocity = random.uniform(0.3, 1.5) * away + test::in_disc(random, 0.4);
  meeting.neighbor.position = random.uniform(2.0, 5.0) * away;
  meeting.neighbor.velocity = -random.uniform(0.0, 1.5) * away + test::in_disc(random, 0.4);
  return meeting;
}

std::optional<NeighborPlane> own_plane_of(const Planner& planner, const Meeting& meeting) {
  PlanWorkspace workspace;
  HalfPlanes planes;
  planner.collect_half_planes(meeting.robot, std::span(&meeting.neighbor, 1), workspace, planes);
  if (planes.planes.empty()) return {};
  return planes.planes[0];
}
std::optional<HalfPlane> plane_of(const Planner& planner, const Meeting& meeting) {
  const auto own = own_plane_of(planner, meeting);
  return own ? std::optional(own->plane) : std::nullopt;
}

// As docs/half_plane.md says it, of one pair.
double radius_with_reserve(const Pair& pair, const Reserve& reserve) {
  const double towards = -dot(pair.position, pair.velocity);
  double time = towards > 0.0 ? reserve.horizon : 0.0;
  const double squared = norm_squared(pair.velocity);
  if (towards < time * squared) time = towards / squared;
  const double wanted =
      pair.radius + reserve.quantile * (reserve.position + time * reserve.velocity);
  return std::max(pair.radius, std::min(wanted, norm(pair.position)));
}

TEST(Noise, reserves_of_many_pairs_are_those_of_each) {
  Random random(91);
  for (int round = 0; round < 3'000 && !HasFailure(); ++round) {
    const Reserve reserve{random.uniform(0.0, 0.2), random.uniform(0.0, 0.3),
                          random.uniform(0.0, 3.0), random.uniform(1.0, 10.0)};
    std::vector<Pair> pairs(static_cast<std::size_t>(1 + random.below(20)));
    PairColumns columns;
    columns.reserve(pairs.size());
    columns.count = pairs.size();
    for (std::size_t i = 0; i < pairs.size(); ++i) {
      Pair& pair = pairs[i];
      pair.position = random.log_uniform(0.5, 20.0) * random.direction();
      pair.velocity = random.below(8) == 0 ? Vec2{} : test::in_disc(random, 3.0);
      pair.radius = random.uniform(0.2, 1.5);
      columns.p_x[i] = pair.position.x, columns.p_y[i] = pair.position.y;
      columns.v_x[i] = pair.velocity.x, columns.v_y[i] = pair.velocity.y;
      columns.radius[i] = pair.radius;
    }
    reserve_room(reserve, columns);
    for (std::size_t i = 0; i < pairs.size(); ++i) {
      EXPECT_EQ(columns.radius[i], radius_with_reserve(pairs[i], reserve));
      EXPECT_EQ(columns.radius[i], reserved_radius(pairs[i], reserve));
    }
  }
}

// How often the half-plane of the true state is broken by what just keeps the one that is seen.
double share_broken(double quantile, Random& random, double* mean_risk = nullptr) {
  const Planner exact = planner_with({});
  const Planner careful = planner_with({kPosition, kVelocity, quantile});
  int broken = 0, all = 0;
  double risk = 0.0;
  while (all < 4000) {
    const Meeting seen = any_meeting(random);
    const std::optional<NeighborPlane> own = own_plane_of(careful, seen);
    if (!own || own->excess > 0.0) continue;
    const auto& [normal, offset] = own->plane;
    const double demanded_now = offset - dot(normal, seen.robot.velocity);
    if (demanded_now < 0.02) continue;
    const Vec2 choice = seen.robot.velocity + demanded_now * normal;
    Meeting actual = seen;
    actual.neighbor.position =
        actual.neighbor.position + kPosition * Vec2{gaussian(random), gaussian(random)};
    actual.neighbor.velocity =
        actual.neighbor.velocity + kVelocity * Vec2{gaussian(random), gaussian(random)};
    const std::optional<HalfPlane> demanded = plane_of(exact, actual);
    if (demanded && dot(demanded->normal, normal) < 0.5) continue;  // they pass on the other side
    broken += demanded && dot(demanded->normal, choice) < demanded->offset ? 1 : 0;
    risk += careful.half_plane_risk(seen.robot, seen.neighbor, choice);
    ++all;
  }
  if (mean_risk != nullptr) *mean_risk = risk / all;
  return static_cast<double>(broken) / all;
}

TEST(Noise, quantiles_bound_how_often_the_true_half_plane_is_broken) {
  Random random(12);
  EXPECT_GT(share_broken(0.0, random), 0.35);
  double risk = 0.0;
  EXPECT_LT(share_broken(1.0, random, &risk), 0.1587);  // 1 - Φ(1)
  EXPECT_NEAR(risk, 0.1587, 0.005);
  EXPECT_LT(share_broken(2.0, random, &risk), 0.0228);
  EXPECT_NEAR(risk, 0.0228, 0.002);
}

// A velocity on the line of the listed half-plane.
Vec2 choice_on(const HalfPlane& plane, Vec2 velocity) {
  return velocity + (plane.offset - dot(plane.normal, velocity)) * plane.normal;
}

// 1 - Φ, by tables.
TEST(Noise, risk_is_that_of_a_normal_distribution) {
  const Robot robot{.velocity = {1.0, 0.0}};
  const Neighbor neighbor{.position = {4.0, 0.3}, .velocity = {-1.0, 0.0}};
  for (const auto& [quantile, risk] :
       std::vector<std::pair<double, double>>{{0.5, 0.30853753872598690},
                                              {1.0, 0.15865525393145705},
                                              {1.9, 0.02871655981600179},
                                              {2.1, 0.01786442056281656},
                                              {4.0, 3.1671241833119924e-05},
                                              {6.0, 9.8658764503769814e-10}}) {
    const Planner planner = planner_with({0.01, 0.0, quantile});
    const HalfPlane plane = *plane_of(planner, {robot, neighbor});
    const Vec2 choice = choice_on(plane, robot.velocity);
    EXPECT_NEAR(planner.half_plane_risk(robot, neighbor, choice), risk, 1e-6 * risk) << quantile;
  }
}

TEST(Noise, risk_is_of_the_half_plane_that_the_robot_decides_by) {
  const Robot robot{.velocity = {1.0, 0.0}};
  for (const auto& [method, distance] :
       std::vector<std::pair<Method, double>>{{Method::avo, 4.0},
                                              {Method::orca, 4.0},
                                              {Method::orca_clamped, 4.0},
                                              {Method::buffered_voronoi, 2.0}}) {
    PlannerOptions options = default_options(method);
    options.sensing_noise = {kPosition, 0.0, 1.0};
    const Planner planner(options);
    const Neighbor disc{.position = {distance, 0.3}, .velocity = {-1.0, 0.0}};
    Neighbor lorry = disc;  // the foremost of its discs is where the other neighbor is
    lorry.position.x += 1.0, lorry.radius = 1.5;
    lorry.footprint = {.discs = 3, .radius = 0.5, .first = -1.0, .spacing = 1.0};
    lorry.ahead = {-1.0, 0.0};
    for (const Neighbor& neighbor : {disc, lorry}) {
      const std::optional<HalfPlane> plane = plane_of(planner, {robot, neighbor});
      ASSERT_TRUE(plane) << to_string(method);
      const Vec2 choice = choice_on(*plane, robot.velocity);
      EXPECT_NEAR(planner.half_plane_risk(robot, neighbor, choice), 0.15865525393145705, 1e-6)
          << to_string(method) << ", " << neighbor.radius;
    }
  }
}

// A velocity that the robot cannot have is judged as well, by a half-plane that cannot cut.
TEST(Noise, risk_is_of_any_velocity) {
  const Planner planner = planner_with({kPosition, kVelocity});
  const Robot slow{.max_speed = 0.2};
  const Neighbor neighbor{.position = {4.0, 0.0}};
  EXPECT_FALSE(plane_of(planner, {slow, neighbor}));
  EXPECT_LT(planner.half_plane_risk(slow, neighbor, {0.2, 0.0}), 1e-6);
  EXPECT_EQ(planner.half_plane_risk(slow, neighbor, {3.0, 0.0}), 1.0);
}

TEST(Noise, risk_grows_towards_the_neighbor) {
  const Planner planner = planner_with({kPosition, kVelocity});
  const Robot robot{.velocity = {1.0, 0.0}};
  const Neighbor neighbor{.position = {4.0, 0.3}, .velocity = {-1.0, 0.0}};
  double last = 0.0;
  for (double speed = -2.0; speed <= 2.0; speed += 0.1) {
    const double risk = planner.half_plane_risk(robot, neighbor, {0.0, speed});
    EXPECT_GE(risk, 0.0);
    EXPECT_LE(risk, 1.0);
    EXPECT_GE(risk, last - 1e-12) << speed;
    last = risk;
  }
  EXPECT_EQ(last, 1.0);
  EXPECT_EQ(planner_with({}).half_plane_risk(robot, neighbor, {0.0, 2.0}), 0.0);
}

TEST(Noise, brings_nobody_into_contact) {
  const Planner planner = planner_with({1.0, 0.0, 3.0});
  PlanWorkspace workspace;
  HalfPlanes planes;
  const Neighbor near{.position = {1.2, 0.0}};
  planner.collect_half_planes({}, std::span(&near, 1), workspace, planes);
  EXPECT_FALSE(planes.overlapping);
  EXPECT_NE(planner.plan({}, std::span(&near, 1), workspace).status, PlanStatus::overlapping);
}

// Those of plan(), which are made in lanes, and those that are listed.
TEST(Noise, decisions_are_made_of_the_half_planes_that_are_listed) {
  for (const Method method : {Method::avo_paper, Method::orca}) {
    PlannerOptions options = default_options(method);
    options.sensing_noise = {kPosition, kVelocity, 1.0};
    const Planner planner(options);
    Random random(5);
    int constrained = 0;
    for (int k = 0; k < 500; ++k) {
      Meeting meeting = any_meeting(random);
      meeting.robot.preferred_velocity = meeting.robot.velocity;
      PlanWorkspace workspace;
      const Plan plan = planner.plan(meeting.robot, std::span(&meeting.neighbor, 1), workspace);
      const std::optional<HalfPlane> plane = plane_of(planner, meeting);
      if (!plane || plan.status != PlanStatus::optimal) continue;
      const double slack = dot(plane->normal, plan.new_velocity) - plane->offset;
      EXPECT_GT(slack, -1e-9);
      if (dot(plane->normal, meeting.robot.preferred_velocity) < plane->offset) {
        EXPECT_NEAR(slack, 0.0, 1e-9);
        ++constrained;
      }
    }
    EXPECT_GT(constrained, 100);
  }
}

TEST(Noise, out_of_range_is_refused) {
  PlannerOptions options;
  options.sensing_noise.quantile = -1.0;
  try {
    const Planner planner(options);
    FAIL();
  } catch (const Error& error) {
    EXPECT_STREQ(error.what(), "PlannerOptions.sensing_noise.quantile: found -1, must be >= 0");
  }
}

}  // namespace
}  // namespace avo
