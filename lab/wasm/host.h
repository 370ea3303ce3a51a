// SPDX-License-Identifier: Apache-2.0
// What the module's functions share: bytes that go to and fro, and the one simulation.
#pragma once
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "avo/metrics.h"
#include "avo/scenario.h"
#include "avo/simulation.h"

/// A function that the host calls by that name; in C++ with avo_ before it, because the C library
/// has a time() of its own. Texts and tables are handed over in the room, see room().
#define AVO_EXPORT(type, name) extern "C" __attribute__((export_name(#name), used)) type avo_##name

namespace avo_lab {

/// One scene and its simulation an instance.
struct Lab {
  avo::Scenario scenario;  ///< as it was read
  avo::Scenario start;     ///< what the simulation began with: that, or what it has taken over
  std::unique_ptr<avo::Simulation> simulation;
  std::unique_ptr<avo::Metrics>
      metrics;  ///< since the start, where they were asked for; none once a state was restored
};
Lab& lab();

/// Index into the fleet of the robot with that number. Throws Error where there is none.
std::size_t index_of(std::uint64_t robot);

/// "robots.3", or "moving_obstacles.0" of source -1.
std::string name_of(std::int64_t source);

/// Bytes that the host has put into the room, in their order: whole numbers, and texts behind
/// their lengths.
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

/// What a simulation of another text begins with where it takes over from the present one.
struct Takeover {
  avo::Scenario start;
  std::vector<avo::RobotId> gone = {};  ///< that have to be removed first
  /// Of the moving obstacles: whether each is where it was, not where the text lets it start.
  std::vector<bool> goes_on = {};
};
Takeover taken_over_by(const avo::Scenario& text);
/// Puts into the one that takes over what the present simulation knows besides, see Takeover.
void remember(avo::Simulation& simulation, const std::vector<bool>& goes_on);

/// m, of each robot of the present fleet, see avo/clearance.h; until the next call.
std::span<const float> clearances_of(const avo::FleetView& fleet);

/// What is in the room, which is empty then.
std::vector<std::byte> taken_from_room();
/// Into the room; its size.
std::size_t into_room(std::span<const std::byte> bytes);
inline std::size_t into_room(std::string_view text) {
  return into_room(std::as_bytes(std::span(text)));
}

}  // namespace avo_lab
