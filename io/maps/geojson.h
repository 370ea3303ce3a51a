// SPDX-License-Identifier: Apache-2.0
// GeoJSON (RFC 7946) as a plan: lines and polygons in the plane, in m.
#pragma once
#include <string>
#include <vector>

#include "avo/wall.h"
#include "io/text/source_text.h"

namespace avo_io {

/// Lines become open chains, and rings closed chains; the first two numbers of a position count.
/// Notes tell the number of points that are left out, and whether the file names degrees. Throws
/// SceneError.
std::vector<avo::Chain> read_geojson(const SourceText& source, std::vector<std::string>& notes);

}  // namespace avo_io
