// SPDX-License-Identifier: Apache-2.0
// Recordings of space as MCAP: balls, velocities and boxes for Foxglove's 3D panel, and poses.
#include <cmath>
#include <fmt/format.h>

#include "avo/space/metrics.h"
#include "io/export/foxglove.h"
#include "io/space/solid_boxes.h"
#include "io/space/space_export.h"

namespace avo_io {
namespace {

using avo::Vec3;

constexpr double kStill = 1e-3;  // m/s: a slower robot has no arrow

std::string pose_at(Vec3 place, const std::string& quaternion) {
  ProtoBytes pose;
  pose.text(1, numbers_of({place.x, place.y, place.z}));
  pose.text(2, quaternion);
  return pose.bytes();
}

const std::string& upright() {
  static const std::string quaternion = numbers_of({0.0, 0.0, 0.0, 1.0});
  return quaternion;
}

// Returns the quaternion that turns the x axis to the direction, without rolling.
std::string towards(Vec3 direction) {
  const double w = std::sqrt(std::max(0.5 * (1.0 + direction.x), 0.0));
  if (w < 1e-6) return numbers_of({0.0, 0.0, 1.0, 0.0});
  return numbers_of({0.0, -0.5 * direction.z / w, 0.5 * direction.y / w, w});
}

// A ball, and an arrow as long as the distance that it travels in a second, unless it is at rest.
std::string ball_of(ProtoBytes entity, const avo::space::CheckedState& body, double radius,
                    const std::string& color) {
  const double speed = norm(body.velocity);
  if (speed > kStill)
    entity.text(7, arrow_of(pose_at(body.position, towards(body.velocity / speed)), speed, radius));
  ProtoBytes ball;
  ball.text(1, pose_at(body.position, upright()));
  ball.text(2, numbers_of({2.0 * radius, 2.0 * radius, 2.0 * radius}));
  ball.text(3, color);
  entity.text(9, ball.bytes());
  return entity.bytes();
}

class SpaceMcap final : public SpaceExport {
 public:
  SpaceMcap(OutputFile& file, const avo::space::Scenario& scene)
      : scene_(scene),
        boxes_(solid_boxes_of(scene)),
        file_(file),
        channels_(add_foxglove_channels(file_)) {
    for (const avo::space::RobotSetup& setup : scene.robots)
      radii_.push_back(robot_of(setup).radius);
    if (!scene.moving_obstacles.empty())
      movers_ = file_.add_channel("/moving_obstacles", channels_.scene_update);
  }
  void add(const SpaceMoment& moment) override;
  void finish() override { file_.finish(); }

 private:
  [[nodiscard]] std::string walls(const std::string& timestamp) const;
  [[nodiscard]] std::string movers_at(double time, const std::string& timestamp) const;

  const avo::space::Scenario& scene_;
  std::vector<SolidBox> boxes_;
  std::vector<double> radii_;
  McapFile file_;
  FoxgloveChannels channels_;
  std::uint16_t movers_ = 0;  // their channel; 0: there are none
  bool begun_ = false;
};

std::string SpaceMcap::walls(const std::string& timestamp) const {
  ProtoBytes update;
  for (std::size_t k = 0; k < boxes_.size(); ++k) {
    const SolidBox& box = boxes_[k];
    ProtoBytes cube;
    cube.text(1, pose_at(box.center, numbers_of({0.0, 0.0, box.turn.y, box.turn.x})));
    cube.text(2, numbers_of({2.0 * box.half.x, 2.0 * box.half.y, 2.0 * box.half.z}));
    cube.text(3, numbers_of({0.5, 0.5, 0.5, 0.35}));
    ProtoBytes entity = entity_of(timestamp, fmt::format("{}", k));
    entity.text(8, cube.bytes());
    update.text(2, entity.bytes());
  }
  return update.bytes();
}

// Recordings have no rows of moving obstacles: their scene tells their places.
std::string SpaceMcap::movers_at(double time, const std::string& timestamp) const {
  ProtoBytes update;
  for (const avo::space::CheckedState& mover : mover_states(scene_, time))
    update.text(2, ball_of(entity_of(timestamp, fmt::format("{}", mover.robot)), mover,
                           scene_.moving_obstacles[static_cast<std::size_t>(mover.robot)].radius,
                           numbers_of({0.84, 0.15, 0.16, 1.0})));
  return update.bytes();
}

void SpaceMcap::add(const SpaceMoment& moment) {
  const std::uint64_t time = nanoseconds_of(moment.time);
  const std::string timestamp = timestamp_of(time);
  if (!begun_) file_.write(channels_.walls, time, walls(timestamp));
  begun_ = true;
  ProtoBytes update, poses;
  poses.text(1, timestamp);
  poses.text(2, kFrameId);
  for (const avo::space::CheckedState& row : moment.rows) {
    const double radius = radii_[static_cast<std::size_t>(row.robot)];
    update.text(2, ball_of(entity_of(timestamp, fmt::format("{}", row.robot)), row, radius,
                           numbers_of({0.12, 0.47, 0.71, 1.0})));
    poses.text(3, pose_at(row.position, upright()));
  }
  file_.write(channels_.robots, time, update.bytes());
  if (movers_ != 0) file_.write(movers_, time, movers_at(moment.time, timestamp));
  file_.write(channels_.poses, time, poses.bytes());
}

}  // namespace

std::unique_ptr<SpaceExport> export_mcap(OutputFile& file, const avo::space::Scenario& scene) {
  return std::make_unique<SpaceMcap>(file, scene);
}

}  // namespace avo_io
