// SPDX-License-Identifier: Apache-2.0
// Both certificates written out plainly for held motion, with switches that take one step of
// the proof away, and a search for robots that then overlap.
#pragma once
#include <algorithm>
#include <array>
#include <cstddef>
#include <functional>
#include <optional>
#include <vector>

#include "situations.h"

namespace avo::test {

/// What a robot may choose, and what it does if it finds nothing.
struct Choices {
  std::function<bool(Vec2)> admits;
  Vec2 backup;
};
/// By robot: from the states of all.
using Rule = std::function<Choices(const std::vector<Robot>&, std::size_t, const PlannerOptions&)>;

inline double decrement_of(const Robot& robot, const PlannerOptions& options) {
  return robot.max_acceleration * options.time_step;
}

inline Vec2 hardest_braked(const Robot& robot, const PlannerOptions& options) {
  return braked(robot.velocity, decrement_of(robot, options));
}

/// The others, nearest first, cut to the first `most`.
inline std::vector<std::size_t> nearest_others(const std::vector<Robot>& robots, std::size_t self,
                                               std::size_t most) {
  std::vector<std::size_t> order;
  for (std::size_t k = 0; k < robots.size(); ++k) {
    if (k != self) order.push_back(k);
  }
  const auto distance = [&](std::size_t k) {
    return norm(robots[k].position - robots[self].position);
  };
  std::sort(order.begin(), order.end(),
            [&](std::size_t a, std::size_t b) { return distance(a) < distance(b); });
  order.resize(std::min(order.size(), most));
  return order;
}

/// Direction of the nearest point to 0 of the edges of a polygon.
template <std::size_t N>
Vec2 direction_of_nearest(const std::array<Vec2, N>& corners) {
  Vec2 nearest = corners[0];
  for (std::size_t k = 0; k < N; ++k) {
    const Vec2 other = nearest_on_segment(corners[k], corners[(k + 1) % N]);
    if (norm_squared(other) < norm_squared(nearest)) nearest = other;
  }
  const double length = norm(nearest);
  return length > 0.0 ? nearest / length : Vec2{1.0, 0.0};
}

inline Vec2 turned(Vec2 a, double angle) {
  return {std::cos(angle) * a.x - std::sin(angle) * a.y,
          std::sin(angle) * a.x + std::cos(angle) * a.y};
}

/// rad, between the lines of two robots that differ
inline constexpr double kTurn = 0.2;

/// Braking trajectories with all steps of its proof, unless one is switched off.
struct TrajectoryRule {
  bool middle_coefficient = true;  ///< of intervals after the first
  bool whole_intervals = true;     ///< or the times at their ends only
  bool until_both_rest = true;     ///< or until A itself would, braking now
  bool same_number = true;         ///< or until A's candidates rest
  bool same_normals = true;        ///< or turned by kTurn, for every second robot
  std::size_t most_neighbors = 1000;

  struct Constraint {
    Vec2 normal;
    std::size_t interval, point;
    double offset;  ///< normal . (y - p_A) + offset >= 0
  };

  int count(const Robot& self, const Robot& other, const PlannerOptions& options) const {
    const auto until_rest = [&](const Robot& robot, double more) {
      const double u = decrement_of(robot, options);
      return 1 + static_cast<int>(std::floor((norm(robot.velocity) + more * u) / u + more));
    };
    if (!until_both_rest) return until_rest(self, 0.0);
    if (!same_number) return until_rest(self, 1.0);
    return std::max(until_rest(self, 1.0), until_rest(other, 1.0));
  }

  void append_constraints(const Robot& self, const Robot& other, bool second,
                          const PlannerOptions& options,
                          std::vector<Constraint>& constraints) const {
    const StepLaw law = law_of(options).step;
    const int intervals = count(self, other, options);
    const auto x_A = stepped_braking(self, law, intervals);
    const auto x_B = stepped_braking(other, law, intervals);
    const double contact = self.radius + other.radius;
    const double share = self.max_acceleration / (self.max_acceleration + other.max_acceleration);
    for (std::size_t m = 0; m < x_A.size(); ++m) {
      Points q{};
      for (std::size_t i = 0; i < 3; ++i) q[i] = x_A[m][i] - x_B[m][i];
      Vec2 n = whole_intervals ? direction_of_nearest(q) : q[2] / norm(q[2]);
      if (!same_normals && second) n = turned(n, kTurn);
      for (std::size_t i = whole_intervals ? (m == 0 ? 2 : 0) : 2; i < 3; ++i) {
        if (i == 1 && !middle_coefficient) continue;
        constraints.push_back(
            {n, m, i, share * (dot(n, q[i]) - contact) - dot(n, x_A[m][i] - self.position)});
      }
    }
  }

  Choices operator()(const std::vector<Robot>& robots, std::size_t self,
                     const PlannerOptions& options) const {
    std::vector<Constraint> constraints;
    for (const std::size_t k : nearest_others(robots, self, most_neighbors)) {
      append_constraints(robots[self], robots[k], self > k, options, constraints);
    }
    const Robot robot = robots[self];
    const auto keeps_all = [constraints, robot, options](Vec2 next) {
      std::size_t most = 0;
      for (const Constraint& constraint : constraints) most = std::max(most, constraint.interval);
      const auto y = stepped_path(robot, next, law_of(options).step, static_cast<int>(most) + 1);
      return std::all_of(constraints.begin(), constraints.end(), [&](const Constraint& constraint) {
        return dot(constraint.normal, y[constraint.interval][constraint.point] - robot.position) +
                   constraint.offset >=
               0.0;
      });
    };
    return {keeps_all, hardest_braked(robot, options)};
  }
};

/// What is searched: starts, and for how long.
struct Search {
  std::function<std::vector<Robot>(Random&, const PlannerOptions&)> start;
  PlannerOptions options;
  int trials = 100;
  int steps = 30;
};

/// m by which two of the robots overlap at most, in any trial: each pushes at another as hard as
/// its rule admits; all brake in the end. Negative: the least gap.
double deepest_overlap(const Rule& rule, const Search& search);

}  // namespace avo::test
