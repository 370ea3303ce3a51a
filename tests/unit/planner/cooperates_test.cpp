// SPDX-License-Identifier: Apache-2.0
// Neighbors that cooperate: their share by half-planes, and no promise
// (docs/certificate/movers.md, "Robots that cooperate").
#include <gtest/gtest.h>
#include <vector>

#include "unit/planner/crowds.h"

namespace avo {
namespace {

using test::Crowd;
using test::Random;

// With what a planner must not read of them: an acceleration.
std::vector<Neighbor> as(Behavior behavior, std::vector<Neighbor> neighbors) {
  for (Neighbor& B : neighbors) {
    B.behavior = behavior;
    B.acceleration = behavior == Behavior::moves_on ? Vec2{} : Vec2{0.3, -0.2};
  }
  return neighbors;
}

Crowd random_crowd(Random& random, Method method) {
  Crowd crowd;
  crowd.options = default_options(method);
  crowd.robot = test::paper_robot({}, test::in_disc(random, 2.0), test::in_disc(random, 2.0));
  const int count = 1 + static_cast<int>(random.below(5));
  for (int k = 0; k < count; ++k)
    crowd.neighbors.push_back(test::random_neighbor(random, crowd.robot, 0.01));
  return crowd;
}

TEST(Cooperates, half_planes_are_those_of_one_that_decides) {
  Random random(1);
  PlanWorkspace workspace;
  int compared = 0;
  for (const Method method : {Method::avo, Method::avo_paper, Method::orca, Method::orca_clamped,
                              Method::buffered_voronoi}) {
    for (int trial = 0; trial < 200; ++trial) {
      const Crowd crowd = random_crowd(random, method);
      const Planner planner(crowd.options);
      HalfPlanes expected, found;
      planner.collect_half_planes(crowd.robot, as(Behavior::decides, crowd.neighbors), workspace,
                                  expected);
      planner.collect_half_planes(crowd.robot, as(Behavior::cooperates, crowd.neighbors), workspace,
                                  found);
      ASSERT_EQ(found.planes.size(), expected.planes.size());
      for (std::size_t k = 0; k < found.planes.size(); ++k, ++compared) {
        EXPECT_EQ(found.planes[k].neighbor, expected.planes[k].neighbor);
        EXPECT_EQ(found.planes[k].plane.normal, expected.planes[k].plane.normal);
        EXPECT_EQ(found.planes[k].plane.offset, expected.planes[k].plane.offset);
      }
      if (method == Method::avo) continue;  // its certificate tells them apart
      const auto plan = [&](Behavior behavior) {
        return planner.plan(crowd.robot, as(behavior, crowd.neighbors), workspace);
      };
      EXPECT_EQ(plan(Behavior::cooperates).new_velocity, plan(Behavior::decides).new_velocity)
          << crowd;
    }
  }
  EXPECT_GT(compared, 500);
}

TEST(Cooperates, reciprocal_velocity_obstacles_are_those_of_one_that_decides) {
  Random random(2);
  PlanWorkspace workspace;
  for (int trial = 0; trial < 100; ++trial) {
    const Crowd crowd = random_crowd(random, Method::reciprocal_velocity_obstacle);
    const Planner planner(crowd.options);
    const auto plan = [&](Behavior behavior) {
      return planner.plan(crowd.robot, as(behavior, crowd.neighbors), workspace).new_velocity;
    };
    EXPECT_EQ(plan(Behavior::cooperates), plan(Behavior::decides)) << crowd;
  }
}

TEST(Cooperates, the_certificate_is_that_against_a_mover_of_its_velocity) {
  Random random(3);
  PlanWorkspace workspace;
  std::size_t compared = 0, unlike = 0;
  for (int trial = 0; trial < 200; ++trial) {
    Crowd crowd = random_crowd(random, Method::avo);
    for (Neighbor& B : crowd.neighbors) {
      B.max_deviation = random.below(2) == 0 ? 0.0 : 0.5;
      B.max_speed = 2.5;
    }
    const Planner planner(crowd.options);
    const auto constraints_of = [&](Behavior behavior) {
      std::vector<CertificateConstraint> constraints;
      planner.collect_certificate(crowd.robot, as(behavior, crowd.neighbors), workspace,
                                  constraints);
      return constraints;
    };
    const auto found = constraints_of(Behavior::cooperates),
               expected = constraints_of(Behavior::moves_on);
    ASSERT_EQ(found.size(), expected.size()) << crowd;
    for (std::size_t k = 0; k < found.size(); ++k, ++compared) {
      EXPECT_EQ(found[k].neighbor, expected[k].neighbor);
      EXPECT_EQ(found[k].interval, expected[k].interval);
      EXPECT_EQ(found[k].normal, expected[k].normal);
      EXPECT_EQ(found[k].offset, expected[k].offset);
    }
    if (constraints_of(Behavior::decides).size() != found.size()) ++unlike;
  }
  EXPECT_GT(compared, 1000U);
  EXPECT_GT(unlike, 20U) << "else nothing tells it from one that decides";
}

// B drives straight on, as no promise says that it would not.
struct Met {
  bool in_motion = false, at_rest = false;
};
Met meet(Behavior behavior) {
  const Planner planner(default_options(Method::avo));
  Robot A = test::paper_robot({}, {1.5, 0}, {1.5, 0});
  Neighbor B{.position = {9, 0.1}, .velocity = {-2, 0}, .behavior = behavior};
  // a wall on either side: there is no room beside B
  const std::vector<Wall> walls{{{-20, 0.6}, {20, 0.6}, 0.0}, {{-20, -0.6}, {20, -0.6}, 0.0}};
  PlanWorkspace workspace;
  Detour detour;
  Met met;
  for (int step = 0; step < 80; ++step) {
    const Plan plan = planner.plan(A, std::vector{B}, workspace, &detour, walls);
    const Vec2 next = plan.next_velocity;
    A.position = A.position + 0.05 * (A.velocity + next);
    B.position = B.position + 0.1 * B.velocity;
    const bool moves = A.velocity != Vec2{} || next != Vec2{};
    A.velocity = next;
    if (norm(A.position - B.position) >= 1.0) continue;
    (moves ? met.in_motion : met.at_rest) = true;
    break;
  }
  return met;
}

TEST(Cooperates, nobody_counts_on_it_to_brake) {
  EXPECT_TRUE(meet(Behavior::decides).in_motion) << "it has counted on B's brakes";
  const Met met = meet(Behavior::cooperates);
  EXPECT_FALSE(met.in_motion);
  EXPECT_TRUE(met.at_rest);
}

// B takes its share by its priority, as a robot that decides does.
TEST(Cooperates, takes_its_share_by_priority) {
  const Planner planner(test::paper_options());
  const Robot A = test::paper_robot({}, {1.5, 0}, {1.5, 0});
  PlanWorkspace workspace;
  const auto offset = [&](Behavior behavior, double priority) {
    const Neighbor B{
        .position = {6, 0.3}, .velocity = {-1.5, 0}, .behavior = behavior, .priority = priority};
    return planner.plan(A, std::vector{B}, workspace).new_velocity.y;
  };
  EXPECT_EQ(offset(Behavior::cooperates, 3.0), offset(Behavior::decides, 3.0));
  EXPECT_NE(offset(Behavior::cooperates, 3.0), offset(Behavior::cooperates, 1.0));
}

// Its state may be doomed as beside one that decides, not as beside one that keeps its motion.
TEST(Cooperates, contact_is_inevitable_only_if_it_can_do_nothing_either) {
  const Planner planner(default_options(Method::avo));
  PlanWorkspace workspace;
  const Robot A = test::paper_robot({}, {}, {});
  const auto state = [&](Behavior behavior) {
    const Neighbor B{.position = {1.8, 0}, .velocity = {-1.5, 0}, .behavior = behavior};
    return planner.state(A, std::vector{B}, workspace).state;
  };
  EXPECT_EQ(state(Behavior::moves_on), SafetyState::doomed);
  EXPECT_NE(state(Behavior::cooperates), SafetyState::doomed);
}

TEST(Cooperates, its_numbers_are_those_of_one_that_decides_and_of_a_mover) {
  const Planner planner(default_options(Method::avo));
  PlanWorkspace workspace;
  const Neighbor good{
      .position = {6, 0.3}, .velocity = {-1.5, 0}, .behavior = Behavior::cooperates};
  const auto status = [&](Neighbor B) {
    return planner.plan(test::paper_robot({}, {}, {1, 0}), std::vector{B}, workspace).status;
  };
  EXPECT_NE(status(good), PlanStatus::invalid_input);
  Neighbor bad = good;
  bad.max_acceleration = 0.0;
  EXPECT_EQ(status(bad), PlanStatus::invalid_input);
  bad = good, bad.priority = -1.0;
  EXPECT_EQ(status(bad), PlanStatus::invalid_input);
  bad = good, bad.max_deviation = -1.0;
  EXPECT_EQ(status(bad), PlanStatus::invalid_input);
  bad = good, bad.max_speed = 0.0;
  EXPECT_EQ(status(bad), PlanStatus::invalid_input);
}

}  // namespace
}  // namespace avo
