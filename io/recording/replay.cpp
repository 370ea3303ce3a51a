// SPDX-License-Identifier: Apache-2.0
// Simulates a recording again, and compares it bit by bit.
#include "avo_io/replay.h"

#include <bit>
#include <cstring>
#include <fmt/format.h>
#include <span>
#include <utility>

#include "avo/clearance.h"
#include "avo/simulation.h"
#include "avo/version.h"
#include "avo_io/errors.h"
#include "avo_io/printable.h"
#include "avo_io/scene.h"
#include "io/recording/block_source.h"
#include "io/recording/recorded_scene.h"
#include "io/recording/recorded_states.h"
#include "io/recording/replayed_run.h"
#include "io/text/json.h"

namespace avo_io {
namespace {

template <typename Value>
bool same_bits(Value a, Value b) {
  return std::memcmp(&a, &b, sizeof a) == 0;
}

std::string word_of(std::uint8_t status) {
  return status == kAbsent ? "absent" : avo::to_string(static_cast<avo::PlanStatus>(status));
}

/// The data that a recording and a simulation share at the same time.
struct Moment {
  const BlockShape& shape;
  const RecordingBlock& recorded;
  std::size_t k;                    // index of the time in the block
  const RecordingBlock& simulated;  // its only time

  [[nodiscard]] std::optional<ReplayDifference> difference() const;
};

std::optional<ReplayDifference> Moment::difference() const {
  const double time = recorded.time[k];
  if (!same_bits(time, simulated.time[0]))
    return ReplayDifference{
        time, {}, "time", fmt::format("{}", time), fmt::format("{}", simulated.time[0])};
  for (std::size_t i = 0; i < shape.robots; ++i) {
    ReplayDifference found{time, static_cast<std::int64_t>(i), {}, {}, {}};
    const auto differ = [&](const char* column, const auto& a, const auto& b) {
      found.column = column;
      found.recorded = fmt::format("{}", a);
      found.simulated = fmt::format("{}", b);
      return found;
    };
    for (std::size_t c = 0; c < shape.columns(); ++c) {
      const double a = recorded.row(shape, c, k)[i], b = simulated.row(shape, c, 0)[i];
      if (!same_bits(a, b)) return differ(shape.state->names[c], a, b);
    }
    const std::size_t at = k * shape.robots + i;
    if (recorded.status[at] != simulated.status[i])
      return differ("status", word_of(recorded.status[at]), word_of(simulated.status[i]));
    if (!same_bits(recorded.clearance[at], simulated.clearance[i]))
      return differ("clearance", recorded.clearance[at], simulated.clearance[i]);
  }
  return std::nullopt;
}

void require_same_motion(const std::string& recording, const RecordingHeader& header) {
  if (const auto lost = lost_setting(header.scene))
    throw RecordingError(
        fmt::format("{}: its scene: found {}, which was removed: its run cannot "
                    "be simulated again",
                    recording, *lost));
}

/// The steps that have rows: every n-th step from the start on, and the last step.
struct RecordedSteps {
  std::int64_t every = 1;
  double duration = 0.0;     // s, of the scene
  std::int64_t next = 0;     // step of the next row, unless it is the last
  bool was_between = false;  // the row before was off the grid, so it must be the last

