// SPDX-License-Identifier: Apache-2.0
// The comparison of a recording with a run that is simulated again, in the plane and in space.
#pragma once
#include <cstdint>
#include <functional>
#include <string>

#include "avo_io/replay.h"
#include "io/recording/block_source.h"

namespace avo_io {

/// A simulation of the recorded scene.
class ReplayedRun {
 public:
  virtual ~ReplayedRun() = default;
  [[nodiscard]] virtual std::int64_t steps() const = 0;
  [[nodiscard]] virtual double time() const = 0;  ///< s
  /// Returns whether the next step ends by that time, s.
  [[nodiscard]] virtual bool can_step_by(double time) const = 0;
  virtual void step() = 0;
  /// Appends the present state and its clearances to the block.
  virtual void take(RecordingBlock& block) = 0;
  [[nodiscard]] virtual std::uint64_t state_hash() const = 0;
};

/// A simulation that an observer sees, at the start and after each step. The observer may be empty.
template <class Simulation>
class ObservedRun : public ReplayedRun {
 public:
  using Observe = std::function<void(const Simulation&)>;
  ObservedRun(const auto& scenario, int threads, const Observe& observe)
      : simulation_(scenario, threads), observe_(observe) {
    if (observe_) observe_(simulation_);
  }
  [[nodiscard]] std::int64_t steps() const override { return simulation_.steps(); }
  [[nodiscard]] double time() const override { return simulation_.time(); }
  [[nodiscard]] bool can_step_by(double time) const override {
    return simulation_.can_step_by(time);
  }
  void step() override {
    simulation_.step();
    if (observe_) observe_(simulation_);
  }
  [[nodiscard]] std::uint64_t state_hash() const override { return simulation_.state_hash(); }

 protected:
  [[nodiscard]] const Simulation& simulation() const { return simulation_; }

 private:
  Simulation simulation_;
  const Observe& observe_;
};

/// Throws RecordingError for a recording that this version need not simulate to the same bits.
void require_this_version(const std::string& recording, const RecordingHeader& header);

/// Steps the run along the recording until a value differs. duration: of the scene, s.
Replay compare(BlockSource& source, ReplayedRun& run, const std::string& scene, double duration);

}  // namespace avo_io
