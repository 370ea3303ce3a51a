// SPDX-License-Identifier: Apache-2.0
// The judge follows each disc of a footprint between the rows: integration by small parts says
// where the discs are.
#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <numbers>
#include <vector>

#include "avo/check.h"
#include "support/generators.h"
#include "support/refusal.h"

namespace avo::test {
namespace {

constexpr double kTruckStep = 0.4;  // s
constexpr int kParts = 4000;

Vec2 direction(double angle) {
  return {std::cos(angle), std::sin(angle)};
}

struct Truck {
  CheckedRobot robot;
  CheckedState before, now;
  std::vector<std::vector<Vec2>> ways;  // of each disc
};

CheckedRobot covered(const CheckedKinematics& kinematics, Random& random) {
  CheckedRobot robot;
  robot.radius = random.uniform(0.3, 0.8);
  robot.max_acceleration = robot.max_speed = 1e6;
  robot.kinematics = kinematics;
  const double first = random.uniform(-2.0, 0.5), spacing = random.uniform(0.3, 1.0);
  for (int k = 0; k < 1 + random.below(5); ++k) robot.discs.push_back(first + k * spacing);
  return robot;
}

void note(Vec2 axle, double heading, Truck& truck) {
  for (std::size_t k = 0; k < truck.ways.size(); ++k)
    truck.ways[k].push_back(axle + truck.robot.discs[k] * direction(heading));
}

// On an arc with a constant change of its speed, or turning at rest.
Truck on_an_arc(Random& random) {
  Truck truck{covered(CheckedCar{.reverse = true, .exact_set = true}, random), {}, {}, {}};
  truck.ways.resize(truck.robot.discs.size());
  const bool rests = random.below(3) == 0;
  const double speed = rests ? 0.0 : random.uniform(0.2, 2.0);
  const double next = rests ? 0.0 : random.uniform(0.2, 2.0), turn = random.uniform(-1.5, 1.5);
  const double length = 0.5 * kTruckStep * (speed + next);
  double heading = random.uniform(-3.0, 3.0);
  Vec2 axle = in_disc(random, 1.0);
  truck.before = {0, axle, speed * direction(heading), CheckedHeading{heading, speed}};
  const double start = heading;
  note(axle, heading, truck);
  for (int k = 0; k < kParts; ++k) {
    const double part = (k + 0.5) / kParts, v = speed + part * (next - speed);
    const double covered_way = kTruckStep * part * (speed + 0.5 * part * (next - speed));
    const double middle = start + turn * (rests ? part * part : covered_way / length);
    axle = axle + (kTruckStep / kParts * v) * direction(middle);
    const double end = static_cast<double>(k + 1) / kParts;
    const double end_way = kTruckStep * end * (speed + 0.5 * end * (next - speed));
    heading = start + turn * (rests ? end * end : end_way / length);
    note(axle, heading, truck);
  }
  truck.now = {0, axle, next * direction(heading), CheckedHeading{heading, next}};
  return truck;
}

// Towed by a point that accelerates evenly.
Truck towed(Random& random) {
  const double offset = random.uniform(0.2, 0.8);
  Truck truck{covered(CheckedDrive{.track = 0.5, .offset = offset}, random), {}, {}, {}};
  truck.ways.resize(truck.robot.discs.size());
  double heading = random.uniform(-3.0, 3.0);
  Vec2 axle = in_disc(random, 1.0);
  const Vec2 velocity = in_disc(random, 1.5), next = velocity + in_disc(random, 0.5);
  const auto along = [&](double angle, Vec2 v) { return dot(direction(angle), v); };
  truck.before = {0, axle, velocity, CheckedHeading{heading, along(heading, velocity)}};
  note(axle, heading, truck);
  Vec2 point = axle + offset * direction(heading);
  for (int k = 0; k < kParts; ++k) {
    const double part = (k + 0.5) / kParts, step = kTruckStep / kParts;
    const Vec2 v = velocity + part * (next - velocity);
    const auto rate = [&](double angle) {
      return dot(Vec2{-std::sin(angle), std::cos(angle)}, v) / offset;
    };
    heading += step * rate(heading + 0.5 * step * rate(heading));
    point = point + step * v;
    axle = point - offset * direction(heading);
    note(axle, heading, truck);
  }
  truck.now = {0, axle, next, CheckedHeading{heading, along(heading, next)}};
  return truck;
}

// Compares the least distance from a robot at rest, and from a wall.
void expect_ways(const Truck& truck, Random& random) {
  const Vec2 place = in_disc(random, 4.0), a = in_disc(random, 4.0), b = in_disc(random, 4.0);
  CheckedRobot other;
  other.radius = 0.2;
  Check check({truck.robot, other});
  check.set_walls({{a, b, 0.1}});
  const auto add = [&](double time, const CheckedState& row) {
    check.add(time, std::vector<CheckedState>{row, {1, place, {}}});
  };
  add(0.0, truck.before), add(kTruckStep, truck.now);
  double apart = 1e9, from_wall = 1e9;
  for (const std::vector<Vec2>& way : truck.ways) {
    for (const Vec2 p : way) {
      apart = std::min(apart, norm(p - place));
      const double part = std::clamp(dot(p - a, b - a) / dot(b - a, b - a), 0.0, 1.0);
      from_wall = std::min(from_wall, norm(p - a - part * (b - a)));
    }
  }
  const CheckReport report = check.report();
  EXPECT_NEAR(*report.least_clearance, apart - truck.robot.radius - 0.2, 1e-5);
  const double part = std::clamp(dot(place - a, b - a) / dot(b - a, b - a), 0.0, 1.0);
  const double others = norm(place - a - part * (b - a)) - 0.3;
  // samples on both sides of the wall miss the point on it
  EXPECT_NEAR(*report.least_static_clearance,
              std::min(from_wall - truck.robot.radius - 0.1, others),
              from_wall < 0.01 ? 1e-3 : 1e-5);
  const bool touches = apart < truck.robot.radius + 0.2 - 1e-5;
  if (touches) {
    EXPECT_EQ(report.overlaps.count, 1);
  }
}

TEST(CheckFootprints, discs_of_a_car_are_where_its_arc_takes_them) {
  Random random(1);
  for (int k = 0; k < 200; ++k) expect_ways(on_an_arc(random), random);
}

TEST(CheckFootprints, discs_of_a_drive_are_where_its_point_tows_them) {
  Random random(2);
  for (int k = 0; k < 200; ++k) expect_ways(towed(random), random);
}

TEST(CheckFootprints, are_those_of_cars_and_drives_alone) {
  CheckedRobot robot;
  robot.discs = {0.0, 1.0};
  EXPECT_EQ(refusal([&] { Check({robot}); }),
            "robots.0.discs: found 2, must be none: it is no car and no drive");
  robot.kinematics = CheckedCar{};
  robot.discs.resize(6);
  EXPECT_EQ(refusal([&] { Check({robot}); }), "robots.0.discs: found 6, must be at most 5");
}

}  // namespace
}  // namespace avo::test
