// SPDX-License-Identifier: Apache-2.0
// A robot that shares its goal with others stands near it, and does not fight for a point at which
// only one can be. It is a rule for arriving (docs/arrival.md, rule 4), of method avo alone.
#include "sim/shared_goals.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "core/plane.h"
#include "planner/rules/arrival.h"
#include "sim/world.h"

namespace avo::inline sim {

namespace {

constexpr double kTouching = 1e-9;  // of contact: goals that touch leave room for both

// The layers of at least one robot, and those of at least two.
struct LayersOfMany {
  std::uint32_t once = 0, twice = 0;

  void add(LayerSet layers) {
    twice |= once & layers.bits;
    once |= layers.bits;
  }
  // The layers of all robots except the one with these layers.
  std::uint32_t without(LayerSet own) const { return twice | (once & ~own.bits); }
};

// The robots that have one goal.
struct Sharers {
  LayersOfMany layers, avoids;

  void add(const Conduct& conduct) {
    layers.add(conduct.layers);
    avoids.add(conduct.avoids);
  }
  // keep_apart(), of one of them and any other one
  bool hinder(const Conduct& own) const {
    return (own.avoids.bits & layers.without(own.layers)) != 0 ||
           (own.layers.bits & avoids.without(own.avoids)) != 0;
  }
};

// Returns whether goals lie along y rather than along x: a sweep along them meets few at a time.
bool are_along_y(std::span<const Vec2> goals) {
  const auto by_x = [](Vec2 a, Vec2 b) { return a.x < b.x; };
  const auto by_y = [](Vec2 a, Vec2 b) { return a.y < b.y; };
  const auto [left, right] = std::minmax_element(goals.begin(), goals.end(), by_x);
  const auto [low, high] = std::minmax_element(goals.begin(), goals.end(), by_y);
  return left != goals.end() && high->y - low->y > right->x - left->x;
}

// What robots of method avo share, by rank.
class Sharing {
 public:
  explicit Sharing(const World& world) : fleet_(world.fleet) {
    for (std::uint32_t slot = 0; slot < fleet_.size(); ++slot) {
      goals_.push_back(world.end_of(slot));
      if (rests_at_goal(fleet_, slot)) slots_.push_back(slot);
    }
    if (are_along_y(goals_))
      for (Vec2& goal : goals_) std::swap(goal.x, goal.y);
    std::sort(slots_.begin(), slots_.end(), [&](std::uint32_t a, std::uint32_t b) {
      return along(goals_[a]) < along(goals_[b]);
    });
  }

  std::vector<Shares> found() && {
    find_same();
    find_close();
    return std::move(shares_);
  }

 private:
  // The order of goals, in which equal ones are next to each other.
  static std::pair<double, double> along(Vec2 goal) { return {goal.x, goal.y}; }
  double between(std::size_t first, std::size_t second) const {
    return goal(second).x - goal(first).x;
  }
  Vec2 goal(std::size_t place) const { return goals_[slots_[place]]; }
  const Conduct& conduct(std::size_t place) const { return fleet_.conduct[slots_[place]]; }
  // Robots with footprints may both be at goals that are nearer than the discs that cover them.
  double radius(std::size_t place) const { return fleet_.traits[slots_[place]].route_radius; }
  std::size_t rank(std::size_t place) const {
    return static_cast<std::size_t>(fleet_.rank[slots_[place]]);
  }

  void note(std::size_t place, Shares shares) {
    if (!method_traits(conduct(place).method).has_rules) return;
    shares_.resize(fleet_.size());
    shares_[rank(place)] = std::max(shares_[rank(place)], shares);
  }

  void find_same() {
    for (std::size_t first = 0, end = 0; first < slots_.size(); first = end) {
      Sharers sharers;
      for (; end < slots_.size() && goal(end) == goal(first); ++end) sharers.add(conduct(end));
      for (std::size_t k = first; k < end && end - first > 1; ++k)
        if (sharers.hinder(conduct(k))) note(k, Shares::goal);
    }
  }

  // Finds pairs with goals so close that they cannot both be there.
  void find_close() {
    double largest = 0.0;  // m
    for (std::size_t k = 0; k < slots_.size(); ++k) largest = std::max(largest, radius(k));
    const auto overlap = [&](std::size_t a, std::size_t b) {
      return leave_no_room(goal(a), radius(a), goal(b), radius(b)) &&
             keep_apart(conduct(a), conduct(b));
    };
    for (std::size_t k = 0; k < slots_.size(); ++k) {
      if (!shares_.empty() && shares_[rank(k)] != Shares::nothing) continue;
      const double reach = radius(k) + largest;
      for (std::size_t other = k + 1; other < slots_.size(); ++other) {
        if (between(k, other) >= reach) break;
        if (!overlap(k, other)) continue;
        note(k, Shares::room), note(other, Shares::room);
        break;
      }
      for (std::size_t other = k; other-- > 0 && between(other, k) < reach;) {
        if (!overlap(k, other)) continue;
        note(k, Shares::room);
        break;
      }
    }
  }

