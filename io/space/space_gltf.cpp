// SPDX-License-Identifier: Apache-2.0
// Recordings of space as glTF 2.0 in one binary file (.glb): animated balls, and boxes. A viewer
// interpolates by the cubic with the rows' positions and velocities, which is the judge's path.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <fmt/format.h>
#include <limits>
#include <numbers>
#include <vector>

#include "avo/version.h"
#include "avo_io/printable.h"
#include "core/elementary.h"
#include "io/space/solid_boxes.h"
#include "io/space/space_export.h"
#include "io/text/json.h"

namespace avo_io {
namespace {

using avo::Vec3;

constexpr int kFloat = 5126, kUnsignedShort = 5123;  // component types
constexpr int kVertices = 34962, kIndices = 34963;   // targets of buffer views
constexpr int kRings = 12, kSegments = 16;           // of the ball
// those of Okabe and Ito, linear
constexpr std::array<std::array<double, 3>, 7> kColors{{{0.091, 0.456, 0.815},
                                                        {0.665, 0.112, 0.0},
                                                        {0.0, 0.342, 0.171},
                                                        {0.604, 0.191, 0.386},
                                                        {0.791, 0.347, 0.0},
                                                        {0.0, 0.168, 0.445},
                                                        {0.871, 0.776, 0.054}}};

/// Numbers of the file, and the tables that say what they are.
class GltfBuffer {
 public:
  /// Returns the index of an accessor of `count` elements of the type. bounds: whether the least
  /// and the largest numbers are told, which positions and times need. target: 0: none.
  int add(const std::vector<float>& numbers, const char* type, std::size_t width, bool bounds,
          int target = 0) {
    const int view = add_view(numbers.data(), numbers.size() * sizeof(float), target);
    Json accessor{{"bufferView", view},
                  {"componentType", kFloat},
                  {"count", numbers.size() / width},
                  {"type", type}};
    if (bounds) {
      std::vector<float> least(numbers.begin(),
                               numbers.begin() + static_cast<std::ptrdiff_t>(width)),
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
  int add(const std::vector<std::uint16_t>& indices) {
    const int view = add_view(indices.data(), indices.size() * sizeof(std::uint16_t), kIndices);
    accessors.push_back({{"bufferView", view},
                         {"componentType", kUnsignedShort},
                         {"count", indices.size()},
                         {"type", "SCALAR"}});
    return static_cast<int>(accessors.size()) - 1;
  }

  Json views = Json::array(), accessors = Json::array();
  std::string bytes;

 private:
  int add_view(const void* data, std::size_t size, int target) {
    views.push_back({{"buffer", 0}, {"byteOffset", bytes.size()}, {"byteLength", size}});
    if (target != 0) views.back()["target"] = target;
    bytes.append(static_cast<const char*>(data), size);
    bytes.resize((bytes.size() + 3) / 4 * 4, '\0');
    return static_cast<int>(views.size()) - 1;
  }
};

/// Accessors of a shape of triangles.
struct GltfShape {
  int position = 0, normal = 0, indices = 0;
};

/// A ball of radius 1 m.
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

/// The cube from (-1, -1, -1) to (1, 1, 1).
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

Json mesh_of(const GltfShape& shape, std::size_t material) {
  const Json primitive{{"attributes", {{"POSITION", shape.position}, {"NORMAL", shape.normal}}},
                       {"indices", shape.indices},
                       {"material", material}};
  return {{"primitives", Json::array({primitive})}};
}

/// A node for a box: the cube, scaled and turned.
Json node_of(const SolidBox& box, std::size_t number, std::size_t mesh) {
  return {{"name", fmt::format("box {}", number)},
          {"mesh", mesh},
          {"translation", {box.center.x, box.center.y, box.center.z}},
          {"rotation", {0.0, 0.0, box.turn.y, box.turn.x}},
          {"scale", {box.half.x, box.half.y, box.half.z}}};
}

/// Makes the file while the rows come.
class GltfExport final : public SpaceExport {
 public:
  GltfExport(OutputFile& file, const avo::space::Scenario& scene) : file_(file), scene_(scene) {
    for (const avo::space::RobotSetup& setup : scene.robots)
      radii_.push_back(avo::space::robot_of(setup).radius);
    paths_.resize(radii_.size());
  }

  void add(const SpaceMoment& moment) override {
    if (moment.rows.size() != radii_.size())
      throw RecordingError(fmt::format("found {} robots, must be all {} of the scene",
                                       moment.rows.size(), radii_.size()));
    times_.push_back(static_cast<float>(moment.time));
    for (const avo::space::CheckedState& row : moment.rows) {
      const auto k = static_cast<std::size_t>(row.robot);
      // in-tangent, value and out-tangent of a cubic spline
      for (const Vec3& v : {row.velocity, row.position, row.velocity})
        for (const double x : {v.x, v.y, v.z}) paths_[k].push_back(static_cast<float>(x));
    }
  }

  void finish() override;

 private:
  [[nodiscard]] Json materials() const;
  void add_robots(GltfBuffer& buffer, Json& nodes, Json& animation) const;

  OutputFile& file_;
  const avo::space::Scenario& scene_;
  std::vector<double> radii_;
  std::vector<float> times_;
  std::vector<std::vector<float>> paths_;  // of each robot
};

// The colors of robots, and then that of boxes.
Json GltfExport::materials() const {
  Json all = Json::array();
  for (const auto& color : kColors)
    all.push_back({{"pbrMetallicRoughness",
                    {{"baseColorFactor", {color[0], color[1], color[2], 1.0}},
                     {"metallicFactor", 0.0},
                     {"roughnessFactor", 0.6}}}});
  all.push_back({{"pbrMetallicRoughness",
                  {{"baseColorFactor", {0.5, 0.5, 0.5, 0.35}},
                   {"metallicFactor", 0.0},
                   {"roughnessFactor", 1.0}}},
                 {"alphaMode", "BLEND"},
                 {"doubleSided", true}});
  return all;
}

void GltfExport::add_robots(GltfBuffer& buffer, Json& nodes, Json& animation) const {
  animation = {{"name", "motion"}, {"channels", Json::array()}, {"samplers", Json::array()}};
  const int times = buffer.add(times_, "SCALAR", 1, true);
  for (std::size_t k = 0; k < paths_.size(); ++k) {
    const std::vector<float>& path = paths_[k];
    animation["channels"].push_back(
        {{"sampler", k}, {"target", {{"node", nodes.size()}, {"path", "translation"}}}});
    animation["samplers"].push_back({{"input", times},
                                     {"interpolation", "CUBICSPLINE"},
                                     {"output", buffer.add(path, "VEC3", 3, false)}});
    nodes.push_back({{"name", fmt::format("robot {}", k)},
                     {"mesh", k % kColors.size()},
                     {"translation", {path[3], path[4], path[5]}},
                     {"scale", {radii_[k], radii_[k], radii_[k]}}});
  }
}

void append_chunk(const char* type, std::string bytes, char padding, std::string& file) {
  bytes.resize((bytes.size() + 3) / 4 * 4, padding);
  const auto size = static_cast<std::uint32_t>(bytes.size());
  char raw[sizeof size];
  std::memcpy(raw, &size, sizeof size);
  file.append(raw, sizeof raw).append(type, 4).append(bytes);
}

void GltfExport::finish() {
  GltfBuffer buffer;
  const GltfShape ball = add_ball(buffer), cube = add_cube(buffer);
  Json meshes = Json::array(), animation;
  for (std::size_t color = 0; color < kColors.size(); ++color)
    meshes.push_back(mesh_of(ball, color));
  meshes.push_back(mesh_of(cube, kColors.size()));
  // node 0 turns z upwards to glTF's y upwards
  Json nodes = Json::array();
  nodes.push_back(Json{{"name", printable(scene_.name)}});
  add_robots(buffer, nodes, animation);
  const std::vector<SolidBox> boxes = solid_boxes_of(scene_);
  for (std::size_t b = 0; b < boxes.size(); ++b)
    nodes.push_back(node_of(boxes[b], b, kColors.size()));
  Json children = Json::array();
  for (std::size_t k = 1; k < nodes.size(); ++k) children.push_back(k);
  const double half = std::sqrt(0.5);
  nodes[0]["rotation"] = {-half, 0.0, 0.0, half};
  nodes[0]["children"] = children;
  constexpr std::size_t kMost = std::numeric_limits<std::uint32_t>::max() / 2;
  if (buffer.bytes.size() > kMost)
    throw avo::Error(fmt::format("found {} bytes of motion, must be at most {} in a .glb",
                                 buffer.bytes.size(), kMost));
  const Json json{
      {"asset", {{"version", "2.0"}, {"generator", fmt::format("avo {}", avo::kVersion)}}},
      {"scene", 0},
      {"scenes", Json::array({Json{{"nodes", Json::array({0})}}})},
      {"nodes", nodes},
      {"meshes", meshes},
      {"materials", materials()},
      {"animations", Json::array({animation})},
      {"buffers", Json::array({Json{{"byteLength", buffer.bytes.size()}}})},
      {"bufferViews", buffer.views},
      {"accessors", buffer.accessors}};
  std::string chunks;
  append_chunk("JSON", json.dump(-1, ' ', false, Json::error_handler_t::replace), ' ', chunks);
  append_chunk("BIN\0", buffer.bytes, '\0', chunks);
  std::string header(12, '\0');
  const std::uint32_t version = 2, size = static_cast<std::uint32_t>(chunks.size() + 12);
  std::memcpy(header.data(), "glTF", 4);
  std::memcpy(header.data() + 4, &version, 4);
  std::memcpy(header.data() + 8, &size, 4);
  file_.write(header);
  file_.write(chunks);
}

}  // namespace

std::unique_ptr<SpaceExport> export_gltf(OutputFile& file, const avo::space::Scenario& scene) {
  return std::make_unique<GltfExport>(file, scene);
}

}  // namespace avo_io
