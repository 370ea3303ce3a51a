// SPDX-License-Identifier: Apache-2.0
// GeoJSON (RFC 7946) as a plan: lines and polygons in the plane, in m.
#pragma once
#include <string>
#include <vector>

#include "avo/wall.h"
#include "io/text/source_text.h"

namespace avo_io {

/// Lines become open chains, rings closed ones; of a position the first two numbers count. Notes
/// say how many points are left out, and where the file speaks of degrees. Throws SceneError.
std::vector<avo::Chain> read_geojson(const SourceText& source, std::vector<std::string>& notes);

}  // namespace avo_io
