// SPDX-License-Identifier: Apache-2.0
// Well-known text (OGC 06-103r4, §7): lines and polygons in the plane.
#pragma once
#include <vector>

#include "avo/wall.h"
#include "io/text/source_text.h"

namespace avo_io {

/// Lines become open chains, and rings closed chains. It reads LINESTRING, LINEARRING, POLYGON,
/// MULTI forms and GEOMETRYCOLLECTION of these, in any case, one or more in sequence. EMPTY gives
/// no chains. Throws SceneError or OverrideError.
std::vector<avo::Chain> read_wkt(const SourceText& source);

}  // namespace avo_io
