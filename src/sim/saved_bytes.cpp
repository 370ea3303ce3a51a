// SPDX-License-Identifier: Apache-2.0
// A saved state as bytes: 64-bit words, the lowest byte first on every machine. They are a mark,
// the number of bytes, the version of the library, the settings, obstacles, robots, and at the end
// a checksum of all the words before it. One text, describe(), serves writing and reading.
#include <algorithm>
#include <bit>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>

#include "avo/version.h"
#include "core/hash.h"
#include "planner/options.h"
#include "sim/saved_state.h"

namespace avo {
namespace {

constexpr std::size_t kWord = 8;                              // bytes
constexpr std::uint64_t kMark = 0x65766173206f7661;           // "avo save"
constexpr std::size_t kFewestWords = 3;                       // mark, number of bytes, checksum
constexpr std::size_t kObstacleWords = 16, kRobotWords = 19;  // at least
constexpr std::size_t kPastWords = 4, kClockWords = 15;
constexpr std::size_t kStaticWords = 4, kChainWords = 2, kPointWords = 2;  // at least

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
      if (unread.empty()) refuse_saved("the end of the bytes", "more of them");
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
      refuse_saved(std::to_string(count) + " entries", "at most " + std::to_string(most));
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
      refuse_saved("the number " + std::to_string(word), "one that its type has");
  }
}

template <bool kReads, typename Choice>
requires std::is_enum_v<Choice>
void describe(Archive<kReads>& archive, Choice& choice) {
  auto number = static_cast<std::underlying_type_t<Choice>>(choice);
  describe(archive, number);
  if (number >= kNames<Choice>.size()) refuse_saved("an unknown choice", "a known one");
  choice = static_cast<Choice>(number);
}

