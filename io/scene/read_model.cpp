// SPDX-License-Identifier: Apache-2.0
#include "io/scene/read_model.h"

#include <algorithm>
#include <cmath>
#include <variant>

#include "avo/error.h"
#include "avo/footprint.h"
#include "core/retell.h"

namespace avo_io {
namespace {

/// The keys of models that have keys of their own.
struct OwnKeys {
  std::string_view key;
  ModelKind kind;
  std::string_view whose;
};
constexpr OwnKeys kOwnKeys[] = {
    {"car", ModelKind::car, "keys of a car"},
    {"drive", ModelKind::differential_drive, "keys of a differential drive"},
    {"airplane", ModelKind::airplane, "keys of an airplane"},
};

/// Returns the model that is named, or the model with keys that are present.
ModelKind kind_of(const Reader& reader, const YamlNode& node, const std::string& path,
                  const avo::RobotSetup& robot) {
  ModelKind kind = static_cast<ModelKind>(robot.model.index());
  for (const OwnKeys& own : kOwnKeys)
    if (node.find(own.key) != nullptr) kind = own.kind;
  if (const YamlNode* model = node.find("model"))
    kind = reader.choice(*model, path_to(path, "model"), kModels);
  for (const OwnKeys& own : kOwnKeys) {
    const YamlNode* keys = node.find(own.key);
    if (keys != nullptr && kind != own.kind)
      reader.fail(*keys, path_to(path, own.key), std::string(own.whose),
                  "must be left out: its model is " + std::string(model_name(kind)));
  }
  return kind;
}

void read_heading(const Reader& reader, const YamlNode& given, const std::string& path,
                  double& angle, GroupHeading* heading) {
  const bool word = given.kind == YamlNode::Kind::text && !is_number(given.text);
  if (heading != nullptr) *heading = GroupHeading::given;
  if (heading != nullptr && word) {
    *heading = reader.choice(given, path, kHeadings);
  } else {
    angle = reader.number(given, path, kHeadingField.range, kHeadingField.unit);
  }
}

void read_car(const Reader& reader, const YamlNode& node, const std::string& path, avo::Car& car) {
  std::vector<std::string_view> keys = keys_of(fields<avo::Car>());
  keys.push_back(kHeadingField.key);
  reader.check_keys(node, path, keys);
  reader.read(node, path, fields<avo::Car>(), car, true);
  const YamlNode* body = node.find("body");
  if (body == nullptr) return;
  const bool is_whole = car.body.has_value();  // a robot of a group may override some of its keys
  if (!is_whole) car.body.emplace();
  reader.check_keys(*body, path_to(path, "body"), keys_of(fields<avo::CarBody>()));
  reader.read(*body, path_to(path, "body"), fields<avo::CarBody>(), *car.body, is_whole);
}

// Returns the cover of the shape that the keys describe.
avo::Footprint cover_of(const Reader& reader, const YamlNode& node, const std::string& path) {
  FootprintShape shape;
  reader.check_keys(node, path, keys_of(fields<FootprintShape>()));
  reader.read(node, path, fields<FootprintShape>(), shape);
  const bool is_rectangle = shape.length && shape.width && node.find("polygon") == nullptr;
  const bool is_polygon =
      !shape.polygon.empty() && !shape.length && !shape.width && node.find("offset") == nullptr;
  if (!is_rectangle && !is_polygon)
    reader.fail(node, path, shown(node), "must have length and width, or a polygon alone");
  double side = is_rectangle ? 0.5 * *shape.width : 0.0;
  for (const avo::Vec2 corner : shape.polygon) side = std::max(side, std::abs(corner.y));
  const double excess = shape.excess.value_or(2.0 * side * avo::kUsualExcess);
  return avo::retelling<avo::Error>(
      [&] {
        return is_rectangle
                   ? avo::cover_rectangle(*shape.length, *shape.width, shape.offset, excess)
                   : avo::cover_polygon(shape.polygon, excess);
      },
      [&](const avo::Error& error) { reader.document().fail(node, path + "." + error.what()); });
}

void read_footprint(const Reader& reader, const YamlNode& node, const std::string& path,
                    avo::MotionModel& model) {
  if (auto* car = std::get_if<avo::Car>(&model)) {
    car->footprint = cover_of(reader, node, path);
  } else if (auto* drive = std::get_if<avo::DifferentialDrive>(&model)) {
    drive->footprint = cover_of(reader, node, path);
  } else {
    reader.fail(node, path, "a footprint",
                "must be left out: its model is " +
                    std::string(model_name(static_cast<ModelKind>(model.index()))) +
                    ", not car or differential_drive");
  }
}

}  // namespace

void read_model(const Reader& reader, const YamlNode& node, const std::string& path,
                avo::RobotSetup& robot, GroupHeading* heading) {
  const ModelKind kind = kind_of(reader, node, path, robot);
  if (kind == ModelKind::holonomic) robot.model = avo::Holonomic{};
  if (kind == ModelKind::car && !std::holds_alternative<avo::Car>(robot.model))
    robot.model = avo::Car{};
  if (kind == ModelKind::differential_drive &&
      !std::holds_alternative<avo::DifferentialDrive>(robot.model))
    robot.model = avo::DifferentialDrive{};
  if (kind == ModelKind::airplane && can_rest(robot.model)) robot.model = avo::Airplane{};
  const YamlNode *given = node.find("heading"), *car = node.find("car");
  const YamlNode* within = car != nullptr ? car->find("heading") : nullptr;
  if (given != nullptr && within != nullptr)
    reader.fail(*within, path_to(path, "car.heading"), "a second heading", "must be given once");
  if (given != nullptr && kind == ModelKind::holonomic)
    reader.fail(*given, path_to(path, "heading"), "a heading",
                "must be left out: its model is holonomic");
  if (given != nullptr)
    read_heading(reader, *given, path_to(path, "heading"), robot.heading, heading);
  if (within != nullptr)
    read_heading(reader, *within, path_to(path, "car.heading"), robot.heading, heading);
  if (car != nullptr) read_car(reader, *car, path_to(path, "car"), std::get<avo::Car>(robot.model));
  if (const YamlNode* drive = node.find("drive")) {
    const auto& table = fields<avo::DifferentialDrive>();
    reader.check_keys(*drive, path_to(path, "drive"), keys_of(table));
    reader.read(*drive, path_to(path, "drive"), table,
                std::get<avo::DifferentialDrive>(robot.model), true);
  }
  if (const YamlNode* footprint = node.find("footprint"))
    read_footprint(reader, *footprint, path_to(path, "footprint"), robot.model);
  if (const YamlNode* airplane = node.find("airplane")) {
    const auto& table = fields<avo::Airplane>();
    reader.check_keys(*airplane, path_to(path, "airplane"), keys_of(table));
    reader.read(*airplane, path_to(path, "airplane"), table, std::get<avo::Airplane>(robot.model),
                true);
  }
}

}  // namespace avo_io
