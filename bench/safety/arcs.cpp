// SPDX-License-Identifier: Apache-2.0
// Where robots are within a step, cars on their arcs among them.
#include "arcs.h"

#include <cmath>
#include <cstddef>

#include "placement.h"

namespace avo::safety {
namespace {

Vec2 direction(double angle) {
  return {std::cos(angle), std::sin(angle)};
}

// The arc's length grows by the speed, its turn with its length.
Pose on_arc(const Pose& from, double next_speed, double turn, double time_step, double part) {
  const double speed = norm(from.velocity), gain = next_speed - speed;
  const double length = part * time_step * (speed + 0.5 * part * gain);
  const double whole = time_step * (speed + 0.5 * gain);
  const double turned = whole > 0.0 ? turn * length / whole : 0.0, half = 0.5 * turned;
  const double chord = std::abs(half) < 1e-8 ? length : length * std::sin(half) / half;
  return {from.position + chord * direction(from.heading + half),
          (speed + part * gain) * direction(from.heading + turned), from.heading + turned};
}

Pose on_parabola(const Pose& from, Vec2 next_velocity, double time_step, double part) {
  const Vec2 gain = part * (next_velocity - from.velocity);
  return {from.position + (part * time_step) * (from.velocity + 0.5 * gain), from.velocity + gain};
}

}  // namespace

std::vector<Pose> poses(const FleetView& fleet) {
  std::vector<Pose> all;
  for (std::size_t i = 0; i < fleet.id.size(); ++i) {
    all.push_back({fleet.position[i], fleet.velocity[i], fleet.heading[i]});
  }
  return all;
}

std::vector<CheckedState> states_within(const std::vector<Pose>& before, const FleetView& now,
                                        double time_step, double part) {
  std::vector<CheckedState> states;
  for (std::size_t i = 0; i < before.size(); ++i) {
    const double turn = std::remainder(now.heading[i] - before[i].heading, 2.0 * kPi);
    const Pose pose = !is_holonomic(now.setup[i].model)
                          ? on_arc(before[i], norm(now.velocity[i]), turn, time_step, part)
                          : on_parabola(before[i], now.velocity[i], time_step, part);
    states.push_back({static_cast<std::int64_t>(now.id[i].value), pose.position, pose.velocity});
  }
  return states;
}

}  // namespace avo::safety
