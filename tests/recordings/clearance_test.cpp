// SPDX-License-Identifier: Apache-2.0
// Clearances found on a grid, against all pairs.
#include <cmath>
#include <gtest/gtest.h>
#include <limits>
#include <random>
#include <vector>

#include <avo/clearance.h>
#include <avo/simulation.h>

namespace avo {
namespace {

constexpr double kNowhere = std::numeric_limits<double>::quiet_NaN();

std::vector<float> by_all_pairs(const Scenario& scenario) {
  std::vector<float> clearance;
  for (const RobotSetup& a : scenario.robots) {
    double least = std::numeric_limits<double>::infinity();
    for (const RobotSetup& b : scenario.robots) {
      const bool by_layers =
          (a.avoids.bits & b.layers.bits) != 0 && (b.avoids.bits & a.layers.bits) != 0;
      const bool both = is_parked(a) != is_parked(b) || (!is_parked(a) && by_layers);
      if (&a == &b || !both || std::isnan(b.position.x)) continue;
      least =
          std::min(least, norm(disc_center(a) - disc_center(b)) - disc_radius(a) - disc_radius(b));
    }
    clearance.push_back(std::isnan(a.position.x) ? std::numeric_limits<float>::quiet_NaN()
                                                 : static_cast<float>(least));
  }
  return clearance;
}

std::vector<float> by_grid(const Scenario& scenario) {
  std::vector<double> x, y, heading;
  for (const RobotSetup& robot : scenario.robots) {
    x.push_back(robot.position.x);
    y.push_back(robot.position.y);
    heading.push_back(robot.heading);
  }
  std::vector<float> clearance(x.size());
  ClearanceFinder(scenario).find({x, y, heading}, clearance);
  return clearance;
}

void expect_equal(const Scenario& scenario) {
  const std::vector<float> slow = by_all_pairs(scenario), fast = by_grid(scenario);
  ASSERT_EQ(slow.size(), fast.size());
  for (std::size_t i = 0; i < slow.size(); ++i) {
    EXPECT_EQ(std::isnan(slow[i]), std::isnan(fast[i])) << i;
    if (std::isfinite(slow[i])) {
      EXPECT_NEAR(fast[i], slow[i], 1e-5f) << i;
    } else if (std::isinf(slow[i])) {
      EXPECT_EQ(fast[i], slow[i]) << i;
    }
  }
}

TEST(Clearance, is_that_of_all_pairs) {
  std::mt19937_64 random(7);
  const auto number = [&random](double low, double high) {
    return low + (high - low) * static_cast<double>(random() >> 11) * 0x1p-53;
  };
  for (int scene = 0; scene < 200; ++scene) {
    Scenario scenario;
    const double width = number(0.1, 200.0), height = number(0.0, width);
    const int count = 1 + static_cast<int>(random() % 60);
    for (int k = 0; k < count; ++k) {
      RobotSetup robot;
      robot.position = {number(-width, width), number(-height, height)};
      robot.radius = number(0.1, k % 9 == 0 ? 8.0 : 1.0);
      robot.heading = number(-3.0, 3.0);
      if (random() % 4 == 0) robot.behavior = Behavior::parked;
      if (random() % 3 == 0) robot.layers = {1U << (random() % 3)};
      if (random() % 5 == 0) robot.avoids = {1U << (random() % 3)};
      if (random() % 6 == 0) robot.model = DifferentialDrive{};
      if (random() % 10 == 0) robot.position.x = kNowhere;
      scenario.robots.push_back(robot);
    }
    expect_equal(scenario);
  }
}

TEST(Clearance, of_robots_at_one_point_or_alone_is_defined) {
  Scenario scenario;
  scenario.robots.resize(1);
  expect_equal(scenario);
  scenario.robots.resize(3);
  expect_equal(scenario);
  for (RobotSetup& robot : scenario.robots) robot.position.x = kNowhere;
  expect_equal(scenario);
}

}  // namespace
}  // namespace avo
