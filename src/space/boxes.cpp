// SPDX-License-Identifier: Apache-2.0
#include "space/boxes.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "planner/stages/demands.h"
#include "space/certificate.h"
#include "space/own_space.h"

namespace avo::space {
namespace {

double finite(double bound) {
  return std::isfinite(bound) ? std::abs(bound) : 0.0;
}

// m/s: the highest speed of the robot in any direction.
double top_speed(const Robot& robot) {
  return robot.max_speed * std::max(robot.vertical, 1.0);
}

// The number of steps in which a robot stops, and the lengths of its body and of stopping, m.
struct Stopping {
  double steps, lengths;
};
Stopping stopping_of(const Robot& robot, const StepLaw& law) {
  const double own = std::max(own_length(robot.velocity, robot.vertical), robot.max_speed);
  const BrakingProfile braking = braking_profile(own, braking_limit(robot) * law.braking_time);
  const double ratio = std::max(robot.vertical, 1.0);
  return {braking.full_steps + 2.0,
          robot.radius + ratio * (law.time_step * own + stopping_length(braking, law))};
}

// docs/space.md, "Rounding beside boxes".
double margin_of(const Robot& robot, const Box& box, const Stopping& stopping) {
  const double size = std::max(finite(box.min.x), finite(box.max.x)) +
                      std::max(finite(box.min.y), finite(box.max.y)) +
                      std::max(finite(box.min.z), finite(box.max.z));
  const double place =
      std::abs(robot.position.x) + std::abs(robot.position.y) + std::abs(robot.position.z);
  return 0x1p-46 * stopping.steps * (2.0 * (size + place) + 8.0 * (box.radius + stopping.lengths));
}

// m: where a robot of that velocity comes to rest, from its place.
Vec3 stopping_vector(const Robot& robot, Vec3 velocity, const StepLaw& law) {
  const Braking braking =
      braking_of(velocity, robot.max_acceleration, braking_limit(robot), robot.vertical, law);
  return braking.length * braking.direction;
}

// The candidate's path: p, the end of its step, and the end of braking from there.
struct Path {
  Vec3 start, middle, first, end;
};
Path path_of(const Robot& robot, Vec3 next_velocity, const StepLaw& law,
             const BoxConstraints& constraints) {
  const Vec3 first = constraints.middle + (law.time_step - law.lag) * next_velocity;
  return {robot.position, constraints.middle, first,
          first + stopping_vector(robot, next_velocity, law)};
}

// m: how far the middle point of the step is from the segment of its ends. No point of the triangle
// is farther, as that distance is convex.
double height_of(const Path& path) {
  const Vec3 chord = path.first - path.start, middle = path.middle - path.start;
  const double squared = norm_squared(chord);
  const double part = squared > 0.0 ? std::clamp(dot(middle, chord) / squared, 0.0, 1.0) : 0.0;
  return norm(middle - part * chord);
}

// m: where the chord keeps so much, no point inside of the step's triangle is nearer to the box
// than `least`. The box may be elsewhere by `lost`.
double kept_by_chord(const Path& path, double least, double lost) {
  const double height = height_of(path), true_least = least - lost;
  return std::sqrt(true_least * true_least + height * height) + lost;
}

// Whether no point of the step's triangle is nearer to the box than `least`, where its sides are
// not.
bool keeps_inside(const Path& path, const NearestToBox& chord, double least, double lost) {
  if (chord.distance > 0.0) {
    const Vec3 normal = (chord.on_segment - chord.on_box) / chord.distance;
    if (dot(normal, path.middle - chord.on_box) >= least) return true;
  }
  return chord.distance >= kept_by_chord(path, least, lost);
}

/// The part of a path that comes too near to a box, and where.
struct TooNear {
  NearestToBox at;
  double least = 0.0;   ///< m, that it has to keep
  bool brakes = false;  ///< the part is the braking after the step
};

// Returns whether each point of the path is at least as far from the box as the point of braking at
// the same time. It holds for all possible places of the robot (docs/certificate/walls.md, "Errors
// of one's own place").
bool leaves_box(const NearBox& near, const Path& path, const BoxConstraints& boxes) {
  if (!(near.cone < 1.0)) return false;
  const auto gained = [&](Vec3 from_braking) {
    return dot(near.normal, from_braking) - near.cone * norm(from_braking);
  };
  return gained(path.first - boxes.first) >= near.margin &&
         gained(path.end - boxes.stop) >= near.margin;
}

// docs/space.md, "Boxes", (a), (b), (b').
std::optional<TooNear> too_near(const NearBox& near, const Path& path,
                                const BoxConstraints& boxes) {
  if (leaves_box(near, path, boxes)) return std::nullopt;
  const double after = near.held + near.margin, within = near.held + 0.5 * near.margin;
  const NearestToBox braking = nearest(path.first, path.end, near.box);
  if (!(braking.distance >= after)) return TooNear{braking, after, true};
  const NearestToBox chord = nearest(path.start, path.first, near.box);
  if (!(chord.distance >= within)) return TooNear{chord, within, false};
  const NearestToBox side = nearest(path.middle, path.first, near.box);
  if (!(side.distance >= within)) return TooNear{side, within, false};
  if (!keeps_inside(path, chord, within, near.lost))
    return TooNear{chord, kept_by_chord(path, within, near.lost), false};
  return std::nullopt;
}

// A half-space in the robot's own space: the tangent of the distance, docs/certificate/walls.md.
std::optional<HalfSpace> cut_of(const Robot& robot, const TooNear& worst, Vec3 next_velocity,
                                const StepLaw& law) {
  if (!(worst.at.distance > 0.0)) return std::nullopt;
  const Vec3 normal = (worst.at.on_segment - worst.at.on_box) / worst.at.distance;
  const double step = law.time_step - law.lag, part = worst.at.part;
  const Vec3 own_normal = from_own(normal, robot.vertical);
  const Vec3 v = to_own(next_velocity, robot.vertical);
  Vec3 gradient = (worst.brakes ? step : part * step) * own_normal;
  if (worst.brakes) {
    const Braking braking = braking_of(next_velocity, robot.max_acceleration, braking_limit(robot),
                                       robot.vertical, law);
    const double speed = norm(v);
    const Vec3 direction = speed > 0.0 ? v / speed : Vec3{};
    const double across =
        part * (braking.profile.speed > 0.0 ? braking.length / braking.profile.speed : law.lag);
    const double along = part * (law.time_step * braking.profile.full_steps + law.lag);
    gradient = gradient + across * own_normal +
               ((along - across) * dot(own_normal, direction)) * direction;
  }
  const double length = norm(gradient);
  if (!(length > 0.0)) return std::nullopt;
  const double missing = worst.least - worst.at.distance;
  return HalfSpace{gradient / length, (dot(gradient, v) + missing) / length};
}

// A half-space in the robot's own space, in which most velocities leave the box.
HalfSpace cut_towards(const Robot& robot, const NearBox& near, Vec3 next_velocity,
                      const StepLaw& law, const BoxConstraints& boxes) {
  constexpr double kMoreThanRounding = 1.0 + 0x1p-20;
  const double least =
      near.cone * norm(next_velocity - boxes.backup) + near.margin / (law.time_step - law.lag);
  const double offset = dot(near.normal, boxes.backup) + kMoreThanRounding * least;
  return to_own(HalfSpace{near.normal, offset}, robot.vertical);
}

// The distance held by a robot that does not know exactly where it is. Within the error, braking is
// assumed to keep clear, as it does if it has done so before.
void hold_lost(NearBox& near, const NearestToBox& braking, double contact, double lost) {
  near.held = contact + lost, near.lost = lost;
  if (!(braking.distance > 0.0)) return;
  near.normal = (braking.on_segment - braking.on_box) / braking.distance;
  near.cone = 2.0 * lost / (contact + braking.distance);
}

}  // namespace

double box_reach(const Robot& robot, const StepLaw& law) {
  return stopping_of(robot, law).lengths;
}

void begin_boxes(const Robot& robot, std::span<const Box> boxes, const StepLaw& law,
                 BoxConstraints& constraints) {
  constraints.near.clear();
  constraints.broken = constraints.tight = {};
  constraints.must_brake = constraints.doubtful = false;
  if (boxes.empty()) return;
  constraints.middle = robot.position + law.lag * robot.velocity;
  constraints.stop = robot.position + stopping_vector(robot, robot.velocity, law);
  constraints.backup = backup_velocity(robot, law);
  constraints.first = constraints.middle + (law.time_step - law.lag) * constraints.backup;
  const double lost = law.localization_error;
  Stopping stopping = stopping_of(robot, law);
  stopping.lengths += lost;
  for (std::size_t k = 0; k < boxes.size(); ++k) {
    const Box& box = boxes[k];
    const double contact = robot.radius + box.radius;
    const double margin = margin_of(robot, box, stopping);
    const double away = nearest(robot.position, robot.position, box).distance;
    if (!(away <= box.radius + margin + stopping.lengths)) continue;
    NearBox near{box, contact, margin};
    // the center is in the box: there is no side to keep, and nothing is deeper
    if (!(away > 0.0)) {
      constraints.broken.take(static_cast<int>(k), contact);
      constraints.tight.take(static_cast<int>(k), contact + margin);
      continue;
    }
    const NearestToBox braking = nearest(robot.position, constraints.stop, box);
    const double kept = braking.distance;
    if (lost > 0.0 && kept >= contact - lost)
      hold_lost(near, braking, contact, lost);
    else if (kept < contact + 0.5 * margin)
      near.held = kept, near.margin = 0.0;
    constraints.doubtful = constraints.doubtful || (lost > 0.0 && kept < contact + lost);
    constraints.broken.take(static_cast<int>(k), contact - lost - kept);
    constraints.tight.take(static_cast<int>(k), contact + margin - kept);
    constraints.must_brake = constraints.must_brake || (kept == 0.0 && !(robot.velocity == Vec3{}));
    constraints.near.push_back(near);
  }
}

bool keeps_boxes(const Robot& robot, Vec3 next_velocity, const StepLaw& law,
                 const BoxConstraints& constraints) {
  if (constraints.near.empty() || next_velocity == constraints.backup) return true;
  if (constraints.must_brake) return false;
  const Path path = path_of(robot, next_velocity, law, constraints);
  return std::none_of(constraints.near.begin(), constraints.near.end(), [&](const NearBox& near) {
    return too_near(near, path, constraints).has_value();
  });
}

void append_box_cuts(const Robot& robot, Vec3 next_velocity, const StepLaw& law,
                     const BoxConstraints& constraints, std::vector<HalfSpace>& cuts) {
  if (constraints.near.empty() || constraints.must_brake) return;
  const Path path = path_of(robot, next_velocity, law, constraints);
  for (const NearBox& near : constraints.near) {
    const std::optional<TooNear> worst = too_near(near, path, constraints);
    if (!worst) continue;
    const bool is_lost = near.cone < 1.0;
    if (is_lost &&
        nearest(robot.position, constraints.stop, near.box).distance < near.held + near.margin) {
      cuts.push_back(cut_towards(robot, near, next_velocity, law, constraints));
      continue;
    }
    if (const std::optional<HalfSpace> cut = cut_of(robot, *worst, next_velocity, law))
      cuts.push_back(*cut);
  }
}

void append_speed_planes(const Robot& robot, std::span<const Box> boxes, const StepLaw& law,
                         std::vector<HalfSpace>& half_spaces) {
  if (boxes.empty()) return;
  const double reach = box_reach(robot, law);
  for (const Box& box : boxes) {
    const NearestToBox at = nearest(robot.position, robot.position, box);
    const double gap = at.distance - robot.radius - box.radius - law.localization_error;
    if (!(gap < reach) || !(at.distance > 0.0)) continue;
    const Vec3 normal = (at.on_segment - at.on_box) / at.distance;
    const double braking = planned_braking(robot) / own_length(normal, robot.vertical);
    const double speed = gap > 0.0 ? speed_before(gap, braking, law) : 0.0;
    half_spaces.push_back({normal, std::max(-speed, -top_speed(robot))});
  }
}

}  // namespace avo::space