  /// Simulates until the next row's time; returns a difference if a row is missing before it.
  std::optional<ReplayDifference> go_to(double time, ReplayedRun& run);
};

std::optional<ReplayDifference> RecordedSteps::go_to(double time, ReplayedRun& run) {
  const auto step_until = [&](std::int64_t last, double until) {
    while (run.steps() < last && run.time() < until && run.can_step_by(until)) run.step();
  };
  const auto missing = [&]() -> ReplayDifference {
    return {run.time(), {}, "time", "no row", fmt::format("{}", run.time())};
  };
  if (was_between) {
    step_until(next - every, duration);
    return missing();
  }
  step_until(next, time);
  if (run.steps() == next && run.time() < time && run.can_step_by(time)) return missing();
  was_between = run.steps() < next;
  next += every;
  return std::nullopt;
}

void compare_hashes(const RecordingHeader& header, const ReplayedRun& run, Replay& result) {
  result.state_hash = run.state_hash();
  result.ended = header.state_hash.has_value();
  if (result.difference || !result.ended || *header.state_hash == result.state_hash) return;
  result.difference = {run.time(),
                       {},
                       "state_hash",
                       fmt::format("{:#018x}", *header.state_hash),
                       fmt::format("{:#018x}", result.state_hash)};
}

/// A run of the plane.
class PlaneRun final : public ObservedRun<avo::Simulation> {
 public:
  PlaneRun(BlockSource& source, int threads, const Observe& observe,
           const avo::ExternalMethod& external)
      : ObservedRun(recorded(source.scenario(), external), threads, observe),
        shape_(source.shape()),
        clearances_(source.scenario()) {}
  void take(RecordingBlock& block) override {
    add_states(simulation(), shape_, block);
    find_clearances(shape_, block.times - 1, clearances_, block);
  }

 private:
  static avo::Scenario recorded(avo::Scenario scenario, const avo::ExternalMethod& external) {
    scenario.allow_broken_assumptions = true;  // because the recorded run allowed them
    scenario.external = external;
    return scenario;
  }

  BlockShape shape_;
  avo::ClearanceFinder clearances_;
};

}  // namespace

void require_this_version(const std::string& recording, const RecordingHeader& header) {
  if (header.version != avo::kVersion)
    throw RecordingError(
        fmt::format("{}: version: found {}, must be {}: another version of avo "
                    "need not simulate the same bits",
                    recording, printable(header.version, 40), avo::kVersion));
}

Replay compare(BlockSource& source, ReplayedRun& run, const std::string& scene, double duration) {
  const BlockShape shape = source.shape();
  RecordingBlock now(shape);
  RecordedSteps steps{source.header().every, duration};
  Replay result{.scene = scene, .robots = static_cast<std::int64_t>(shape.robots)};
  while (!result.difference && source.next()) {
    for (std::size_t k = 0; k < source.block().times && !result.difference; ++k) {
      const double time = source.block().time[k];
      result.difference = steps.go_to(time, run);
      if (result.difference) break;
      now.times = 0;
      run.take(now);
      result.difference = Moment{shape, source.block(), k, now}.difference();
      if (!result.difference) ++result.times;
    }
  }
  result.whole = !result.difference && !run.can_step_by(duration);
  compare_hashes(source.header(), run, result);
  return result;
}

Replay replay(const std::string& recording, int threads,
              const std::function<void(const avo::Simulation&)>& observe,
              const avo::ExternalMethod& external) {
  BlockSource source(recording);
  require_plane(recording, source.header());
  require_this_version(recording, source.header());
  require_same_motion(recording, source.header());
  PlaneRun run(source, threads, observe, external);
  return compare(source, run, source.scenario().name, source.scenario().duration);
}

std::string readable(const Replay& replay) {
  std::string text = fmt::format("{}: {} times of {} robots are equal", printable(replay.scene),
                                 replay.times, replay.robots);
  if (!replay.difference)
    return text + (replay.ended ? fmt::format(", and the state hash {:#018x}\n", replay.state_hash)
                                : ", all that the run has left\n");
  const ReplayDifference& first = *replay.difference;
  text += fmt::format("\n  the first that differs: at {} s, ", first.time);
  if (first.robot) text += fmt::format("robot {}, ", *first.robot);
  return text + fmt::format("{}: recorded {}, simulated {}\n", first.column, first.recorded,
                            first.simulated);
}

std::string to_json(const Replay& replay) {
  Json first;
  if (const auto& found = replay.difference)
    first = {{"time", found->time},
             {"robot", or_null(found->robot)},
             {"column", found->column},
             {"recorded", found->recorded},
             {"simulated", found->simulated}};
  const Json json{
      {"scene", replay.scene}, {"equal", !replay.difference},
      {"times", replay.times}, {"robots", replay.robots},
      {"ended", replay.ended}, {"state_hash", fmt::format("{:#018x}", replay.state_hash)},
      {"difference", first},   {"version", avo::kVersion}};
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace avo_io
