// SPDX-License-Identifier: Apache-2.0
// Robots that decide at times of their own and a step of their own apart, each of which chooses the
// worst that its certificate admits, judged by Check.
#include <algorithm>
#include <array>
#include <gtest/gtest.h>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "avo/check.h"
#include "certificate/kernels.h"
#include "property/certificate_fleets.h"

namespace avo::test {
namespace {

constexpr double kLongest = 0.4;  // s, of all steps

struct Clocked {
  Robot robot;  // now
  CertificateLaw law;
  Whim whim = Whim::random;
  double next = 0.0;        // s, when it decides again
  Vec2 position, velocity;  // when it decided
  Vec2 acceleration = {};   // m/s², held since then
  double since = -std::numeric_limits<double>::infinity();
};

// What robots believe of each other's clocks.
struct Belief {
  Clock clock = Clock::free;
  double part_of_longest = 1.0;  // of the longest step, what they take for it
};

void carry_on(Clocked& each, double time) {
  if (!(each.since > -1.0)) return;
  const double t = time - each.since, step = each.law.step.time_step;
  each.robot.position = each.position + t * each.velocity + (0.5 * t * t) * each.acceleration;
  each.robot.velocity = each.velocity + t * each.acceleration;
  const bool ends = t > 0.999999 * step;
  if (ends && norm(each.robot.velocity) < 1e-14 * norm(each.velocity)) each.robot.velocity = {};
}

// The fleet has two to six close robots at rest, with steps from 0.02 to 0.4 s.
std::vector<Clocked> clocked_fleet(Random& random, const Belief& belief) {
  std::vector<Clocked> fleet;
  std::vector<Robot> robots;
  const int count = 2 + random.below(5);
  const bool brakes_otherwise = belief.part_of_longest == 1.0 && random.below(2) == 0;
  double extent = 1.0;
  while (static_cast<int>(fleet.size()) < count) {
    extent *= 1.05;
    Clocked each;
    each.robot = random_robot(random);
    if (brakes_otherwise)
      each.robot.max_braking = random_braking(random, each.robot.max_acceleration);
    each.robot.position = in_disc(random, extent);
    if (touches(each.robot, others(robots, robots.size()))) continue;
    PlannerOptions options;
    options.time_step = random.log_uniform(0.02, kLongest);
    options.clock = belief.clock;
    if (belief.clock == Clock::free) options.longest_step = kLongest * belief.part_of_longest;
    each.law = law_of(options);
    each.next = random.uniform(0.0, options.time_step);
    each.position = each.robot.position;
    each.whim = std::array{Whim::random, Whim::at_the_nearest, Whim::at_where_it_stops,
                           Whim::past_the_nearest}[static_cast<std::size_t>(random.below(4))];
    robots.push_back(each.robot);
    fleet.push_back(each);
  }
  return fleet;
}

// The report of one fleet's doings for so many decisions.
CheckReport run(std::uint64_t seed, const Belief& belief, int decisions) {
  Random random(seed);
  std::vector<Clocked> fleet = clocked_fleet(random, belief);
  std::vector<CheckedRobot> limits;
  for (const Clocked& each : fleet) {
    limits.push_back({each.robot.radius, each.robot.max_acceleration, each.robot.max_speed});
    limits.back().time_step = each.law.step.time_step;
    limits.back().max_braking = each.robot.max_braking;
  }
  Check check(limits);
  CertificateConstraints constraints;
  const auto show = [&](double time) {
    std::vector<CheckedState> rows;
    for (std::size_t k = 0; k < fleet.size(); ++k) {
      const Robot& robot = fleet[k].robot;
      rows.push_back({static_cast<std::int64_t>(k), robot.position, robot.velocity});
    }
    check.add(time, rows);
  };
  show(0.0);
  double time = 0.0;
  for (int k = 0; k < decisions;) {
    const double before = time;
    time = std::numeric_limits<double>::infinity();
    for (const Clocked& each : fleet) time = std::min(time, each.next);
    for (Clocked& each : fleet) carry_on(each, time);
    if (time > before) show(time);
    std::vector<Robot> robots;
    for (const Clocked& each : fleet) robots.push_back(each.robot);
    for (std::size_t i = 0; i < fleet.size(); ++i) {
      Clocked& self = fleet[i];
      if (self.next > time) continue;
      ++k;
      const std::vector<Neighbor> seen = others(robots, i);
      collect_constraints(self.robot, seen, self.law, constraints);
      if (random.below(40) == 0) self.whim = static_cast<Whim>(random.below(5));
      const Vec2 next =
          adverse_velocity(random, self.robot, self.whim, seen, self.law, constraints);
      self.position = self.robot.position, self.velocity = self.robot.velocity;
      self.acceleration = (next - self.velocity) / self.law.step.time_step;
      self.since = time, self.next = time + self.law.step.time_step;
    }
  }
  return check.report();
}

// In how many of so many fleets robots overlap, and how near they come in the others.
std::pair<int, double> overlapping(const Belief& belief, int fleets, int decisions) {
  int count = 0;
  double least = std::numeric_limits<double>::infinity();
  for (int seed = 1; seed <= fleets; ++seed) {
    const CheckReport report = run(static_cast<std::uint64_t>(seed), belief, decisions);
    EXPECT_EQ(report.accelerations.count + report.speeds.count + report.jumps.count, 0) << seed;
    EXPECT_EQ(report.changes.count, 0) << seed;
    count += report.overlaps.count > 0 ? 1 : 0;
    if (report.least_clearance) least = std::min(least, *report.least_clearance);
  }
  return {count, least};
}

TEST(FreeClock, robots_that_choose_the_worst_never_touch) {
  const auto [count, least] = overlapping({}, 500, 1500);
  EXPECT_EQ(count, 0);
  EXPECT_LT(least, 2e-3);  // it was tight
  RecordProperty("least", std::to_string(least));
}

TEST(FreeClock, with_the_rule_of_a_common_clock_they_touch) {
  EXPECT_GT(overlapping({Clock::common}, 40, 1500).first, 20);
}

TEST(FreeClock, with_too_short_a_longest_step_they_touch) {
  EXPECT_GT(overlapping({Clock::free, 0.05}, 300, 1500).first, 0);
}

// A held acceleration for some time, then full braking in steps, known at times `kGrain` apart.
struct SlowPath {
  static constexpr double kGrain = 0.002;  // s
  std::vector<Vec2> places;

