// SPDX-License-Identifier: Apache-2.0
#include "space/shared_goals.h"

#include <algorithm>

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

// Calls visit(b) for every robot b that cannot be at its place there together with the robot.
template <typename Visit>
void for_overlapping(const Robot& robot, std::span<const Robot> there, const SpaceCells& cells,
                     const Visit& visit) {
  SpaceCells::Runs runs;
  const std::size_t count = cells.around(robot.position, runs);
  for (const Run& run : std::span(runs).first(count)) {
    for (std::size_t place = run.first; place < run.last; ++place) {
      const std::size_t b = cells.order()[place];
      if (overlap(robot, there[b])) visit(b);
    }
  }
}

}  // namespace

void SharedGoals::set(std::span<const Robot> robots, std::span<const Vec3> goals) {
  shares_.assign(robots.size(), SpaceShares::nothing);
  noted_.assign(robots.size(), 0);
  there_.assign(robots.begin(), robots.end());
  for (std::size_t k = 0; k < there_.size(); ++k) there_[k].position = goals[k];
  if (there_.empty()) return;
  cells_ = SpaceCells(farthest_shared(robots));
  cells_.sort(there_);
  for (std::size_t a = 0; a < there_.size(); ++a) {
    for_overlapping(there_[a], there_, cells_, [&](std::size_t b) {
      if (b == a) return;
      const bool is_same = there_[a].position == there_[b].position;
      shares_[a] = std::max(shares_[a], is_same ? SpaceShares::goal : SpaceShares::room);
    });
  }
  const auto is_nothing = [](SpaceShares shares) { return shares == SpaceShares::nothing; };
  if (std::all_of(shares_.begin(), shares_.end(), is_nothing)) shares_.clear();
}

void SharedGoals::note(std::span<const Robot> robots, std::span<const std::uint8_t> has_stood) {
  if (shares_.empty()) return;
  for (std::size_t k = 0; k < robots.size(); ++k) {
    const bool stands = has_stood[k] != 0 && robots[k].velocity == Vec3{};
    if (stands && noted_[k] == 0) note_taken_by(k, robots[k]);
    noted_[k] = stands ? 1 : 0;
  }
}

void SharedGoals::note_taken_by(std::size_t k, const Robot& robot) {
  for_overlapping(robot, there_, cells_, [&](std::size_t b) {
    if (b != k) shares_[b] = std::max(shares_[b], SpaceShares::room);
  });
}

}  // namespace avo::space
