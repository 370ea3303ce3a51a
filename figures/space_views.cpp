// SPDX-License-Identifier: Apache-2.0
#include "figures/space_views.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "figures/hull.h"

namespace avo::figures {
namespace {

/// The two numbers of a place that a view shows.
using View = Vec2 (*)(Vec3);
Vec2 from_above(Vec3 a) {
  return {a.x, a.y};
}
Vec2 from_the_side(Vec3 a) {
  return {a.x, a.z};
}

/// The part of space that robots and goals are in, with some room around it.
struct Extent {
  Vec3 low, high;
};
Extent extent_of(const space::Scenario& scenario, const std::vector<SpaceRecorder::Frame>& frames) {
  const Vec3 first = scenario.robots.front().goal;
  Extent extent{first, first};
  double radius = 0.0;
  const auto take = [&extent](Vec3 a) {
    extent.low = {std::min(extent.low.x, a.x), std::min(extent.low.y, a.y),
                  std::min(extent.low.z, a.z)};
    extent.high = {std::max(extent.high.x, a.x), std::max(extent.high.y, a.y),
                   std::max(extent.high.z, a.z)};
  };
  for (const space::RobotSetup& robot : scenario.robots) {
    take(robot.goal);
    radius = std::max(radius, robot.radius);
  }
  for (const space::MovingObstacle& mover : scenario.moving_obstacles)
    radius = std::max(radius, mover.radius);
  for (const SpaceRecorder::Frame& frame : frames) {
    std::for_each(frame.position.begin(), frame.position.end(), take);
    std::for_each(frame.mover.begin(), frame.mover.end(), take);
  }
  const auto finite = [](double bound, double otherwise) {
    return std::isfinite(bound) ? bound : otherwise;
  };
  for (const space::Box& box : scenario.boxes) {
    const double c = std::cos(box.heading), s = std::sin(box.heading);
    for (const Vec3& bound : {box.min, box.max}) {
      const bool is_flat = std::isfinite(bound.x) && std::isfinite(bound.y);
      take({is_flat ? c * bound.x - s * bound.y : first.x,
            is_flat ? s * bound.x + c * bound.y : first.y, finite(bound.z, first.z)});
    }
  }
  const Vec3 room{2.0 * radius, 2.0 * radius, 2.0 * radius};
  return {extent.low - room, extent.high + room};
}

// The corners of a box in space, cut off far outside of the extent.
std::array<Vec3, 8> corners_of(const space::Box& box, const Extent& extent) {
  const double c = std::cos(box.heading), s = std::sin(box.heading);
  const double far = norm(extent.high - extent.low) + norm(extent.low) + norm(extent.high);
  const auto cut = [](double x, double low, double high) { return std::clamp(x, low, high); };
  std::array<Vec3, 8> corners;
  for (std::size_t k = 0; k < 8; ++k) {
    const double x = cut(k % 2 == 0 ? box.min.x : box.max.x, -far, far);
    const double y = cut(k / 2 % 2 == 0 ? box.min.y : box.max.y, -far, far);
    const double z = k / 4 == 0 ? box.min.z : box.max.z;
    corners[k] = {cut(c * x - s * y, extent.low.x, extent.high.x),
                  cut(s * x + c * y, extent.low.y, extent.high.y),
                  cut(z, extent.low.z, extent.high.z)};
  }
  return corners;
}

// A box that covers all that a view shows hides everything: a floor from above.
bool covers(const std::vector<Vec2>& outline, Vec2 low, Vec2 high) {
  return outline.size() == 4 && std::all_of(outline.begin(), outline.end(), [&](Vec2 a) {
           return (a.x == low.x || a.x == high.x) && (a.y == low.y || a.y == high.y);
         });
}

TracedRun traced(const space::Scenario& scenario, const std::vector<SpaceRecorder::Frame>& frames,
                 const Extent& extent, const char* title, View view) {
  TracedRun run;
  run.title = title;
  run.scenario.name = scenario.name;
  run.scenario.time_step = scenario.time_step;
  run.scenario.duration = scenario.duration;
  for (const space::RobotSetup& robot : scenario.robots) {
    RobotSetup disc;
    disc.position = view(robot.position);
    disc.goal = view(robot.goal);
    disc.radius = robot.radius;
    disc.max_speed = robot.max_speed;
    disc.preferred_speed = robot.preferred_speed;
    run.scenario.robots.push_back(disc);
  }
  for (const space::MovingObstacle& mover : scenario.moving_obstacles)
    run.scenario.moving_obstacles.push_back(
        {.position = view(state_at(mover, 0.0).position), .radius = mover.radius});
  for (const space::Box& box : scenario.boxes) {
    std::vector<Vec2> points;
    for (const Vec3& corner : corners_of(box, extent)) points.push_back(view(corner));
    const std::vector<Vec2> outline = convex_hull(std::move(points));
    if (outline.empty() || covers(outline, view(extent.low), view(extent.high))) continue;
    const bool is_area = outline.size() > 2;
    run.scenario.obstacles.push_back({.chains = {{outline, is_area}},
                                      .radius = box.radius,
                                      .fill = is_area ? Fill::solid : Fill::none});
  }
  for (const SpaceRecorder::Frame& frame : frames) {
    TrajectoryFrame& shown = run.frames.emplace_back();
    shown.time = frame.time;
    for (const Vec3& place : frame.position) shown.position.push_back(view(place));
    for (const Vec3& place : frame.mover) shown.mover_position.push_back(view(place));
  }
  return run;
}

}  // namespace

void SpaceRecorder::observe(const space::Simulation& simulation) {
  latest_.time = simulation.time();
  latest_.position.clear();
  latest_.mover.clear();
  for (const space::Robot& robot : simulation.robots()) latest_.position.push_back(robot.position);
  for (const space::Mover& mover : simulation.movers()) latest_.mover.push_back(mover.position);
  if (observed_++ % stride_ != 0) return;
  kept_.push_back(latest_);
  if (kept_.size() < most_frames_) return;
  std::vector<Frame> half;
  for (std::size_t k = 0; k < kept_.size(); k += 2) half.push_back(std::move(kept_[k]));
  kept_ = std::move(half);
  stride_ *= 2;
}

std::vector<SpaceRecorder::Frame> SpaceRecorder::frames() const {
  std::vector<Frame> frames = kept_;
  if (!frames.empty() && frames.back().time != latest_.time) frames.push_back(latest_);
  return frames;
}

std::string draw_views(const space::Scenario& scenario,
                       const std::vector<SpaceRecorder::Frame>& frames, const std::string& path,
                       FigureOptions options) {
  const Extent extent = extent_of(scenario, frames);
  std::array<TracedRun, 2> views{
      traced(scenario, frames, extent, "plan: x, y", from_above),
      traced(scenario, frames, extent, "elevation: x, z", from_the_side)};
  views[1].like_first = true;
  options.y_label = "y, z (m)";
  return draw_side_by_side(views, path, options);
}

std::vector<Vec2> ViewsInPlane::places(const std::vector<Vec3>& positions) const {
  std::vector<Vec2> all;
  for (const Vec3& place : positions) all.push_back(from_above(place));
  for (const Vec3& place : positions) all.push_back(from_the_side(place) + shift);
  return all;
}

std::vector<bool> ViewsInPlane::twice(const std::vector<bool>& flags) {
  std::vector<bool> all = flags;
  all.insert(all.end(), flags.begin(), flags.end());
  return all;
}

ViewsInPlane views_in_plane(const space::Scenario& scenario,
                            const std::vector<SpaceRecorder::Frame>& frames) {
  constexpr double kGap = 0.1;  // of the width of a view
  const Extent extent = extent_of(scenario, frames);
  ViewsInPlane views;
  views.scenario = traced(scenario, {}, extent, "", from_above).scenario;
  Scenario side = traced(scenario, {}, extent, "", from_the_side).scenario;
  const Vec3 sum = extent.low + extent.high;
  views.shift = {(1.0 + kGap) * (extent.high.x - extent.low.x), 0.5 * (sum.y - sum.z)};
  for (RobotSetup& robot : side.robots) {
    robot.position = robot.position + views.shift;
    robot.goal = robot.goal + views.shift;
    views.scenario.robots.push_back(robot);
  }
  for (StaticObstacle& obstacle : side.obstacles) {
    for (Chain& chain : obstacle.chains)
      for (Vec2& point : chain.points) point = point + views.shift;
    views.scenario.obstacles.push_back(obstacle);
  }
  for (MovingObstacle& mover : side.moving_obstacles) {
    mover.position = mover.position + views.shift;
    views.scenario.moving_obstacles.push_back(mover);
  }
  return views;
}

std::vector<Vec3> movers_at(const space::Scenario& scenario, double time) {
  std::vector<Vec3> places;
  for (const space::MovingObstacle& mover : scenario.moving_obstacles)
    places.push_back(state_at(mover, time).position);
  return places;
}

}  // namespace avo::figures
