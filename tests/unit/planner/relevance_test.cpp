// SPDX-License-Identifier: Apache-2.0
// A neighbor beyond the relevant range, and not among the nearest, changes no bit of a decision.
#include "planner/stages/relevance.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <gtest/gtest.h>
#include <vector>

#include "certificate/pair.h"
#include "core/stage_clock.h"
#include "planner/rules/arrival.h"
#include "planner/scratch.h"
#include "planner/stages/certify.h"
#include "support/half_plane_batches.h"
#include "unit/planner/crowds.h"

namespace avo {
namespace {

using test::Crowd;
using test::Random;

constexpr double kSensingRadius = 30.0;

// One robot amid others of unequal sizes and limits, most of them as fast as they may be, some of
// them coming straight at it, all within the sensing radius and in canonical order.
Crowd crowd_of(Random& random, Certificate certificate, Motion motion) {
  Crowd crowd;
  crowd.options = default_options(Method::avo);
  crowd.options.certificate = certificate;
  crowd.options.motion = motion;
  crowd.options.max_neighbors = 1 + random.below(4);
  Robot& A = crowd.robot;
  A.radius = random.log_uniform(0.2, 1.0);
  A.max_acceleration = random.log_uniform(0.5, 2.0);
  const bool brakes_otherwise = random.below(2) == 0;
  if (brakes_otherwise) A.max_braking = random.log_uniform(0.4, 3.0) * A.max_acceleration;
  A.max_speed = random.uniform(0.3, 1.0) * 2.0 * A.max_acceleration;
  A.velocity = A.max_speed * random.uniform(0.5, 1.0) * random.direction();
  A.preferred_velocity = A.max_speed * random.direction();
  if (random.below(3) == 0) A.distance_to_goal = A.radius * random.log_uniform(0.1, 30.0);
  const int count = 1 + random.below(24);
  const double spread = random.uniform(4.0, kSensingRadius);
  for (int k = 0; k < count; ++k) {
    Neighbor B;
    B.radius = random.log_uniform(0.2, 1.0);
    B.max_acceleration = random.log_uniform(0.5, 2.0);
    if (brakes_otherwise) B.max_braking = random.log_uniform(0.4, 3.0) * B.max_acceleration;
    const double top = random.uniform(0.3, 1.0) * 2.0 * B.max_acceleration;
    const double gap = random.uniform(0.0, spread - 2.0);
    const Vec2 direction = random.direction();
    B.position = A.position + (A.radius + B.radius + gap) * direction;
    const int kind = random.below(4);
    B.velocity = kind == 0 ? Vec2{} : top * (kind == 1 ? random.direction() : -direction);
    crowd.neighbors.push_back(B);
  }
  std::stable_sort(
      crowd.neighbors.begin(), crowd.neighbors.end(), [&](const Neighbor& a, const Neighbor& b) {
        return norm_squared(a.position - A.position) < norm_squared(b.position - A.position);
      });
  return crowd;
}

// A slow robot that a fast or a large one comes straight at; another one, behind it and nearer,
// gets the only half-plane.
Crowd duel(Random& random, Certificate certificate, Motion motion) {
  Crowd crowd;
  crowd.options = default_options(Method::avo);
  crowd.options.certificate = certificate;
  crowd.options.motion = motion;
  crowd.options.max_neighbors = 1;
  Robot& A = crowd.robot;
  A.radius = 0.05;
  A.max_speed = random.uniform(0.1, 0.5);
  A.velocity = {A.max_speed, 0.0};
  A.preferred_velocity = A.velocity;
  Neighbor B;
  B.radius = random.log_uniform(0.05, 2.0);
  const double speed = random.below(2) == 0 ? 0.0 : random.uniform(1.0, 3.0);
  B.velocity = {-speed, 0.0};
  // contact, what both brake for, and what they cover until then
  const double ways = 0.5 * (A.max_speed * A.max_speed + speed * speed) +
                      (A.max_speed + speed) * crowd.options.time_step;
  const double distance = A.radius + B.radius + random.uniform(0.0, 1.2) * (ways + 0.25 * B.radius);
  B.position = {distance, 0.0};
  Neighbor behind;
  behind.radius = A.radius;
  behind.position = {-0.9 * distance, 0.0};
  crowd.neighbors = {behind, B};
  return crowd;
}

Peers peers_of(const Crowd& crowd, const Planner& planner) {
  Peers peers;
  include(peers, planner, crowd.robot);
  for (const Neighbor& B : crowd.neighbors) {
    Robot robot;
    robot.radius = B.radius;
    robot.max_acceleration = B.max_acceleration;
    robot.max_speed = norm(B.velocity);
    robot.max_braking = B.max_braking;
    include(peers, planner, robot);
  }
  return peers;
}

// The nearest max_neighbors, and all within a range.
std::vector<Neighbor> relevant(const Crowd& crowd, double range) {
  std::vector<Neighbor> kept;
  for (const Neighbor& B : crowd.neighbors) {
    if (kept.size() < static_cast<std::size_t>(*crowd.options.max_neighbors) ||
        norm_squared(B.position - crowd.robot.position) <= range * range) {
      kept.push_back(B);
    }
  }
  return kept;
}

Detour any_detour(Random& random) {
  const auto below = [&](double most) { return static_cast<float>(random.uniform(0.0, most)); };
  return {below(1.0), below(60.0), below(2.8), random.below(2) == 0};
}

struct Decision {
  Plan plan;
  Detour detour;
  friend bool operator==(const Decision& a, const Decision& b) {
    const auto bits = [](double x) { return std::bit_cast<std::uint64_t>(x); };
    return a.plan.new_velocity == b.plan.new_velocity &&
           a.plan.acceleration == b.plan.acceleration && a.plan.status == b.plan.status &&
           bits(a.plan.violation) == bits(b.plan.violation) &&
           bits(a.detour.angle) == bits(b.detour.angle) &&
           bits(a.detour.beside) == bits(b.detour.beside) &&
           bits(a.detour.congestion) == bits(b.detour.congestion) &&
           a.detour.has_arrived == b.detour.has_arrived;
  }
};

Decision decide(const Planner& planner, const Robot& robot, const std::vector<Neighbor>& neighbors,
                const Detour& detour) {
  PlanWorkspace workspace;
  Decision decision{{}, detour};
  decision.plan = planner.plan(robot, neighbors, workspace, &decision.detour);
  return decision;
}

// Those farther away are sensed, but of them only the first pack of lanes is looked at.
Decision decide_within(const Planner& planner, const Robot& robot,
                       const std::vector<Neighbor>& neighbors, double range, const Detour& detour,
                       const char* simd = "scalar") {
  const test::OnTarget target(simd);
  PlanWorkspace workspace;
  StageClock clock;
  Decision decision{{}, detour};
  Tile tile;
  tile.reserve(1, neighbors.size());
  Neighbors sensed = in_columns(neighbors, tile.neighbors);
  sensed.range = range;
  tile.robots.add(robot, sensed);
  tile.detour.push_back(&decision.detour);
  tile.plan.push_back(&decision.plan);
  tile.slot.push_back(0);
  plan_together(planner, tile, PlanWorkspace::Scratch::of(workspace), clock);
  return decision;
}

struct Counts {
  int dropped = 0, changed_by_a_cut = 0, changed_by_looking_less_far = 0;
};

Counts compare(Certificate certificate, Motion motion, std::uint64_t seed) {
  Random random(seed);
  Counts counts;
  for (int k = 0; k < 4000 && !testing::Test::HasFailure(); ++k) {
    const Crowd crowd =
        k % 4 == 0 ? duel(random, certificate, motion) : crowd_of(random, certificate, motion);
    const Planner planner(crowd.options);
    const double range = relevant_range(planner, crowd.robot, peers_of(crowd, planner))
                             .at(norm(crowd.robot.velocity));
    const Detour detour = any_detour(random);
    const Decision all = decide(planner, crowd.robot, crowd.neighbors, detour);
    const std::vector<Neighbor> kept = relevant(crowd, range);
    EXPECT_EQ(decide(planner, crowd.robot, kept, detour), all) << crowd << "\nrange " << range;
    counts.dropped += kept.size() < crowd.neighbors.size() ? 1 : 0;
    for (const auto& simd : simd_targets()) {
      EXPECT_EQ(decide_within(planner, crowd.robot, crowd.neighbors, range, detour, simd), all)
          << crowd << simd;
    }
    const Decision near = decide_within(planner, crowd.robot, crowd.neighbors, 0.3 * range, detour);
    counts.changed_by_looking_less_far += near == all ? 0 : 1;
    const Decision cut = decide(planner, crowd.robot, relevant(crowd, 0.6 * range), detour);
    counts.changed_by_a_cut += cut == all ? 0 : 1;
  }
  return counts;
}

TEST(Relevance, the_far_change_no_bit) {
  for (const Motion motion : {Motion::held, Motion::exponential}) {
    const Counts counts = compare(Certificate::braking_trajectories, motion, 11);
    EXPECT_GT(counts.dropped, 1000);
    EXPECT_GT(counts.changed_by_a_cut, 20);  // the range is not generous beyond measure
    EXPECT_GT(counts.changed_by_looking_less_far, 20);
  }
}

// Whatever the two may choose, of all the neighbors placed just beyond the range; nearer by a tenth
// some can meet, so that the range is no larger than it has to be.
TEST(Relevance, nobody_beyond_it_can_come_into_contact) {
  for (const Clock clock : {Clock::common, Clock::free}) {
    Random random(13);
    int near = 0;
    for (int k = 0; k < 2000 && !testing::Test::HasFailure(); ++k) {
      Crowd crowd = crowd_of(random, Certificate::braking_trajectories, Motion::held);
      crowd.options.clock = clock;
      if (clock == Clock::free) crowd.options.longest_step = random.log_uniform(0.05, 0.4);
      if (random.below(2) == 0)
        crowd.options.sensing_error = {random.uniform(0.0, 0.1), random.uniform(0.0, 0.2)};
      const Planner planner(crowd.options);
      const StepLaw law = certificate_law(planner).step;
      const Robot& A = crowd.robot;
      const double range =
          relevant_range(planner, A, peers_of(crowd, planner)).at(norm(A.velocity));
      const Braking own = braking_of(A.velocity, ability_of(A), law);
      const auto can_meet = [&](Neighbor B, double distance) {
        B.position = A.position + distance * random.direction();
        return !cannot_meet(braking_pair(A, B, own, law), B, law);
      };
      for (const Neighbor& B : crowd.neighbors) {
        EXPECT_FALSE(can_meet(B, (1.0 + 1e-9) * range)) << crowd << range;
        near += can_meet(B, 0.9 * range) ? 1 : 0;
      }
    }
    EXPECT_GT(near, 100);
  }
}

// A robot with a neighbor that does not decide is planned by itself. A robot that no neighbor
// hinders is planned in lanes.
TEST(Relevance, a_mover_far_away_changes_no_bit) {
  Random random(12);
  int free = 0, turning = 0, yielding = 0;
  for (int k = 0; k < 8000 && !testing::Test::HasFailure(); ++k) {
    const Certificate certificate =
        k % 3 == 0 ? Certificate::none : Certificate::braking_trajectories;
    Crowd crowd = crowd_of(random, certificate, k % 2 == 0 ? Motion::held : Motion::exponential);
    crowd.options.max_neighbors = 30;
    if (random.below(2) == 0) crowd.neighbors.resize((crowd.neighbors.size() + 1) / 2);
    if (random.below(8) == 0) crowd.robot.velocity = 1.2 * crowd.robot.velocity;
    const Planner planner(crowd.options);
    Detour detour = any_detour(random);
    if (random.below(2) == 0) detour.angle = 0.0F;
    if (random.below(2) == 0) detour.beside = 0.0F;
    const Decision alone = decide(planner, crowd.robot, crowd.neighbors, detour);
    Neighbor mover;
    mover.position = {1e5, 0.0};
    mover.behavior = Behavior::moves_on;
    crowd.neighbors.push_back(mover);
    EXPECT_EQ(decide(planner, crowd.robot, crowd.neighbors, detour), alone) << crowd;
    free += alone.plan.status == PlanStatus::optimal && detour.angle == 0.0 ? 1 : 0;
    turning += detour.angle > 0.0 ? 1 : 0;
    yielding += alone.detour.beside > 0.0F ? 1 : 0;
  }
  EXPECT_GT(free, 1000);
  EXPECT_GT(turning, 1000);
  EXPECT_GT(yielding, 1000);
}

TEST(Relevance, everyone_matters_where_nothing_bounds_it) {
  PlannerOptions options = default_options(Method::avo);
  const Robot robot;
  Peers peers;
  include(peers, Planner(options), robot);
  EXPECT_TRUE(
      std::isinf(relevant_range(Planner(options), robot, peers).at(0.0)));  // all half-planes
  options.max_neighbors = 10;
  EXPECT_TRUE(std::isfinite(relevant_range(Planner(options), robot, peers).at(robot.max_speed)));
  options = default_options(Method::avo_paper);
  options.max_neighbors = 10;
  EXPECT_EQ(relevant_range(Planner(options), robot, peers).at(robot.max_speed), 0.0);
}

TEST(Relevance, narrow_numbers_are_rounded_up) {
  PlannerOptions options = default_options(Method::avo);
  options.max_neighbors = 10;
  const Planner planner(options);
  Random random(7);
  for (int trial = 0; trial < 1000; ++trial) {
    Robot robot;
    robot.radius = random.log_uniform(0.1, 2.0);
    robot.max_acceleration = random.log_uniform(0.2, 5.0);
    robot.max_speed = random.log_uniform(0.2, 5.0);
    Peers peers;
    include(peers, planner, robot);
    const double exact = arrival_range(robot, peers.radius);
    const RelevantRange range = relevant_range(planner, robot, peers);
    EXPECT_GE(range.least, exact);
    EXPECT_LE(range.least, (1.0 + 0x1p-22) * exact);
  }
}

}  // namespace
}  // namespace avo
