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

#include "avo/error.h"
#include "avo/version.h"
#include "core/hash.h"
#include "core/ranges.h"
#include "planner/arrival.h"
#include "sim/saved_settings.h"
#include "sim/saved_state.h"

namespace avo {
namespace {

constexpr std::size_t kWord = 8;                     // bytes
constexpr std::uint64_t kMark = 0x65766173206f7661;  // "avo save"
constexpr std::size_t kFewestWords = 3;              // mark, number of bytes, checksum
constexpr std::size_t kObstacleWords = 11, kRobotWords = 15;
constexpr std::int64_t kLastStep = std::int64_t{1} << 53;  // time() tells no later ones apart

[[noreturn]] void refuse(const std::string& given, const std::string& allowed) {
  throw Error("saved state: found " + given + ", must be " + allowed);
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

class Writer {
 public:
  explicit Writer(std::size_t words) { bytes_.reserve(words * kWord); }

  template <typename Value>
  void number(Value value) {
    if constexpr (std::is_floating_point_v<Value>) {
      put(std::bit_cast<std::uint64_t>(value));
    } else {
      put(static_cast<std::uint64_t>(value));
    }
  }
  void text(const std::string& letters) {
    number(letters.size());
    const std::size_t end = bytes_.size();
    bytes_.resize(end + (letters.size() + kWord - 1) / kWord * kWord);
    std::transform(letters.begin(), letters.end(),
                   bytes_.begin() + static_cast<std::ptrdiff_t>(end),
                   [](char letter) { return static_cast<std::byte>(letter); });
  }
  template <typename Entry>
  void size(const std::vector<Entry>& list, std::size_t) {
    number(list.size());
  }
  std::vector<std::byte> finish() {
    put_word(bytes_.size() + kWord, &bytes_[kWord]);
    put(checksum(bytes_));
    return std::move(bytes_);
  }

 private:
  void put(std::uint64_t word) {
    bytes_.resize(bytes_.size() + kWord);
    put_word(word, &bytes_[bytes_.size() - kWord]);
  }
  std::vector<std::byte> bytes_;
};

class Reader {
 public:
  explicit Reader(std::span<const std::byte> words) : left_(words) {}

  template <typename Value>
  void number(Value& value) {
    const std::uint64_t word = next();
    if constexpr (std::is_floating_point_v<Value>) {
      value = std::bit_cast<double>(word);
    } else {
      value = static_cast<Value>(word);
      if (static_cast<std::uint64_t>(value) != word) {
        refuse("the number " + std::to_string(word), "one that its type has");
      }
    }
  }
  void text(std::string& letters) {
    const std::uint64_t count = next();
    if (count > left_.size()) refuse("a text of " + std::to_string(count) + " bytes", "shorter");
    const auto size = static_cast<std::size_t>(count);
    letters.resize(size);
    std::transform(left_.begin(), left_.begin() + static_cast<std::ptrdiff_t>(size),
                   letters.begin(), [](std::byte letter) { return static_cast<char>(letter); });
    left_ = left_.subspan((size + kWord - 1) / kWord * kWord);
  }
  /// Makes room for as many entries as there are, of so many words each.
  template <typename Entry>
  void size(std::vector<Entry>& list, std::size_t words) {
    const std::uint64_t count = next(), most = left_.size() / (words * kWord);
    if (count > most) refuse(std::to_string(count) + " entries", "at most " + std::to_string(most));
    list.resize(static_cast<std::size_t>(count));
  }
  void finish() const {
    if (!left_.empty()) refuse(std::to_string(left_.size()) + " more bytes", "no more");
  }

 private:
  std::uint64_t next() {
    if (left_.empty()) refuse("an end", "more");
    const std::uint64_t word = word_at(left_, 0);
    left_ = left_.subspan(kWord);
    return word;
  }
  std::span<const std::byte> left_;
};

template <typename Archive, typename Number>
requires std::is_arithmetic_v<Number>
void describe(Archive& archive, Number& value) {
  archive.number(value);
}

constexpr Method last(Method) {
  return Method::orca;
}
constexpr Certificate last(Certificate) {
  return Certificate::braking_trajectories;
}
constexpr Motion last(Motion) {
  return Motion::exponential;
}

template <typename Archive, typename Choice>
requires std::is_enum_v<Choice>
void describe(Archive& archive, Choice& choice) {
  archive.number(choice);
  if (choice > last(choice)) refuse("an unknown choice", "a known one");
}

template <typename Archive>
void describe(Archive& archive, std::string& text) {
  archive.text(text);
}

template <typename Archive>
void describe(Archive& archive, Vec2& value) {
  archive.number(value.x), archive.number(value.y);
}

template <typename Archive, typename Value>
void describe(Archive& archive, std::optional<Value>& optional) {
  bool is_set = optional.has_value();
  Value value = optional.value_or(Value{});
  archive.number(is_set);
  describe(archive, value);
  if (is_set) optional = value;
}

template <typename Archive>
void describe(Archive& archive, MovingObstacle& setup, ObstacleState& state) {
  for_each_obstacle_value([&](const char*, auto member) { describe(archive, setup.*member); });
  describe(archive, state.position), describe(archive, state.velocity);
}

template <typename Archive>
void describe(Archive& archive, RobotSetup& setup, RobotState& state) {
  describe(archive, setup.goal), describe(archive, setup.radius);
  describe(archive, setup.max_speed), describe(archive, setup.max_acceleration);
  describe(archive, setup.preferred_speed);
  double wheelbase = setup.car ? setup.car->wheelbase : 0.0;  // 0: not a car
  describe(archive, wheelbase);
  if (wheelbase != 0.0) setup.car = CarSetup{wheelbase, 0.0};

  describe(archive, state.id.value), describe(archive, state.position);
  describe(archive, state.velocity), describe(archive, state.heading);
  describe(archive, state.detour.angle), describe(archive, state.detour.yielded);
}

template <typename Archive>
void describe(Archive& archive, SavedState& state) {
  std::string version = kVersion;
  describe(archive, version);
  if (version != kVersion) {
    const bool is_plain = version.find_first_not_of("0123456789.") == std::string::npos;
    refuse("one of " + (is_plain ? "avo " + version : "another program"),
           std::string("one of avo ") + kVersion);
  }
  Scenario& scene = state.scene;
  for_each_setting([&](const char*, auto member) { describe(archive, scene.*member); });
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

// Refuses what no simulation comes to: only forged bytes have it.
void check_states(const SavedState& state) {
  const auto is_finite_motion = [](const auto& body) {
    return is_finite(body.position) && is_finite(body.velocity);
  };
  const bool moves = std::all_of(state.robots.begin(), state.robots.end(), is_finite_motion) &&
                     std::all_of(state.obstacles.begin(), state.obstacles.end(), is_finite_motion);
  if (!moves) refuse("a position or velocity that is not finite", "finite");
  std::uint64_t next = 0;  // id, at least
  for (const RobotState& robot : state.robots) {
    if (!kAnyValue.contains(robot.heading))
      refuse("heading " + text(robot.heading), "an angle in rad");
    if (!is_sound(robot.detour)) refuse("a detour that no robot can remember", "a sound one");
    if (robot.id.value < next || robot.id.value >= state.next_id) {
      refuse("id " + std::to_string(robot.id.value),
             "ascending and below the next, " + std::to_string(state.next_id));
    }
    next = robot.id.value + 1;
  }
  if (state.steps < 0 || state.steps > kLastStep) {
    refuse(std::to_string(state.steps) + " steps", "0 to " + std::to_string(kLastStep));
  }
}

}  // namespace

std::vector<std::byte> to_bytes(SavedState state) {
  constexpr std::size_t kSettings = 64;  // words, about
  Writer writer(kSettings + kRobotWords * state.robots.size() +
                kObstacleWords * state.obstacles.size());
  writer.number(kMark), writer.number(std::uint64_t{0});
  describe(writer, state);
  return writer.finish();
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
  Reader reader(checked.subspan(2 * kWord));
  SavedState state;
  describe(reader, state);
  reader.finish();
  check_setups(state.scene);
  check_states(state);
  return state;
}

}  // namespace avo
