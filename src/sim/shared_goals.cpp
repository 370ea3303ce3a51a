// SPDX-License-Identifier: Apache-2.0
// Who shares its goal with others stands near it, and does not fight for a point at which only one
// can be (docs/arrival.md, rule 4): a rule for arriving, of method avo alone.
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "certificate/braking_path.h"
#include "planner/certify.h"
#include "robots/model.h"
#include "sim/world.h"

namespace avo {

namespace {

// What is set in anybody's layers, and in those of two.
struct LayersOfMany {
  std::uint32_t once = 0, twice = 0;

  void add(LayerSet layers) {
    twice |= once & layers.bits;
    once |= layers.bits;
  }
  // In those of anybody but the one whose layers these are.
  std::uint32_t without(LayerSet own) const { return twice | (once & ~own.bits); }
};

// Those who have one goal.
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

// By rank: 1 of those whose goal another one has as well, who may not be in their place; empty
// where there are none.
std::vector<std::uint8_t> sharers_of(const World& world) {
  const Fleet& fleet = world.fleet;
  const auto goal_of = [&](std::uint32_t slot) {
    const Vec2 end = world.end_of(slot);
    return std::pair(end.x, end.y);
  };
  std::vector<std::uint32_t> slots;
  if (std::none_of(fleet.conduct.begin(), fleet.conduct.end(),
                   [](const Conduct& conduct) { return conduct.method == Method::avo; }))
    return {};
  for (std::uint32_t slot = 0; slot < fleet.size(); ++slot)
    if (!fleet.conduct[slot].parked && fleet.flight(slot) == nullptr) slots.push_back(slot);
  std::sort(slots.begin(), slots.end(),
            [&](std::uint32_t a, std::uint32_t b) { return goal_of(a) < goal_of(b); });
  std::vector<std::uint8_t> shares;
  for (std::size_t first = 0, end = 0; first < slots.size(); first = end) {
    Sharers sharers;
    for (; end < slots.size() && goal_of(slots[end]) == goal_of(slots[first]); ++end)
      sharers.add(fleet.conduct[slots[end]]);
    if (end - first == 1) continue;
    for (std::size_t k = first; k < end; ++k) {
      const Conduct& own = fleet.conduct[slots[k]];
      if (own.method != Method::avo || !sharers.hinder(own)) continue;
      shares.resize(fleet.size());
      shares[static_cast<std::size_t>(fleet.rank[slots[k]])] = 1;
    }
  }
  return shares;
}

}  // namespace

void find_shared_goals(World& world) {
  if (!world.has_new_goals) return;
  world.shares_goal = sharers_of(world);
  world.has_new_goals = false;
}

bool stays_near(const World& world, std::size_t slot, Vec2 aim) {
  if (world.shares_goal.empty()) return false;
  const Fleet& fleet = world.fleet;
  const Vec2 goal = world.end_of(slot);
  return world.shares_goal[static_cast<std::size_t>(fleet.rank[slot])] != 0 && aim == goal &&
         norm(goal - fleet.place(slot)) <= world.settings.arrival_distance;
}

std::optional<Plan> stop_of(const World& world, std::size_t slot) {
  const Fleet& fleet = world.fleet;
  if (fleet.has_stood[slot] != 0) return std::nullopt;
  const RobotTraits& traits = fleet.traits[slot];
  Robot robot;
  robot.velocity = fleet.velocity[slot];
  robot.max_acceleration = traits.max_acceleration, robot.max_braking = max_braking_of(traits);
  const Pace& pace = world.pace(slot);
  const CertificateLaw law = certificate_law(pace.planner);
  const Vec2 next = braked(robot.velocity, decrement_of(robot, law.step));
  Plan plan = plan_under(law, robot, next, PlanStatus::optimal, 0.0);
  const MotionState state{{}, robot.velocity, fleet.heading[slot]};
  const MotionModel* model = fleet.own_model(slot);
  const MotionStep step = model == nullptr
                              ? advance(state, plan, pace.response)
                              : advance(*model, {planned_braking(traits), traits.max_speed}, state,
                                        plan, pace.response.time_step);
  plan.next_velocity = step.next.velocity;
  return plan;
}

}  // namespace avo
