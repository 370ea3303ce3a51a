// SPDX-License-Identifier: Apache-2.0
#include "io/space/gltf_shapes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

#include "avo/vec.h"
#include "core/elementary.h"

namespace avo_io {
namespace {

constexpr int kFloat = 5126, kUnsignedShort = 5123;  // component types
constexpr int kVertices = 34962, kIndices = 34963;   // targets of buffer views
constexpr int kRings = 12, kSegments = 16;           // of the ball

}  // namespace

int GltfBuffer::add(const std::vector<float>& numbers, const char* type, std::size_t width,
                    bool bounds, int target) {
  const int view = add_view(numbers.data(), numbers.size() * sizeof(float), target);
  Json accessor{{"bufferView", view},
                {"componentType", kFloat},
                {"count", numbers.size() / width},
                {"type", type}};
  if (bounds) {
    std::vector<float> least(numbers.begin(), numbers.begin() + static_cast<std::ptrdiff_t>(width)),
        most = least;
    for (std::size_t k = 0; k < numbers.size(); ++k) {
      least[k % width] = std::min(least[k % width], numbers[k]);
      most[k % width] = std::max(most[k % width], numbers[k]);
    }
    accessor["min"] = least;
    accessor["max"] = most;
  }
  accessors.push_back(std::move(accessor));
  return static_cast<int>(accessors.size()) - 1;
}

int GltfBuffer::add(const std::vector<std::uint16_t>& indices) {
  const int view = add_view(indices.data(), indices.size() * sizeof(std::uint16_t), kIndices);
  accessors.push_back({{"bufferView", view},
                       {"componentType", kUnsignedShort},
                       {"count", indices.size()},
                       {"type", "SCALAR"}});
  return static_cast<int>(accessors.size()) - 1;
}

int GltfBuffer::add_view(const void* data, std::size_t size, int target) {
  views.push_back({{"buffer", 0}, {"byteOffset", bytes.size()}, {"byteLength", size}});
  if (target != 0) views.back()["target"] = target;
  bytes.append(static_cast<const char*>(data), size);
  bytes.resize((bytes.size() + 3) / 4 * 4, '\0');
  return static_cast<int>(views.size()) - 1;
}

GltfShape add_ball(GltfBuffer& buffer) {
  std::vector<float> points;
  std::vector<std::uint16_t> indices;
  for (int ring = 0; ring <= kRings; ++ring) {
    const avo::Vec2 up = avo::elementary::direction(std::numbers::pi * ring / kRings);
    for (int k = 0; k <= kSegments; ++k) {
      const double turn =
          std::remainder(2.0 * std::numbers::pi * k / kSegments, 2.0 * std::numbers::pi);
      const avo::Vec2 around = avo::elementary::direction(turn);
      for (const double x : {up.y * around.x, up.y * around.y, up.x})
        points.push_back(static_cast<float>(x));
    }
  }
  for (int ring = 0; ring < kRings; ++ring) {
    for (int k = 0; k < kSegments; ++k) {
      const int a = ring * (kSegments + 1) + k, b = a + kSegments + 1;
      for (const int corner : {a, b, a + 1, a + 1, b, b + 1})
        indices.push_back(static_cast<std::uint16_t>(corner));
    }
  }
  const int position = buffer.add(points, "VEC3", 3, true, kVertices);
  const int normal = buffer.add(points, "VEC3", 3, false, kVertices);
  return {position, normal, buffer.add(indices)};
}

GltfShape add_cube(GltfBuffer& buffer) {
  std::vector<float> points, normals;
  std::vector<std::uint16_t> indices;
  for (int axis = 0; axis < 3; ++axis) {
    for (const float side : {-1.0F, 1.0F}) {
      const auto first = static_cast<std::uint16_t>(points.size() / 3);
      for (const auto& [u, v] :
           {std::pair{-1.0F, -1.0F}, {side, -side}, {1.0F, 1.0F}, {-side, side}}) {
        std::array<float, 3> point{}, normal{};
        point[static_cast<std::size_t>(axis)] = normal[static_cast<std::size_t>(axis)] = side;
        point[static_cast<std::size_t>((axis + 1) % 3)] = u;
        point[static_cast<std::size_t>((axis + 2) % 3)] = v;
        points.insert(points.end(), point.begin(), point.end());
        normals.insert(normals.end(), normal.begin(), normal.end());
      }
      for (const int corner : {0, 1, 2, 0, 2, 3})
        indices.push_back(static_cast<std::uint16_t>(first + corner));
    }
  }
  const int position = buffer.add(points, "VEC3", 3, true, kVertices);
  const int normal = buffer.add(normals, "VEC3", 3, false, kVertices);
  return {position, normal, buffer.add(indices)};
}

}  // namespace avo_io