// Eight letters a word.
template <bool kReads>
void describe(Archive<kReads>& archive, std::string& text) {
  std::uint64_t count = text.size();
  archive.word(count);
  if (kReads && count > archive.unread.size())
    refuse_saved("a text of " + std::to_string(count) + " bytes", "shorter");
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
void describe(Archive<kReads>& archive, std::vector<Vec2>& points) {
  archive.size(points, kPointWords);
  for (Vec2& point : points) describe(archive, point);
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
  for_each_obstacle_value([&](const char*, auto member) { describe(archive, setup.*member); });
  describe(archive, state.position), describe(archive, state.velocity);
  describe(archive, state.target);
}

template <bool kReads>
void describe(Archive<kReads>& archive, StaticObstacle& obstacle, ObstacleId& id) {
  describe(archive, id.value);
  auto fill = static_cast<std::uint8_t>(obstacle.fill);
  describe(archive, obstacle.radius), describe(archive, fill);
  if (fill > static_cast<std::uint8_t>(Fill::bounds))
    refuse_saved("an unknown fill", "a known one");
  obstacle.fill = static_cast<Fill>(fill);
  archive.size(obstacle.chains, kChainWords);
  for (Chain& chain : obstacle.chains) {
    describe(archive, chain.closed);
    describe(archive, chain.points);
  }
}

// In one word.
template <bool kReads>
void describe(Archive<kReads>& archive, SavedWay& way) {
  std::uint64_t word = std::uint64_t{way.is_exact} << 32 | way.target;
  archive.word(word);
  if (word >> 33 != 0) refuse_saved("the way " + std::to_string(word), "one of 33 bits");
  way = {static_cast<std::uint32_t>(word), word >> 32 != 0};
}

template <bool kReads>
void describe(Archive<kReads>&, Holonomic&) {}

template <bool kReads>
void describe(Archive<kReads>& archive, Car& car) {
  bool has_body = car.body.has_value();
  double curvature = car.max_curvature.value_or(0.0);  // 0: unbounded
  auto set = static_cast<std::uint8_t>(car.acceleration_set);
  describe(archive, car.wheelbase), describe(archive, curvature);
  describe(archive, has_body), describe(archive, car.reverse), describe(archive, set);
  if (set > static_cast<std::uint8_t>(AccelerationSet::exact))
    refuse_saved("an unknown set of accelerations", "a known one");
  if (curvature != 0.0) car.max_curvature = curvature;
  car.acceleration_set = static_cast<AccelerationSet>(set);
  if (!has_body) return;
  if (kReads) car.body.emplace();
  describe(archive, car.body->offset), describe(archive, car.body->radius);
}

template <bool kReads>
void describe(Archive<kReads>& archive, DifferentialDrive& drive) {
  describe(archive, drive.track), describe(archive, drive.offset);
  describe(archive, drive.wheel_speed), describe(archive, drive.wheel_acceleration);
}

template <bool kReads>
void describe(Archive<kReads>& archive, Airplane& airplane) {
  auto after = static_cast<std::uint8_t>(airplane.after_goal);
  describe(archive, airplane.min_speed), describe(archive, airplane.lateral_acceleration);
  describe(archive, after);
  if (after > static_cast<std::uint8_t>(AfterGoal::leave))
    refuse_saved("an unknown after_goal", "a known one");
  airplane.after_goal = static_cast<AfterGoal>(after);
}

template <bool kReads>
void describe(Archive<kReads>& archive, SavedFlight& flight) {
  describe(archive, flight.circle.center), describe(archive, flight.circle.radius);
  describe(archive, flight.has_arrived);
}

// Its kind and then what that has.
template <bool kReads>
void describe(Archive<kReads>& archive, MotionModel& model) {
  auto kind = static_cast<std::uint64_t>(model.index());
  archive.word(kind);
  if (kReads && kind == 0) model = Holonomic{};
  if (kReads && kind == 1) model = Car{};
  if (kReads && kind == 2) model = DifferentialDrive{};
  if (kReads && kind == 3) model = Airplane{};
  if (kind != model.index()) refuse_saved("an unknown motion model", "a known one");
  std::visit([&](auto& known) { describe(archive, known); }, model);
}

template <bool kReads>
void describe(Archive<kReads>& archive, RobotSetup& setup, RobotState& state) {
  describe(archive, setup.goal), describe(archive, setup.radius);
  describe(archive, setup.max_speed), describe(archive, setup.max_acceleration);
  double max_braking = setup.max_braking.value_or(0.0);  // 0: unset
  describe(archive, max_braking);
  if (max_braking != 0.0) setup.max_braking = max_braking;
  describe(archive, setup.preferred_speed), describe(archive, setup.priority);
  describe(archive, setup.parked);
  std::uint64_t layers = std::uint64_t{setup.layers.bits} << 32 | setup.avoids.bits;
  archive.word(layers);
  setup.layers.bits = static_cast<std::uint32_t>(layers >> 32);
  setup.avoids.bits = static_cast<std::uint32_t>(layers);
  if (kReads && setup.parked) setup.position = setup.goal;
  describe(archive, setup.model);

  describe(archive, state.id.value), describe(archive, state.position);
  describe(archive, state.velocity), describe(archive, state.heading);
  describe(archive, state.detour.angle), describe(archive, state.detour.yielded);
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
  if (kReads)
    state.flights.resize(static_cast<std::size_t>(
        std::count_if(scene.robots.begin(), scene.robots.end(),
                      [](const RobotSetup& robot) { return is_airplane(robot.model); })));
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
  if (generations_needed(scene.sensing) < 2) return;  // they remember nothing
  archive.size(state.since, 1);
  for (std::int64_t& generation : state.since) describe(archive, generation);
  archive.size(state.past, kPastWords);
  for (PastState& past : state.past) describe(archive, past);
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
    refuse_saved(std::to_string(bytes.size()) + " bytes", "whole");
  }
  if (word_at(bytes, 0) != kMark) refuse_saved("something else", "bytes of Simulation::save()");
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
  if (!archive.unread.empty()) {
    refuse_saved(std::to_string(archive.unread.size()) + " more bytes", "no more");
  }
  check_saved(state);
  return state;
}

}  // namespace avo
