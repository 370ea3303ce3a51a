// SPDX-License-Identifier: Apache-2.0
// Robots are among moving obstacles that do as they like within a declared acceleration and speed.
// The moving obstacles chase, cross and reverse at their bounds, after they have seen what the
// robots decided. Robots do the worst that is admitted. A touched robot is at rest.
#include <gtest/gtest.h>
#include <string>
#include <tuple>

#include "certificate_fleets.h"

namespace avo::test {
namespace {

constexpr int kFleets = 400;
constexpr int kSteps = 120;
constexpr int kTurns = 3;  // within a step, in which a mover keeps its acceleration

enum class Intent { chase, meet, reverse, wander };

struct Person {
  Neighbor now = {}, seen = {};
  Intent intent = Intent::chase;
  double turns_at = 0.0;  // m, from a robot, where one that reverses does
};

// How robots see people.
enum class Sight { exact, with_errors, late };
constexpr int kMostLate = 3;  // steps

struct Street {
  PlannerOptions options;
  Sight sight = Sight::exact;
  std::vector<Robot> robots;
  std::vector<Person> people;
};

Street random_street(Random& random, Certificate kind, Motion motion, Sight sight) {
  Street street;
  street.options = random_options(random, kind, motion);
  street.sight = sight;
  if (sight == Sight::with_errors) street.options.sensing_error = {0.02, 0.05};
  const int robots = 1 + random.below(3), people = 1 + random.below(3);
  const auto clear = [&](const Robot& robot) {
    return !touches(robot, others(street.robots, street.robots.size()));
  };
  while (static_cast<int>(street.robots.size()) < robots) {
    Robot robot = random_robot(random);
    if (random.below(3) == 0)
      robot.max_braking = random.log_uniform(0.4, 3.0) * robot.max_acceleration;
    robot.position = in_disc(random, 4.0);
    if (clear(robot)) street.robots.push_back(robot);
  }
  while (static_cast<int>(street.people.size()) < people) {
    Person person{.intent = static_cast<Intent>(random.below(4)),
                  .turns_at = random.log_uniform(0.5, 5.0)};
    Neighbor& now = person.now;
    now.behavior = Behavior::moves_on;
    now.radius = random.log_uniform(0.1, 0.6);
    now.position = in_disc(random, 14.0);
    now.max_deviation = random.log_uniform(0.1, 8.0);
    if (random.below(3) > 0) now.max_speed = random.log_uniform(0.3, 3.0);
    now.velocity = in_disc(random, std::min(now.max_speed, 2.0));
    if (std::none_of(street.robots.begin(), street.robots.end(),
                     [&](const Robot& robot) { return touches(robot, {now}); }))
      street.people.push_back(person);
  }
  return street;
}

// m/s², within its bounds for so long.
Vec2 acceleration_of(Person& person, const std::vector<Robot>& robots, double time,
                     Random& random) {
  const Neighbor& now = person.now;
  const Robot* nearest = robots.data();
  for (const Robot& robot : robots) {
    if (norm(robot.position - now.position) < norm(nearest->position - now.position))
      nearest = &robot;
  }
  Vec2 towards = nearest->position - now.position;
  if (person.intent == Intent::meet)
    towards =
        towards + (0.5 * norm(nearest->velocity) / braking_limit(*nearest)) * nearest->velocity;
  if (person.intent == Intent::reverse && norm(towards) > person.turns_at) towards = -1.0 * towards;
  if (person.intent == Intent::wander) towards = in_disc(random, 1.0);
  if (random.below(60) == 0) person.intent = static_cast<Intent>(random.below(4));
  const double length = norm(towards);
  if (!(length > 0.0)) return {};
  const Vec2 hardest = (now.max_deviation / length) * towards;
  const Vec2 next = now.velocity + time * hardest;
  if (norm(next) <= now.max_speed) return hardest;
  // as fast as it may be in that direction, as far as it can turn to it
  const Vec2 wanted = (now.max_speed / length) * towards;
  const Vec2 change = wanted - now.velocity;
  const double most = time * now.max_deviation, part = std::min(1.0, most / norm(change));
  return ((1.0 - 1e-12) * part / time) * change;
}

struct Seen {
  double least_gap = 1.0 / 0.0;         // m, between robots
  double least_gap_moving = 1.0 / 0.0;  // m, to a person over a step in which the robot moves
  int touched_moving = 0, touched_at_rest = 0, moves = 0, stops = 0;
};

// The people move on from part to part of the step, and the least distance from the robot is kept.
double walk(Person& person, const TrueStep& robot, std::vector<Vec2>& accelerations,
            const PlannerOptions& options) {
  constexpr int kSamples = 40;
  const double part = options.time_step / kTurns;
  Vec2 p = person.now.position, v = person.now.velocity;
  double least = 1.0 / 0.0;
  for (int n = 0; n < kTurns; ++n) {
    const Vec2 a = accelerations[static_cast<std::size_t>(n)];
    for (int k = 0; k <= kSamples; ++k) {
      const double t = part * k / kSamples;
      const Vec2 x = p + t * v + (0.5 * t * t) * a;
      least = std::min(least, norm(robot.at(n * part + t, options) - x));
    }
    p = p + part * v + (0.5 * part * part) * a, v = v + part * a;
  }
  return least;
}

// Robots see the person anew, or carry it on.
void look(Person& person, Sight sight, double time_step, Random& random) {
  Neighbor& seen = person.seen;
  const bool is_missed = sight == Sight::late && seen.behavior == Behavior::moves_on &&
                         seen.age < kMostLate && random.below(3) > 0;
  if (!is_missed) {
    seen = person.now;
    return;
  }
  seen.position = seen.position + time_step * seen.velocity;
  ++seen.age;
}

void step(Random& random, Street& street, const CertificateLaw& law,
          CertificateConstraints& constraints, Seen& result) {
  std::vector<TrueStep> steps;
  for (Person& person : street.people) look(person, street.sight, law.step.time_step, random);
  const auto& [e_p, e_v] = law.step.sensing_error;
  for (std::size_t k = 0; k < street.robots.size(); ++k) {
    const Robot& robot = street.robots[k];
    std::vector<Neighbor> neighbors = others(street.robots, k);
    for (const Person& person : street.people) neighbors.push_back(person.seen);
    for (Neighbor& neighbor : neighbors) {
      neighbor.position = neighbor.position + in_disc(random, e_p);
      neighbor.velocity = neighbor.velocity + in_disc(random, e_v);
    }
    collect_constraints(robot, neighbors, law, constraints);
    const Vec2 next = adverse_velocity(random, robot, static_cast<Whim>(random.below(4)), neighbors,
                                       law, constraints);
    result.stops += constraints.invariant.touched && robot.velocity != Vec2{} ? 1 : 0;
    steps.push_back({robot.position, robot.velocity, next});
  }
  for (std::size_t i = 0; i < steps.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      const double contact = street.robots[i].radius + street.robots[j].radius;
      result.least_gap =
          std::min(result.least_gap, least_distance(steps[i], steps[j], street.options) - contact);
    }
  }
  const double h = law.step.time_step, part = h / kTurns;
  for (Person& person : street.people) {
    const Person before = person;
    std::vector<Vec2> accelerations;
    for (int n = 0; n < kTurns; ++n) {
      accelerations.push_back(acceleration_of(person, street.robots, part, random));
      const Vec2 a = accelerations.back();
      person.now.position =
          person.now.position + part * person.now.velocity + (0.5 * part * part) * a;
      person.now.velocity = person.now.velocity + part * a;
    }
    Person walker = before;
    for (std::size_t i = 0; i < steps.size(); ++i) {
      const bool moves = steps[i].velocity != Vec2{} || steps[i].next_velocity != Vec2{};
      const double contact = street.robots[i].radius + before.now.radius;
      const double gap = walk(walker, steps[i], accelerations, street.options) - contact;
      result.moves += moves ? 1 : 0;
      if (moves) result.least_gap_moving = std::min(result.least_gap_moving, gap);
      if (gap < 0.0) ++(moves ? result.touched_moving : result.touched_at_rest);
    }
  }
  for (std::size_t k = 0; k < steps.size(); ++k) {
    street.robots[k].position = steps[k].at(h, street.options);
    street.robots[k].velocity = steps[k].next_velocity;
  }
}

class DeviatingMovers : public testing::TestWithParam<std::tuple<Certificate, Motion, Sight>> {};

TEST_P(DeviatingMovers, touch_robots_at_rest_only_whatever_they_do) {
  const auto [kind, motion, sight] = GetParam();
  CertificateConstraints constraints;
  Seen all;
  for (int seed = 1; seed <= kFleets; ++seed) {
    Random random(static_cast<std::uint64_t>(seed));
    Street street = random_street(random, kind, motion, sight);
    const CertificateLaw law = law_of(street.options);
    for (int k = 0; k < kSteps; ++k) {
      step(random, street, law, constraints, all);
      ASSERT_GE(all.least_gap, 0.0) << "seed " << seed << " step " << k;
      ASSERT_GE(all.least_gap_moving, -1e-12) << "seed " << seed << " step " << k;
    }
  }
  if (sight == Sight::exact) {
    EXPECT_EQ(all.stops, 0);  // braking never comes too late
  }
  EXPECT_GT(all.touched_at_rest, 1000);
  EXPECT_GT(all.moves, 10000);
  EXPECT_LT(all.least_gap_moving, sight == Sight::exact ? 1e-2 : 5e-2);  // it was tight
  RecordProperty("least", std::to_string(all.least_gap_moving));
}

std::string name_of(const testing::TestParamInfo<DeviatingMovers::ParamType>& info) {
  const auto [kind, motion, sight] = info.param;
  return std::string(to_string(kind)) + (motion == Motion::held ? "_held" : "_exponential") +
         (sight == Sight::exact  ? ""
          : sight == Sight::late ? "_late"
                                 : "_errors");
}

INSTANTIATE_TEST_SUITE_P(
    , DeviatingMovers,
    testing::Values(std::tuple(Certificate::braking_trajectories, Motion::held, Sight::exact),
                    std::tuple(Certificate::braking_trajectories, Motion::exponential,
                               Sight::exact),
                    std::tuple(Certificate::braking_trajectories, Motion::held, Sight::with_errors),
                    std::tuple(Certificate::braking_trajectories, Motion::held, Sight::late)),
    name_of);

}  // namespace
}  // namespace avo::test
