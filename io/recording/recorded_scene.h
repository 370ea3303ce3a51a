// SPDX-License-Identifier: Apache-2.0
// The scene that a recording has in itself.
#pragma once
#include <cstdint>
#include <string>

#include "avo/scenario.h"
#include "avo_io/errors.h"
#include "avo_io/recording.h"

namespace avo_io {

/// A recording whose own scene cannot be used; all else of it may be good.
class OwnSceneError final : public RecordingError {
 public:
  using RecordingError::RecordingError;
};

/// The same as parse_scenario(), but throws RecordingError, without a place, where the scene has
/// another number of robots, before any of them is placed.
avo::Scenario parse_scenario_of(const SceneSource& source, std::int64_t robots);

/// Throws OwnSceneError, and RecordingError where it has not as many robots as the recording. Both
/// begin with the path.
avo::Scenario own_scene(const std::string& path, const RecordingHeader& header);

}  // namespace avo_io
