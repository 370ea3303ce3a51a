// SPDX-License-Identifier: Apache-2.0
// The scene that a recording contains.
#pragma once
#include <cstdint>
#include <string>

#include "avo/scenario.h"
#include "avo_io/errors.h"
#include "avo_io/recording.h"
#include "avo_io/space.h"

namespace avo_io {

/// The scene in a recording is unusable; the rest of the recording may be good.
class OwnSceneError final : public RecordingError {
 public:
  using RecordingError::RecordingError;
};

/// Does the same as parse_scenario(). It also throws RecordingError, without a place, if the scene
/// has another number of robots; it checks that before it places any of them.
avo::Scenario parse_scenario_of(const SceneSource& source, std::int64_t robots);
/// Makes a scene of space again. Throws SceneError before it places more than `most_robots` robots.
avo::space::Scenario parse_space_scenario_of(const SceneSource& source, std::int64_t most_robots);

/// Throws OwnSceneError, and RecordingError if the scene and the recording differ in the number of
/// robots. Both messages begin with the path.
avo::Scenario own_scene(const std::string& path, const RecordingHeader& header);
/// Does the same for a recording of space.
avo::space::Scenario own_scene_of_space(const std::string& path, const RecordingHeader& header);
/// Throws RecordingError if the recording is one of space.
void require_plane(const std::string& path, const RecordingHeader& header);

}  // namespace avo_io
