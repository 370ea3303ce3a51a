// SPDX-License-Identifier: Apache-2.0
#include "certificate/trajectory_steps.h"

#include <algorithm>

#include "core/plane.h"
#include "core/timed_places.h"
#include "walls/segment.h"

namespace avo::inline certificate {
void TrajectorySteps::reserve(std::size_t intervals) {
  if (bend.size() >= intervals + 1 + kConstraintLanes) return;  // this column grows last
  for (std::vector<double>* column : {&x, &y, &bend})
    column->resize(intervals + 1 + kConstraintLanes);
}

void TrajectorySteps::begin(const Trajectory& trajectory, double now, Vec2 origin,
                            double time_step) {
  trajectory_ = &trajectory, now_ = now, origin_ = origin, time_step_ = time_step;
  reserve(1);
  ahead_ = first_later(trajectory.places(), now);
  const Vec2 start = place_on(trajectory, ahead_, now) - origin;
  x[0] = start.x, y[0] = start.y;
  known_ = 0;
}

void TrajectorySteps::look_ahead(std::size_t intervals) {
  const std::span<const TimedPlace> places = trajectory_->places();
  reserve(intervals);
  for (; known_ < intervals; ++known_) {
    const double begin = now_ + time_step_ * static_cast<double>(known_);
    const double end = now_ + time_step_ * static_cast<double>(known_ + 1);
    const std::size_t first = ahead_;
    while (ahead_ < places.size() && places[ahead_].time <= end) ++ahead_;
    const Vec2 from = place(known_), to = place_on(*trajectory_, ahead_, end) - origin_;
    double most = 0.0;
    for (std::size_t k = first; k < ahead_; ++k) {
      const double part = (places[k].time - begin) / (end - begin);
      most = std::max(most, norm(places[k].position - origin_ - (from + part * (to - from))));
    }
    if (ahead_ == places.size() && trajectory_->repeats_from())
      most += norm(to - from) + trajectory_->round();
    x[known_ + 1] = to.x, y[known_ + 1] = to.y;
    bend[known_] = most;
  }
}

bool passes_by(const Trajectory& trajectory, double from, Vec2 place, double distance) {
  const std::span<const TimedPlace> places = trajectory.places();
  if (trajectory.repeats_from()) from = std::min(from, *trajectory.repeats_from());
  const double fastest = trajectory.max_speed(from);
  Vec2 start = trajectory.at(from) - place;
  for (std::size_t k = first_later(places, from); k < places.size();) {
    const Vec2 end = places[k].position - place;
    if (avo::distance(Vec2{}, Segment{start, end}) < distance) return false;
    std::size_t next = k + 1;
    if (fastest > 0.0) {
      // until then no leg comes that near, so that most legs need no test
      const double clear_until = places[k].time + (norm(end) - distance) / fastest;
      next = first_later(places, clear_until, next);
    }
    start = places[next - 1].position - place;
    k = next;
  }
  if (norm(start) < distance) return false;
  if (trajectory.repeats_from() || places.size() == 1) return true;
  // after the last place the mover goes on as before it
  const Vec2 v = places.back().position - places[places.size() - 2].position;
  const double squared = norm_squared(v), along = is_rest(v) ? 0.0 : -dot(start, v);
  return !(along > 0.0) || norm(start + (along / squared) * v) >= distance;
}

}  // namespace avo::inline certificate
