// SPDX-License-Identifier: Apache-2.0
// Which robots overlapped within steps, and how near robots came to each other.
#pragma once
#include <cstdint>
#include <functional>
#include <optional>
#include <set>
#include <span>
#include <utility>
#include <vector>

#include "avo/response.h"
#include "metrics/body.h"
#include "spatial/point_grid.h"

namespace avo::inline metrics {

/// The observed step.
struct StepSpan {
  double begin = 0.0;                     // s
  double duration = 0.0;                  // s
  bool moves = false;                     // false before the first step
  std::optional<Response> response = {};  // for robots that move by Eqs. (8), (9)
};

/// Pairs by their names; distinct ones over the run.
struct Encounters {
  using Pairs = std::set<std::pair<std::uint64_t, std::uint64_t>>;
  Pairs collided = {}, one_sided = {}, one_sided_in_motion = {}, with_mover = {},
        with_mover_in_motion = {};
  std::optional<double> min_clearance = {};         // m, of robots that avoid each other
  std::optional<double> first_collision_time = {};  // s, of such robots
  double overlap_depth = 0.0;                       // the deepest, as a part of r_A + r_B
  std::int64_t collision_robot_steps = 0;
  /// Robots that overlapped in this step with a robot that they avoid.
  std::vector<std::uint64_t> overlapping = {};
  /// Robots that a moving obstacle touched, in motion or at rest.
  std::vector<std::uint64_t> touched_by_movers = {};
  /// Pairs of a robot and a moving obstacle that had never touched before this step.
  std::vector<std::pair<std::uint64_t, std::uint64_t>> new_hits = {};

  /// body: the body of a row's robot; sweeps: of all rows.
  void observe(std::span<const Sweep> sweeps, const std::function<Body(std::size_t)>& body,
               std::uint64_t roster, const std::vector<Body>& obstacles, const StepSpan& step);

 private:
  /// The robots that each robot may meet in this step and some of the next ones.
  struct Company {
    std::uint64_t roster = 0;          // of the robots in it; 0: none
    double reach = 0.0;                // m, of centers; it shrinks by their displacements
    int pause = 0;                     // steps, in which no robots are listed
    std::vector<std::size_t> first;    // of each robot, index into `other`
    std::vector<std::uint32_t> other;  // later rows
  };

  [[nodiscard]] bool changes_nothing(const Sweep& a, const Sweep& b) const;
  void meet(const Body& a, const Body& b, const StepSpan& step);
  void meet_mover(const Body& robot, const Body& obstacle, const StepSpan& step);
  void meet_movers(std::span<const Sweep> sweeps, const std::function<Body(std::size_t)>& body,
                   const std::vector<Body>& obstacles, const StepSpan& step);
  void list_company(std::uint64_t roster, double need, double farthest);
  void append_company(std::size_t robot, double reach);
  void meet_company(std::span<const Sweep> sweeps, std::size_t robot, double need,
                    std::span<const std::uint32_t> others,
                    const std::function<Body(std::size_t)>& body, const StepSpan& step);

  std::vector<std::uint64_t> colliding_;  // robots of pairs that overlap in this step
  std::vector<Vec2> positions_;
  Company company_;
  double farthest_ = 0.0;  // m, the longest displacement of a robot in the step before
  std::vector<std::uint32_t> places_;
  std::vector<std::pair<double, std::uint32_t>> near_;  // m², and row
  SearchScratch scratch_;
  PointGrid grid_;
};

}  // namespace avo::inline metrics
