// SPDX-License-Identifier: Apache-2.0
// Maps of ROS, read as its map_server reads them.
#include "io/maps/ros_map.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

#include "io/fields/fields.h"
#include "io/files/file_names.h"
#include "io/maps/image.h"
#include "io/scene/reader.h"
#include "io/text/words.h"

namespace avo_io {
namespace {

/// Ignores keys that ROS does not define for a map, as ROS does, and notes them.
void note_unknown_keys(const Document& document, const std::vector<std::string_view>& known,
                       std::vector<std::string>& notes) {
  const std::vector<YamlNode>& entries = document.root.children;
  for (std::size_t i = 0; i + 1 < entries.size(); i += 2) {
    const std::string& key = entries[i].text;
    if (std::find(known.begin(), known.end(), key) != known.end()) continue;
    const auto meant = nearest(key, known);
    add_note(notes, fmt::format("{}: the unknown key {} is left out, as ROS does{}",
                                document.where(entries[i]), in_quotes(key),
                                meant ? fmt::format("; did you mean \"{}\"?", *meant) : ""));
  }
}

/// Reads 0, 1, false or true.
bool read_negate(const Reader& reader, const YamlNode& node) {
  if (node.kind != YamlNode::Kind::text || !is_number(node.text))
    return reader.truth(node, "negate");
  return reader.whole_number(node, "negate", {0.0, 1.0, false}) == 1;
}

RosMap read_settings(const Reader& reader, std::vector<std::string>& notes) {
  const YamlNode& root = reader.document().root;
  const std::vector<std::string_view> known = keys_of(fields<RosMap>());
  std::vector<std::string_view> allowed = known;
  for (std::size_t i = 0; i < root.children.size() && root.kind == YamlNode::Kind::map; i += 2)
    allowed.push_back(root.children[i].text);
  reader.check_keys(root, "", root.kind == YamlNode::Kind::map ? allowed : known);
  note_unknown_keys(reader.document(), known, notes);
  RosMap map;
  reader.read(root, "", fields<RosMap>(), map);
  if (const YamlNode* negate = root.find("negate"))
    map.negate = read_negate(reader, *negate);
  else
    reader.fail_missing(root, "", "negate", "1 or true: white is occupied");
  if (map.free_thresh > map.occupied_thresh)
    reader.fail(*root.find("free_thresh"), "free_thresh", fmt::format("{}", map.free_thresh),
                fmt::format("must be <= occupied_thresh = {}", map.occupied_thresh));
  return map;
}

void read_origin(const Reader& reader, const YamlNode& root, OccupancyGrid& grid) {
  const YamlNode* node = root.find("origin");
  if (node == nullptr)
    reader.fail_missing(root, "", "origin", "[x, y, yaw] of the lower left corner");
  if (node->kind != YamlNode::Kind::list || node->children.size() != 3)
    reader.fail(*node, "origin", shown(*node), "must be [x, y, yaw] in m and rad");
  const auto number = [&](std::size_t i, std::string_view unit) {
    return reader.number(node->children[i], fmt::format("origin.{}", i), avo::kAnyValue, unit);
  };
  grid.origin = {number(0, "m"), number(1, "m")};
  grid.yaw = number(2, "rad");
  constexpr double kLargestAngle = 0x1p40;  // the limit of the elementary functions
  if (std::abs(grid.yaw) > kLargestAngle)
    reader.fail(node->children[2], "origin.2", shown(node->children[2]), "must be an angle (rad)");
}

/// The darkness of a pixel, from 0 (free) to 1: the share of the largest brightness, over all its
/// channels, that the pixel lacks. `raw`: hundredths are stored, and values above 100 are unknown.
struct Darkness {
  const RosMap& map;
  const Image& image;

  [[nodiscard]] bool is_free(std::size_t pixel) const {
    const bool has_opacity = !image.opacity.empty();
    if (map.mode == RosMode::scale && has_opacity && image.opacity[pixel] < image.white)
      return false;  // unknown
    const bool averaged = map.mode == RosMode::trinary && has_opacity;
    const double most = static_cast<double>(image.white) * (averaged ? 4.0 : 3.0);
    const double bright = image.color[pixel] + (averaged ? image.opacity[pixel] : 0.0);
    if (map.mode == RosMode::raw) {
      const double percent = std::round(bright / most * 255.0);
      return percent <= 100.0 && percent / 100.0 < map.free_thresh;
    }
    return (map.negate ? bright : most - bright) / most < map.free_thresh;
  }
};

}  // namespace

OccupancyGrid read_ros_map(const SourceText& source, const std::string& folder, SceneFiles& files) {
  Document document;
  document.root = parse_yaml(source.text(), source.name(), document);
  const Reader reader(document);
  const RosMap map = read_settings(reader, files.notes);
  OccupancyGrid grid;
  grid.cell = map.resolution;
  read_origin(reader, document.root, grid);
  const std::string path = path_in(folder, map.image);
  const SourceText text =
      read_named_file(reader, *document.root.find("image"), "image", path, files);
  const Image image = read_image(text);
  grid.width = image.width;
  grid.height = image.height;
  grid.free.reserve(image.color.size());
  const Darkness darkness{map, image};
  for (std::size_t k = 0; k < image.color.size(); ++k) grid.free.push_back(darkness.is_free(k));
  return grid;
}

}  // namespace avo_io
