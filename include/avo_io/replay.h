// SPDX-License-Identifier: Apache-2.0
// A recording simulated again, and compared bit by bit.
#pragma once
#include <cstdint>
#include <functional>
#include <optional>
#include <string>

#include "avo/export.h"
#include "avo/simulation.h"

namespace avo_io {

/// The first value that is another one.
struct ReplayDifference {
  double time = 0.0;                       ///< s
  std::optional<std::int64_t> robot = {};  ///< none: of the time itself, or of the state hash
  std::string column;                      ///< e.g. "x", "status"
  std::string recorded, simulated;
};

/// What replay() has found.
struct Replay {
  std::string scene;
  std::int64_t times = 0;  ///< that were compared, of all robots
  std::int64_t robots = 0;
  bool whole = false;            ///< until the end of the scene: no step is left
  bool ended = false;            ///< the recording says which state hash its run ended with
  std::uint64_t state_hash = 0;  ///< of the last state that was simulated
  std::optional<ReplayDifference> difference = {};
};

/// Simulates the scene that the recording (HDF5, or a spool) has in itself, and compares each of
/// its values with what comes out, until one differs. Calls observe(simulation), where it is given,
/// at the start and after each step. Throws FileError; RecordingError also on a file of another
/// version of avo, which need not simulate the same bits; Error on the number of threads.
AVO_API Replay replay(const std::string& recording, int threads = 0,
                      const std::function<void(const avo::Simulation&)>& observe = {});

/// One line or two.
AVO_API std::string readable(const Replay& replay);
/// One JSON object, keys in a fixed order; what there is not is null.
AVO_API std::string to_json(const Replay& replay);

}  // namespace avo_io
