// SPDX-License-Identifier: Apache-2.0
// What collect_half_planes() collects: shares, offsets, and only planes that cut (Eqs. 15-20).
#include <cmath>
#include <gtest/gtest.h>
#include <limits>

#include "avo/half_plane.h"
#include "unit/planner/crowds.h"

namespace avo {
namespace {

using test::as_neighbor;
using test::Crowd;
using test::Random;

// All planes of A written out from the paper, whether they cut or not.
struct Expected {
  PairState state = PairState::free;
  HalfPlane plane;
};

Expected expected_plane(const Crowd& crowd, const Neighbor& B) {
  const Robot& A = crowd.robot;
  const double delta = crowd.options.control_time;
  const Horizon horizon(delta, crowd.options.time_horizon, crowd.options.time_step);
  const bool decides = B.behavior == Behavior::decides;
  const double reach =
      delta * (A.max_acceleration + (decides ? B.max_acceleration : norm(B.acceleration)));
  const Pair pair{A.position - B.position, A.velocity - B.velocity, A.radius + B.radius};
  const RelativeHalfPlane relative = half_plane(pair, reach, horizon);
  const double alpha =
      decides ? A.max_acceleration / (A.max_acceleration + B.max_acceleration) : 1.0;
  const Vec2 n = relative.plane.normal;
  const Vec2 v_B_change = decides ? Vec2{} : delta * B.acceleration;
  const double offset = dot(n, A.velocity) + alpha * relative.plane.offset + dot(n, v_B_change);
  return {relative.state, {n, offset}};
}

// Smallest n . u over both discs: at the far point of either disc, or where the circles meet.
double least_over_discs(Vec2 n, const Disc& a, const Disc& b) {
  const auto inside = [](const Disc& disc, Vec2 u) {
    return norm(u - disc.center) <= disc.radius * (1.0 + 1e-12);
  };
  double least = std::numeric_limits<double>::infinity();
  const Vec2 far_a = a.center - a.radius * n, far_b = b.center - b.radius * n;
  if (inside(b, far_a)) least = std::min(least, dot(n, far_a));
  if (inside(a, far_b)) least = std::min(least, dot(n, far_b));
  const Vec2 between = b.center - a.center;
  const double d = norm(between);
  if (d > 0.0 && d <= a.radius + b.radius && d >= std::abs(a.radius - b.radius)) {
    const double along = (a.radius * a.radius - b.radius * b.radius + d * d) / (2.0 * d);
    const double across = std::sqrt(std::max(0.0, a.radius * a.radius - along * along));
    for (const double side : {-1.0, 1.0}) {
      const Vec2 u =
          a.center + (along / d) * between + (side * across / d) * perpendicular(between);
      least = std::min(least, dot(n, u));
    }
  }
  return least;
}

TEST(Planes, P9_are_shared_by_ability_and_kept_exactly_where_they_cut) {
  Random random(20);
  int kept = 0, dropped = 0;
  for (int k = 0; k < 20'000 && !testing::Test::HasFailure(); ++k) {
    const Crowd crowd = test::random_crowd(random, -0.5);
    const Planner planner(crowd.options);
    PlanWorkspace workspace;
    HalfPlanes half_planes;
    planner.collect_half_planes(crowd.robot, crowd.neighbors, workspace, half_planes);
    std::size_t next = 0;
    bool overlapping = false;
    for (std::size_t j = 0; j < crowd.neighbors.size(); ++j) {
      const Expected expected = expected_plane(crowd, crowd.neighbors[j]);
      overlapping = overlapping || expected.state == PairState::overlapping ||
                    expected.state == PairState::coincident;
      const bool found = next < half_planes.planes.size() &&
                         half_planes.planes[next].neighbor == static_cast<int>(j);
      if (expected.state == PairState::free || expected.state == PairState::coincident) {
        EXPECT_FALSE(found) << crowd;
        continue;
      }
      const Robot& A = crowd.robot;
      const Disc acceleration{A.velocity, crowd.options.control_time * A.max_acceleration};
      const Disc speed{{}, A.max_speed};
      const double least = least_over_discs(expected.plane.normal, acceleration, speed);
      const double scale = 1.0 + norm(A.velocity) + std::abs(expected.plane.offset);
      if (std::abs(least - expected.plane.offset) > 1e-9 * scale) {
        EXPECT_EQ(found, least < expected.plane.offset) << crowd;
      }
      if (!found) {
        ++dropped;
        continue;
      }
      ++kept;
      const HalfPlane plane = half_planes.planes[next++].plane;
      EXPECT_EQ(plane.normal, expected.plane.normal);
      EXPECT_NEAR(plane.offset, expected.plane.offset, 1e-12 * scale) << crowd;
    }
    EXPECT_EQ(next, half_planes.planes.size()) << "planes out of order or of no neighbor";
    EXPECT_EQ(half_planes.overlapping, overlapping);
  }
  EXPECT_GT(kept, 20'000);
  EXPECT_GT(dropped, 2'000);
}

// The figures are worked out by hand. A of a_max 1 takes a quarter against B of a_max 3. B takes
// three quarters against A, and A takes all of it against a moving obstacle.
TEST(Planes, P9_shares_of_unequal_abilities) {
  PlannerOptions options = test::paper_options();
  options.control_time = 1.0;
  Robot weak = test::paper_robot({}, {1, 0}, {1, 0});
  Robot strong = test::paper_robot({6, 0.2}, {-1, 0}, {});
  strong.max_acceleration = 3.0;
  const Planner planner(options);
  const auto demand = [&](const Robot& A, const Neighbor& B) {
    PlanWorkspace workspace;
    HalfPlanes half_planes;
    planner.collect_half_planes(A, std::vector<Neighbor>{B}, workspace, half_planes);
    EXPECT_EQ(half_planes.planes.size(), 1u);
    const HalfPlane plane = half_planes.planes.at(0).plane;
    return plane.offset - dot(plane.normal, A.velocity);
  };
  const double of_weak = demand(weak, as_neighbor(strong));
  const double of_strong = demand(strong, as_neighbor(weak));
  EXPECT_GT(of_weak, 0.0);
  EXPECT_NEAR(of_strong, 3.0 * of_weak, 1e-12);
  const Horizon horizon(1.0, 10.0, 0.1);
  const Pair pair{weak.position - strong.position, weak.velocity - strong.velocity, 1.0};
  EXPECT_NEAR(of_weak + of_strong, half_plane(pair, 4.0, horizon).plane.offset, 1e-12);
  Neighbor mover = as_neighbor(strong);
  mover.behavior = Behavior::moves_on;
  EXPECT_NEAR(demand(weak, mover), half_plane(pair, 1.0, horizon).plane.offset, 1e-12);
}

// In a pair with the priorities 3 and 1 the first robot takes a quarter, by every method that
// shares.
TEST(Planes, P9_shares_of_unequal_priorities) {
  PlannerOptions exact = test::paper_options(), orca = exact;
  orca.method = Method::orca;
  Robot first = test::paper_robot({}, {1, 0}, {1, 0});
  Robot second = test::paper_robot({6, 0.2}, {-1, 0}, {});
  const auto demand = [&](const PlannerOptions& options, const Robot& A, const Robot& B) {
    PlanWorkspace workspace;
    HalfPlanes half_planes;
    Planner(options).collect_half_planes(A, std::vector<Neighbor>{as_neighbor(B)}, workspace,
                                         half_planes);
    EXPECT_EQ(half_planes.planes.size(), 1u);
    const HalfPlane plane = half_planes.planes.at(0).plane;
    return plane.offset - dot(plane.normal, A.velocity);
  };
  for (const PlannerOptions& options : {exact, orca}) {
    first.priority = second.priority = 1.0;
    const double half = demand(options, first, second);
    EXPECT_GT(half, 0.0);
    first.priority = second.priority = 7.3;
    EXPECT_EQ(demand(options, first, second), half);
    first.priority = 3.0, second.priority = 1.0;
    EXPECT_NEAR(demand(options, first, second), 0.5 * half, 1e-12);
    EXPECT_NEAR(demand(options, second, first), 1.5 * half, 1e-12);
    first.priority = 1e9;
    EXPECT_NEAR(demand(options, first, second), half / 32.0, 1e-12);
    EXPECT_NEAR(demand(options, second, first), 63.0 * half / 32.0, 1e-12);
  }
  // What is left to both is shared in reverse.
  second.velocity = {1, 0.3};
  for (const PlannerOptions& options : {exact, orca}) {
    first.priority = second.priority = 1.0;
    const double half = demand(options, first, second);
    EXPECT_LT(half, -0.1);
    first.priority = 3.0;
    EXPECT_NEAR(demand(options, first, second), 1.5 * half, 1e-12);
    EXPECT_NEAR(demand(options, second, first), 0.5 * half, 1e-12);
  }
}

// P9, Eqs. (19), (21): A's part of every relative change lies in D(v_A, δ a_A), and the parts of
// A and B add up to it.
TEST(Planes, P9_the_set_of_A_lies_in_its_acceleration_disc) {
  Random random(21);
  for (int k = 0; k < 20'000; ++k) {
    const double a_A = random.log_uniform(1e-3, 1e3), a_B = random.log_uniform(1e-3, 1e3);
    const double delta = random.log_uniform(0.1, 10.0);
    Robot A = test::paper_robot({}, test::in_disc(random, 2.0), {});
    A.max_acceleration = a_A;
    PlannerOptions options = test::paper_options();
    options.control_time = delta;
    const Disc disc = Planner(options).acceleration_disc(A);
    const double alpha = reciprocal_share(a_A, a_B), beta = reciprocal_share(a_B, a_A);
    const Vec2 w = delta * (a_A + a_B) * random.direction();
    EXPECT_LE(norm(A.velocity + alpha * w - disc.center),
              disc.radius * (1 + 1e-12) + 1e-15 * norm(A.velocity));
    EXPECT_NEAR(alpha + beta, 1.0, 1e-15);
  }
}

}  // namespace
}  // namespace avo
