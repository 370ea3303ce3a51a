// SPDX-License-Identifier: Apache-2.0
// Shared parts of the module's functions: bytes to and from the host, and the one simulation.
#pragma once
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "avo/metrics.h"
#include "avo/scenario.h"
#include "avo/simulation.h"
#include "avo/space/metrics.h"
#include "avo/space/scenario.h"
#include "avo/space/simulation.h"

/// A function that the host calls by that name. In C++ its name begins with avo_, because the C
/// library has its own time(). Texts and tables are passed in the room, see room().
#define AVO_EXPORT(type, name) extern "C" __attribute__((export_name(#name), used)) type avo_##name

namespace avo_lab {

/// A scene of the plane and its simulation.
struct PlaneRun {
  avo::Scenario scenario;  ///< as it was read
  /// the scenario at the start of the simulation: that, or a scenario that was taken over
  avo::Scenario start;
  std::unique_ptr<avo::Simulation> simulation;
  std::unique_ptr<avo::Metrics>
      metrics;  ///< since the start, if they were asked for; none once a state was restored
};

/// A scene of space and its simulation.
struct SpaceRun {
  avo::space::Scenario scenario;
  std::unique_ptr<avo::space::Simulation> simulation;
  std::unique_ptr<avo::space::Metrics> metrics;  ///< if they were asked for
};

/// The one run of the instance.
std::variant<PlaneRun, SpaceRun>& run();

/// The run of a scene of the plane. Throws Error if the scene is one of space.
PlaneRun& plane();

/// Calls `action` with the run, of the plane or of space.
template <class Action>
auto with_run(const Action& action) {
  if (auto* space = std::get_if<SpaceRun>(&run())) return action(*space);
  return action(*std::get_if<PlaneRun>(&run()));
}

/// Columns of numbers, one behind the other.
class Columns {
 public:
  template <class Value>
  void add(Value value) {
    const auto* bytes = reinterpret_cast<const std::byte*>(&value);
    bytes_.insert(bytes_.end(), bytes, bytes + sizeof value);
  }
  template <class Column>
  void add_all(const Column& column) {
    for (const auto& value : column) add(value);
  }
  [[nodiscard]] const std::vector<std::byte>& bytes() const { return bytes_; }

 private:
  std::vector<std::byte> bytes_;
};

/// Returns "robots.3", or "moving_obstacles.0" for source -1.
std::string name_of(std::int64_t source);

/// Returns the number in the scene of the obstacle that the box is a part of.
std::int64_t obstacle_of(const avo::space::Scenario& scenario, std::size_t box);

/// Bytes that the host has put into the room, in order: whole numbers, and texts with their lengths
/// in front.
class Input {
 public:
  explicit Input(std::vector<std::byte> bytes) : bytes_(std::move(bytes)) {}

  std::uint32_t whole() { return value<std::uint32_t>(); }
  std::string text() {
    const std::uint32_t size = whole();
    std::string text(size, '\0');
    std::memcpy(text.data(), bytes_.data() + at_, size);
    at_ += size;
    return text;
  }
  [[nodiscard]] bool has_ended() const { return at_ >= bytes_.size(); }

 private:
  template <class Value>
  Value value() {
    Value value;
    std::memcpy(&value, bytes_.data() + at_, sizeof value);
    at_ += sizeof value;
    return value;
  }

  std::vector<std::byte> bytes_;
  std::size_t at_ = 0;
};

/// The start of a simulation of a changed text that takes over from the present simulation.
struct Takeover {
  avo::Scenario start;
  std::vector<avo::RobotId> gone = {};  ///< robots to remove first
  /// for each moving obstacle: whether it keeps its place, instead of the start in the text
  std::vector<bool> goes_on = {};
};
Takeover taken_over_by(const avo::Scenario& text);
/// Copies the rest of the present simulation's memory into the simulation that takes over, see
/// Takeover.
void remember(avo::Simulation& simulation, const std::vector<bool>& goes_on);

/// See braking_paths().
std::size_t space_braking_paths(const SpaceRun& space, std::uint32_t robot);

// What the host asks of a run of either kind. Texts are JSON.
Columns moment_of(const PlaneRun& run);  ///< see moment()
Columns moment_of(const SpaceRun& run);
std::string info_of(const PlaneRun& run);
std::string info_of(const SpaceRun& run);
std::string contacts_of(const PlaneRun& run);
std::string contacts_of(const SpaceRun& run);

/// Returns m, for each robot of the present fleet, see avo/clearance.h; valid until the next call.
std::span<const float> clearances_of(const avo::FleetView& fleet);

/// Returns the contents of the room, which is empty after that.
std::vector<std::byte> taken_from_room();
/// Puts the bytes into the room and returns their number.
std::size_t into_room(std::span<const std::byte> bytes);
inline std::size_t into_room(std::string_view text) {
  return into_room(std::as_bytes(std::span(text)));
}

}  // namespace avo_lab
