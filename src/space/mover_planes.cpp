// SPDX-License-Identifier: Apache-2.0
#include "space/mover_planes.h"

#include "avo/half_plane.h"
#include "planner/rules/margin.h"
#include "space/frame.h"

namespace avo::space {

void append_mover_planes(const Robot& robot, std::span<const Mover> movers,
                         const PlannerOptions& options, const Horizon& horizon,
                         std::vector<HalfSpace>& half_spaces) {
  const double margin =
      margin_on_route(mover_margin(options, robot.radius), robot.radius, robot.distance_to_goal);
  for (const Mover& mover : movers) {
    const Vec3 p = robot.position - mover.position;
    if (p == Vec3{}) continue;
    const PairFrame frame = frame_of(p, robot.velocity - mover.velocity);
    const double contact = robot.radius + mover.radius;
    const avo::Pair pair{{frame.distance, 0.0},
                         frame.velocity,
                         contact + margin_in_gap(margin, frame.distance - contact)};
    const double reach = options.control_time * (robot.max_acceleration + norm(mover.acceleration));
    const RelativeHalfPlane relative = half_plane(pair, reach, horizon);
    if (relative.state == PairState::free || relative.state == PairState::coincident) continue;
    const Vec3 normal = turned_back(frame, relative.plane.normal);
    const Vec3 goes_on = robot.velocity + options.control_time * mover.acceleration;
    half_spaces.push_back({normal, dot(normal, goes_on) + relative.plane.offset});
  }
}

}  // namespace avo::space
