// SPDX-License-Identifier: Apache-2.0
// Exports as MCAP: discs, velocities and walls for Foxglove's 3D panel, and poses.
#include <algorithm>
#include <cmath>
#include <fmt/format.h>

#include "avo/discs.h"
#include "avo_io/errors.h"
#include "io/export/foxglove.h"
#include "io/export/mcap_file.h"
#include "io/export/protobuf.h"
#include "io/export/target.h"
#include "io/recording/mover_walk.h"

namespace avo_io {
namespace {

using avo::Vec2;

constexpr double kHeight = 0.2;           // m, of robots and walls, which stand on z = 0
constexpr double kLeastThickness = 0.02;  // m, of lines, so that they are visible

/// Red, green, blue.
struct Paint {
  double r, g, b;
};
constexpr Paint kRobotPaint{0.12, 0.47, 0.71}, kWallPaint{0.3, 0.3, 0.3},
    kMoverPaint{0.84, 0.15, 0.16};

std::string color_of(const Paint& paint) {
  return numbers_of({paint.r, paint.g, paint.b, 1.0});
}

/// Returns a pose. `face` has length 1; the half-angle formulas give the quaternion of its angle
/// about z.
std::string pose_of(Vec2 position, double z, Vec2 face) {
  ProtoBytes orientation;
  orientation.number(3, std::copysign(std::sqrt(std::max(0.5 * (1.0 - face.x), 0.0)), face.y));
  orientation.number(4, std::sqrt(std::max(0.5 * (1.0 + face.x), 0.0)));
  ProtoBytes pose;
  pose.text(1, numbers_of({position.x, position.y, z}));
  pose.text(2, orientation.bytes());
  return pose.bytes();
}

std::string cylinder_of(Vec2 center, double radius, const Paint& paint) {
  ProtoBytes cylinder;
  cylinder.text(1, pose_of(center, 0.5 * kHeight, {1.0, 0.0}));
  cylinder.text(2, numbers_of({2.0 * radius, 2.0 * radius, kHeight}));
  cylinder.number(3, 1.0);
  cylinder.number(4, 1.0);
  cylinder.text(5, color_of(paint));
  return cylinder.bytes();
}

std::string line_of(const avo::Chain& chain, double radius) {
  ProtoBytes line;
  line.whole(1, chain.closed ? 1 : 0);  // LINE_LOOP, LINE_STRIP
  line.text(2, pose_of({}, 0.0, {1.0, 0.0}));
  line.number(3, std::max(2.0 * radius, kLeastThickness));
  for (const Vec2 point : chain.points) line.text(5, numbers_of({point.x, point.y, 0.0}));
  line.text(6, color_of(kWallPaint));
  return line.bytes();
}

/// Returns a moving disc: a cylinder, and an arrow unless the disc is at rest.
std::string disc_of(ProtoBytes entity, Vec2 center, Vec2 velocity, double radius,
                    const Paint& paint) {
  if (const double speed = norm(velocity); speed > kAtRest)
    entity.text(7, arrow_of(pose_of(center, kHeight, velocity / speed), speed, radius));
  entity.text(10, cylinder_of(center, radius, paint));
  return entity.bytes();
}

class McapExport final : public ExportTarget {
 public:
  McapExport(OutputFile& file, const avo::Scenario& scenario);
  void add(const ExportedTime& moment) override;
  void finish(double /*fps*/) override { file_.finish(); }

 private:
  [[nodiscard]] std::string robot_of(const avo::CheckedState& row,
                                     const std::string& timestamp) const;
  [[nodiscard]] std::string robots_of(const RecordedTime& moment, const std::string& timestamp);
  [[nodiscard]] std::string walls(const std::string& timestamp) const;
  [[nodiscard]] std::string movers_of(const RecordedTime& moment, const std::string& timestamp);

