// SPDX-License-Identifier: Apache-2.0
// Measures the stages of a step: one clock per worker, read between stages.
#pragma once
#include <array>
#include <chrono>
#include <cstddef>
#include <cstdint>

namespace avo::inline core {

enum class Stage : std::uint8_t { index, search, half_planes, program, certificate, motion };
inline constexpr std::array kStageNames{"index",   "search",      "half_planes",
                                        "program", "certificate", "motion"};

/// Adds up the time between laps by stage. While off, a lap costs one branch.
class StageClock {
 public:
  /// Clears the sums.
  void measure(bool on) {
    on_ = on;
    nanoseconds_ = {};
  }
  /// Begins a lap.
  void start() {
    if (on_) last_ = Clock::now();
  }
  /// Adds the time since the last lap, or since start(), to the stage.
  void lap(Stage stage) {
    if (!on_) return;
    const Clock::time_point now = Clock::now();
    nanoseconds_[static_cast<std::size_t>(stage)] +=
        std::chrono::duration<double, std::nano>(now - last_).count();
    last_ = now;
  }
  [[nodiscard]] bool is_on() const { return on_; }
  [[nodiscard]] double nanoseconds(std::size_t stage) const { return nanoseconds_[stage]; }

 private:
  using Clock = std::chrono::steady_clock;
  bool on_ = false;
  Clock::time_point last_;
  std::array<double, kStageNames.size()> nanoseconds_{};
};

}  // namespace avo::inline core
