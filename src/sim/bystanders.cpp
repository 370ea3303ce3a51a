// SPDX-License-Identifier: Apache-2.0
#include "sim/bystanders.h"

#include <algorithm>

#include "core/plane.h"
#include "sim/columns/fleet.h"
#include "spatial/cells.h"

namespace avo::inline sim {

void forget(Bystanders& bystanders) {
  bystanders.is_wanted = bystanders.is_made = false;
}

bool has_many_late(const Bystanders& bystanders) {
  constexpr std::size_t kFew = 1024, kOfOne = 64;  // tests of a late robot, for one in the grid
  const std::size_t late = bystanders.late.size();
  return late * late > kFew + kOfOne * bystanders.id.size();
}

void note_late(Bystanders& bystanders, RobotId robot, Vec2 position) {
  if (bystanders.is_made) bystanders.late.push_back({robot, position});
}

void make(Bystanders& bystanders, const Fleet& fleet, const MostOfOthers& most, double side) {
  bystanders.most = most;
  bystanders.side = side;
  bystanders.id = fleet.id;
  bystanders.late.clear();
  bystanders.grid.build(fleet.position, side);
  bystanders.is_made = true;
}

std::vector<std::uint32_t> near_place(const Bystanders& bystanders, const Fleet& fleet, Vec2 center,
                                      double radius) {
  constexpr double kMargin = 1.0 + 1e-9;  // for rounding
  if (!bystanders.is_made || !is_finite(center) ||
      !(kMargin * radius <= kMostSides * bystanders.side))
    return fleet.slot_of;
  std::vector<std::uint32_t> places, ranks, slots;
  bystanders.grid.list_within(center, kMargin * radius, places);
  const auto take = [&](RobotId robot) {
    if (const auto slot = fleet.slot(robot))
      ranks.push_back(static_cast<std::uint32_t>(fleet.rank[*slot]));
  };
  for (const std::uint32_t place : places)
    take(bystanders.id[static_cast<std::size_t>(bystanders.grid.index(place))]);
  const double reach = kMargin * radius;
  for (const Bystanders::Late& robot : bystanders.late)
    if (!(norm_squared(robot.position - center) > reach * reach)) take(robot.id);
  std::sort(ranks.begin(), ranks.end());
  ranks.erase(std::unique(ranks.begin(), ranks.end()), ranks.end());
  for (const std::uint32_t rank : ranks) slots.push_back(fleet.slot_of[rank]);
  return slots;
}

}  // namespace avo::inline sim
