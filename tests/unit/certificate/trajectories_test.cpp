// SPDX-License-Identifier: Apache-2.0
// The future of these moving obstacles is known (avo/trajectory.h). The tests check where the
// moving obstacles are, and which robots keep clear of the moving obstacles for ever.
#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <limits>
#include <optional>
#include <vector>

#include "avo/error.h"
#include "avo/trajectory.h"
#include "certificate/trajectory_steps.h"
#include "support/generators.h"
#include "support/refusal.h"

namespace avo {
namespace {

using test::refusal;

// Legs of any length in time, which turn at any angle; some are rests.
std::vector<TimedPlace> random_places(test::Random& random) {
  std::vector<TimedPlace> places;
  double time = random.uniform(-3.0, 3.0);
  Vec2 p = random.uniform(0.0, 8.0) * random.direction();
  for (int k = random.below(12); k >= 0; --k) {
    places.push_back({time, p});
    const double lasts = random.log_uniform(0.01, 4.0);
    time += lasts;
    if (random.below(5) > 0) p = p + lasts * random.uniform(0.1, 2.5) * random.direction();
  }
  return places;
}

std::optional<double> random_round(test::Random& random, const std::vector<TimedPlace>& places) {
  if (random.below(2) == 0) return std::nullopt;
  return places[static_cast<std::size_t>(random.below(static_cast<int>(places.size())))].time;
}

TEST(Trajectories, go_straight_from_place_to_place) {
  const std::vector<TimedPlace> places{{1.0, {0, 0}}, {3.0, {4, 0}}, {4.0, {4, -1}}};
  const Trajectory trajectory(places);
  EXPECT_EQ(trajectory.at(0.0), (Vec2{0, 0})) << "it waits";
  EXPECT_EQ(trajectory.at(2.0), (Vec2{2, 0}));
  EXPECT_EQ(trajectory.at(3.0), (Vec2{4, 0}));
  EXPECT_EQ(trajectory.at(3.5), (Vec2{4, -0.5}));
  EXPECT_EQ(trajectory.at(6.0), (Vec2{4, -3})) << "it goes on";
  EXPECT_EQ(trajectory.max_speed(0.0), 2.0);
  EXPECT_EQ(trajectory.max_speed(3.0), 1.0);
  EXPECT_EQ(trajectory.max_speed(9.0), 1.0);
  EXPECT_EQ(trajectory.round(), 0.0);
  const Trajectory round(places, 0.1, 3.0);
  EXPECT_EQ(round.at(6.0), (Vec2{4, -1}));
  EXPECT_EQ(round.round(), 1.0);
  EXPECT_EQ(round.error(), 0.1);
  EXPECT_EQ(Trajectory(std::vector<TimedPlace>{{0.0, {1, 2}}}).at(5.0), (Vec2{1, 2}));
}

TEST(Trajectories, are_refused_in_one_line) {
  const auto of = [](std::vector<TimedPlace> places, double error = 0.0,
                     std::optional<double> round = {}) {
    return refusal([&] { Trajectory(places, error, round); });
  };
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(of({}), "places: found none, must be one or more");
  EXPECT_EQ(of({{0, {}}, {0, {}}}), "places.1.time: found 0, must be > 0 s");
  EXPECT_EQ(of({{nan, {}}}), "places.0.time: found nan, must be a finite number");
  EXPECT_EQ(of({{0, {nan, 0}}}), "places.0.position.0: found nan, must be a finite number");
  EXPECT_EQ(of({{0, {}}}, -1.0), "error: found -1, must be >= 0 m");
  EXPECT_EQ(of({{0, {}}}, 0.0, 1.0),
            "repeats_from: found 1, must be the time of one of the places");
  Trajectory kept(std::vector<TimedPlace>{{0.0, {1, 2}}});
  EXPECT_THROW(kept.assign({}), Error);
  EXPECT_EQ(kept.places().size(), 1U) << "nothing changes where it is refused";
}

// On each step the mover is near its chord, and no farther off than is said.
TEST(Trajectories, in_steps_of_a_robot_stay_near_their_chords) {
  test::Random random(41);
  double used = 0.0;
  for (int trial = 0; trial < 400; ++trial) {
    const std::vector<TimedPlace> places = random_places(random);
    const Trajectory trajectory(places, 0.0, random_round(random, places));
    const double h = random.log_uniform(0.02, 0.5), now = random.uniform(-4.0, 8.0);
    const Vec2 origin = random.uniform(0.0, 5.0) * random.direction();
    TrajectorySteps steps;
    steps.begin(trajectory, now, origin, h);
    steps.look_ahead(40);
    for (std::size_t k = 0; k < 40; ++k) {
      for (int part = 0; part <= 8; ++part) {
        const double t = now + h * (static_cast<double>(k) + part / 8.0);
        const Vec2 chord = steps.place(k) + (part / 8.0) * (steps.place(k + 1) - steps.place(k));
        const double off = norm(trajectory.at(t) - origin - chord);
        ASSERT_LE(off, steps.bend[k] + 1e-12) << trial << ", step " << k;
        if (steps.bend[k] > 0.01) used = std::max(used, off / steps.bend[k]);
      }
    }
  }
  EXPECT_GT(used, 0.9) << "the bound is no larger than it has to be";
}

// m, least of many distances from a time on.
double sampled_distance(const Trajectory& trajectory, double from, Vec2 place) {
  const double end = trajectory.places().back().time;
  const auto round = trajectory.repeats_from();
  double least = std::numeric_limits<double>::infinity();
  const double first = round ? std::min(from, *round) : from, last = round ? end : end + 60.0;
  for (double t = first; t < last; t += 2e-3)
    least = std::min(least, norm(place - trajectory.at(t)));
  return std::min(least, norm(place - trajectory.at(std::max(from, end))));
}

TEST(Trajectories, that_pass_by_never_come_near) {
  test::Random random(42);
  int clear = 0, near = 0;
  for (int trial = 0; trial < 2000; ++trial) {
    const std::vector<TimedPlace> places = random_places(random);
    const Trajectory trajectory(places, 0.0, random_round(random, places));
    const double from = random.uniform(-4.0, 12.0), distance = random.uniform(0.2, 2.0);
    const Vec2 place = random.uniform(0.0, 6.0) * random.direction();
    const double least = sampled_distance(trajectory, from, place);
    if (passes_by(trajectory, from, place, distance)) {
      ++clear;
      ASSERT_GE(least, distance - 1e-9) << trial;
    } else {
      ++near;
      ASSERT_LE(least, distance + 0.01) << trial << ": nothing is refused without need";
    }
  }
  EXPECT_GT(clear, 100);
  EXPECT_GT(near, 100);
}

}  // namespace
}  // namespace avo
