// SPDX-License-Identifier: Apache-2.0
// Robots in a saved state: their setups, their routes, and what they remember.
#pragma once
#include <bit>
#include <cstdint>
#include <string>
#include <utility>

#include "avo/scenario.h"
#include "core/plane.h"
#include "sim/state/archive.h"
#include "sim/state/late_fields.h"
#include "sim/state/saved_models.h"
#include "sim/state/saved_state.h"

namespace avo::inline sim {

template <bool kReads>
void describe(Archive<kReads>& archive, Waiting& waiting) {
  describe(archive, waiting.least), describe(archive, waiting.waited);
  describe(archive, waiting.looks_at), describe(archive, waiting.opens_at);
  constexpr std::size_t kGapWords = 4;
  archive.size(waiting.closed, kGapWords);
  for (Segment& gap : waiting.closed) describe(archive, gap.a), describe(archive, gap.b);
}

// In one word; more where it ends elsewhere than at the goal, and where passages may be held.
template <bool kReads>
void describe(Archive<kReads>& archive, SavedRoute& route) {
  const bool waits = route.waiting.least < kInfinity || !route.waiting.closed.empty();
  std::uint64_t word =
      (waits ? std::uint64_t{1} << 36 : 0) | static_cast<std::uint64_t>(route.ends) << 34 |
      std::uint64_t{route.around_movers} << 33 | std::uint64_t{route.is_exact} << 32 | route.target;
  archive.word(word);
  const std::uint64_t ends = word >> 34 & 3;
  if (word >> 37 != 0 || ends > static_cast<std::uint64_t>(RouteEnd::short_of))
    refuse_saved("the route " + std::to_string(word), "one of 37 bits, and how it ends");
  route = {static_cast<std::uint32_t>(word), (word >> 32 & 1) != 0, (word >> 33 & 1) != 0,
           static_cast<RouteEnd>(ends),      route.place,           std::move(route.waiting)};
  if (route.ends != RouteEnd::goal) describe(archive, route.place);
  if ((word >> 36 & 1) != 0) describe(archive, route.waiting);
}

template <bool kReads>
void describe(Archive<kReads>& archive, SavedFlight& flight) {
  describe(archive, flight.circle.center), describe(archive, flight.circle.radius);
  describe(archive, flight.has_arrived);
}

template <bool kReads>
void describe(Archive<kReads>& archive, Detour& detour) {
  const auto packed = [](float low, std::uint64_t high) {
    return std::uint64_t{std::bit_cast<std::uint32_t>(low)} | high << 32;
  };
  const auto number = [](std::uint64_t word) {
    return std::bit_cast<float>(static_cast<std::uint32_t>(word));
  };
  std::uint64_t first = packed(detour.angle, std::bit_cast<std::uint32_t>(detour.beside));
  std::uint64_t second =
      packed(detour.congestion, (detour.has_arrived ? 1U : 0U) | (detour.goal_taken ? 2U : 0U));
  std::uint64_t third =
      packed(detour.acceleration_x, std::bit_cast<std::uint32_t>(detour.acceleration_y));
  archive.word(first), archive.word(second), archive.word(third);
  if (second >> 34 != 0) refuse_saved("a detour that no robot can remember", "a sound one");
  detour = {number(first),     number(first >> 32), number(second),     (second >> 32 & 1) != 0,
            second >> 33 != 0, number(third),       number(third >> 32)};
}

// Rare properties of robots, in one word with their values after it.
template <bool kReads>
void describe_kinds(Archive<kReads>& archive, RobotSetup& setup) {
  const auto method = static_cast<std::uint64_t>(setup.method.value_or(Method{}));
  std::uint64_t kinds =
      (is_parked(setup) ? 1U : 0U) | (setup.method ? 2U | method << 8 : 0U) |
      (setup.time_horizon ? 4U : 0U) | (setup.behavior == Behavior::cooperates ? 8U : 0U) |
      (setup.arrival_distance ? 16U : 0U) | (setup.behavior == Behavior::moves_on ? 32U : 0U) |
      late_kinds(setup, kLateFields);
  archive.word(kinds);
  const std::uint64_t late = kinds & kLateKinds;
  if constexpr (kReads) {
    kinds &= ~kLateKinds;
    const bool has_method = (kinds & 2) != 0;
    const bool is_more_than_parked = (kinds & 1) != 0 && kinds != 1;
    if ((kinds & 0xc0) != 0 || (kinds & 40) == 40 || (!has_method && kinds >> 8 != 0) ||
        is_more_than_parked || kinds >> 8 >= kNames<Method>.size())
      refuse_saved("the kinds of a robot " + std::to_string(kinds), "known ones");
    if ((kinds & 1) != 0) setup.behavior = Behavior::parked;
    if ((kinds & 8) != 0) setup.behavior = Behavior::cooperates;
    if ((kinds & 32) != 0) setup.behavior = Behavior::moves_on;
    if (has_method) setup.method = static_cast<Method>(kinds >> 8);
    if ((kinds & 4) != 0) setup.time_horizon.emplace();
    if ((kinds & 16) != 0) setup.arrival_distance.emplace();
  }
  if (setup.time_horizon) describe(archive, *setup.time_horizon);
  if (setup.arrival_distance) describe(archive, *setup.arrival_distance);
  describe_late(archive, setup, late, kLateFields);
}

template <bool kReads>
void describe(Archive<kReads>& archive, RobotSetup& setup, SavedRobot& state) {
  describe(archive, setup.goal), describe(archive, setup.radius);
  describe(archive, setup.max_speed), describe(archive, setup.max_acceleration);
  double max_braking = setup.max_braking.value_or(0.0);  // 0: unset
  describe(archive, max_braking);
  if (max_braking != 0.0) setup.max_braking = max_braking;
  describe(archive, setup.preferred_speed), describe(archive, setup.priority);
  describe_kinds(archive, setup);
  std::uint64_t layers = std::uint64_t{setup.layers.bits} << 32 | setup.avoids.bits;
  archive.word(layers);
  setup.layers.bits = static_cast<std::uint32_t>(layers >> 32);
  setup.avoids.bits = static_cast<std::uint32_t>(layers);
  if (kReads && is_parked(setup)) setup.position = setup.goal;
  describe(archive, setup.model);

  describe(archive, state.id.value), describe(archive, state.position);
  describe(archive, state.velocity), describe(archive, state.heading);
  describe(archive, state.detour);
}

}  // namespace avo::inline sim
