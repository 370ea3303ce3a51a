// SPDX-License-Identifier: Apache-2.0
// The binary part of a glTF file, and the shapes of bodies in it.
#pragma once
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "io/text/json.h"

namespace avo_io {

/// Numbers of the file, and the tables that say what they are.
class GltfBuffer {
 public:
  /// Returns the index of an accessor of `count` elements of the type. bounds: whether the least
  /// and the largest numbers are told, which positions and times need. target: 0: none.
  int add(const std::vector<float>& numbers, const char* type, std::size_t width, bool bounds,
          int target = 0);
  int add(const std::vector<std::uint16_t>& indices);

  Json views = Json::array(), accessors = Json::array();
  std::string bytes;

 private:
  int add_view(const void* data, std::size_t size, int target);
};

/// Accessors of a shape of triangles.
struct GltfShape {
  int position = 0, normal = 0, indices = 0;
};

/// A ball of radius 1 m.
GltfShape add_ball(GltfBuffer& buffer);
/// The cube from (-1, -1, -1) to (1, 1, 1).
GltfShape add_cube(GltfBuffer& buffer);

}  // namespace avo_io
