// SPDX-License-Identifier: Apache-2.0
// A file that is made of the rows of a recording of space.
#pragma once
#include <memory>

#include "avo/space/scenario.h"
#include "avo_io/errors.h"
#include "avo_io/output_file.h"
#include "io/space/space_rows.h"

namespace avo_io {

class SpaceExport {
 public:
  virtual ~SpaceExport() = default;
  /// Adds the rows of one time; times ascend. Throws RecordingError without a place.
  virtual void add(const SpaceMoment& moment) = 0;
  /// Call it after the last time.
  virtual void finish() = 0;
};

/// glTF 2.0 in one file (.glb), and MCAP. The scene outlives the export.
std::unique_ptr<SpaceExport> export_gltf(OutputFile& file, const avo::space::Scenario& scene);
std::unique_ptr<SpaceExport> export_mcap(OutputFile& file, const avo::space::Scenario& scene);

}  // namespace avo_io
