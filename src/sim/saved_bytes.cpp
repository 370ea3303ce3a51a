// SPDX-License-Identifier: Apache-2.0
// A saved state as bytes: 64-bit words, the lowest byte first on every machine. They are a mark,
// the number of bytes, the version of the library, the settings, obstacles, robots, and at the end
// a checksum of all the words before it. One text, describe(), serves writing and reading.
#include <algorithm>
#include <bit>
#include <cmath>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>

#include "avo/version.h"
#include "core/hash.h"
#include "core/ranges.h"
#include "planner/arrival.h"
#include "planner/options.h"
#include "sim/saved_state.h"

namespace avo {
namespace {

constexpr std::size_t kWord = 8;                     // bytes
constexpr std::uint64_t kMark = 0x65766173206f7661;  // "avo save"
constexpr std::size_t kFewestWords = 3;              // mark, number of bytes, checksum
constexpr std::size_t kObstacleWords = 11, kRobotWords = 20;
constexpr std::size_t kPastWords = 4;
constexpr std::size_t kStaticWords = 4, kChainWords = 2, kPointWords = 2;  // at least
constexpr std::int64_t kLastStep = std::int64_t{1} << 53;  // time() tells no later ones apart

[[noreturn]] void refuse(const std::string& given, const std::string& allowed) {
  avo::refuse("saved state", given, allowed);
}

std::uint64_t word_at(std::span<const std::byte> bytes, std::size_t index) {
  std::uint64_t word = 0;
  for (std::size_t k = 0; k < kWord; ++k) {
    word |= std::to_integer<std::uint64_t>(bytes[index * kWord + k]) << (8 * k);
  }
  return word;
}

void put_word(std::uint64_t word, std::byte* to) {
  for (std::size_t k = 0; k < kWord; ++k) to[k] = static_cast<std::byte>(word >> (8 * k) & 0xff);
}

std::uint64_t checksum(std::span<const std::byte> bytes) {
  std::uint64_t hash = 0;
  for (std::size_t k = 0; k < bytes.size() / kWord; ++k) hash = mixed(hash, word_at(bytes, k));
  return hash;
}

// Writes values behind `written`, or takes them off the front of `unread`.
template <bool kReads>
struct Archive {
  std::vector<std::byte> written = {};
  std::span<const std::byte> unread = {};

