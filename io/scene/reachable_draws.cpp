// SPDX-License-Identifier: Apache-2.0
#include "io/scene/reachable_draws.h"

#include <algorithm>
#include <cstddef>
#include <optional>
#include <variant>

#include "avo/reachability.h"
#include "io/maps/wall_space.h"
#include "io/scene/placement.h"

namespace avo_io {
namespace {

using avo::Vec2;

constexpr int kTriesAgain = 2000;                          // for one place
constexpr std::uint64_t kAgain = std::uint64_t{1} << 62U;  // differs from all other streams

// The walls that a robot in those layers heeds.
std::vector<avo::Wall> walls_about(const avo::Scenario& scenario, avo::LayerSet robot) {
  std::vector<avo::Wall> walls = avo::walls_of(heeded(scenario.obstacles, robot));
  const std::vector<avo::Wall> parked = avo::parked_discs(scenario.robots);
  walls.insert(walls.end(), parked.begin(), parked.end());
  return walls;
}

// A group's starts and goals, and the robots of it without a route to their goals ("lost" robots).
class Draws {
 public:
  Draws(const Group& group, const avo::Scenario& scenario, Random random,
        const std::vector<avo::Wall>& walls, Starts& from, std::vector<Vec2>& to)
      : group_(group),
        scenario_(scenario),
        random_(random),
        reachability_(walls, disc_radius(group.robot)),
        from_(from),
        to_(to) {
    for (std::size_t i = 0; i < to.size(); ++i)
      if (!reachability_.connects(from.points[i], to[i])) lost_.push_back(i);
  }

  [[nodiscard]] bool all_reach() const { return lost_.empty(); }

  void draw_goals(const RandomGoals& area) {
    mend(area, to_, false,
         [&](std::size_t i, Vec2 place) { return reachability_.connects(from_.points[i], place); });
  }

  // Draws starts; goals that depend on their starts move with them.
  void draw_starts(const RandomPlacement& area) {
    mend(area, from_.points, true, [&](std::size_t i, Vec2 place) {
      const Vec2 goal = goal_from(i, place);
      if (!reachability_.connects(place, goal)) return false;
      to_[i] = goal;
      return true;
    });
  }

  // Exchanges the goals of two lost robots if the first can reach the goal of the second.
  void exchange_goals() {
    for (const std::size_t i : lost_) {
      for (const std::size_t k : lost_) {
        if (reachability_.connects(from_.points[i], to_[i])) break;
        const bool is_own = to_[k] == from_.points[i] || to_[i] == from_.points[k];
        if (k == i || is_own || reachability_.connects(from_.points[k], to_[k])) continue;
        if (reachability_.connects(from_.points[i], to_[k])) std::swap(to_[i], to_[k]);
      }
    }
    std::erase_if(lost_,
                  [&](std::size_t i) { return reachability_.connects(from_.points[i], to_[i]); });
  }

 private:
  Vec2 goal_from(std::size_t i, Vec2 start) const {
    if (std::holds_alternative<AntipodalGoals>(group_.goals))
      return from_.center + (from_.center - start);
    if (const auto* offset = std::get_if<OffsetGoals>(&group_.goals)) return start + offset->by;
    return to_[i];
  }

  // Draws the places of the lost robots again, clear of all other places.
  template <typename Area, typename Accepts>
  void mend(const Area& area, std::vector<Vec2>& places, bool are_starts, const Accepts& accepts) {
    const double radius = room_of(group_.robot);
    FreeSpace space(area.min, area.max, radius, area.clearance,
                    places.size() + (are_starts ? scenario_.robots.size() : 0));
    if (are_starts) add_others(group_, scenario_, space);
    for (std::size_t i = 0; i < places.size(); ++i)
      if (!std::binary_search(lost_.begin(), lost_.end(), i)) space.add({places[i], radius});
    const WallSpace walls(heeded(scenario_.obstacles, group_.robot.layers),
                          radius + area.clearance);
    std::vector<std::size_t> still;
    for (const std::size_t i : lost_) {
      bool is_mended = false;
      for (int k = 0; k < kTriesAgain && !is_mended; ++k) {
        const double x = random_.between(area.min.x, area.max.x);
        const Vec2 place{x, random_.between(area.min.y, area.max.y)};
        is_mended = space.is_clear(place) && walls.is_clear(place) && accepts(i, place);
        if (is_mended) places[i] = place;
      }
      if (!is_mended) still.push_back(i);
      space.add({places[i], radius});
    }
    lost_ = still;
  }

  const Group& group_;
  const avo::Scenario& scenario_;
  Random random_;
  avo::Reachability reachability_;
  Starts& from_;
  std::vector<Vec2>& to_;
  std::vector<std::size_t> lost_;  // ascending
};

}  // namespace

void add_others(const Group& group, const avo::Scenario& scenario, FreeSpace& space) {
  for (const auto& robot : scenario.robots) {
    if (keep_apart(robot, group.robot)) space.add({disc_center(robot), disc_radius(robot)});
  }
  for (const auto& mover : scenario.moving_obstacles) space.add({mover.position, mover.radius});
}

void draw_reachable(const Group& group, const avo::Scenario& scenario, std::uint64_t stream,
                    Starts& from, std::vector<Vec2>& to) {
  const auto* area = std::get_if<RandomPlacement>(&group.placement);
  const auto* goals = std::get_if<RandomGoals>(&group.goals);
  if ((area == nullptr && goals == nullptr) || is_parked(group.robot)) return;
  const std::vector<avo::Wall> walls = walls_about(scenario, group.robot.layers);
  if (walls.empty()) return;
  Draws draws(group, scenario, Random(scenario.seed, stream + kAgain), walls, from, to);
  if (draws.all_reach()) return;
  if (goals != nullptr)
    draws.draw_goals(*goals);
  else if (std::holds_alternative<PermutationGoals>(group.goals))
    draws.exchange_goals();
  if (area == nullptr || std::holds_alternative<PermutationGoals>(group.goals)) return;
  draws.draw_starts(*area);
  if (goals != nullptr) draws.draw_goals(*goals);
}

}  // namespace avo_io
