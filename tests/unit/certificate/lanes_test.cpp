// SPDX-License-Identifier: Apache-2.0
// Constraints and admission have the same bits whatever the instruction set, and nothing that is
// left out can refuse: no candidate's path gets farther from braking than it is counted on.
#include <bit>
#include <cmath>
#include <cstdint>
#include <gtest/gtest.h>
#include <limits>
#include <string>

#include "certificate/kernels.h"
#include "core/simd_target.h"
#include "robots/model.h"
#include "situations.h"

namespace avo::test {
namespace {

// A robot has a few neighbors, and some of the neighbors may be moving obstacles. Now and then the
// robot has sensing errors.
struct Crowd {
  CertificateLaw law;
  Robot robot;
  std::vector<Neighbor> neighbors;
  std::vector<Vec2> candidates;
};

Crowd random_crowd(Random& random) {
  const Motion motion = random.below(2) == 0 ? Motion::held : Motion::exponential;
  PlannerOptions options = random_options(random, kTrajectories, motion);
  if (random.below(4) == 0) options.sensing_error = {0.01, 0.02};
  if (motion == Motion::held && random.below(4) == 0) {
    options.clock = Clock::free;
    options.longest_step = random.log_uniform(0.5, 3.0) * options.time_step;
  }
  Crowd crowd{law_of(options), random_body(random), {}, {}};
  crowd.robot.position = in_disc(random, 5.0);
  const int count = 1 + random.below(20);
  const bool has_movers = random.below(2) == 0, brakes_otherwise = random.below(2) == 0;
  if (brakes_otherwise)
    crowd.robot.max_braking = random_braking(random, crowd.robot.max_acceleration);
  for (int k = 0; k < count; ++k) {
    Robot other = random_body(random);
    const double gap = random.log_uniform(1e-4, 6.0);
    other.position =
        crowd.robot.position + (crowd.robot.radius + other.radius + gap) * random.direction();
    if (brakes_otherwise) {
      if (random.below(2) == 0) other.max_acceleration = crowd.robot.max_acceleration;
      other.max_braking = random_braking(random, other.max_acceleration);
      if (random.below(4) == 0) {  // alike
        other.max_acceleration = crowd.robot.max_acceleration;
        other.max_braking = crowd.robot.max_braking;
      }
    }
    crowd.neighbors.push_back(seen(other));
    if (has_movers && random.below(5) == 0) {
      crowd.neighbors.back().behavior = Behavior::moves_on;
      crowd.neighbors.back().acceleration = in_disc(random, 1.0);
    }
  }
  const double u = increment(crowd.robot.max_acceleration, crowd.law.step);
  for (int k = 0; k < 4; ++k) crowd.candidates.push_back(crowd.robot.velocity + in_disc(random, u));
  return crowd;
}

// What has been seen: each of it has to be.
struct Seen {
  std::size_t admitted = 0, refused = 0;
  std::size_t first_intervals = 0, later_intervals = 0, of_movers = 0, cones = 0;  // constraints
};

// Everything that a decision rests on.
std::vector<std::uint64_t> bits_of(const Crowd& crowd, Seen& seen) {
  std::vector<std::uint64_t> all;
  const auto add = [&all](double number) { all.push_back(std::bit_cast<std::uint64_t>(number)); };
  CertificateConstraints constraints;
  collect_constraints(crowd.robot, crowd.neighbors, crowd.law, constraints);
  add(constraints.invariant.slack);
  for (const TrajectoryConstraint& constraint : all_constraints(constraints.trajectories)) {
    add(constraint.neighbor), add(constraint.interval), add(constraint.only_in_motion ? 1.0 : 0.0);
    add(constraint.normal.x), add(constraint.normal.y), add(constraint.cone), add(constraint.bound);
    for (const double offset : constraint.offset) add(offset);
    const std::size_t other = static_cast<std::size_t>(constraint.neighbor);
    ++(constraint.interval == 0 ? seen.first_intervals : seen.later_intervals);
    seen.of_movers += crowd.neighbors[other].behavior == Behavior::moves_on ? 1 : 0;
    seen.cones += constraint.cone > 0.0 ? 1 : 0;
  }
  for (const Vec2 candidate : crowd.candidates) {
    const bool admitted = admits(crowd.robot, candidate, crowd.law, constraints, Asked::all);
    ++(admitted ? seen.admitted : seen.refused);
    add(admitted ? 1.0 : 0.0);
    const WorstConstraint worst =
        worst_of_all(constraints.trajectories, constraints.path, crowd.law.step);
    add(worst.coefficient), add(worst.point), add(worst.lean.x), add(worst.lean.y);
  }
  return all;
}

TEST(CertificateLanes, have_the_bits_of_the_scalar_text) {
  const std::string before = simd_target();
  std::vector<std::vector<std::uint64_t>> expected;
  ASSERT_TRUE(use_simd_target("scalar"));
  for (const char* target : simd_targets()) {
    Random random(41);
    Seen seen;
    for (std::size_t i = 0; i < 4000; ++i) {
      const Crowd crowd = random_crowd(random);
      Seen scalar;
      if (expected.size() <= i) expected.push_back(bits_of(crowd, scalar));
      ASSERT_TRUE(use_simd_target(target));
      ASSERT_EQ(bits_of(crowd, seen), expected[i]) << target << ", crowd " << i;
      ASSERT_TRUE(use_simd_target("scalar"));
    }
    EXPECT_GT(seen.admitted, 500U);
    EXPECT_GT(seen.refused, 500U);
    EXPECT_GT(seen.first_intervals, 1000U);
    EXPECT_GT(seen.later_intervals, 10000U);
    EXPECT_GT(seen.of_movers, 1000U);
    EXPECT_GT(seen.cones, 1000U);
  }
  use_simd_target(before);
}

// The near pairs of a robot are the same whichever other robots are looked at. The queue of pairs
// may be emptied meanwhile, however often.
TEST(NearPairs, of_many_robots_are_those_of_each_alone) {
  Random random(44);
  std::size_t kept = 0, with_movers = 0;
  for (int round = 0; round < 40; ++round) {
    std::vector<Crowd> crowds;
    for (int i = 0; i < 30; ++i) crowds.push_back(random_crowd(random));
    const StepLaw& law = crowds[0].law.step;
    NeighborColumns columns;
    columns.reserve(30 * 20);
    RobotColumns robots, single;
    robots.reserve(crowds.size());
    single.reserve(1);
    for (const Crowd& crowd : crowds) {
      robots.add(crowd.robot, {&columns, columns.count, crowd.neighbors.size()});
      for (const Neighbor& each : crowd.neighbors) columns.add(each);
    }
    NearPairs all, alone;
    find_near(robots, law, all);
    for (std::size_t i = 0; i < crowds.size(); ++i) {
      single.clear();
      single.add(crowds[i].robot, robots.neighbors[i]);
      find_near(single, law, alone);
      ASSERT_EQ(all.of(i).size(), alone.of(0).size());
      EXPECT_EQ(all.has_others[i], alone.has_others[0]);
      const Deviation in_lane = all.own.deviation(i), by_itself = alone.own.deviation(0);
      EXPECT_EQ(in_lane.most_ahead, by_itself.most_ahead);
      EXPECT_EQ(in_lane.most_aside, by_itself.most_aside);
      for (std::size_t k = 0; k < all.of(i).size(); ++k) {
        const NearPair &of_all = all.of(i)[k], &own = alone.of(0)[k];
        EXPECT_EQ(of_all.neighbor, own.neighbor);
        EXPECT_EQ(of_all.p, crowds[i].robot.position - crowds[i].neighbors[own.neighbor].position);
        EXPECT_EQ(of_all.inflated, own.inflated);
        EXPECT_EQ(of_all.share, own.share);
        EXPECT_EQ(of_all.b.length, own.b.length);
      }
      kept += all.of(i).size();
      with_movers += all.has_others[i];
    }
  }
  EXPECT_GT(kept, 40U * 3U * NearQueue::kSize);  // so often was it full
  EXPECT_GT(with_movers, 100U);
}

// A pair waits until a candidate comes that the pair can refuse. No candidate may be judged
// otherwise than where no pair waits.
TEST(Waiting, candidates_are_judged_as_if_all_constraints_were_collected) {
  Random random(46);
  std::size_t refused = 0, admitted = 0, waited = 0, told_at_once = 0;
  RobotColumns robots;
  NeighborColumns seen;
  robots.reserve(1);
  for (int i = 0; i < 3000; ++i) {
    const Crowd crowd = random_crowd(random);
    CertificateConstraints all, waiting;
    collect_constraints(crowd.robot, crowd.neighbors, crowd.law, all);
    robots.clear();
    robots.add(crowd.robot, in_columns(crowd.neighbors, seen));
    find_near(robots, crowd.law, waiting);
    for (const Vec2 candidate : crowd.candidates) {
      begin_constraints(crowd.robot, robots.neighbors[0], 0, crowd.law, waiting);
      const bool is_admitted = admits(crowd.robot, candidate, crowd.law, all);
      EXPECT_EQ(admits(crowd.robot, candidate, crowd.law, waiting), is_admitted) << "crowd " << i;
      waited += waiting.trajectories.waiting.size();
      const std::vector<double> x(1 + kSpareNeighbors, candidate.x);
      const std::vector<double> y(1 + kSpareNeighbors, candidate.y);
      if (crowd.law.kind == Certificate::braking_trajectories) {
        admit_next(robots, x, y, crowd.law.step, waiting.near);
        EXPECT_TRUE(waiting.near.admits[0] == 0 || is_admitted) << "crowd " << i;
        told_at_once += waiting.near.admits[0];
      }
      (is_admitted ? admitted : refused) += 1;
    }
  }
  EXPECT_GT(refused, 1000U);
  EXPECT_GT(admitted, 1000U);
  EXPECT_GT(waited, 1000U);
  EXPECT_GT(told_at_once, 150U);
}

// The bound holds for every candidate, at every point of every interval and along any normal.
TEST(Deviation, bounds_what_a_path_loses_along_any_normal) {
  Random random(42);
  int slow = 0, tight = 0;
  RobotColumns robots;
  robots.reserve(1);
  NeighborColumns columns;
  NearPairs near;
  for (int i = 0; i < 4000; ++i) {
    const PairSituation s = random_pair(
        random, kTrajectories, i % 2 == 0 ? Motion::held : Motion::exponential, i % 4 >= 2);
    const StepLaw& law = s.law.step;
    const Braking a = braking_of(s.a.velocity, ability_of(s.a), law);
    robots.clear();
    robots.add(s.a, in_columns({}, columns));
    find_near(robots, law, near);
    const Deviation deviation = near.own.deviation(0);
    OwnColumns own;
    own.count = std::min<std::size_t>(static_cast<std::size_t>(a.intervals), 100);
    own.reserve(own.count);
    fill_own(a, deviation, law, own);
    const Vec2 next = random_choice(random, s), n = random.direction();
    const auto x = stepped_braking(s.a, law, static_cast<int>(own.count));
    const auto y = stepped_path(s.a, next, law, static_cast<int>(own.count));
    const double against = std::max(-dot(n, a.direction), 0.0);
    const double aside = std::abs(cross(n, a.direction));
    slow += a.profile.speed < a.increment ? 1 : 0;
    for (std::size_t m = 0; m < own.count; ++m) {
      const double most = against * own.ahead[m] + aside * own.across[m] + own.anyhow[m];
      for (std::size_t k = 0; k < 3; ++k) {
        const double loss = -dot(n, y[m][k] - x[m][k]);
        EXPECT_LE(loss, most + 1e-12);
        tight += loss > 0.9 * most ? 1 : 0;
      }
      EXPECT_LE(own.ahead[m], deviation.most_ahead * (1.0 + 1e-12));
      EXPECT_LE(own.across[m] + own.anyhow[m], deviation.most_aside * (1.0 + 1e-12));
    }
  }
  EXPECT_GT(slow, 500);
  EXPECT_GT(tight, 500);
}

using Real = scalar::Pack<double>;

scalar::Vec<Real> pack(Vec2 v) {
  return scalar::constant<Real>(v);
}

// What one robot looks at another by.
struct Look {
  scalar::PackBound<Real> bound;
  scalar::PackRobot<Real> self, other;
};

Real strays(const Robot& a) {
  return stray_of(a.model, a.max_acceleration, 0.1).velocity;
}

Look look_of(const Robot& a, const Neighbor& b, const StepLaw& law) {
  const auto own =
      scalar::braking_of(pack(a.velocity), Real(a.max_acceleration), Real(braking_limit(a)), law);
  const auto deviation = scalar::deviation_of(own, strays(a), Real(0.0), law);
  const auto braking_of_b =
      scalar::braking_of(pack(b.velocity), Real(b.max_acceleration), Real(braking_limit(b)), law);
  return {
      scalar::bound_of(pack(a.position), Real(a.radius), own, deviation, Real(a.max_speed), law),
      {pack(a.position), pack(a.velocity), a.radius, a.max_acceleration, braking_limit(a),
       a.priority, own},
      {pack(b.position), pack(b.velocity), b.radius, b.max_acceleration, braking_limit(b),
       b.priority, braking_of_b}};
}

bool is_beyond_far_bound(const Robot& a, const Neighbor& b, const StepLaw& law) {
  const Look look = look_of(a, b, law);
  return scalar::are_far(look.bound, look.self, look.other).bit;
}

// And all but a few where none can.
TEST(FarBound, are_far_only_where_no_candidates_can_meet) {
  Random random(43);
  int far = 0, beyond = 0;
  for (int i = 0; i < 8000; ++i) {
    PairSituation s =
        random_pair(random, kTrajectories, i % 2 == 0 ? Motion::held : Motion::exponential);
    if (i % 8 == 0) s.law.step.sensing_error = {0.01, 0.02};
    if (i % 6 == 0)  // of held motion
      s.law.step.longest_step = random.log_uniform(0.5, 3.0) * s.law.step.time_step;
    s.b.max_acceleration = s.a.max_acceleration;
    if (i % 5 < 2) s.a.max_braking = random_braking(random, s.a.max_acceleration);
    s.b.max_braking = s.a.max_braking;
    if (norm(s.b.velocity) > s.a.max_speed) s.b.velocity = {};
    const Braking a = braking_of(s.a.velocity, ability_of(s.a), s.law.step);
    const auto pair = [&] { return braking_pair(s.a, seen(s.b), a, s.law.step); };
    const double reaches = pair().a.reach + pair().b.reach + pair().inflated + pair().error;
    const double part = random.uniform(0.9, 1.1);
    s.b.position = s.a.position + (part * reaches) * random.direction();
    const Neighbor other = seen(s.b);
    const bool is_far = is_beyond_far_bound(s.a, other, s.law.step);
    EXPECT_TRUE(!is_far || cannot_meet(pair(), other, s.law.step)) << "pair " << i;
    far += is_far ? 1 : 0;
    beyond += part > 1.05 ? 1 : 0;
  }
  EXPECT_GT(far, beyond / 2);
}

// A pair that refuses nothing by the bound without a division refuses nothing by the exact bound as
// well.
TEST(ClearBound, is_clear_only_of_those_that_refuse_nothing) {
  Random random(45);
  int clear = 0, exactly = 0, near = 0;
  for (int i = 0; i < 20000; ++i) {
    PairSituation s =
        random_pair(random, kTrajectories, i % 2 == 0 ? Motion::held : Motion::exponential);
    s.b.max_acceleration = s.a.max_acceleration;
    if (i % 5 < 2) s.a.max_braking = random_braking(random, s.a.max_acceleration);
    s.b.max_braking = s.a.max_braking;
    const Neighbor other = seen(s.b);
    const StepLaw& law = s.law.step;
    const Look look = look_of(s.a, other, law);
    const bool told = scalar::are_clear(look.bound, look.self, look.other, law).bit;
    const auto pair = scalar::pair_of(look.self, look.other, law);
    const auto [gap, against] = scalar::clearance_of(look.self, pair, look.other, law);
    const auto deviation = scalar::deviation_of(look.self.braking, strays(s.a), Real(0.0), law);
    const bool refuses_nothing =
        gap.value > against.value * deviation.most_ahead.value + deviation.most_aside.value;
    EXPECT_TRUE(!told || refuses_nothing) << "pair " << i;
    clear += told ? 1 : 0, exactly += refuses_nothing ? 1 : 0, near += refuses_nothing ? 0 : 1;
  }
  EXPECT_GT(near, 1000);
  EXPECT_GT(clear, exactly / 4);
}

// The distance that joint braking leaves is no less than clearance_of() counts on. Often the line
// of both braking paths tells most of this distance.
TEST(Clearance, is_no_more_than_the_distance_that_joint_braking_leaves) {
  Random random(47);
  int known = 0, by_line = 0;
  for (int i = 0; i < 20000; ++i) {
    PairSituation s =
        random_pair(random, kTrajectories, i % 2 == 0 ? Motion::held : Motion::exponential);
    s.b.max_acceleration = s.a.max_acceleration;
    if (i % 3 == 0) s.b.velocity = in_disc(random, 1.1 * norm(s.a.velocity));
    const StepLaw& law = s.law.step;
    const Look look = look_of(s.a, seen(s.b), law);
    const Braking a = braking_of(s.a.velocity, ability_of(s.a), law);
    const Braking b = braking_of(s.b.velocity, ability_of(s.b), law);
    const auto pair = scalar::pair_of(look.self, look.other, law);
    const double gap = scalar::clearance_of(look.self, pair, look.other, law).gap.value;
    if (!std::isfinite(gap)) continue;
    const double least = gap / pair.share.value + pair.inflated.value;
    double nearest = std::numeric_limits<double>::infinity();
    for (int k = 0; k < static_cast<int>(std::max(a.intervals, b.intervals)); ++k) {
      const auto [start_a, middle_a, end_a] = braking_distances(a.profile, law, k);
      const auto [start_b, middle_b, end_b] = braking_distances(b.profile, law, k);
      const Vec2 p = s.a.position - s.b.position;
      const Vec2 start = p + start_a * a.direction - start_b * b.direction;
      const Vec2 middle = p + middle_a * a.direction - middle_b * b.direction;
      const Vec2 end = p + end_a * a.direction - end_b * b.direction;
      for (const Vec2 point : {nearest_on_segment(start, middle), nearest_on_segment(middle, end),
                               nearest_on_segment(end, start)})
        nearest = std::min(nearest, norm(point));
    }
    EXPECT_LE(least, nearest + 1e-9 * (1.0 + nearest)) << "pair " << i;
    ++known;
    by_line += least > 0.9 * nearest ? 1 : 0;
  }
  EXPECT_GT(known, 4000);
  EXPECT_GT(by_line, known / 4);
}

}  // namespace
}  // namespace avo::test
