// SPDX-License-Identifier: Apache-2.0
#include "sim/sensing/outliers.h"

#include <algorithm>
#include <functional>

#include "core/plane.h"
#include "robots/footprint.h"
#include "sim/world.h"

namespace avo::inline sim {
namespace {

// Where more than one in so many are outliers, all robots are examined closely, and there are no
// outliers.
constexpr std::size_t kUnlikeOfMany = 8, kFarOfMany = 64;
// A far reach is this factor longer than that of all others.
constexpr double kFarther = 1.25;

// m: the reach of all robots except a few that each reach much farther; infinite where there are no
// such robots.
double usual_reach(const World& world) {
  const Fleet& fleet = world.fleet;
  const Planner& planner = world.certified_planner();
  const std::size_t few = fleet.size() / kFarOfMany;
  if (few == 0 || fleet.has_clocks || !world.all_matter() || !planner.options().max_neighbors)
    return kInfinity;
  std::vector<double> reach;
  for (std::size_t slot = 0; slot < fleet.size(); ++slot) {
    Peers own;
    include(own, planner, limits_of(fleet, slot));
    reach.push_back(fleet.is_parked(slot) ? 0.0 : own.reach);
  }
  const auto last = reach.begin() + static_cast<std::ptrdiff_t>(few);
  std::nth_element(reach.begin(), last, reach.end(), std::greater<>());
  const double most = kFarther * *last;
  return std::any_of(reach.begin(), last, [&](double r) { return r > most; }) ? most : kInfinity;
}

bool reaches_beyond(const World& world, std::size_t slot, double reach) {
  if (reach == kInfinity || world.fleet.is_parked(slot)) return false;
  Peers own;
  include(own, world.certified_planner(), limits_of(world.fleet, slot));
  return own.reach > reach;
}

bool is_covered(const Fleet& fleet, std::size_t slot) {
  return fleet.has_footprints && fleet.own_model(slot) != nullptr &&
         has_footprint(*fleet.own_model(slot));
}

Outlier outlier_of(const World& world, std::size_t slot, double reach) {
  const Fleet& fleet = world.fleet;
  const Conduct& conduct = fleet.conduct[slot];
  Conduct usual;
  usual.method = fleet.usual.method, usual.certified = fleet.usual.certified;
  usual.priority = conduct.priority;
  return {.rank = fleet.rank[slot],
          .reaches_far = reaches_beyond(world, slot, reach),
          .is_unlike = conduct.priority != Conduct{}.priority ||
                       max_braking_of(fleet.traits[slot]) || is_covered(fleet, slot),
          .stands_apart = conduct != usual || fleet.flight(slot) != nullptr};
}

void find_outliers(World& world) {
  Outliers& outliers = world.outliers;
  outliers.usual = Scrutiny::plain;
  outliers.robots.clear();
  if (!world.senses.are_exact()) return;  // all robots are then examined one by one
  const double reach = usual_reach(world);
  std::size_t unlike = 0, apart = 0;
  for (const std::uint32_t slot : world.fleet.slot_of) {
    const Outlier outlier = outlier_of(world, slot, reach);
    if (outlier.is_unlike || outlier.stands_apart || outlier.reaches_far)
      outliers.robots.push_back(outlier);
    unlike += outlier.is_unlike || outlier.stands_apart ? 1 : 0;
    apart += outlier.stands_apart ? 1 : 0;
  }
  const std::size_t movers = world.movers.setup.size();
  const bool are_few = (unlike + movers) * kUnlikeOfMany <= world.fleet.size();
  // where clocks are free, no robot is moved only to find which robots are near it
  if (are_few && (!world.fleet.has_clocks || unlike + movers == 0)) return;
  outliers.usual = apart + movers > 0 ? Scrutiny::everyone : Scrutiny::one_by_one;
  std::erase_if(outliers.robots, [](const Outlier& outlier) { return !outlier.reaches_far; });
}

bool reaches_far(const World& world, std::size_t slot) {
  const std::vector<Outlier>& robots = world.outliers.robots;
  const auto place =
      std::lower_bound(robots.begin(), robots.end(), world.fleet.rank[slot],
                       [](const Outlier& outlier, int rank) { return outlier.rank < rank; });
  return place != robots.end() && place->rank == world.fleet.rank[slot] && place->reaches_far;
}

// The first of the paces that differ from each pace in the arrival distance at most: their robots
// meet the same.
std::vector<std::size_t> first_alike(const std::vector<Pace>& paces) {
  const auto are_alike = [&](std::size_t a, std::size_t b) {
    const PlannerOptions &one = paces[a].planner.options(), &other = paces[b].planner.options();
    return one.method == other.method && one.time_step == other.time_step &&
           one.time_horizon == other.time_horizon;
  };
  std::vector<std::size_t> firsts, result;
  for (std::size_t k = 0; k < paces.size(); ++k) {
    const auto first = std::find_if(firsts.begin(), firsts.end(),
                                    [&](std::size_t other) { return are_alike(k, other); });
    result.push_back(first != firsts.end() ? *first : firsts.emplace_back(k));
  }
  return result;
}

// The robots that a robot of one pace may meet, with or without those of far reach.
Peers whom_they_meet(const World& world, const Pace& pace, bool with_far) {
  const Fleet& fleet = world.fleet;
  Peers met;
  for (std::size_t slot = 0; slot < fleet.size(); ++slot) {
    if (fleet.is_parked(slot) || (!with_far && reaches_far(world, slot))) continue;
    include(met, pace.planner, limits_of(fleet, slot));
  }
  return met;
}

}  // namespace

void find_ranges(World& world) {
  Fleet& fleet = world.fleet;
  Outliers& outliers = world.outliers;
  find_outliers(world);
  const bool some_far = std::any_of(outliers.robots.begin(), outliers.robots.end(),
                                    [](const Outlier& outlier) { return outlier.reaches_far; });
  const std::vector<std::size_t> first = first_alike(world.paces);
  std::vector<Peers> all, usual;  // by pace
  for (std::size_t k = 0; k < first.size(); ++k) {
    const Pace& pace = world.paces[k];
    const bool is_first = first[k] == k;
    usual.push_back(is_first ? whom_they_meet(world, pace, false) : Peers(usual[first[k]]));
    const Peers met = some_far && is_first ? whom_they_meet(world, pace, true) : usual.back();
    all.push_back(is_first ? met : Peers(all[first[k]]));
  }
  double sum = 0.0;
  outliers.reach = 0.0;
  for (const std::uint32_t slot : fleet.slot_of) {
    const Pace& pace = world.pace(slot);
    const auto k = static_cast<std::size_t>(&pace - world.paces.data());
    const Robot robot = limits_of(fleet, slot);
    const bool is_far = reaches_far(world, slot);
    fleet.range[slot] = relevant_range(pace.planner, robot, is_far ? all[k] : usual[k]);
    if (some_far && !is_far) {
      const double speed = (1.0 + kSpeedRounding) * robot.max_speed;
      outliers.reach =
          std::max(outliers.reach, relevant_range(pace.planner, robot, all[k]).at(speed));
    }
    sum += std::min(fleet.range[slot].at(0.5 * robot.max_speed), world.sensing_radius);
  }
  world.near = fleet.size() > 0 ? sum / static_cast<double>(fleet.size()) : 0.0;
}

void locate_outliers(World& world) {
  Outliers& outliers = world.outliers;
  outliers.in_sight.clear();
  const bool is_alone = outliers.robots.empty() && world.movers.setup.empty();
  if (is_alone || !world.senses.are_exact() || outliers.usual == Scrutiny::everyone) return;
  const Cells& cells = world.snapshot.cells;
  outliers.in_sight.resize(cells.table() + 1);
  const auto mark = [&](Vec2 p, double radius) {
    if (!is_finite(p)) return;
    const CellRange range = cells_within(p, radius, cells);
    for (std::int64_t row = range.first_row; row <= range.last_row; ++row) {
      for (std::size_t k = 0; k < range.columns; ++k)
        outliers.in_sight[cells.slot(range.first_column + static_cast<std::int64_t>(k), row)] = 1;
    }
  };
  outliers.position.clear(), outliers.velocity.clear();
  for (const Outlier& outlier : outliers.robots) {
    const std::uint32_t slot = world.fleet.slot_of[static_cast<std::size_t>(outlier.rank)];
    outliers.position.push_back(world.fleet.position[slot]);
    outliers.velocity.push_back(world.fleet.velocity[slot]);
    const bool is_far = !outlier.is_unlike && !outlier.stands_apart;
    mark(outliers.position.back(),
         is_far ? std::min(outliers.reach, world.sensing_radius) : world.sensing_radius);
  }
  if (!outliers.robots.empty()) outliers.grid.build(outliers.position, world.sensing_radius);
  for (const Vec2 p : world.movers.position) mark(p, world.sensing_radius);
}

}  // namespace avo::inline sim
