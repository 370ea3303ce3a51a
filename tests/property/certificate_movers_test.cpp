// SPDX-License-Identifier: Apache-2.0
// Robots are among moving obstacles that decide nothing. Robots never touch each other. Only at
// rest does a robot touch a moving obstacle that keeps its acceleration. A touched robot stays at
// rest. In motion a robot may touch a moving obstacle that changes its acceleration. This contact
// is no deeper than the change and the time until rest allow.
#include <gtest/gtest.h>
#include <string>
#include <tuple>

#include "certificate_fleets.h"

namespace avo::test {
namespace {

constexpr int kFleets = 300;
constexpr int kSteps = 90;

class AmongMovers : public testing::TestWithParam<std::tuple<Certificate, Motion>> {};

std::string name_of(const testing::TestParamInfo<AmongMovers::ParamType>& info) {
  const auto [kind, motion] = info.param;
  return std::string(to_string(kind)) + (motion == Motion::held ? "_held" : "_exponential");
}

// There are 1 to 3 robots at rest and 1 to 3 moving obstacles that head towards the robots. Half of
// the moving obstacles accelerate.
Fleet fleet_among_movers(Random& random, Certificate kind, Motion motion) {
  Fleet fleet;
  fleet.options = random_options(random, kind, motion);
  const int robots = 1 + random.below(3), movers = 1 + random.below(3);
  while (static_cast<int>(fleet.robots.size()) < robots) {
    Robot robot = random_robot(random);
    robot.position = in_disc(random, 4.0);
    if (!touches(robot, others(fleet.robots, fleet.robots.size()))) fleet.robots.push_back(robot);
  }
  while (static_cast<int>(fleet.movers.size()) < movers) {
    Neighbor mover;
    mover.behavior = Behavior::moves_on;
    mover.radius = random.log_uniform(0.1, 1.5);
    mover.position = in_disc(random, 12.0);
    mover.velocity = random.uniform(-0.05, 0.4) * (in_disc(random, 3.0) - mover.position);
    if (random.below(4) == 0) mover.velocity = {};
    if (random.below(2) == 0) mover.acceleration = in_disc(random, 1.0);
    const bool clear = std::none_of(fleet.robots.begin(), fleet.robots.end(),
                                    [&](const Robot& robot) { return touches(robot, {mover}); });
    if (clear) fleet.movers.push_back(mover);
  }
  return fleet;
}

TrueStep step_of(const Neighbor& mover, double time_step) {
  return {mover.position, mover.velocity, mover.velocity + time_step * mover.acceleration};
}

// The mover's parabola is no motion of the robot's kind where that is exponential: sampled densely.
double least_distance_of(const TrueStep& robot, const Neighbor& mover,
                         const PlannerOptions& options) {
  const double h = options.time_step;
  if (options.motion == Motion::held) return least_distance(robot, step_of(mover, h), options);
  double least = 1.0 / 0.0;
  for (int k = 0; k <= 200; ++k) {
    const double t = h * k / 200.0;
    const Vec2 x = mover.position + t * mover.velocity + (0.5 * t * t) * mover.acceleration;
    least = std::min(least, norm(robot.at(t, options) - x));
  }
  return least;
}

// What the movers do besides what robots expect of them.
struct Whims {
  double change = 0.0;       // of their accelerations, m/s^2 at most
  bool looks_large = false;  // by how far that can take them until a robot rests
};

// Time from a decision until the robot rests, whatever it decides now.
double time_until_rest(const Robot& robot, const StepLaw& law) {
  const double u = braking_decrement(robot.max_acceleration, law);
  return law.time_step * (1.0 + std::ceil(robot.max_speed / u));
}

// m, that a change takes a mover off its predicted path until the robot rests.
double way_of(const Whims& whims, const Robot& robot, const StepLaw& law) {
  const double t = time_until_rest(robot, law);
  return 0.5 * whims.change * t * t;
}

struct Seen {
  double least_gap = 1.0 / 0.0;         // m, between robots
  double least_gap_moving = 1.0 / 0.0;  // m, to a mover over a step in which the robot moves
  double most_of_bound = 0.0;  // depth of a contact in motion, as a part of what is possible
  int contacts_moving = 0;     // robot-steps of them
  int contacts = 0;            // robot-steps in contact with a mover
  int moves = 0;               // robot-steps in motion
};

void look(const std::vector<TrueStep>& steps, const Fleet& fleet, const StepLaw& law,
          const Whims& whims, Seen& result) {
  for (std::size_t i = 0; i < steps.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      const double contact = fleet.robots[i].radius + fleet.robots[j].radius;
      result.least_gap =
          std::min(result.least_gap, least_distance(steps[i], steps[j], fleet.options) - contact);
    }
    const bool moves = steps[i].velocity != Vec2{} || steps[i].next_velocity != Vec2{};
    result.moves += moves ? 1 : 0;
    for (const Neighbor& mover : fleet.movers) {
      const double gap = least_distance_of(steps[i], mover, fleet.options) -
                         (fleet.robots[i].radius + mover.radius);
      if (moves) result.least_gap_moving = std::min(result.least_gap_moving, gap);
      if (moves && gap < 0.0 && whims.change > 0.0) {
        const double way = way_of(whims, fleet.robots[i], law);
        result.most_of_bound = std::max(result.most_of_bound, -gap / way);
        ++result.contacts_moving;
      }
      if (gap < 0.0) ++result.contacts;
    }
  }
}

// Movers change their accelerations just after the robots have looked.
void step(Random& random, Fleet& fleet, const CertificateLaw& law,
          CertificateConstraints& constraints, const Whims& whims, Seen& result) {
  std::vector<TrueStep> steps;
  for (std::size_t k = 0; k < fleet.robots.size(); ++k) {
    const Robot& robot = fleet.robots[k];
    std::vector<Neighbor> neighbors = others(fleet.robots, k);
    for (Neighbor mover : fleet.movers) {
      if (whims.looks_large) mover.radius += way_of(whims, robot, law.step);
      neighbors.push_back(mover);
    }
    collect_constraints(robot, neighbors, law, constraints);
    const Vec2 next = adverse_velocity(random, robot, static_cast<Whim>(random.below(4)), neighbors,
                                       law, constraints);
    steps.push_back({robot.position, robot.velocity, next});
  }
  for (Neighbor& mover : fleet.movers) {
    if (whims.change > 0.0) mover.acceleration = in_disc(random, 0.5 * whims.change);
  }
  look(steps, fleet, law.step, whims, result);
  const double h = law.step.time_step;
  for (std::size_t k = 0; k < steps.size(); ++k) {
    fleet.robots[k].position = steps[k].at(h, fleet.options);
    fleet.robots[k].velocity = steps[k].next_velocity;
  }
  for (Neighbor& mover : fleet.movers) {
    mover.position = mover.position + h * mover.velocity + (0.5 * h * h) * mover.acceleration;
    mover.velocity = mover.velocity + h * mover.acceleration;
  }
}

TEST_P(AmongMovers, who_is_touched_is_at_rest_and_stays_so) {
  const auto [kind, motion] = GetParam();
  CertificateConstraints constraints;
  Seen all;
  for (int seed = 1; seed <= kFleets; ++seed) {
    Random random(static_cast<std::uint64_t>(seed));
    Fleet fleet = fleet_among_movers(random, kind, motion);
    const CertificateLaw law = law_of(fleet.options);
    for (int k = 0; k < kSteps; ++k) {
      step(random, fleet, law, constraints, {}, all);
      ASSERT_GE(all.least_gap, 0.0) << "seed " << seed << " step " << k;
      // a robot that starts beside a mover is not inflated: rounding of the lengths may show
      ASSERT_GE(all.least_gap_moving, -1e-12) << "seed " << seed << " step " << k;
    }
  }
  EXPECT_GT(all.contacts, 1000);
  EXPECT_GT(all.moves, 10000);
  EXPECT_LT(all.least_gap_moving, 1e-3);
}

Seen among_changing_movers(Certificate kind, Motion motion, double most, bool looks_large) {
  CertificateConstraints constraints;
  Seen all;
  for (int seed = 1; seed <= kFleets; ++seed) {
    Random random(static_cast<std::uint64_t>(seed));
    Fleet fleet = fleet_among_movers(random, kind, motion);
    const CertificateLaw law = law_of(fleet.options);
    const Whims whims{random.log_uniform(0.01, most), looks_large};
    for (Neighbor& mover : fleet.movers) mover.acceleration = in_disc(random, 0.5 * whims.change);
    for (int k = 0; k < kSteps; ++k) step(random, fleet, law, constraints, whims, all);
  }
  return all;
}

TEST_P(AmongMovers, changed_accelerations_are_touched_in_motion_no_deeper_than_proven) {
  const auto [kind, motion] = GetParam();
  const Seen all = among_changing_movers(kind, motion, 2.0, false);
  EXPECT_GE(all.least_gap, 0.0);
  EXPECT_LE(all.most_of_bound, 1.0);
  EXPECT_GT(all.contacts_moving, 100);
  EXPECT_LT(all.least_gap_moving, -0.05);
}

TEST_P(AmongMovers, taken_for_larger_by_what_a_change_does_are_touched_at_rest_only) {
  const auto [kind, motion] = GetParam();
  EXPECT_GT(among_changing_movers(kind, motion, 0.1, false).contacts_moving, 10);
  const Seen all = among_changing_movers(kind, motion, 0.1, true);
  EXPECT_GE(all.least_gap, 0.0);
  EXPECT_GE(all.least_gap_moving, 0.0);
  EXPECT_GT(all.moves, 10000);
}

// Near what is proven: A drives at a mover at rest as fast as it may; when it can only just stop,
// the mover comes towards it. From then on A brakes as hard as it can, and says that it is touched.
TEST(ChangingMover, is_touched_in_motion_nearly_as_deep_as_proven) {
  constexpr double kChange = 0.2;
  const PlannerOptions options;
  const CertificateLaw law = law_of(options);
  CertificateConstraints constraints;
  Robot robot;
  Neighbor mover{.position = {12.0, 0.0}, .behavior = Behavior::moves_on};
  double deepest = 0.0;
  bool comes = false;
  for (int k = 0; k < 200; ++k) {
    collect_constraints(robot, {&mover, 1}, law, constraints);
    const bool broken = constraints.invariant.touched;
    const Vec2 wish = within_speed(robot, {0.1, 0.0});
    const Vec2 next = farthest_admitted(robot, wish, law, constraints, 40);
    if (broken) {
      EXPECT_EQ(next, backup_velocity(robot, law)) << k;
    }
    if (!comes && next.x < wish.x) {
      comes = true;
      mover.acceleration = {-kChange, 0.0};
    }
    const TrueStep step{robot.position, robot.velocity, next};
    const double gap = least_distance(step, step_of(mover, 0.1), options) - 1.0;
    if (robot.velocity != Vec2{} || next != Vec2{}) deepest = std::max(deepest, -gap);
    robot.position = step.at(0.1, options);
    robot.velocity = next;
    mover.position = mover.position + 0.1 * mover.velocity + 0.005 * mover.acceleration;
    mover.velocity = mover.velocity + 0.1 * mover.acceleration;
    if (comes && next == Vec2{}) break;
  }
  const double t = time_until_rest(robot, law.step);
  EXPECT_LE(deepest, 0.5 * kChange * t * t);
  EXPECT_GE(deepest, 0.8 * 0.5 * kChange * t * t);
}

INSTANTIATE_TEST_SUITE_P(
    , AmongMovers,
    testing::Values(std::tuple(Certificate::braking_trajectories, Motion::held),
                    std::tuple(Certificate::braking_trajectories, Motion::exponential)),
    name_of);

}  // namespace
}  // namespace avo::test
