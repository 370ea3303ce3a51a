// SPDX-License-Identifier: Apache-2.0
// Braking in steps: closed forms against stepping, the true motion within each step, rest reached
// exactly.
#include "certificate/braking_path.h"

#include <gtest/gtest.h>
#include <string>

#include "avo/simulation.h"
#include "certificate/kernels.h"
#include "situations.h"

namespace avo::test {
namespace {

TEST(BrakingPath, stopping_length_and_steps_are_those_of_stepping) {
  for (const Motion motion : kMotions) {
    Random random(11);
    for (int i = 0; i < 3000; ++i) {
      const StepLaw law = law_of(random_options(random, Certificate::none, motion)).step;
      const double u = random.log_uniform(1e-3, 3.0), first = u * random.uniform(0.0, 60.0);
      double speed = first, length = 0.0;
      int steps = 0;
      for (; speed > 0.0; ++steps) {
        const double next = norm(braked({speed, 0.0}, u));
        length += law.lag * speed + (law.time_step - law.lag) * next;
        speed = next;
      }
      EXPECT_NEAR(stopping_length(first, u, law), length, 1e-12 * (1.0 + length));
      EXPECT_GE(braking_steps(first, u), steps);
      EXPECT_LE(braking_steps(first, u), steps + 1);
    }
  }
}

TEST(BrakingPath, stopping_takes_longer_in_steps_than_without) {
  const StepLaw held{0.5, 0.25, 0.5, {}};
  EXPECT_DOUBLE_EQ(stopping_length(2.0, 0.5, held), 2.0);  // a_max 1: v²/2a where k is whole
  // and at most u Δt/8 more, at half a step
  EXPECT_DOUBLE_EQ(stopping_length(2.25, 0.5, held) - 0.5 * 2.25 * 2.25, 0.5 * 0.5 / 8.0);
  EXPECT_EQ(stopping_length(0.0, 0.5, held), 0.0);
  EXPECT_EQ(braking_steps(0.0, 0.5), 0.0);
}

TEST(BrakingPath, distances_are_those_of_stepping) {
  for (const Motion motion : kMotions) {
    Random random(12);
    for (int i = 0; i < 500; ++i) {
      const PairSituation s = random_pair(random, Certificate::none, motion);
      const StepLaw& law = s.law.step;
      const Vec2 next = random_choice(random, s);
      const CandidatePath path = follow(s.a, next, law);
      const std::vector<Points> expected = stepped_path(s.a, next, law, 41);
      const Vec2 p = s.a.position;
      EXPECT_LE(norm(p + path.first - expected[0][2]), 1e-12);
      for (std::size_t m = 0; m < 40; ++m) {
        const auto [start, middle, end] = braking_distances(path.braking, law, static_cast<int>(m));
        const std::array<double, 3> along{start, middle, end};
        for (std::size_t k = 0; k < 3; ++k) {
          EXPECT_LE(norm(p + path.first + along[k] * path.direction - expected[m + 1][k]), 1e-11);
        }
        EXPECT_LE(along[0], along[1]);
        EXPECT_LE(along[1], along[2]);
        const bool moves = expected[m + 1][2] != expected[m + 1][0];
        if (moves) {
          EXPECT_GT(path.moving, static_cast<int>(m) + 1);
        }
      }
    }
  }
}

// How far a step of braking from v moves.
Vec2 way_of_step(Vec2 v, Vec2 next, const StepLaw& law) {
  return law.lag * v + (law.time_step - law.lag) * next;
}

// docs/certificate/errors.md, "Sensing errors": two that begin within the errors of each other.
TEST(BrakingPath, errors_move_it_no_farther_than_their_bound_which_is_reached) {
  using Real = scalar::Pack<double>;
  for (const Motion motion : kMotions) {
    Random random(15);
    double reached = 0.0;
    for (int i = 0; i < 5000; ++i) {
      StepLaw law = law_of(random_options(random, Certificate::none, motion)).step;
      law.sensing_error = {random.uniform(0.0, 0.2), random.log_uniform(1e-3, 1.0)};
      const auto& [position, velocity] = law.sensing_error;
      const double u = random.log_uniform(1e-3, 1.0);
      Vec2 seen = in_disc(random, 60.0 * u);
      if (random.below(4) == 0) seen = {};
      const double ahead = norm(seen) > 0.0 ? 1.0 / norm(seen) : 0.0;
      Vec2 real = seen + velocity * (random.below(2) == 0 ? ahead * seen : random.direction());
      Vec2 off = position * (norm(real) > 0.0 ? real / norm(real) : random.direction());
      const auto profile = scalar::profile<Real>(norm(seen), u);
      for (int m = 0; m < 120; ++m) {
        const double bound = scalar::braking_error(profile, law, Real(m + 1.0)).value;
        EXPECT_LE(norm(off + law.lag * (real - seen)), bound * (1.0 + 1e-9)) << i << " " << m;
        const Vec2 next_seen = braked(seen, u), next_real = braked(real, u);
        off = off + way_of_step(real, next_real, law) - way_of_step(seen, next_seen, law);
        seen = next_seen, real = next_real;
        EXPECT_LE(norm(off), bound * (1.0 + 1e-9)) << i << " " << m;
        if (m == 20) reached = std::max(reached, (norm(off) - position) / (bound - position));
      }
    }
    EXPECT_GT(reached, 0.99);
  }
}

// Weights of x in the triangle of q; of x on the segment where it is flat.
double least_weight(Vec2 x, const Points& q) {
  const double area = cross(q[1] - q[0], q[2] - q[0]);
  const std::array<double, 3> parts{cross(q[1] - x, q[2] - x), cross(q[2] - x, q[0] - x),
                                    cross(q[0] - x, q[1] - x)};
  return std::min({parts[0] / area, parts[1] / area, parts[2] / area});
}

TEST(BrakingPath, true_motion_stays_in_the_triangle_of_its_points) {
  for (const Motion motion : kMotions) {
    Random random(13);
    for (int i = 0; i < 500; ++i) {
      const PairSituation s = random_pair(random, Certificate::none, motion);
      // of two robots: the relative path, the other one brakes
      const Vec2 next_A = random_choice(random, s);
      const double u_B = braking_decrement(s.b.max_acceleration, s.law.step);
      const Vec2 next_B = braked(s.b.velocity, u_B);
      const Points a = stepped_path(s.a, next_A, s.law.step, 1)[0];
      const Points b = stepped_path(s.b, next_B, s.law.step, 1)[0];
      const Points q{a[0] - b[0], a[1] - b[1], a[2] - b[2]};
      const double size = norm(q[1] - q[0]) + norm(q[2] - q[0]);
      if (std::abs(cross(q[1] - q[0], q[2] - q[0])) < 1e-6 * size * size) continue;
      const TrueStep step_A{s.a.position, s.a.velocity, next_A};
      const TrueStep step_B{s.b.position, s.b.velocity, next_B};
      for (int k = 0; k <= 20; ++k) {
        const double t = s.options.time_step * k / 20.0;
        const Vec2 x = step_A.at(t, s.options) - step_B.at(t, s.options);
        EXPECT_GE(least_weight(x, q), -1e-8);
      }
      const double h = s.options.time_step;
      EXPECT_LE(norm(step_A.at(h, s.options) - step_B.at(h, s.options) - q[2]), 1e-12);
    }
  }
}

// A neighbor that would brake for ever is braked for: A has no other choice.
Scenario braking_scene(Random& random, Motion motion) {
  Scenario scene{.allow_broken_assumptions = true};
  scene.motion = motion;
  scene.sensing_radius = 1000.0;
  scene.time_step = random.log_uniform(0.02, 0.4);
  scene.control_time = random.log_uniform(scene.time_step, 4.0);
  RobotSetup a, b;
  a.max_acceleration = random.log_uniform(0.3, 5.0);
  a.max_speed = 3.0;
  a.velocity = in_disc(random, 3.0);
  a.goal = 50.0 * random.direction();
  b.position = b.goal = {-100.0, 100.0};
  b.velocity = {-1.0, 1.0};
  b.max_acceleration = 1e-9;
  b.max_speed = 1e-9;  // it is faster, and brakes for longer than is looked at
  scene.robots = {a, b};
  return scene;
}

TEST(BrakingPath, robots_that_brake_come_to_rest_exactly) {
  for (const Motion motion : kMotions) {
    Random random(14);
    for (int i = 0; i < 200; ++i) {
      const Scenario scene = braking_scene(random, motion);
      Simulation simulation(scene, 1);
      const StepLaw law = certificate_law(simulation.planner()).step;
      const double u = braking_decrement(scene.robots[0].max_acceleration, law);
      const double speed = norm(scene.robots[0].velocity);
      const double steps = braking_steps(speed, u);
      for (int k = 0; k < static_cast<int>(steps); ++k) {
        simulation.step();
        ASSERT_EQ(simulation.fleet().plan[0].status, PlanStatus::braking);
      }
      EXPECT_EQ(simulation.fleet().velocity[0], Vec2{}) << "seed " << i;
      const Vec2 stopped = simulation.fleet().position[0];
      const Vec2 expected = (stopping_length(speed, u, law) / speed) * scene.robots[0].velocity;
      EXPECT_LE(norm(stopped - expected), 1e-12 * (1.0 + norm(expected)));
      simulation.step();
      EXPECT_EQ(simulation.fleet().position[0], stopped);
    }
  }
}

}  // namespace
}  // namespace avo::test