  const avo::Scenario& scenario_;
  McapFile file_;
  MoverWalk walk_;
  FoxgloveChannels channels_;
  std::uint16_t movers_ = 0;  // their channel; 0: there are none
  bool begun_ = false;
  std::vector<std::int64_t> there_;  // robots of the time before
};

McapExport::McapExport(OutputFile& file, const avo::Scenario& scenario)
    : scenario_(scenario), file_(file), walk_(scenario), channels_(add_foxglove_channels(file_)) {
  if (!scenario.moving_obstacles.empty())
    movers_ = file_.add_channel("/moving_obstacles", channels_.scene_update);
}

std::string McapExport::walls(const std::string& timestamp) const {
  ProtoBytes update;
  for (std::size_t k = 0; k < scenario_.obstacles.size(); ++k) {
    const avo::StaticObstacle& obstacle = scenario_.obstacles[k];
    ProtoBytes entity = entity_of(timestamp, fmt::format("{}", k));
    for (const avo::Chain& chain : obstacle.chains)
      if (chain.points.size() == 1)
        entity.text(10, cylinder_of(chain.points[0], obstacle.radius, kWallPaint));
    for (const avo::Chain& chain : obstacle.chains)
      if (chain.points.size() > 1) entity.text(11, line_of(chain, obstacle.radius));
    update.text(2, entity.bytes());
  }
  return update.bytes();
}

std::string McapExport::robot_of(const avo::CheckedState& row, const std::string& timestamp) const {
  const avo::RobotSetup& setup = scenario_.robots[static_cast<std::size_t>(row.robot)];
  ProtoBytes entity = entity_of(timestamp, fmt::format("{}", row.robot));
  if (!row.heading)
    return disc_of(entity, row.position, row.velocity, disc_radius(setup), kRobotPaint);
  const std::vector<avo::Disc> discs = discs_at(setup, row.position, row.heading->angle);
  for (std::size_t k = 0; k + 1 < discs.size(); ++k)
    entity.text(10, cylinder_of(discs[k].center, discs[k].radius, kRobotPaint));
  return disc_of(entity, discs.back().center, row.velocity, discs.back().radius, kRobotPaint);
}

// Returns the moving obstacles. Recordings have no rows of them: their scene tells their places.
std::string McapExport::movers_of(const RecordedTime& moment, const std::string& timestamp) {
  try {
    walk_.go_to(moment.time);
    if (moment.every > 1 && moment.time > 0.0) walk_.require_known(moment.time);
  } catch (const avo::Error& error) {
    throw RecordingError(error.what());
  }
  ProtoBytes update;
  for (std::size_t k = 0; k < scenario_.moving_obstacles.size(); ++k)
    update.text(2, disc_of(entity_of(timestamp, fmt::format("{}", k)), walk_.position(k),
                           walk_.velocity(k), scenario_.moving_obstacles[k].radius, kMoverPaint));
  return update.bytes();
}

// Returns the robots, and deletes robots that are no longer present.
std::string McapExport::robots_of(const RecordedTime& moment, const std::string& timestamp) {
  std::vector<std::int64_t> there;
  for (const avo::CheckedState& row : moment.rows) there.push_back(row.robot);
  ProtoBytes update;
  for (const std::int64_t robot : there_) {
    if (std::binary_search(there.begin(), there.end(), robot)) continue;
    ProtoBytes deletion;
    deletion.text(1, timestamp);
    deletion.text(3, fmt::format("{}", robot));
    update.text(1, deletion.bytes());
  }
  for (const avo::CheckedState& row : moment.rows) update.text(2, robot_of(row, timestamp));
  there_ = std::move(there);
  return update.bytes();
}

void McapExport::add(const ExportedTime& moment) {
  const std::uint64_t time = nanoseconds_of(moment.recorded.time);
  const std::string timestamp = timestamp_of(time);
  if (!begun_) file_.write(channels_.walls, time, walls(timestamp));
  begun_ = true;
  file_.write(channels_.robots, time, robots_of(moment.recorded, timestamp));
  if (movers_ != 0) file_.write(movers_, time, movers_of(moment.recorded, timestamp));
  ProtoBytes poses;
  poses.text(1, timestamp);
  poses.text(2, kFrameId);
  for (std::size_t k = 0; k < moment.recorded.rows.size(); ++k)
    poses.text(3, pose_of(moment.recorded.rows[k].position, 0.0, moment.faces[k]));
  file_.write(channels_.poses, time, poses.bytes());
}

}  // namespace

std::unique_ptr<ExportTarget> export_mcap(const ExportPlace& place, const avo::Scenario& scenario) {
  return std::make_unique<McapExport>(place.file, scenario);
}

}  // namespace avo_io
