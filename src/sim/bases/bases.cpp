// SPDX-License-Identifier: Apache-2.0
#include "sim/bases/bases.h"

#include <algorithm>
#include <cmath>
#include <span>

#include "core/draws.h"
#include "core/elementary.h"
#include "core/hash.h"
#include "robots/execution_bounds.h"
#include "sim/world.h"

namespace avo::inline sim {
namespace {

// What tells the draws of a base from other draws of the same robot and step.
constexpr std::uint64_t kBase = 0xba5e;
constexpr std::uint64_t kStep = 0xba5e + 1;

// In [-1, 1).
double drawn(Draws& draws) {
  return 2.0 * draws.uniform() - 1.0;
}

// Within a disc of that radius: each coordinate within its square.
Vec2 drawn(Draws& draws, double radius) {
  constexpr double kHalfDiagonal = 0.70710678118654746;  // √½, rounded down
  const double x = drawn(draws), y = drawn(draws);
  return (kHalfDiagonal * radius) * Vec2{x, y};
}

// 1 - e^(-t/T'): the part of the distance to its target that a velocity covers in that time.
double approached_in(double time, double lag) {
  return lag > 0.0 ? -elementary::expm1(-time / lag) : 1.0;
}

}  // namespace

Bases::Bases(const Scenario& scenario)
    : model(scenario.execution),
      declared(scenario.execution_error),
      time_step(scenario.time_step),
      seed(scenario.seed) {
  if (!model) return;
  const double latest = model->dead_time + model->dead_time_error;
  depth = static_cast<std::size_t>(std::ceil(latest / time_step)) + 2;
}

double Bases::added_radius(const RobotSetup& body) const {
  if (declared || !model) return declared.value_or(0.0);
  return bounds_of(*model, body.model, limits_of(body), time_step).position;
}

RobotSetup Bases::reference_of(const RobotSetup& body) const {
  RobotSetup reference = body;
  reference.radius += added_radius(body);
  return reference;
}

void Bases::reserve_one() {
  if (all.size() == all.capacity()) all.reserve(2 * all.size() + 8);
  sent.reserve(all.capacity() * depth);
}

void Bases::add(RobotId robot, const RobotSetup& body) {
  if (!model) return;
  sent.resize((all.size() + 1) * depth);
  Draws draws(Draws::key_of(seed, 0, robot.value), kBase);
  Base base;
  base.radius = body.radius, base.added = added_radius(body);
  base.position = body.position;
  base.lag = model->time_constant + drawn(draws) * model->time_constant_error;
  const double dead_time = model->dead_time + drawn(draws) * model->dead_time_error;
  base.whole_steps = static_cast<std::size_t>(dead_time / time_step);
  base.rest =
      std::clamp(dead_time - static_cast<double>(base.whole_steps) * time_step, 0.0, time_step);
  base.before = approached_in(base.rest, base.lag);
  base.after = approached_in(time_step - base.rest, base.lag);
  all.push_back(base);
}

void Bases::remove(std::size_t rank) {
  if (!model) return;
  const auto first = sent.begin() + static_cast<std::ptrdiff_t>(rank * depth);
  sent.erase(first, first + static_cast<std::ptrdiff_t>(depth));
  all.erase(all.begin() + static_cast<std::ptrdiff_t>(rank));
}

void Bases::put_down(std::size_t rank, Vec2 position) {
  if (!model) return;
  all[rank].position = position, all[rank].velocity = {};
  std::fill_n(sent.begin() + static_cast<std::ptrdiff_t>(rank * depth), depth, Vec2{});
}

Scenario with_references(const Scenario& scenario) {
  Scenario result = scenario;
  const Bases bases(scenario);
  for (RobotSetup& robot : result.robots) robot = bases.reference_of(robot);
  result.execution.reset(), result.execution_error.reset();
  return result;
}

Bases bases_of(const Scenario& scenario) {
  Bases bases(scenario);
  if (bases.are_exact()) return bases;
  for (std::size_t k = 0; k < scenario.robots.size(); ++k) bases.add({k}, scenario.robots[k]);
  return bases;
}

namespace {

// The exact motion towards a velocity that is held.
void go_on(Vec2 target, double time, double part, Base& base) {
  const Vec2 gained = part * (target - base.velocity);
  base.position = base.position + time * target - base.lag * gained;
  base.velocity = base.lag > 0.0 ? base.velocity + gained : target;
}

// `after`: the reference at the end of the step.
void move_base(const Bases& bases, std::size_t step, Draws draws, const MotionState& after,
               std::span<Vec2> sent, Base& base) {
  const ExecutionModel& model = *bases.model;
  const Vec2 position = base.position + drawn(draws, model.measured_position_error);
  const Vec2 velocity = base.velocity + drawn(draws, model.measured_velocity_error);
  const Vec2 error = drawn(draws, model.velocity_error);
  sent[step % bases.depth] = executable(
      model,
      command_towards(model, after, position, velocity,
                      still_to_come(sent, step % bases.depth, model.dead_time, bases.time_step),
                      bases.time_step));
  const auto acting = [&](std::size_t late) {  // nothing was sent before the first step
    return step >= late ? sent[(step - late) % bases.depth] : Vec2{};
  };
  if (base.rest > 0.0) go_on(acting(base.whole_steps + 1) + error, base.rest, base.before, base);
  if (base.rest < bases.time_step)
    go_on(acting(base.whole_steps) + error, bases.time_step - base.rest, base.after, base);
}

}  // namespace

void move_bases(World& world) {
  Fleet& fleet = world.fleet;
  Bases& bases = fleet.bases;
  const auto step = static_cast<std::size_t>(world.steps - 1);
  for (std::size_t rank = 0; rank < bases.all.size(); ++rank) {
    const std::uint32_t slot = fleet.slot_of[rank];
    if (fleet.conduct[slot].parked) continue;
    const Draws draws(Draws::key_of(bases.seed, world.steps, fleet.id[slot].value), kStep);
    move_base(bases, step, draws, fleet.state(slot),
              std::span(bases.sent).subspan(rank * bases.depth, bases.depth), bases.all[rank]);
  }
}

std::uint64_t hash_of(const Bases& bases, std::uint64_t hash) {
  const auto mix = [&](Vec2 value) {
    hash = mixed(mixed(hash, word_of(value.x)), word_of(value.y));
  };
  for (const Base& base : bases.all) mix(base.position), mix(base.velocity);
  for (const Vec2 command : bases.sent) mix(command);
  return hash;
}

}  // namespace avo::inline sim
