// SPDX-License-Identifier: Apache-2.0
// Set points of quadrotors for their autopilots, made of the references that a run recorded.
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <fmt/format.h>
#include <string>
#include <vector>

#include "avo/error.h"
#include "avo/space/quadrotor.h"
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

/// Writes set points at even times.
struct SetPointWriter {
  OutputFile file;
  double rate;             // Hz
  std::int64_t count = 0;  // of times
  std::string lines = {};

  // All set points from the last written one to that time, s.
  void write_until(double time, const std::vector<Filter>& filters) {
    for (;; ++count) {
      const double now = static_cast<double>(count) / rate;
      if (now > time) return;
      const std::string text = csv_time(now);
      lines.clear();
      for (std::size_t k = 0; k < filters.size(); ++k) {
        const SetPoint point = filters[k].at(now);
        lines += fmt::format("{},{}", text, k);
        for (const Vec3& vector : {point.position, point.velocity, point.acceleration}) {
          for (const double x : {vector.x, vector.y, vector.z}) {
            lines += ',';
            append_number(x, lines);
          }
        }
        lines += '\n';
      }
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
                              const Scenario& scene, double rate) {
  if (!(rate > 0.0 && rate <= kMostRate))
    throw avo::Error(fmt::format("rate: found {}, must be > 0 and <= {} Hz", rate, kMostRate));
  std::vector<Filter> filters = filters_of(scene);
  SpaceRows rows(recording);
  SetPointWriter writer{OutputFile(output), rate};
  writer.file.write(kHeader);
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
