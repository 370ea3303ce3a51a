// SPDX-License-Identifier: Apache-2.0
// Vectors by their number of dimensions: what is proved for the plane and for space is one text.
#pragma once
#include <type_traits>

#include "avo/vec.h"
#include "avo/vec3.h"

namespace avo::inline core {

template <int D>
using VectorOf = std::conditional_t<D == 2, Vec2, Vec3>;

}  // namespace avo::inline core
