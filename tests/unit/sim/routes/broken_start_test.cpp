// SPDX-License-Identifier: Apache-2.0
// Robots that are put into each other: their decisions tell, no overlap grows, they part.
#include <cmath>
#include <gtest/gtest.h>
#include <limits>
#include <map>
#include <span>
#include <utility>

#include "certificate/certificate.h"
#include "planner/stages/certify.h"
#include "support/generators.h"
#include "unit/sim/certified_scenes.h"

namespace avo {
namespace {

using test::Kind;
using test::kKinds;
using test::Random;

// By pair, m: how far the two stay apart if all brake now, less than nothing where they overlap.
using Slacks = std::map<std::pair<std::size_t, std::size_t>, double>;

Slacks slacks(const Simulation& simulation, const CertificateLaw& law) {
  const FleetView fleet = simulation.fleet();
  CertificateConstraints constraints;
  Slacks result;
  for (std::size_t i = 0; i < fleet.id.size(); ++i) {
    for (std::size_t j = i + 1; j < fleet.id.size(); ++j) {
      Robot robot;
      robot.position = fleet.position[i], robot.velocity = fleet.velocity[i];
      robot.radius = fleet.setup[i].radius;
      robot.max_acceleration = fleet.setup[i].max_acceleration;
      const Neighbor other{fleet.position[j],
                           fleet.velocity[j],
                           fleet.setup[j].radius,
                           fleet.setup[j].max_acceleration,
                           {}};
      collect_constraints(robot, std::span(&other, 1), law, constraints);
      result[{i, j}] = constraints.invariant.slack;
    }
  }
  return result;
}

double deepest(const FleetView& fleet) {
  double depth = 0.0;
  for (std::size_t i = 0; i < fleet.id.size(); ++i) {
    for (std::size_t j = i + 1; j < fleet.id.size(); ++j) {
      depth = std::max(depth, fleet.setup[i].radius + fleet.setup[j].radius -
                                  norm(fleet.position[i] - fleet.position[j]));
    }
  }
  return depth;
}

RobotSetup robot_near(Vec2 place, double extent, Random& random) {
  RobotSetup robot;
  robot.position = place + test::in_disc(random, extent);
  robot.goal = place + 15.0 * random.direction();
  robot.radius = random.uniform(0.3, 0.6);
  robot.max_acceleration = random.log_uniform(0.5, 2.0);
  return robot;
}

// One robot alone, far away, and a cluster that is dropped beside it later.
Simulation with_cluster(int count, Kind kind, Random& random) {
  Scenario scene;
  scene.certificate = kind.certificate;
  scene.motion = kind.motion;
  scene.robots.resize(1);
  scene.robots[0].position = {0.0, 40.0};
  scene.robots[0].goal = {0.0, 60.0};
  scene.robots[0].max_acceleration = 0.5;
  scene.sensing_radius = 25.0;  // all are seen early enough
  scene.allow_broken_assumptions = true;
  Simulation simulation(scene, 1);
  for (int k = 0; k < 5; ++k) simulation.step();
  const double extent = 0.25 * std::sqrt(static_cast<double>(count));
  for (int i = 0; i < count; ++i) simulation.add_robot(robot_near({}, extent, random));
  return simulation;
}

TEST(BrokenStart, robots_dropped_into_each_other_go_no_deeper_and_part) {
  Random random(21);
  for (const Kind kind : kKinds) {
    for (int count = 2; count <= 20; count += 3) {
      Simulation simulation = with_cluster(count, kind, random);
      const CertificateLaw law = certificate_law(simulation.planner());
      Slacks before = slacks(simulation, law);
      const double start = deepest(simulation.fleet());
      ASSERT_GT(start, 0.0);
      for (int k = 0; k < 600; ++k) {
        simulation.step();
        if (k == 0) {
          int told = 0;
          for (const Plan& plan : simulation.fleet().plan) {
            told += plan.status == PlanStatus::overlapping ? 1 : 0;
          }
          EXPECT_GE(told, 2);
        }
        const Slacks after = slacks(simulation, law);
        for (const auto& [pair, slack] : after) {
          if (slack < -1e-9) {
            ASSERT_GE(slack, before[pair] - 1e-9) << count << " step " << k;
          }
        }
        ASSERT_LE(deepest(simulation.fleet()), start + 1e-9);
        before = after;
      }
      EXPECT_LE(deepest(simulation.fleet()), 1e-9) << count << " robots have not parted";
    }
  }
}

TEST(BrokenStart, robots_in_one_place_do_no_harm_to_themselves) {
  for (const Kind kind : kKinds) {
    Scenario scene;
    scene.certificate = kind.certificate;
    scene.motion = kind.motion;
    scene.robots.resize(5);
    scene.allow_broken_assumptions = true;
    for (std::size_t i = 0; i < 5; ++i) {
      const double angle = 1.2 * static_cast<double>(i);
      scene.robots[i].goal = {10.0 * std::cos(angle), 10.0 * std::sin(angle)};
    }
    Simulation simulation(scene, 1);
    for (int k = 0; k < 300; ++k) {
      simulation.step();
      for (const Vec2 position : simulation.fleet().position) ASSERT_TRUE(is_finite(position));
    }
    if (kind.certificate == Certificate::braking_trajectories) {
      EXPECT_LT(deepest(simulation.fleet()), 1e-9);
    }
  }
}

}  // namespace
}  // namespace avo