  SlowPath(const Robot& robot, Vec2 acceleration, double time, double step) {
    Vec2 p = robot.position, v = robot.velocity, a = acceleration;
    double begin = 0.0, end = time;
    while (places.size() < 4000) {
      for (double t; (t = kGrain * static_cast<double>(places.size())) < end;)
        places.push_back(p + (t - begin) * v + (0.5 * (t - begin) * (t - begin)) * a);
      const double passed = end - begin;
      p = p + passed * v + (0.5 * passed * passed) * a, v = v + passed * a;
      if (norm(v) < 1e-12) break;
      begin = end, end += step;
      a = -(std::min(braking_limit(robot), norm(v) / step) / norm(v)) * v;
    }
    places.push_back(p);
  }
  [[nodiscard]] Vec2 at(std::size_t k) const { return places[std::min(k, places.size() - 1)]; }
};

double least_distance(const SlowPath& one, const SlowPath& other) {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < std::max(one.places.size(), other.places.size()); ++k)
    least = std::min(least, norm(one.at(k) - other.at(k)));
  return least;
}

// The bound of the proof, of any rest of B's step: kept, and nearly reached.
TEST(FreeClock, no_rest_of_a_step_leads_farther_than_the_drift) {
  Random random(11);
  double most = 0.0;
  for (int k = 0; k < 4000; ++k) {
    Robot b;
    b.max_acceleration = random.log_uniform(0.5, 3.0);
    if (k % 2 == 0) b.max_braking = random_braking(random, b.max_acceleration);
    b.velocity = random.below(4) == 0 ? Vec2{} : in_disc(random, 1.5);
    PlannerOptions options;
    options.time_step = random.log_uniform(0.02, 0.3);
    options.clock = Clock::free, options.longest_step = random.log_uniform(0.02, 0.3);
    const StepLaw law = law_of(options).step;
    using Real = scalar::Pack<double>;
    const auto drift = scalar::drift_of<Real>(norm(b.velocity), increment(b.max_acceleration, law),
                                              decrement_of(b, law), law);
    const double part = k % 2 == 0 ? 1.0 : random.uniform(0.2, 1.0);
    const double step = part * options.longest_step;
    const double time = k % 3 == 0 ? step : random.uniform(0.0, step);
    const Vec2 held = change_limit(b) * random.direction();
    const SlowPath rest(b, held, time, step), expected(b, {}, law.time_step, law.time_step);
    for (std::size_t n = 0; n < std::max(rest.places.size(), expected.places.size()); ++n) {
      const double t = std::max(SlowPath::kGrain * static_cast<double>(n), law.time_step);
      const double bound = std::min(drift.start.value + drift.per_time.value * t, drift.most.value);
      const double off = norm(rest.at(n) - expected.at(n));
      ASSERT_LE(off, bound * (1.0 + 1e-9)) << k << ' ' << t;
      most = std::max(most, off / bound);
    }
  }
  EXPECT_GT(most, 0.95);
  RecordProperty("most", std::to_string(most));
}

// The claim of the proof, by brute force: whatever is left of B's step, if braking keeps clear of
// that and of B's braking behind it, then so does what A's certificate admits.
TEST(FreeClock, what_is_admitted_keeps_clear_of_all_rests_that_braking_keeps_clear_of) {
  constexpr double kGrazing = 2e-3;  // m
  Random random(5);
  int judged = 0, near = 0;
  for (int k = 0; k < 1200; ++k) {
    Robot a, b;
    a.radius = random.uniform(0.1, 0.5), b.radius = random.uniform(0.1, 0.5);
    a.max_acceleration = random.log_uniform(0.5, 3.0);
    b.max_acceleration = random.log_uniform(0.5, 3.0);
    a.max_speed = b.max_speed = 4.0;
    if (k % 2 == 0) {
      a.max_braking = random_braking(random, a.max_acceleration);
      b.max_braking = random_braking(random, b.max_acceleration);
    }
    const double contact = a.radius + b.radius, speed = random.log_uniform(0.01, 1.0);
    a.velocity = in_disc(random, speed), b.velocity = in_disc(random, speed);
    b.position = (contact + random.log_uniform(1e-4, 0.5)) * random.direction();
    PlannerOptions options;
    options.time_step = random.uniform(0.05, 0.2);
    options.clock = Clock::free, options.longest_step = kLongest;
    const CertificateLaw law = law_of(options);
    const double step_of_b = random.uniform(0.05, kLongest);
    const SlowPath braking(a, {}, 0.0, options.time_step);
    std::vector<SlowPath> rests;
    for (int n = 0; n < 30; ++n) {
      const double most = change_limit(b);
      const Vec2 held = n % 2 == 0 ? most * random.direction() : in_disc(random, most);
      const SlowPath rest(b, held, random.uniform(0.0, step_of_b), step_of_b);
      if (least_distance(braking, rest) >= contact) rests.push_back(rest);
    }
    CertificateConstraints constraints;
    collect_constraints(a, std::vector<Neighbor>{seen(b)}, law, constraints);
    const double u = a.max_acceleration * options.time_step;
    for (int n = 0; n < 6; ++n) {
      const Vec2 next = farthest_admitted(a, a.velocity + u * random.direction(), law, constraints);
      const SlowPath path(a, (next - a.velocity) / options.time_step, options.time_step,
                          options.time_step);
      for (const SlowPath& rest : rests) {
        const double distance = least_distance(path, rest);
        ASSERT_GE(distance, contact - 1e-9) << k;
        ++judged, near += distance < contact + kGrazing ? 1 : 0;
      }
    }
  }
  EXPECT_GT(judged, 50000);
  EXPECT_GT(near, 500);
  RecordProperty("near", near);
}

}  // namespace
}  // namespace avo::test
