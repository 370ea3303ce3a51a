// SPDX-License-Identifier: Apache-2.0
// Recordings of space as MCAP: balls, velocities and boxes for Foxglove's 3D panel, and poses.
#include <cmath>
#include <fmt/format.h>

#include "io/export/foxglove.h"
#include "io/export/mcap_file.h"
#include "io/export/protobuf.h"
#include "io/space/solid_boxes.h"
#include "io/space/space_export.h"

namespace avo_io {
namespace {

using avo::Vec3;

constexpr std::string_view kWorld = "world";
constexpr double kLastSecond = 1e9;  // whole nanoseconds of twice this time fit into 64 bits
constexpr double kStill = 1e-3;      // m/s: a slower robot has no arrow
constexpr double kHead = 0.25;       // of an arrow's length
constexpr double kShaft = 0.1, kHeadWidth = 0.2;  // of a robot's radius

std::string message_of(std::initializer_list<double> numbers) {
  ProtoBytes bytes;
  int field = 1;
  for (const double x : numbers) bytes.number(field++, x);
  return bytes.bytes();
}

std::string pose_at(Vec3 place, const std::string& quaternion) {
  ProtoBytes pose;
  pose.text(1, message_of({place.x, place.y, place.z}));
  pose.text(2, quaternion);
  return pose.bytes();
}

const std::string& upright() {
  static const std::string quaternion = message_of({0.0, 0.0, 0.0, 1.0});
  return quaternion;
}

// Returns the quaternion that turns the x axis to the direction, without rolling.
std::string towards(Vec3 direction) {
  const double w = std::sqrt(std::max(0.5 * (1.0 + direction.x), 0.0));
  if (w < 1e-6) return message_of({0.0, 0.0, 1.0, 0.0});
  return message_of({0.0, -0.5 * direction.z / w, 0.5 * direction.y / w, w});
}

std::string time_of(std::uint64_t time) {
  constexpr std::uint64_t kSecond = 1'000'000'000;
  ProtoBytes bytes;
  bytes.whole(1, time / kSecond);
  bytes.whole(2, time % kSecond);
  return bytes.bytes();
}

ProtoBytes entity_at(const std::string& timestamp, std::size_t number) {
  ProtoBytes entity;
  entity.text(1, timestamp);
  entity.text(2, kWorld);
  entity.text(3, fmt::format("{}", number));
  return entity;
}

class SpaceMcap final : public SpaceExport {
 public:
  SpaceMcap(OutputFile& file, const avo::space::Scenario& scene)
      : boxes_(solid_boxes_of(scene)), file_(file) {
    for (const avo::space::RobotSetup& setup : scene.robots)
      radii_.push_back(robot_of(setup).radius);
    const std::string descriptors = foxglove_schema();
    const std::uint16_t update = file_.add_schema("foxglove.SceneUpdate", descriptors);
    const std::uint16_t poses = file_.add_schema("foxglove.PosesInFrame", descriptors);
    walls_ = file_.add_channel("/walls", update);
    robots_ = file_.add_channel("/robots", update);
    poses_ = file_.add_channel("/poses", poses);
  }
  void add(const SpaceMoment& moment) override;
  void finish() override { file_.finish(); }

 private:
  [[nodiscard]] std::string walls(const std::string& timestamp) const;
  [[nodiscard]] std::string robot_at(const avo::space::CheckedState& row,
                                     const std::string& timestamp) const;

  std::vector<SolidBox> boxes_;
  std::vector<double> radii_;
  McapFile file_;
  std::uint16_t walls_ = 0, robots_ = 0, poses_ = 0;  // channels
  bool begun_ = false;
};

std::string SpaceMcap::walls(const std::string& timestamp) const {
  ProtoBytes update;
  for (std::size_t k = 0; k < boxes_.size(); ++k) {
    const SolidBox& box = boxes_[k];
    ProtoBytes cube;
    cube.text(1, pose_at(box.center, message_of({0.0, 0.0, box.turn.y, box.turn.x})));
    cube.text(2, message_of({2.0 * box.half.x, 2.0 * box.half.y, 2.0 * box.half.z}));
    cube.text(3, message_of({0.5, 0.5, 0.5, 0.35}));
    ProtoBytes entity = entity_at(timestamp, k);
    entity.text(8, cube.bytes());
    update.text(2, entity.bytes());
  }
  return update.bytes();
}

// A ball, and an arrow as long as the distance that the robot travels in a second.
std::string SpaceMcap::robot_at(const avo::space::CheckedState& row,
                                const std::string& timestamp) const {
  const double radius = radii_[static_cast<std::size_t>(row.robot)], speed = norm(row.velocity);
  ProtoBytes entity = entity_at(timestamp, static_cast<std::size_t>(row.robot));
  if (speed > kStill) {
    ProtoBytes arrow;
    arrow.text(1, pose_at(row.position, towards(row.velocity / speed)));
    arrow.number(2, (1.0 - kHead) * speed);
    arrow.number(3, kShaft * radius);
    arrow.number(4, kHead * speed);
    arrow.number(5, kHeadWidth * radius);
    arrow.text(6, message_of({0.9, 0.5, 0.1, 1.0}));
    entity.text(7, arrow.bytes());
  }
  ProtoBytes ball;
  ball.text(1, pose_at(row.position, upright()));
  ball.text(2, message_of({2.0 * radius, 2.0 * radius, 2.0 * radius}));
  ball.text(3, message_of({0.12, 0.47, 0.71, 1.0}));
  entity.text(9, ball.bytes());
  return entity.bytes();
}

void SpaceMcap::add(const SpaceMoment& moment) {
  if (!(moment.time >= 0.0 && moment.time <= kLastSecond))
    throw RecordingError(
        fmt::format("found time {} s, must be from 0 to {} s", moment.time, kLastSecond));
  const auto time = static_cast<std::uint64_t>(std::llround(moment.time * 1e9));
  const std::string timestamp = time_of(time);
  if (!begun_) file_.write(walls_, time, walls(timestamp));
  begun_ = true;
  ProtoBytes update, poses;
  poses.text(1, timestamp);
  poses.text(2, kWorld);
  for (const avo::space::CheckedState& row : moment.rows) {
    update.text(2, robot_at(row, timestamp));
    poses.text(3, pose_at(row.position, upright()));
  }
  file_.write(robots_, time, update.bytes());
  file_.write(poses_, time, poses.bytes());
}

}  // namespace

std::unique_ptr<SpaceExport> export_mcap(OutputFile& file, const avo::space::Scenario& scene) {
  return std::make_unique<SpaceMcap>(file, scene);
}

}  // namespace avo_io
