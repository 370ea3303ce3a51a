// SPDX-License-Identifier: Apache-2.0
// Set points of quadrotors for their autopilots, made of the references that a run recorded.
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <fmt/format.h>
#include <string>
#include <vector>

#include "avo/error.h"
#include "avo/space/autopilots.h"
#include "avo_io/output_file.h"
#include "avo_io/space.h"
#include "io/recording/csv_lines.h"
#include "io/space/space_rows.h"

namespace avo_io {
namespace {

using avo::Vec3;
using avo::space::CheckedState;
using avo::space::Filter;
using avo::space::Scenario;
using avo::space::SetPoint;

constexpr const char* kHeader = "time,robot,x,y,z,vx,vy,vz,ax,ay,az\n";
constexpr const char* kPx4Header =
    "timestamp,robot,position[0],position[1],position[2],velocity[0],velocity[1],velocity[2],"
    "acceleration[0],acceleration[1],acceleration[2],jerk[0],jerk[1],jerk[2],yaw,yawspeed\n";
constexpr const char* kCrazyflieHeader =
    "time,robot,x,y,z,vx,vy,vz,ax,ay,az,qx,qy,qz,qw,rollrate,pitchrate,yawrate\n";
constexpr double kMostRate = 1e4;  // Hz
constexpr double kOff = 1e-6;      // m, because those of positions may be

std::vector<Filter> filters_of(const Scenario& scene) {
  const double delay = fleet_delay(scene);
  std::vector<Filter> filters;
  for (const avo::space::RobotSetup& robot : scene.robots) {
    if (!robot.quadrotor)
      throw avo::Error(
          fmt::format("robots.{}: found no quadrotor, must have one: set points are of quadrotors",
                      filters.size()));
    filters.emplace_back(limits_of(*robot.quadrotor), delay, scene.time_step);
  }
  return filters;
}

void append(const Vec3& vector, std::string& line) {
  for (const double x : {vector.x, vector.y, vector.z}) {
    line += ',';
    append_number(x, line);
  }
}

template <std::size_t Size>
void append(const std::array<float, Size>& numbers, std::string& line) {
  for (const float x : numbers) line += fmt::format(",{}", x);
}

// A row after its robot.
template <typename Point>
void append_motion(const Point& point, std::string& line) {
  append(point.position, line);
  append(point.velocity, line);
  append(point.acceleration, line);
}

std::string row_of(const SetPoint& point, double time, std::size_t robot, Autopilot autopilot) {
  std::string line;
  if (autopilot == Autopilot::px4) {
    const avo::space::Px4SetPoint own = px4_set_point(point, time);
    line = fmt::format("{},{}", own.timestamp, robot);
    append_motion(own, line);
    append(own.jerk, line);
    return line + fmt::format(",{},{}\n", own.yaw, own.yawspeed);
  }
  line = fmt::format("{},{}", csv_time(time), robot);
  if (autopilot == Autopilot::any) {
    append_motion(point, line);
    return line + '\n';
  }
  const avo::space::CrazyflieSetPoint own = crazyflie_set_point(point);
  append_motion(own, line);
  append(own.orientation, line);
  return line + fmt::format(",{},{},{}\n", own.roll_rate, own.pitch_rate, own.yaw_rate);
}

const char* header_of(Autopilot autopilot) {
  if (autopilot == Autopilot::px4) return kPx4Header;
  return autopilot == Autopilot::crazyflie ? kCrazyflieHeader : kHeader;
}

/// Writes set points at even times.
struct SetPointWriter {
  OutputFile file;
  double rate;  // Hz
  Autopilot autopilot;
  std::int64_t count = 0;  // of times
  std::string lines = {};

  [[nodiscard]] std::string row(const SetPoint& point, double time, std::size_t robot) const {
    try {
      return row_of(point, time, robot, autopilot);
    } catch (const avo::Error& error) {
      throw avo::Error(fmt::format("robot {} at {} s: {}", robot, csv_time(time), error.what()));
    }
  }

  // All set points from the last written one to that time, s.
  void write_until(double time, const std::vector<Filter>& filters) {
    for (;; ++count) {
      const double now = static_cast<double>(count) / rate;
      if (now > time) return;
      lines.clear();
      for (std::size_t k = 0; k < filters.size(); ++k) lines += row(filters[k].at(now), now, k);
      file.write(lines);
    }
  }
};

// Refuses rows that are not the references of the scene, step by step.
void check_moment(const SpaceRows& rows, const SpaceMoment& moment, std::int64_t step,
                  const Scenario& scene) {
  const double expected = static_cast<double>(step) * scene.time_step;
  if (!(std::abs(moment.time - expected) <= kOfStep * scene.time_step))
    rows.fail(fmt::format("found the time {} s, must be {} s: every step of the scene", moment.time,
                          expected));
  for (std::size_t k = 0; k < moment.rows.size(); ++k) {
    if (moment.rows[k].robot != static_cast<std::int64_t>(k))
      rows.fail(fmt::format("found robot {}, must be {}", moment.rows[k].robot, k));
  }
  if (moment.rows.size() != scene.robots.size())
    rows.fail(fmt::format("found {} robots, must be {}, those of the scene", moment.rows.size(),
                          scene.robots.size()));
}

// The acceleration that leads from one row to the next one.
Vec3 held_acceleration(const SpaceRows& rows, const CheckedState& from, const CheckedState& to,
                       double duration) {
  const double off =
      norm(to.position - from.position - (0.5 * duration) * (from.velocity + to.velocity));
  if (!(off <= kOff))
    rows.fail(
        fmt::format("found robot {} {:.3g} m off its velocities, must be {} m at most: its "
                    "acceleration was not held",
                    to.robot, off, kOff));
  return (to.velocity - from.velocity) / duration;
}

}  // namespace

std::int64_t write_set_points(const std::string& recording, const std::string& output,
                              const Scenario& scene, double rate, Autopilot autopilot) {
  if (!(rate > 0.0 && rate <= kMostRate))
    throw avo::Error(fmt::format("rate: found {}, must be > 0 and <= {} Hz", rate, kMostRate));
  std::vector<Filter> filters = filters_of(scene);
  SpaceRows rows(recording);
  SetPointWriter writer{OutputFile(output), rate, autopilot};
  writer.file.write(header_of(autopilot));
  std::vector<CheckedState> before;
  double last = 0.0;  // s
  for (std::int64_t step = 0; const SpaceMoment* moment = rows.next(); ++step) {
    check_moment(rows, *moment, step, scene);
    if (step > 0) {
      // the set points before this time, since the filters only know the last steps
      writer.write_until(last - kOfStep * scene.time_step, filters);
      for (std::size_t k = 0; k < filters.size(); ++k) {
        const Vec3 a = held_acceleration(rows, before[k], moment->rows[k], scene.time_step);
        filters[k].add(before[k].position, before[k].velocity, a);
      }
    }
    before = moment->rows;
    last = static_cast<double>(step) * scene.time_step;
  }
  if (!(last > 0.0)) rows.fail("found one time at most, must be two at least");
  writer.write_until(last, filters);
  writer.file.commit();
  return writer.count * static_cast<std::int64_t>(filters.size());
}

}  // namespace avo_io