  void word(std::uint64_t& value) {
    if constexpr (kReads) {
      if (unread.empty()) refuse("the end of the bytes", "more of them");
      value = word_at(unread, 0);
      unread = unread.subspan(kWord);
    } else {
      written.resize(written.size() + kWord);
      put_word(value, &written[written.size() - kWord]);
    }
  }
  /// Makes room for as many entries as there are, of so many words each.
  template <typename Entry>
  void size(std::vector<Entry>& list, std::size_t words) {
    std::uint64_t count = list.size();
    word(count);
    const std::uint64_t most = unread.size() / (words * kWord);
    if (kReads && count > most)
      refuse(std::to_string(count) + " entries", "at most " + std::to_string(most));
    list.resize(static_cast<std::size_t>(count));
  }
};

template <bool kReads, typename Value>
requires std::is_arithmetic_v<Value>
void describe(Archive<kReads>& archive, Value& value) {
  if constexpr (std::is_floating_point_v<Value>) {
    auto word = std::bit_cast<std::uint64_t>(value);
    archive.word(word);
    value = std::bit_cast<Value>(word);
  } else {
    auto word = static_cast<std::uint64_t>(value);
    archive.word(word);
    value = static_cast<Value>(word);
    if (static_cast<std::uint64_t>(value) != word)
      refuse("the number " + std::to_string(word), "one that its type has");
  }
}

template <bool kReads, typename Choice>
requires std::is_enum_v<Choice>
void describe(Archive<kReads>& archive, Choice& choice) {
  auto number = static_cast<std::underlying_type_t<Choice>>(choice);
  describe(archive, number);
  if (number >= kNames<Choice>.size()) refuse("an unknown choice", "a known one");
  choice = static_cast<Choice>(number);
}

// Eight letters a word.
template <bool kReads>
void describe(Archive<kReads>& archive, std::string& text) {
  std::uint64_t count = text.size();
  archive.word(count);
  if (kReads && count > archive.unread.size())
    refuse("a text of " + std::to_string(count) + " bytes", "shorter");
  text.resize(static_cast<std::size_t>(count));
  for (std::size_t first = 0; first < text.size(); first += kWord) {
    const std::span<char> letters =
        std::span(text).subspan(first, std::min(kWord, text.size() - first));
    std::uint64_t word = 0;
    for (std::size_t k = 0; k < letters.size(); ++k)
      word |= std::uint64_t{static_cast<unsigned char>(letters[k])} << (8 * k);
    archive.word(word);
    for (std::size_t k = 0; k < letters.size(); ++k)
      letters[k] = static_cast<char>(word >> (8 * k) & 0xff);
  }
}

template <bool kReads>
void describe(Archive<kReads>& archive, Vec2& value) {
  describe(archive, value.x), describe(archive, value.y);
}

template <bool kReads, typename Value>
void describe(Archive<kReads>& archive, std::optional<Value>& optional) {
  bool is_set = optional.has_value();
  Value value = optional.value_or(Value{});
  describe(archive, is_set);
  describe(archive, value);
  if constexpr (kReads) optional = is_set ? std::optional(value) : std::nullopt;
}

template <bool kReads>
void describe(Archive<kReads>& archive, SensingError& error) {
  describe(archive, error.position), describe(archive, error.velocity);
}

template <bool kReads>
void describe(Archive<kReads>& archive, SensingModel& model) {
  MeasurementNoise& noise = model.noise;
  describe(archive, noise.position), describe(archive, noise.velocity);
  describe(archive, noise.distribution), describe(archive, noise.truncated);
  describe(archive, model.delay), describe(archive, model.dropped);
  describe(archive, model.occlusion);
}

template <bool kReads>
void describe(Archive<kReads>& archive, PastState& state) {
  describe(archive, state.position), describe(archive, state.velocity);
}

template <bool kReads>
void describe(Archive<kReads>& archive, MovingObstacle& setup, ObstacleState& state) {
  for_each_obstacle_value([&](const char*, auto member) { describe(archive, setup.*member); });
  describe(archive, state.position), describe(archive, state.velocity);
}

template <bool kReads>
void describe(Archive<kReads>& archive, StaticObstacle& obstacle, ObstacleId& id) {
  describe(archive, id.value);
  auto fill = static_cast<std::uint8_t>(obstacle.fill);
  describe(archive, obstacle.radius), describe(archive, fill);
  if (fill > static_cast<std::uint8_t>(Fill::bounds)) refuse("an unknown fill", "a known one");
  obstacle.fill = static_cast<Fill>(fill);
  archive.size(obstacle.chains, kChainWords);
  for (Chain& chain : obstacle.chains) {
    describe(archive, chain.closed);
    archive.size(chain.points, kPointWords);
    for (Vec2& point : chain.points) describe(archive, point);
  }
}

// In one word.
template <bool kReads>
void describe(Archive<kReads>& archive, SavedWay& way) {
  std::uint64_t word = std::uint64_t{way.is_exact} << 32 | way.target;
  archive.word(word);
  if (word >> 33 != 0) refuse("the way " + std::to_string(word), "one of 33 bits");
  way = {static_cast<std::uint32_t>(word), word >> 32 != 0};
}

template <bool kReads>
void describe(Archive<kReads>& archive, RobotSetup& setup, RobotState& state) {
  describe(archive, setup.goal), describe(archive, setup.radius);
  describe(archive, setup.max_speed), describe(archive, setup.max_acceleration);
  describe(archive, setup.preferred_speed), describe(archive, setup.priority);
  describe(archive, setup.parked);
  std::uint64_t layers = std::uint64_t{setup.layers.bits} << 32 | setup.avoids.bits;
  archive.word(layers);
  setup.layers.bits = static_cast<std::uint32_t>(layers >> 32);
  setup.avoids.bits = static_cast<std::uint32_t>(layers);
  if (kReads && setup.parked) setup.position = setup.goal;
  double wheelbase = setup.car ? setup.car->wheelbase : 0.0;  // 0: not a car
  describe(archive, wheelbase);
  if (wheelbase != 0.0) setup.car = CarSetup{wheelbase, 0.0};

  describe(archive, state.id.value), describe(archive, state.position);
  describe(archive, state.velocity), describe(archive, state.heading);
  describe(archive, state.detour.angle), describe(archive, state.detour.yielded);
  describe(archive, state.seen_acceleration);
}

template <bool kReads>
void describe(Archive<kReads>& archive, SavedState& state) {
  std::string version = kVersion;
  describe(archive, version);
  if (version != kVersion) {
    const bool is_plain = version.find_first_not_of("0123456789.") == std::string::npos;
    refuse("one of " + (is_plain ? "avo " + version : "another program"),
           std::string("one of avo ") + kVersion);
  }
  Scenario& scene = state.scene;
  for_each_setting([&](const char*, auto member) { describe(archive, scene.*member); });
  archive.size(scene.obstacles, kStaticWords);
  state.static_ids.resize(scene.obstacles.size());
  for (std::size_t k = 0; k < scene.obstacles.size(); ++k) {
    describe(archive, scene.obstacles[k], state.static_ids[k]);
  }
  describe(archive, state.next_obstacle);
  archive.size(state.ways, 1);
  for (SavedWay& way : state.ways) describe(archive, way);
  describe(archive, state.steps), describe(archive, state.next_id);

  archive.size(scene.moving_obstacles, kObstacleWords);
  state.obstacles.resize(scene.moving_obstacles.size());
  for (std::size_t k = 0; k < state.obstacles.size(); ++k) {
    describe(archive, scene.moving_obstacles[k], state.obstacles[k]);
  }
  archive.size(scene.robots, kRobotWords);
  state.robots.resize(scene.robots.size());
  for (std::size_t k = 0; k < state.robots.size(); ++k) {
    describe(archive, scene.robots[k], state.robots[k]);
  }
  if (generations_needed(scene.sensing) < 2) return;  // they remember nothing
  archive.size(state.since, 1);
  for (std::int64_t& generation : state.since) describe(archive, generation);
  archive.size(state.past, kPastWords);
  for (PastState& past : state.past) describe(archive, past);
}

// As many robots at a time as a scene may have: more of them may have been added to a simulation.
void check_setups(const Scenario& scene) {
  Scenario part = scene;
  constexpr auto kMost = static_cast<std::size_t>(kMostRobots);
  for (std::size_t first = 0; first == 0 || first < scene.robots.size(); first += kMost) {
    const std::size_t last = std::min(first + kMost, scene.robots.size());
    const auto begin = scene.robots.begin();
    part.robots.assign(begin + static_cast<std::ptrdiff_t>(first),
                       begin + static_cast<std::ptrdiff_t>(last));
    validate(part);
  }
}

void check_past(const SavedState& state) {
  const std::size_t depth = generations_needed(state.scene.sensing), robots = state.robots.size();
  if (depth < 2) return;
  const bool whole = state.since.size() == robots && state.past.size() == robots * depth;
  const bool dated = std::all_of(state.since.begin(), state.since.end(), [&](std::int64_t since) {
    return since >= 0 && since <= state.steps;
  });
  const bool finite = std::all_of(state.past.begin(), state.past.end(), [](const PastState& past) {
    return is_finite(past.position) && is_finite(past.velocity);
  });
  if (!whole || !dated || !finite) refuse("a past that no robots can have", "theirs");
}

// Refuses what no simulation comes to: only forged bytes have it.
void check_states(const SavedState& state) {
  const auto is_finite_motion = [](const auto& body) {
    return is_finite(body.position) && is_finite(body.velocity);
  };
  const bool moves = std::all_of(state.robots.begin(), state.robots.end(), is_finite_motion) &&
                     std::all_of(state.obstacles.begin(), state.obstacles.end(), is_finite_motion);
  if (!moves) refuse("a position or velocity that is not finite", "finite");
  std::uint64_t next = 0;  // id, at least
  const auto check_id = [&next](std::uint64_t id, std::uint64_t beyond) {
    if (id < next || id >= beyond)
      refuse("id " + std::to_string(id), "ascending and below the next, " + std::to_string(beyond));
    next = id + 1;
  };
  for (const ObstacleId id : state.static_ids) check_id(id.value, state.next_obstacle);
  check_past(state);
  next = 0;
  for (const RobotState& robot : state.robots) {
    if (!kAnyValue.contains(robot.heading))
      refuse("heading " + text(robot.heading), "an angle in rad");
    if (!is_sound(robot.detour)) refuse("a detour that no robot can remember", "a sound one");
    check_id(robot.id.value, state.next_id);
    if (!is_finite(robot.seen_acceleration)) refuse("an acceleration that is not finite", "finite");
  }
  for (std::size_t k = 0; k < state.robots.size(); ++k) {
    const RobotState& robot = state.robots[k];
    if (!state.scene.robots[k].parked) continue;
    if (!(robot.position == state.scene.robots[k].goal && robot.velocity == Vec2{}))
      refuse("a parked robot that has moved", "one at its goal");
  }
  if (state.steps < 0 || state.steps > kLastStep) {
    refuse(std::to_string(state.steps) + " steps", "0 to " + std::to_string(kLastStep));
  }
}

}  // namespace

std::vector<std::byte> to_bytes(SavedState state) {
  constexpr std::size_t kSettings = 64;  // words, about
  Archive<false> archive;
  std::vector<std::byte>& bytes = archive.written;
  bytes.reserve(kWord * (kSettings + kRobotWords * state.robots.size() +
                         kObstacleWords * state.obstacles.size()));
  std::uint64_t mark = kMark, size = 0;
  archive.word(mark), archive.word(size);
  describe(archive, state);
  put_word(bytes.size() + kWord, &bytes[kWord]);
  std::uint64_t sum = checksum(bytes);
  archive.word(sum);
  return std::move(bytes);
}

SavedState from_bytes(std::span<const std::byte> bytes) {
  if (bytes.size() < kFewestWords * kWord) {
    refuse(std::to_string(bytes.size()) + " bytes", "whole");
  }
  if (word_at(bytes, 0) != kMark) refuse("something else", "bytes of Simulation::save()");
  if (word_at(bytes, 1) != bytes.size() || bytes.size() % kWord != 0) {
    refuse(std::to_string(bytes.size()) + " bytes",
           "the " + std::to_string(word_at(bytes, 1)) + " that were saved");
  }
  const std::span<const std::byte> checked = bytes.first(bytes.size() - kWord);
  if (checksum(checked) != word_at(bytes, bytes.size() / kWord - 1)) {
    refuse("bytes that have changed", "those that were saved");
  }
  Archive<true> archive{{}, checked.subspan(2 * kWord)};
  SavedState state;
  describe(archive, state);
  if (!archive.unread.empty()) {
    refuse(std::to_string(archive.unread.size()) + " more bytes", "no more");
  }
  check_setups(state.scene);
  check_states(state);
  return state;
}

}  // namespace avo
