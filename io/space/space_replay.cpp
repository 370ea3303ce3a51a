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
class SimulatedAgain final : public ObservedRun<avo::space::Simulation> {
 public:
  SimulatedAgain(BlockSource& source, int threads, const Observe& observe)
      : ObservedRun(source.scenario_of_space(), threads, observe),
        shape_(source.shape()),
        clearances_(source.scenario_of_space()) {}
  void take(RecordingBlock& block) override {
    add_states(simulation(), shape_, block);
    clearances_.find(shape_, block.times - 1, block);
  }

 private:
  BlockShape shape_;
  SpaceClearances clearances_;
};

}  // namespace

Replay replay_in_space(const std::string& recording, int threads,
                       const std::function<void(const avo::space::Simulation&)>& observe) {
  BlockSource source(recording);
  if (!source.header().space)
    throw RecordingError(recording + ": found a recording of the plane, must be one of space here");
  require_this_version(recording, source.header());
  if (source.header().build == kConvertedRows)
    throw RecordingError(recording +
                         ": found rows of avo convert, must be those of a run: they have no "
                         "decisions to compare");
  SimulatedAgain run(source, threads, observe);
  const avo::space::Scenario& scenario = source.scenario_of_space();
  return compare(source, run, scenario.name, scenario.duration);
}

}  // namespace avo_io
