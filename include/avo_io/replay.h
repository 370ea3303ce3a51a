// SPDX-License-Identifier: Apache-2.0
// Simulates a recording again, and compares it bit by bit.
#pragma once
#include <cstdint>
#include <functional>
#include <optional>
#include <string>

#include "avo/export.h"
#include "avo/simulation.h"

namespace avo_io {

/// The first value that differs.
struct ReplayDifference {
  double time = 0.0;                       ///< s
  std::optional<std::int64_t> robot = {};  ///< none: the time itself differs, or the state hash
  std::string column;                      ///< e.g. "x", "status"
  std::string recorded, simulated;
};

/// The result of replay().
struct Replay {
  std::string scene;
  std::int64_t times = 0;  ///< times that were compared, with all robots
  std::int64_t robots = 0;
  /// the recording lasts until the end of the scene: no step is left
  bool whole = false;
  bool ended = false;            ///< the recording has the state hash at the end of its run
  std::uint64_t state_hash = 0;  ///< of the last state that was simulated
  std::optional<ReplayDifference> difference = {};
};

/// Simulates the scene that the recording (HDF5, or a spool) contains. It compares each of the
/// recorded values with the simulated value, until one differs. Calls observe(simulation), where it
/// is given, at the start and after each step. A scene with an external method needs its function.
/// Throws FileError; Error on the number of threads;
/// RecordingError also on a file of another version of avo, which need not simulate the same bits.
AVO_API Replay replay(const std::string& recording, int threads = 0,
                      const std::function<void(const avo::Simulation&)>& observe = {},
                      const avo::ExternalMethod& external = {});

/// Returns one line or two.
AVO_API std::string readable(const Replay& replay);
/// Returns one JSON object, keys in a fixed order; missing values are null.
AVO_API std::string to_json(const Replay& replay);

}  // namespace avo_io
