// SPDX-License-Identifier: Apache-2.0
// Simulates a recording of space again.
#include "avo_io/errors.h"
#include "avo_io/space.h"
#include "io/recording/replayed_run.h"
#include "io/space/space_clearances.h"
#include "io/space/space_recording.h"

namespace avo_io {
namespace {

/// A run in space.
class SimulatedAgain final : public ReplayedRun {
 public:
  using Observe = std::function<void(const avo::space::Simulation&)>;
  SimulatedAgain(BlockSource& source, int threads, const Observe& observe)
      : shape_(source.shape()),
        simulation_(source.scenario_of_space(), threads),
        clearances_(source.scenario_of_space()),
        observe_(observe) {
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
  void take(RecordingBlock& block) override {
    add_states(simulation_, shape_, block);
    clearances_.find(shape_, block.times - 1, block);
  }
  [[nodiscard]] std::uint64_t state_hash() const override { return simulation_.state_hash(); }

 private:
  BlockShape shape_;
  avo::space::Simulation simulation_;
  SpaceClearances clearances_;
  const Observe& observe_;
};

}  // namespace

Replay replay_in_space(const std::string& recording, int threads,
                       const std::function<void(const avo::space::Simulation&)>& observe) {
  BlockSource source(recording);
  if (!source.header().space)
    throw RecordingError(recording + ": found a recording of the plane, must be one of space here");
  require_this_version(recording, source.header());
  SimulatedAgain run(source, threads, observe);
  const avo::space::Scenario& scenario = source.scenario_of_space();
  return compare(source, run, scenario.name, scenario.duration);
}

}  // namespace avo_io
