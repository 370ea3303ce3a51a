// SPDX-License-Identifier: Apache-2.0
// Lemma 3 through the planner: two robots that each decide alone never meet before τ.
#include <algorithm>
#include <gtest/gtest.h>

#include "support/brute_force.h"
#include "unit/planner/crowds.h"

namespace avo {
namespace {

using test::Crowd;
using test::Random;

struct Meeting {
  PlannerOptions options = test::paper_options();
  Robot A, B;
};

// Both robots have random ability, are not in contact, and mostly drive towards each other.
Meeting random_meeting(Random& random) {
  Meeting meeting;
  meeting.options.control_time = random.log_uniform(0.1, 8.0);
  meeting.options.time_horizon = random.log_uniform(0.5, 15.0);
  const auto robot = [&](double size) {
    Robot each;
    each.radius = size * random.log_uniform(0.3, 3.0);
    each.max_acceleration = size * random.log_uniform(0.1, 5.0);
    each.max_speed = size * random.log_uniform(0.5, 4.0);
    each.velocity = test::velocity_or_rest(random, each.max_speed);
    return each;
  };
  const double size = random.below(3) == 0 ? random.log_uniform(1e-4, 1e4) : 1.0;
  meeting.A = robot(size);
  meeting.B = robot(size);
  const double contact = meeting.A.radius + meeting.B.radius;
  const Vec2 direction = random.below(3) == 0 ? Vec2{0, -1} : random.direction();
  meeting.A.position = contact * (1.0 + random.log_uniform(1e-6, 15.0)) * direction;
  const double aside = random.below(3) == 0 ? 0.0 : random.uniform(-0.5, 0.5);
  const Vec2 towards = -direction + aside * perpendicular(direction);
  meeting.A.preferred_velocity = meeting.A.max_speed * towards;
  meeting.B.preferred_velocity = -meeting.B.max_speed * towards;
  return meeting;
}

TEST(Reciprocity, P8_two_that_both_found_a_velocity_do_not_meet_before_tau) {
  Random random(8);
  int both_optimal = 0, would_meet = 0;
  for (int k = 0; k < 60'000 && !testing::Test::HasFailure(); ++k) {
    const Meeting m = random_meeting(random);
    const Planner planner(m.options);
    PlanWorkspace workspace;
    const Plan of_A = planner.plan(m.A, std::vector<Neighbor>{test::as_neighbor(m.B)}, workspace);
    const Plan of_B = planner.plan(m.B, std::vector<Neighbor>{test::as_neighbor(m.A)}, workspace);
    if (of_A.status != PlanStatus::optimal || of_B.status != PlanStatus::optimal) continue;
    ++both_optimal;

    const Pair pair{m.A.position - m.B.position, m.A.velocity - m.B.velocity,
                    m.A.radius + m.B.radius};
    const Obstacle obstacle{pair, Response::proportional(m.options.control_time),
                            m.options.time_horizon};
    const Vec2 v_new_AB = of_A.new_velocity - of_B.new_velocity;
    const double d = closest_approach(obstacle, v_new_AB).distance;
    EXPECT_GE(d, pair.radius * (1.0 - 1e-9)) << Crowd{m.options, m.A, {test::as_neighbor(m.B)}};
    if (k % 20 == 0) {  // by a second text that shares no formula
      const test::Situation s{pair, 0.0, m.options.control_time, m.options.time_horizon};
      EXPECT_GE(test::slow_distance(s, v_new_AB - pair.velocity), pair.radius * (1.0 - 1e-8));
    }
    if (contains(obstacle, m.A.preferred_velocity - m.B.preferred_velocity)) ++would_meet;
  }
  EXPECT_GT(both_optimal, 20'000);
  EXPECT_GT(would_meet, 10'000);
}

// Definition 4: as long as all robots find a velocity and keep it, no two of them meet before τ.
TEST(Reciprocity, P15_no_collision_before_tau_while_all_are_optimal) {
  Random random(15);
  const Planner planner(test::paper_options());
  PlanWorkspace workspace;
  int all_optimal = 0, would_meet = 0;
  for (int k = 0; k < 20'000 && !testing::Test::HasFailure(); ++k) {
    std::vector<Robot> robots;
    for (int i = 0; i < 5; ++i) {
      const Vec2 place = test::in_disc(random, 9.0);
      robots.push_back(test::paper_robot(place, test::in_disc(random, 1.0), -0.2 * place));
    }
    std::vector<Vec2> v_new;
    for (const Robot& A : robots) {
      std::vector<Neighbor> others;
      for (const Robot& B : robots) {
        if (&B != &A) others.push_back(test::as_neighbor(B));
      }
      const Plan plan = planner.plan(A, others, workspace);
      if (plan.status == PlanStatus::optimal) v_new.push_back(plan.new_velocity);
    }
    if (v_new.size() < robots.size()) continue;
    ++all_optimal;
    for (std::size_t a = 0; a < robots.size(); ++a) {
      for (std::size_t b = 0; b < a; ++b) {
        const Pair pair{robots[a].position - robots[b].position,
                        robots[a].velocity - robots[b].velocity, 1.0};
        const Obstacle obstacle{pair, Response::proportional(4.0), 10.0};
        // two that seem to touch, by no more than rounding may feign, come no deeper
        const double contact = std::min(1.0, norm(pair.position));
        EXPECT_GE(contact, 1.0 - 0x1p-12);
        EXPECT_GE(closest_approach(obstacle, v_new[a] - v_new[b]).distance, contact - 1e-9);
        if (contains(obstacle, robots[a].preferred_velocity - robots[b].preferred_velocity)) {
          ++would_meet;
        }
      }
    }
  }
  EXPECT_GT(all_optimal, 1'000);
  EXPECT_GT(would_meet, 1'000);
}

// Neither robot does more than its part.
TEST(Reciprocity, P8_is_tight_two_robots_just_pass) {
  const Robot A = test::paper_robot({-3, 0.05}, {1.5, 0}, {2, 0});
  const Robot B = test::paper_robot({3, -0.05}, {-1.5, 0}, {-2, 0});
  const Planner planner(test::paper_options());
  PlanWorkspace workspace;
  const Plan of_A = planner.plan(A, std::vector<Neighbor>{test::as_neighbor(B)}, workspace);
  const Plan of_B = planner.plan(B, std::vector<Neighbor>{test::as_neighbor(A)}, workspace);
  ASSERT_EQ(of_A.status, PlanStatus::optimal);
  const Pair pair{A.position - B.position, A.velocity - B.velocity, 1.0};
  const Obstacle obstacle{pair, Response::proportional(4.0), 10.0};
  const double d = closest_approach(obstacle, of_A.new_velocity - of_B.new_velocity).distance;
  EXPECT_GE(d, 1.0 - 1e-12);
  EXPECT_LT(d, 1.01);
}

}  // namespace
}  // namespace avo
