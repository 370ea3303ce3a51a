// SPDX-License-Identifier: Apache-2.0
// What senses remember of the robots' past, and how much of it they need.
#include <algorithm>
#include <bit>
#include <utility>

#include "core/hash.h"
#include "sim/sensing/senses.h"

namespace avo::inline sim {

bool senses_by_time(const Scenario& scenario) {
  return scenario.clock == Clock::free && (scenario.sensing.delay > 0 || scenario.sensing.misses());
}

std::size_t generations_needed(const Scenario& scenario) {
  const SensingModel& model = scenario.sensing;
  if (model.is_exact()) return 0;
  if (senses_by_time(scenario)) return 1;
  return 1 + static_cast<std::size_t>(model.delay) + (model.misses() ? kMostCarried : 0);
}

double time_remembered(const Scenario& scenario, double longest_step) {
  const SensingModel& model = scenario.sensing;
  return model.delay * scenario.time_step + (model.misses() ? kMostCarried * longest_step : 0.0);
}

std::size_t knots_needed(const Scenario& scenario, double longest_step, const RobotSetup& robot) {
  constexpr std::size_t kEnds = 4;  // of the steps in which the remembered time begins and ends
  if (!senses_by_time(scenario)) return 0;
  if (is_parked(robot)) return kEnds;
  const double steps = time_remembered(scenario, longest_step) / time_step_of(scenario, robot);
  return kEnds + static_cast<std::size_t>(steps);
}

double time_unseen(const Scenario& scenario, double longest_step) {
  const SensingModel& model = scenario.sensing;
  const int missed = model.dropped > 0.0 ? kMostCarried : 0;
  if (scenario.clock == Clock::common) return (model.delay + missed) * scenario.time_step;
  return model.delay * scenario.time_step + missed * longest_step;
}

void Track::add(const Knot& knot) {
  if (count == ring.size()) first = (first + 1) % ring.size(), --count;
  ring[(first + count++) % ring.size()] = knot;
}

Senses senses_of(const Scenario& scenario) {
  Senses senses;
  senses.depth = generations_needed(scenario);
  senses.by_time = senses_by_time(scenario);
  return senses;
}

void Senses::reserve_one(std::size_t knots) {
  if (since.size() == since.capacity()) since.reserve(2 * since.size() + 8);
  if (past.capacity() < past.size() + depth) past.reserve(2 * past.size() + 8 * depth);
  if (!by_time) return;
  if (tracks.size() == tracks.capacity()) tracks.reserve(2 * tracks.size() + 8);
  spare_ = {};
  spare_.ring.resize(knots);
}

void Senses::add(std::int64_t now) {
  if (are_exact()) return;
  since.push_back(now);
  past.resize(past.size() + depth);
  if (by_time) tracks.push_back(std::move(spare_));
}

void Senses::remove(std::size_t rank) {
  if (are_exact()) return;
  const auto first = past.begin() + static_cast<std::ptrdiff_t>(rank * depth);
  past.erase(first, first + static_cast<std::ptrdiff_t>(depth));
  since.erase(since.begin() + static_cast<std::ptrdiff_t>(rank));
  if (by_time) tracks.erase(tracks.begin() + static_cast<std::ptrdiff_t>(rank));
}

void Senses::renew(std::size_t rank, std::int64_t now) {
  if (are_exact()) return;
  const auto first = past.begin() + static_cast<std::ptrdiff_t>(rank * depth);
  std::fill(first, first + static_cast<std::ptrdiff_t>(depth), PastState{});
  since[rank] = now;
  if (by_time) tracks[rank].count = 0;
}

PastState body_of(const Fleet& fleet, std::size_t slot) {
  const std::vector<Base>& bodies = fleet.bases.all;
  const auto rank = static_cast<std::size_t>(fleet.rank[slot]);
  // a robot that has just come is at its reference, and gets its body last
  if (rank >= bodies.size()) return {fleet.position[slot], fleet.velocity[slot]};
  return {bodies[rank].position, bodies[rank].velocity};
}

void Senses::note(const Fleet& fleet, std::int64_t generation) {
  if (are_exact()) return;
  const std::size_t place = static_cast<std::size_t>(generation) % depth;
  for (std::size_t rank = 0; rank < fleet.size(); ++rank) {
    const std::uint32_t slot = fleet.slot_of[rank];
    past[rank * depth + place] = body_of(fleet, slot);
  }
  // each of its steps begins where the one before ended
  for (std::size_t rank = 0; rank < tracks.size(); ++rank) {
    const OwnClock& clock = fleet.clock[rank];
    Track& track = tracks[rank];
    if (track.count == 0) track.add({clock.begin, clock.from});
    if (track.count == 1 || track.last().at != clock.end) track.add({clock.end, clock.to});
  }
}

std::uint64_t hash_of(const Senses& senses, std::uint64_t hash) {
  for (const std::int64_t generation : senses.since)
    hash = mixed(hash, static_cast<std::uint64_t>(generation));
  for (const auto& [position, velocity] : senses.past) {
    for (const double number : {position.x, position.y, velocity.x, velocity.y})
      hash = mixed(hash, std::bit_cast<std::uint64_t>(number));
  }
  for (const Track& track : senses.tracks) {
    for (std::size_t k = 0; k < track.count; ++k) {
      const auto& [position, velocity, heading, circle] = track[k].state;
      hash = mixed(hash, static_cast<std::uint64_t>(track[k].at));
      for (const double number : {position.x, position.y, velocity.x, velocity.y, heading})
        hash = mixed(hash, std::bit_cast<std::uint64_t>(number));
    }
  }
  return hash;
}

}  // namespace avo::inline sim