  const Fleet& fleet_;
  // m, or the nearest reachable places; x is the axis along which goals lie
  std::vector<Vec2> goals_;
  std::vector<std::uint32_t> slots_;  // of the robots that come to rest at their goals
  std::vector<Shares> shares_;
};

// Returns whether the robot is within the arrival distance of a goal that others have as well: it
// stays in place there (docs/arrival.md, rule 4).
bool stays_near(const World& world, std::size_t slot) {
  const Fleet& fleet = world.fleet;
  return world.shares_goal[static_cast<std::size_t>(fleet.rank[slot])] == Shares::goal &&
         norm(world.end_of(slot) - fleet.place(slot)) <= world.arrival_distance(slot);
}

}  // namespace

bool rests_at_goal(const Fleet& fleet, std::size_t slot) {
  return !fleet.is_parked(slot) && fleet.flight(slot) == nullptr && fleet.heads_for_goal(slot);
}

bool keep_apart(const Conduct& a, const Conduct& b) {
  return (a.avoids.bits & b.layers.bits) != 0 || (b.avoids.bits & a.layers.bits) != 0;
}

bool leave_no_room(Vec2 a, double radius_a, Vec2 b, double radius_b) {
  return norm(a - b) < (1.0 - kTouching) * (radius_a + radius_b);
}

void find_shared_goals(World& world) {
  if (!world.has_new_goals) return;
  const std::vector<Conduct>& conduct = world.fleet.conduct;
  const bool is_minded = std::any_of(conduct.begin(), conduct.end(), [](const Conduct& own) {
    return method_traits(own.method).has_rules;
  });
  world.shares_goal = is_minded ? Sharing(world).found() : std::vector<Shares>();
  find_taken_goals(world);
  world.has_new_goals = false;
}

bool shares_room(const World& world, std::size_t slot) {
  if (world.shares_goal.empty()) return false;
  const auto rank = static_cast<std::size_t>(world.fleet.rank[slot]);
  return world.shares_goal[rank] != Shares::nothing || world.taken_goals.is_taken(rank);
}

Seeker seeker_of(const World& world, std::size_t slot, const Heading& heading, Vec2 lost) {
  const Fleet& fleet = world.fleet;
  const RobotTraits& traits = fleet.traits[slot];
  Robot robot;
  robot.radius = traits.radius, robot.max_speed = traits.max_speed;
  robot.max_acceleration = traits.max_acceleration, robot.max_braking = max_braking_of(traits);
  // farther away it may know the nearest ones only
  const bool knows_all = !world.pace(slot).planner.options().max_neighbors;
  const Vec2 end = world.end_of(slot);
  Seeker seeker = seeker_of({.position = fleet.position[slot],
                             .goal = disc_goal(fleet, slot, end, end) - lost,
                             .end = end,
                             .lost = lost,
                             .range = knows_all ? kInfinity : arrival_range(robot, traits.radius)},
                            traits, heading);
  seeker.has_stood = fleet.has_stood[slot] != 0;
  seeker.is_at_rest = fleet.velocity[slot] == Vec2{};
  seeker.is_near = stays_near(world, slot);
  return seeker;
}

bool rests_at_place(const World& world, std::size_t slot) {
  const Fleet& fleet = world.fleet;
  const bool is_kept_out =
      !world.travels.empty() &&
      world.travels[static_cast<std::size_t>(fleet.rank[slot])].ends == RouteEnd::short_of;
  return !is_kept_out && fleet.has_stood[slot] != 0 && fleet.velocity[slot] == Vec2{} &&
         shares_room(world, slot);
}

Plan stop_of(const World& world, std::size_t slot) {
  const Fleet& fleet = world.fleet;
  const RobotTraits& traits = fleet.traits[slot];
  Robot robot;
  robot.velocity = fleet.velocity[slot], robot.heading = fleet.heading[slot];
  robot.max_speed = traits.max_speed;
  robot.max_acceleration = traits.max_acceleration, robot.max_braking = max_braking_of(traits);
  robot.model = fleet.model(slot);
  const Pace& pace = world.pace(slot);
  return stop_of(pace.planner, pace.response, robot);
}

}  // namespace avo::inline sim
