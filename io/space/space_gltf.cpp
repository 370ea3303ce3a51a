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
#include <vector>

#include "avo/space/metrics.h"
#include "avo/version.h"
#include "avo_io/printable.h"
#include "io/space/gltf_shapes.h"
#include "io/space/solid_boxes.h"
#include "io/space/space_export.h"
#include "io/text/json.h"

namespace avo_io {
namespace {

using avo::Vec3;

// those of Okabe and Ito, linear
constexpr std::array<std::array<double, 3>, 7> kColors{{{0.091, 0.456, 0.815},
                                                        {0.665, 0.112, 0.0},
                                                        {0.0, 0.342, 0.171},
                                                        {0.604, 0.191, 0.386},
                                                        {0.791, 0.347, 0.0},
                                                        {0.0, 0.168, 0.445},
                                                        {0.871, 0.776, 0.054}}};

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

void append_point(Vec3 point, std::vector<float>& path) {
  for (const double x : {point.x, point.y, point.z}) path.push_back(static_cast<float>(x));
}

/// Appends the in-tangent, the value and the out-tangent of a cubic spline.
void append_cubic(const avo::space::CheckedState& body, std::vector<float>& path) {
  for (const Vec3& v : {body.velocity, body.position, body.velocity}) append_point(v, path);
}

/// Makes the file while the rows come.
class GltfExport final : public SpaceExport {
 public:
  GltfExport(OutputFile& file, const avo::space::Scenario& scene) : file_(file), scene_(scene) {
    for (const avo::space::RobotSetup& setup : scene.robots)
      radii_.push_back(avo::space::robot_of(setup).radius);
    for (const avo::space::MovingObstacle& obstacle : scene.moving_obstacles)
      radii_.push_back(obstacle.radius);
    paths_.resize(radii_.size());
  }

  void add(const SpaceMoment& moment) override {
    if (moment.rows.size() != scene_.robots.size())
      throw RecordingError(fmt::format("found {} robots, must be all {} of the scene",
                                       moment.rows.size(), scene_.robots.size()));
    times_.push_back(static_cast<float>(moment.time));
    for (const avo::space::CheckedState& row : moment.rows)
      append_cubic(row, paths_[static_cast<std::size_t>(row.robot)]);
    // recordings have no rows of moving obstacles: their scene tells their places
    for (const avo::space::CheckedState& mover : mover_states(scene_, moment.time)) {
      std::vector<float>& path =
          paths_[scene_.robots.size() + static_cast<std::size_t>(mover.robot)];
      if (is_straight(mover.robot))
        append_point(mover.position, path);
      else
        append_cubic(mover, path);
    }
  }

  void finish() override;

 private:
  [[nodiscard]] Json materials() const;
  void add_bodies(GltfBuffer& buffer, Json& nodes, Json& animation) const;
  /// Whether that moving obstacle goes straight from row to row, as the judge has it.
  [[nodiscard]] bool is_straight(std::int64_t mover) const {
    return !scene_.moving_obstacles[static_cast<std::size_t>(mover)].trajectory.empty();
  }

  OutputFile& file_;
  const avo::space::Scenario& scene_;
  std::vector<double> radii_;  // of robots, and then of moving obstacles
  std::vector<float> times_;
  std::vector<std::vector<float>> paths_;  // of each of them
};

// The colors of robots, and then those of moving obstacles and of boxes.
Json GltfExport::materials() const {
  Json all = Json::array();
  for (const auto& color : kColors)
    all.push_back({{"pbrMetallicRoughness",
                    {{"baseColorFactor", {color[0], color[1], color[2], 1.0}},
                     {"metallicFactor", 0.0},
                     {"roughnessFactor", 0.6}}}});
  all.push_back({{"pbrMetallicRoughness",
                  {{"baseColorFactor", {0.1, 0.1, 0.1, 1.0}},
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

void GltfExport::add_bodies(GltfBuffer& buffer, Json& nodes, Json& animation) const {
  animation = {{"name", "motion"}, {"channels", Json::array()}, {"samplers", Json::array()}};
  const int times = buffer.add(times_, "SCALAR", 1, true);
  const std::size_t robots = scene_.robots.size();
  for (std::size_t k = 0; k < paths_.size(); ++k) {
    const std::vector<float>& path = paths_[k];
    const bool is_robot = k < robots;
    const bool is_cubic = is_robot || !is_straight(static_cast<std::int64_t>(k - robots));
    const std::size_t start = is_cubic ? 3 : 0;
    animation["channels"].push_back(
        {{"sampler", k}, {"target", {{"node", nodes.size()}, {"path", "translation"}}}});
    animation["samplers"].push_back({{"input", times},
                                     {"interpolation", is_cubic ? "CUBICSPLINE" : "LINEAR"},
                                     {"output", buffer.add(path, "VEC3", 3, false)}});
    nodes.push_back({{"name", is_robot ? fmt::format("robot {}", k)
                                       : fmt::format("moving obstacle {}", k - robots)},
                     {"mesh", is_robot ? k % kColors.size() : kColors.size()},
                     {"translation", {path[start], path[start + 1], path[start + 2]}},
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
  for (std::size_t color = 0; color <= kColors.size(); ++color)
    meshes.push_back(mesh_of(ball, color));
  meshes.push_back(mesh_of(cube, kColors.size() + 1));
  // node 0 turns z upwards to glTF's y upwards
  Json nodes = Json::array();
  nodes.push_back(Json{{"name", printable(scene_.name)}});
  add_bodies(buffer, nodes, animation);
  const std::vector<SolidBox> boxes = solid_boxes_of(scene_);
  for (std::size_t b = 0; b < boxes.size(); ++b)
    nodes.push_back(node_of(boxes[b], b, kColors.size() + 1));
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
