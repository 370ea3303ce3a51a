// SPDX-License-Identifier: Apache-2.0
// Robots see what their errors say, and the true motion is judged: declared errors cost no contact,
// undeclared ones do.
#include "sensing.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <string>
#include <vector>

#include "families.h"
#include "run.h"
#include "table.h"

namespace avo::safety {
namespace {

// Three robots; the first one observes.
std::vector<Robot> three_robots() {
  std::vector<Robot> robots(3);
  robots[1].position = {2.0, 0.0};
  robots[1].velocity = {0.5, 0.5};
  robots[2].position = {0.0, 3.0};
  return robots;
}

std::vector<Neighbor> seen(Senses& senses, std::int64_t step) {
  const std::vector<Robot> robots = three_robots();
  std::vector<Neighbor> neighbors;
  senses.observe(0, robots, robots, step, neighbors);
  return neighbors;
}

TEST(Senses, err_as_far_as_they_say_and_where_they_say) {
  const std::vector<Robot> robots = three_robots();
  for (int shape = 0; shape < kErrorShapes; ++shape) {
    Sensing sensing;
    sensing.error = {0.1, 0.2};
    sensing.shape = static_cast<ErrorShape>(shape);
    Senses senses(sensing, 3, 0.1, 1);
    double most = 0.0, least = 1.0;
    for (std::int64_t step = 0; step < 200; ++step) {
      const std::vector<Neighbor> neighbors = seen(senses, step);
      ASSERT_EQ(neighbors.size(), 2U);
      for (std::size_t k = 0; k < 2; ++k) {
        const Vec2 dp = neighbors[k].position - robots[k + 1].position;
        const Vec2 dv = neighbors[k].velocity - robots[k + 1].velocity;
        most = std::max({most, norm(dp) / 0.1, norm(dv) / 0.2});
        least = std::min({least, norm(dp) / 0.1, norm(dv) / 0.2});
        const double away = dot(dp, robots[k + 1].position) / norm(robots[k + 1].position);
        if (sensing.shape == ErrorShape::farther) {
          EXPECT_NEAR(away, 0.1, 1e-12);
        }
        if (sensing.shape == ErrorShape::flips) {
          EXPECT_NEAR(away, step % 2 == 0 ? 0.1 : -0.1, 1e-12);
        }
      }
      if (sensing.shape == ErrorShape::bias) {
        EXPECT_LT(norm(neighbors[0].position - seen(senses, step + 1)[0].position), 1e-12);
      }
    }
    EXPECT_LT(most, 1.0 + 1e-12) << shape;
    EXPECT_GT(most, 0.98) << shape;
    EXPECT_NEAR(least, sensing.shape == ErrorShape::uniform ? 0.0 : 1.0, 0.1) << shape;
  }
}

TEST(Senses, show_the_nearest_first) {
  Sensing sensing;
  Senses senses(sensing, 3, 0.1, 1);
  const std::vector<Neighbor> neighbors = seen(senses, 0);
  EXPECT_EQ(neighbors[0].position, (Vec2{2.0, 0.0}));
  EXPECT_EQ(neighbors[1].position, (Vec2{0.0, 3.0}));
}

TEST(Senses, carry_late_states_on_at_constant_velocity) {
  Sensing sensing;
  sensing.delayed = true;
  Senses senses(sensing, 3, 0.1, 1);
  const std::vector<Robot> before = three_robots();
  std::vector<Robot> now = before;
  now[1].velocity = {0.6, 0.5};
  std::vector<Neighbor> neighbors;
  senses.observe(0, now, before, 5, neighbors);
  EXPECT_EQ(neighbors[0].velocity, (Vec2{0.5, 0.5}));
  EXPECT_EQ(neighbors[0].position, (Vec2{2.05, 0.05}));
}

TEST(Senses, miss_the_part_asked_for) {
  Sensing sensing;
  sensing.missed = 0.25;
  Senses senses(sensing, 3, 0.1, 1);
  std::size_t count = 0;
  for (std::int64_t step = 0; step < 1000; ++step) count += seen(senses, step).size();
  EXPECT_NEAR(static_cast<double>(count), 1500.0, 60.0);
}

// The outcomes of a row's first scenes, of `duration` (s) at most each.
std::vector<Outcome> run_row(const std::string& name, int scenes, double duration) {
  std::vector<Outcome> outcomes;
  for (const Family& family : families(1e4)) {
    if (family.name != name) continue;
    for (std::uint64_t seed = 1; seed <= static_cast<std::uint64_t>(scenes); ++seed) {
      Scene scene = family.make(seed);
      scene.scenario.duration = std::min(scene.scenario.duration, duration);
      outcomes.push_back(run_scene(scene, seed, ""));
    }
  }
  return outcomes;
}

TEST(Sensing, declared_errors_cost_no_contact) {
  for (const std::string sensing : {"sensing-p1", "sensing-p5v5", "delay-1", "gaussian-all"}) {
    for (const std::string kind : {"-random", "-circle", "-crush"}) {
      const RowResult row = summarize("", run_row(sensing + kind, 5, 25.0));
      EXPECT_EQ(row.scenes, 5);
      EXPECT_TRUE(row.certified) << sensing << kind;
      EXPECT_EQ(row.unsafe_scenes, 0) << sensing << kind;
    }
  }
}

TEST(Sensing, declared_errors_leave_arrival) {
  for (const std::string row :
       {"sensing-p1-random", "sensing-p1-circle", "sensing-p5v5-circle", "delay-1-circle"}) {
    const RowResult result = summarize("", run_row(row, 3, 60.0));
    EXPECT_EQ(result.arrived, result.robots) << row;
  }
}

TEST(Sensing, undeclared_errors_cost_contacts_and_are_not_ruled_out) {
  for (const std::string row : {"sensing-undeclared-10-crush", "sensing-beyond-p1-crush",
                                "dropped-5%-crush", "gaussian-undeclared-crush"}) {
    const RowResult result = summarize("", run_row(row, 5, 25.0));
    EXPECT_FALSE(result.certified) << row;
  }
  EXPECT_GT(summarize("", run_row("sensing-undeclared-10-crush", 5, 25.0)).unsafe_scenes, 2);
}

TEST(Sensing, is_the_same_for_the_same_seed) {
  const std::vector<Outcome> first = run_row("sensing-p5v5-circle", 2, 10.0);
  const std::vector<Outcome> second = run_row("sensing-p5v5-circle", 2, 10.0);
  for (std::size_t k = 0; k < 2; ++k) {
    EXPECT_EQ(first[k].verdict.least_clearance, second[k].verdict.least_clearance);
  }
  EXPECT_NE(first[0].verdict.least_clearance, first[1].verdict.least_clearance);
}

}  // namespace
}  // namespace avo::safety
