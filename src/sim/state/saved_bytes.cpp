// SPDX-License-Identifier: Apache-2.0
// A saved state as the words of an archive. They are a mark, the number of bytes, the version of
// the library, the settings, obstacles and robots. At the end there is a checksum of all the words
// before it.
#include <algorithm>
#include <string>
#include <string_view>
#include <utility>

#include "avo/version.h"
#include "core/hash.h"
#include "core/ranges.h"
#include "core/removed.h"
#include "sim/state/archive.h"
#include "sim/state/saved_bases.h"
#include "sim/state/saved_robots.h"
#include "sim/state/saved_state.h"
#include "sim/state/saved_teams.h"

namespace avo::inline sim {
namespace {

constexpr std::uint64_t kMark = 0x65766173206f7661;         // "avo save"
constexpr std::uint64_t kChangedMark = 0x32766173206f7661;  // "avo sav2": with what hosts change
constexpr std::uint64_t kTeamsMark = 0x33766173206f7661;    // "avo sav3": also with teams and names
constexpr std::uint64_t kBasesMark = 0x34766173206f7661;    // "avo sav4": also with bodies
constexpr std::uint64_t kMovedMark = 0x35766173206f7661;    // "avo sav5": also who is moved
constexpr std::size_t kFewestWords = 3;                     // mark, number of bytes, checksum
constexpr std::size_t kObstacleWords = 17, kRobotWords = 19;  // at least
constexpr std::size_t kPastWords = 4, kClockWords = 15, kKnotWords = 6;
constexpr std::size_t kStaticWords = 4, kChainWords = 2;  // at least
constexpr std::size_t kToldWords = 3, kHostMotionWords = 5;

std::uint64_t checksum(std::span<const std::byte> bytes) {
  std::uint64_t hash = 0;
  for (std::size_t k = 0; k < bytes.size() / kWord; ++k) hash = mixed(hash, word_at(bytes, k));
  return hash;
}

template <bool kReads>
void describe(Archive<kReads>& archive, SensingModel& model) {
  MeasurementNoise& noise = model.noise;
  describe(archive, noise.position), describe(archive, noise.velocity);
  describe(archive, noise.distribution), describe(archive, noise.truncated);
  describe(archive, model.delay), describe(archive, model.dropped);
  // one word for both: without localization the format is the older one
  const LocalizationNoise exact;
  std::uint64_t kinds = (model.occlusion ? 1U : 0U) | (model.localization == exact ? 0U : 2U);
  archive.word(kinds);
  if (kinds > 3) refuse_saved("the kinds of sensing " + std::to_string(kinds), "0 to 3");
  model.occlusion = (kinds & 1) != 0;
  if ((kinds & 2) == 0) return;
  LocalizationNoise& own = model.localization;
  describe(archive, own.position), describe(archive, own.distribution);
  describe(archive, own.truncated);
}

template <bool kReads>
void describe(Archive<kReads>& archive, Knot& knot) {
  describe(archive, knot.at), describe(archive, knot.state.position);
  describe(archive, knot.state.velocity), describe(archive, knot.state.heading);
}

template <bool kReads>
void describe(Archive<kReads>& archive, PastState& state) {
  describe(archive, state.position), describe(archive, state.velocity);
}

template <bool kReads>
void describe(Archive<kReads>& archive, SavedClock& clock, RobotSetup& setup) {
  describe(archive, clock.begin), describe(archive, clock.end);
  for (MotionState* state : {&clock.from, &clock.to}) {
    describe(archive, state->position), describe(archive, state->velocity);
    describe(archive, state->heading);
  }
  describe(archive, clock.has_decided);
  describe(archive, setup.time_step);
}

template <bool kReads>
void describe(Archive<kReads>& archive, MovingObstacle& setup, PathWalk& state) {
  for_each_mover_value([&](const char*, auto member) { describe(archive, setup.*member); });
  describe(archive, state.position), describe(archive, state.velocity);
  describe(archive, state.next_point);
}

template <bool kReads>
void describe(Archive<kReads>& archive, StaticObstacle& obstacle, ObstacleId& id) {
  describe(archive, id.value);
  describe(archive, obstacle.radius);
  // one word for both: without layers the format is the older one
  constexpr std::uint64_t kHasLayers = 256;
  std::uint64_t kinds =
      static_cast<std::uint64_t>(obstacle.fill) | (obstacle.layers == kAllLayers ? 0 : kHasLayers);
  archive.word(kinds);
  if ((kinds & ~kHasLayers) > static_cast<std::uint64_t>(Fill::bounds))
    refuse_saved("an unknown fill", "a known one");
  obstacle.fill = static_cast<Fill>(kinds & ~kHasLayers);
  if ((kinds & kHasLayers) != 0) describe(archive, obstacle.layers.bits);
  archive.size(obstacle.chains, kChainWords);
  for (Chain& chain : obstacle.chains) {
    describe(archive, chain.closed);
    describe(archive, chain.points);
  }
}

// A word of the format that earlier builds have used: 0 where half-planes were exact.
template <bool kReads>
void describe_removed_samples(Archive<kReads>& archive) {
  std::uint64_t samples = 0;
  archive.word(samples);
  if (samples != 0)
    refuse("saved state: samples", std::to_string(samples),
           allowed_instead(*removed_key("samples")));
}

template <bool kReads>
void describe(Archive<kReads>& archive, SavedState& state) {
  std::string version = kVersion;
  describe(archive, version);
  if (version != kVersion) {
    const bool is_plain = version.find_first_not_of("0123456789.") == std::string::npos;
    refuse_saved("one of " + (is_plain ? "avo " + version : "another program"),
                 std::string("one of avo ") + kVersion);
  }
  Scenario& scene = state.scene;
  for_each_setting([&](std::string_view key, auto member) {
    describe(archive, scene.*member);
    if (key == "motion") describe_removed_samples(archive);
  });
  describe(archive, scene.allow_broken_assumptions);
  archive.size(scene.obstacles, kStaticWords);
  state.static_ids.resize(scene.obstacles.size());
  for (std::size_t k = 0; k < scene.obstacles.size(); ++k) {
    describe(archive, scene.obstacles[k], state.static_ids[k]);
  }
  describe(archive, state.sensing_radius);
  archive.size(state.stood, 1);
  for (std::uint64_t& id : state.stood) describe(archive, id);
  describe(archive, state.next_obstacle);
  archive.size(state.routes, 1);
  for (SavedRoute& route : state.routes) describe(archive, route);
  describe(archive, state.steps), describe(archive, state.next_id);

  archive.size(scene.moving_obstacles, kObstacleWords);
  state.movers.resize(scene.moving_obstacles.size());
  for (std::size_t k = 0; k < state.movers.size(); ++k) {
    describe(archive, scene.moving_obstacles[k], state.movers[k]);
  }
  archive.size(scene.robots, kRobotWords);
  state.robots.resize(scene.robots.size());
  for (std::size_t k = 0; k < state.robots.size(); ++k) {
    describe(archive, scene.robots[k], state.robots[k]);
  }
  if (has_external(scene)) describe(archive, scene.external_method);
  if (kReads)
    state.flights.resize(static_cast<std::size_t>(
        std::count_if(scene.robots.begin(), scene.robots.end(),
                      [](const RobotSetup& robot) { return !can_rest(robot.model); })));
  for (SavedFlight& flight : state.flights) describe(archive, flight);
  if (scene.clock == Clock::free) {
    describe(archive, state.now);
    archive.size(state.clocks, kClockWords);
    if (state.clocks.size() != scene.robots.size())
      refuse_saved(std::to_string(state.clocks.size()) + " clocks",
                   std::to_string(scene.robots.size()));
    for (std::size_t k = 0; k < state.clocks.size(); ++k)
      describe(archive, state.clocks[k], scene.robots[k]);
  }
  const bool by_time = senses_by_time(scene);
  if (generations_needed(scene) < 2 && !by_time) return;  // they remember nothing
  archive.size(state.since, 1);
  for (std::int64_t& generation : state.since) describe(archive, generation);
  if (by_time) {
    archive.size(state.tracks, 1);
    for (std::vector<Knot>& track : state.tracks) {
      archive.size(track, kKnotWords);
      for (Knot& knot : track) describe(archive, knot);
    }
    return;
  }
  archive.size(state.past, kPastWords);
  for (PastState& past : state.past) describe(archive, past);
}

// Moving obstacles that came or went, and preferred velocities that the host gave. Only a state
// that has some has this part, so that the others have the bytes of earlier builds.
bool is_changed(const SavedState& state) {
  bool all = state.told.empty() && state.next_mover == state.mover_ids.size();
  for (std::size_t k = 0; k < state.mover_ids.size(); ++k)
    all = all && state.mover_ids[k].value == k;
  return !all;
}

template <bool kReads>
void describe_changes(Archive<kReads>& archive, SavedState& state) {
  for (MovingObstacleId& id : state.mover_ids) describe(archive, id.value);
  describe(archive, state.next_mover);
  archive.size(state.told, kToldWords);
  for (SavedTold& told : state.told) {
    describe(archive, told.robot);
    describe(archive, told.velocity);
  }
}

// Only a scene that has one of these has this part. A method's name is here where no robot has the
// method at present.
bool has_teams_or_name(const Scenario& scene) {
  return !scene.teams.empty() || (!has_external(scene) && !scene.external_method.empty());
}

template <bool kReads>
void describe_more(Archive<kReads>& archive, Scenario& scene) {
  describe_teams(archive, scene.teams);
  if (!has_external(scene)) describe(archive, scene.external_method);
}

template <bool kReads>
void describe_host_motions(Archive<kReads>& archive, SavedState& state) {
  archive.size(state.host_motions, kHostMotionWords);
  for (auto& [robot, motion] : state.host_motions) {
    describe(archive, robot), describe(archive, motion.velocity);
    describe(archive, motion.avoids.bits), describe(archive, motion.ends);
  }
}

}  // namespace

std::vector<std::byte> to_bytes(SavedState state) {
  constexpr std::size_t kSettings = 64;  // words, about
  Archive<false> archive;
  std::vector<std::byte>& bytes = archive.written;
  bytes.reserve(kWord * (kSettings + kRobotWords * state.robots.size() +
                         kObstacleWords * state.movers.size()));
  const bool has_bases = !state.bases.are_exact(), is_moved = !state.host_motions.empty();
  const bool has_more = has_bases || is_moved || has_teams_or_name(state.scene);
  const bool changed = has_more || is_changed(state);
  std::uint64_t mark = has_bases  ? kBasesMark
                       : is_moved ? kMovedMark
                       : has_more ? kTeamsMark
                       : changed  ? kChangedMark
                                  : kMark;
  std::uint64_t size = 0;
  archive.word(mark), archive.word(size);
  describe(archive, state);
  if (changed) describe_changes(archive, state);
  if (has_more) describe_more(archive, state.scene);
  if (has_bases) describe_bases(archive, state);
  if (is_moved) describe_host_motions(archive, state);
  put_word(bytes.size() + kWord, &bytes[kWord]);
  std::uint64_t sum = checksum(bytes);
  archive.word(sum);
  return std::move(bytes);
}

SavedState from_bytes(std::span<const std::byte> bytes) {
  if (bytes.size() < kFewestWords * kWord) {
    refuse_saved(std::to_string(bytes.size()) + " bytes", "whole");
  }
  const bool has_bases = word_at(bytes, 0) == kBasesMark;
  const bool is_moved = word_at(bytes, 0) == kMovedMark;
  const bool has_more = has_bases || is_moved || word_at(bytes, 0) == kTeamsMark;
  const bool changed = has_more || word_at(bytes, 0) == kChangedMark;
  if (word_at(bytes, 0) != kMark && !changed)
    refuse_saved("something else", "bytes of Simulation::save()");
  if (word_at(bytes, 1) != bytes.size() || bytes.size() % kWord != 0) {
    refuse_saved(std::to_string(bytes.size()) + " bytes",
                 "the " + std::to_string(word_at(bytes, 1)) + " that were saved");
  }
  const std::span<const std::byte> checked = bytes.first(bytes.size() - kWord);
  if (checksum(checked) != word_at(bytes, bytes.size() / kWord - 1)) {
    refuse_saved("bytes that have changed", "those that were saved");
  }
  Archive<true> archive{{}, checked.subspan(2 * kWord)};
  SavedState state;
  describe(archive, state);
  state.mover_ids.resize(state.scene.moving_obstacles.size());
  for (std::size_t k = 0; k < state.mover_ids.size(); ++k) state.mover_ids[k] = {k};
  state.next_mover = state.mover_ids.size();
  if (changed) describe_changes(archive, state);
  if (has_more) describe_more(archive, state.scene);
  if (has_bases) describe_bases(archive, state);
  if (is_moved) describe_host_motions(archive, state);
  if (!archive.unread.empty()) {
    refuse_saved(std::to_string(archive.unread.size()) + " more bytes", "no more");
  }
  check_saved(state);
  return state;
}

}  // namespace avo::inline sim
