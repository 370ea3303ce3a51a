// SPDX-License-Identifier: Apache-2.0
#include "space/shared_goals.h"

#include <algorithm>
#include <cstddef>

#include "space/cells.h"

namespace avo::space {
namespace {

constexpr double kTouching = 1e-9;  // of contact: goals that touch leave room for both

// Robots at their goals: returns whether only one of the two can be there.
bool overlap(const Robot& a, const Robot& b) {
  return norm(away_from(a.position, a.downwash, b.position, b.downwash)) <
         (1.0 - kTouching) * (a.radius + b.radius);
}

// m: goals of robots that share room are no farther from each other.
double farthest_shared(std::span<const Robot> robots) {
  double radius = 0.0, downwash = 0.0;
  for (const Robot& robot : robots) {
    radius = std::max(radius, robot.radius);
    downwash = std::max(downwash, robot.downwash);
  }
  return 2.0 * radius + downwash;
}

// What robot a shares with some robot at these places, where all are at their goals.
SpaceShares shared_by(std::size_t a, std::span<const Robot> there, const SpaceCells& cells,
                      std::span<const Run> runs) {
  SpaceShares shares = SpaceShares::nothing;
  for (const Run& run : runs) {
    for (std::size_t place = run.first; place < run.last; ++place) {
      const std::size_t b = cells.order()[place];
      if (b == a || !overlap(there[a], there[b])) continue;
      if (there[a].position == there[b].position) return SpaceShares::goal;
      shares = SpaceShares::room;
    }
  }
  return shares;
}

}  // namespace

std::vector<SpaceShares> shared_goals(std::span<const Robot> robots, std::span<const Vec3> goals) {
  if (robots.empty()) return {};
  std::vector<Robot> there(robots.begin(), robots.end());
  for (std::size_t k = 0; k < there.size(); ++k) there[k].position = goals[k];
  SpaceCells cells(farthest_shared(robots));
  cells.sort(there);
  SpaceCells::Runs runs;
  std::vector<SpaceShares> shares;
  bool some = false;
  for (std::size_t a = 0; a < there.size(); ++a) {
    const std::size_t count = cells.around(goals[a], runs);
    shares.push_back(shared_by(a, there, cells, std::span(runs).first(count)));
    some = some || shares.back() != SpaceShares::nothing;
  }
  return some ? shares : std::vector<SpaceShares>();
}

}  // namespace avo::space
