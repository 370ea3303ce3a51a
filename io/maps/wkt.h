// SPDX-License-Identifier: Apache-2.0
// Well-known text (OGC 06-103r4, §7): lines and polygons in the plane.
#pragma once
#include <vector>

#include "avo/wall.h"
#include "io/text/source_text.h"

namespace avo_io {

/// Lines become open chains, rings closed ones. Read are LINESTRING, LINEARRING, POLYGON, MULTI
/// forms and GEOMETRYCOLLECTION of these, in any case, one or more after the other. Of what is
/// EMPTY there are none. Throws SceneError or OverrideError.
std::vector<avo::Chain> read_wkt(const SourceText& source);

}  // namespace avo_io
