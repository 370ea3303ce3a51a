// SPDX-License-Identifier: Apache-2.0
// The exact test of a path against walls, and the half-planes of walls that refuse it.
#include "certificate/wall_constraints.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>

#include "core/plane.h"
#include "robots/model.h"

namespace avo::inline certificate {
namespace {

// A's candidate as segments, relative to p_A: the braking segment from p_1, and the sides of the
// triangle of its step. The side from p lies in the present capsule, except where the disc swings.
struct CandidatePieces {
  std::array<Segment, 4> segment;
  std::size_t count = 3;
  double extent = 0.0;  // m, the largest distance of any of their points from p_A
  double height =
      0.0;  // m, the height of its middle point over [p, p_1]: no point of the triangle is higher
};
constexpr std::size_t kBraking = 0;
constexpr double kMoreThanRounding = 1.0 + 0x1p-20;

CandidatePieces pieces_of(const WallConstraints& walls, const CandidatePath& path,
                          const StepLaw& law) {
  const Vec2 end = path.first + stopping_length(path.braking, law) * path.direction;
  const Vec2 middle = walls.middle + path.swing;
  CandidatePieces pieces{
      {{{path.first, end}, {middle, path.end}, {path.begin, path.end}, {path.begin, middle}}}};
  if (!(path.swing == Vec2{})) pieces.count = 4;
  const double grown = std::max({path.grown, path.grown_within, 0.0});
  pieces.extent = std::max({norm(path.first), norm(end), norm(middle)}) + path.bend +
                  (norm(path.begin) + norm(path.end - path.first) + grown);
  pieces.height = distance(middle, pieces.segment[2]) + path.bend;
  return pieces;
}

// m. A robot at rest within a margin of the wall must be able to leave: its step keeps less than a
// choice keeps.
double demanded(const NearWall& wall, std::size_t piece, const CandidatePath& path) {
  if (piece == kBraking) return (wall.held + wall.margin) + path.grown;
  return (wall.held + 0.5 * wall.margin) + path.grown_within;
}

// An arc is within bend t²/Δt² of the step's parabola, and this is the weight of the last Bézier
// point. So only p_1 must keep the bend in addition, on the line across the nearest points where
// that is enough.
bool keeps_bend(const NearestPoints& nearest, Vec2 first, double bend, double least) {
  if (nearest.distance >= least + bend) return true;
  if (!(nearest.distance > 0.0)) return false;
  const Vec2 normal = (nearest.on_first - nearest.on_second) / nearest.distance;
  return dot(normal, first - nearest.on_second) - bend >= least;
}

// Returns whether each point of the path is at least as far from the wall as the point of braking
// at the same time. It holds for all possible places of A (docs/certificate/walls.md, "Errors of
// one's own place").
bool leaves_wall(const NearWall& wall, const WallConstraints& walls, const CandidatePieces& pieces,
                 const CandidatePath& path) {
  if (!(wall.cone < 1.0)) return false;
  const auto gained = [&](Vec2 from_braking, double bend) {
    return dot(wall.normal, from_braking) - bend - wall.cone * (norm(from_braking) + bend);
  };
  return gained(pieces.segment[kBraking].a - walls.first, path.bend) >= wall.margin + path.grown &&
         gained(pieces.segment[kBraking].b - walls.stop, 0.0) >= wall.margin + path.grown &&
         gained(path.end - walls.first, path.bend) >= wall.margin + path.grown_within &&
         gained(path.swing, 0.0) >= path.grown_within;
}

bool keeps_wall(const NearWall& wall, const WallConstraints& walls, const CandidatePieces& pieces,
                const CandidatePath& path) {
  // the margin covers more than rounding may hide
  if (wall.distance - pieces.extent > wall.held + wall.margin) return true;
  if (leaves_wall(wall, walls, pieces, path)) return true;
  if (pieces.height > wall.held) return false;  // the wall may lie inside the triangle
  for (std::size_t k = 0; k < pieces.count; ++k) {
    const NearestPoints nearest = nearest_points(pieces.segment[k], wall.segment);
    const double least = demanded(wall, k, path);
    if (!(nearest.distance >= least)) return false;
    if (k != kBraking && path.bend > 0.0 && !keeps_bend(nearest, path.end, path.bend, least))
      return false;
  }
  return true;
}

// A point of the path that must not come nearer to a point of the wall.
struct WorstPoint {
  std::size_t piece = 0;
  Vec2 on_path, on_wall, normal;  // m, m, unit: from the wall
};

// Where the path crosses the wall, the normal points to the side of braking.
std::optional<WorstPoint> worst_point(const NearWall& wall, const CandidatePieces& pieces,
                                      const CandidatePath& path, Vec2 stop) {
  WorstPoint worst;
  double least = std::numeric_limits<double>::infinity(), distance = least;
  for (std::size_t k = 0; k < pieces.count; ++k) {
    const NearestPoints nearest = nearest_points(pieces.segment[k], wall.segment);
    const double beyond = nearest.distance - demanded(wall, k, path);
    if (!(beyond < least)) continue;
    least = beyond, distance = nearest.distance;
    worst = {k, nearest.on_first, nearest.on_second, {}};
  }
  if (distance > 0.0) {
    worst.normal = (worst.on_path - worst.on_wall) / distance;
    return worst;
  }
  const NearestPoints braking = nearest_points({{}, stop}, wall.segment);
  if (!(braking.distance > 0.0)) return std::nullopt;
  worst.normal = (braking.on_first - braking.on_second) / braking.distance;
  worst.on_wall = braking.on_second;
  const Segment& crossing = pieces.segment[worst.piece];
  const bool begins_deeper = dot(worst.normal, crossing.a) < dot(worst.normal, crossing.b);
  worst.on_path = begins_deeper ? crossing.a : crossing.b;
  return worst;
}

// The relative position of the point along the segment, in [0, 1].
double fraction_of(Vec2 point, const Segment& segment) {
  const double length = norm(segment.b - segment.a);
  return length > 0.0 ? std::min(norm(point - segment.a) / length, 1.0) : 0.0;
}

// The displacement of a path point for each m/s of v_1, in the direction of the normal: the
// gradient.
Vec2 gradient_at(const WorstPoint& worst, const CandidatePieces& pieces, const CandidatePath& path,
                 const StepLaw& law) {
  const double fraction = fraction_of(worst.on_path, pieces.segment[worst.piece]);
  const double first = law.time_step - law.lag;
  const double turning = path.lever != 0.0 && path.speed > 0.0 ? path.lever / path.speed : 0.0;
  const double n_along = dot(worst.normal, path.direction);
  if (worst.piece != kBraking && turning == 0.0) return fraction * first * worst.normal;
  if (worst.piece != kBraking)
    return fraction * ((first + turning) * worst.normal - turning * n_along * path.direction);
  const Segment& braking = pieces.segment[kBraking];
  const double length = norm(braking.b - braking.a);
  const double per_speed = path.speed > 0.0 ? length / path.speed : law.lag;
  const double to_rest = law.time_step * path.braking.full_steps + law.lag;
  const double across = first + turning + fraction * per_speed, along = first + fraction * to_rest;
  return across * worst.normal + ((along - across) * n_along) * path.direction;
}

std::optional<HalfPlane> cut_of(const NearWall& wall, const WallConstraints& walls,
                                const CandidatePieces& pieces, const CandidatePath& path,
                                const StepLaw& law) {
  const bool is_lost = wall.cone < 1.0;
  if (is_lost && distance({{}, walls.stop}, wall.segment) < wall.held + wall.margin) {
    // the robot may leave the wall, see leaves_wall()
    const double change = norm(path.next_velocity - walls.backup);
    const double least = wall.cone * change + wall.margin / (law.time_step - law.lag);
    return HalfPlane{wall.normal, dot(wall.normal, walls.backup) + kMoreThanRounding * least};
  }
  const std::optional<WorstPoint> worst = worst_point(wall, pieces, path, walls.stop);
  if (!worst) return std::nullopt;
  const Vec2 gradient = gradient_at(*worst, pieces, path, law);
  const double length = norm(gradient);
  if (!(length > 0.0)) return std::nullopt;
  const double missing = demanded(wall, kBraking, path) + path.bend -
                         dot(worst->normal, worst->on_path - worst->on_wall);
  const HalfPlane cut{gradient / length, (dot(gradient, path.next_velocity) + missing) / length};
  if (!std::isfinite(cut.offset)) return std::nullopt;
  return cut;
}

}  // namespace

double wall_reach(double speed, double max_speed, const Ability& ability, const StepLaw& law) {
  const double fastest = speed + increment(ability.acceleration, law);
  const double top_speed = std::max(std::min(fastest, max_speed), speed);
  const double decrement = braking_decrement(ability.braking, law);
  return law.time_step * top_speed + stopping_length(top_speed, decrement, law);
}

WallRounding wall_rounding(double radius, double max_speed, const Ability& ability,
                           const StepLaw& law) {
  const BrakingProfile braking =
      braking_profile(max_speed, braking_decrement(ability.braking, law));
  return {braking.full_steps + 2.0,
          radius + law.time_step * max_speed + stopping_length(braking, law)};
}

// docs/certificate/walls.md, "Rounding"; four times the bound that is derived there. The place of
// the robot does not count, only that it is within reach of the wall: braking changes no margin.
double wall_margin(const Wall& wall, const WallRounding& rounding) {
  const double places = std::max(length_1(wall.a), length_1(wall.b));
  const double lengths = 2.0 * places + 3.0 * (wall.radius + rounding.lengths);
  return 0x1p-48 * rounding.steps * lengths;
}

namespace {

// The distance held by a robot that does not know exactly where it is. Within the error, braking is
// assumed to keep clear, as it does if it has done so before.
void hold_lost(NearWall& near, const WallConstraints& constraints, double contact, double lost) {
  near.held = contact + lost;
  const NearestPoints braking = nearest_points({{}, constraints.stop}, near.segment);
  if (!(braking.distance > 0.0)) return;
  near.normal = (braking.on_first - braking.on_second) / braking.distance;
  near.cone = 2.0 * lost / (contact + braking.distance);
}

}  // namespace

void begin_walls(const Robot& robot, std::span<const Wall> walls, const StepLaw& law,
                 WallConstraints& constraints, const DiscRoom& room) {
  constraints.clear();
  if (walls.empty()) return;
  const double u = decrement_of(robot, law), speed = norm(robot.velocity);
  const double reach = wall_reach(speed, robot.max_speed, ability_of(robot), law) +
                       stray_of(robot.model, robot.max_acceleration, law.time_step).distance +
                       room.reach;
  const WallRounding rounding =
      wall_rounding(robot.radius + room.lengths, robot.max_speed, ability_of(robot), law);
  constraints.middle = law.lag * robot.velocity;
  constraints.backup = braked(robot.velocity, u);
  constraints.stop = stopping_vector(robot.velocity, u, law);
  constraints.first = constraints.middle + (law.time_step - law.lag) * constraints.backup;
  const double lost = law.localization_error;
  for (std::size_t k = 0; k < walls.size(); ++k) {
    const Wall& wall = walls[k];
    const Segment segment{wall.a - robot.position, wall.b - robot.position};
    const double away = distance(Vec2{}, segment), contact = robot.radius + wall.radius;
    const double margin = wall_margin(wall, rounding);
    if (!(away <= contact + lost + margin + reach)) continue;
    NearWall near{segment, away, contact, margin};
    near.index = static_cast<int>(k);
    // the center is on the wall: there is no side to keep, and nothing is deeper
    if (!(away > 0.0)) {
      constraints.broken.take(static_cast<int>(k), contact);
      constraints.doubtful = true;
      continue;
    }
    // beyond the possible effect of rounding, only the distance of braking can be held
    const double kept = distance({{}, constraints.stop}, segment);
    if (lost > 0.0 && kept >= contact - lost)
      hold_lost(near, constraints, contact, lost);
    else if (kept < contact + 0.5 * margin)
      near.held = kept, near.margin = 0.0;
    constraints.broken.take(static_cast<int>(k), contact - lost - kept);
    constraints.doubtful = constraints.doubtful || kept < contact + lost;
    constraints.must_brake = constraints.must_brake || (kept == 0.0 && speed > 0.0);
    constraints.near.push_back(near);
  }
}

bool keeps_walls(const WallConstraints& constraints, const CandidatePath& path,
                 const StepLaw& law) {
  if (constraints.near.empty()) return true;
  // a robot that comes to rest on an arc does not brake as others expect
  if (path.next_velocity == constraints.backup && path.bend == 0.0) return true;
  if (constraints.must_brake) return false;
  const CandidatePieces pieces = pieces_of(constraints, path, law);
  return std::all_of(constraints.near.begin(), constraints.near.end(), [&](const NearWall& wall) {
    return keeps_wall(wall, constraints, pieces, path);
  });
}

std::vector<int> refusing_walls(const WallConstraints& constraints, const CandidatePath& path,
                                const StepLaw& law) {
  if (keeps_walls(constraints, path, law)) return {};
  if (constraints.must_brake) return {constraints.broken.index};
  const CandidatePieces pieces = pieces_of(constraints, path, law);
  std::vector<int> refusing;
  for (const NearWall& wall : constraints.near)
    if (!keeps_wall(wall, constraints, pieces, path)) refusing.push_back(wall.index);
  return refusing;
}

void append_wall_cuts(const WallConstraints& constraints, const CandidatePath& path,
                      const StepLaw& law, std::vector<HalfPlane>& half_planes) {
  if (constraints.near.empty() || constraints.must_brake) return;
  const CandidatePieces pieces = pieces_of(constraints, path, law);
  for (const NearWall& wall : constraints.near) {
    if (keeps_wall(wall, constraints, pieces, path)) continue;
    const std::optional<HalfPlane> cut = cut_of(wall, constraints, pieces, path, law);
    if (cut) half_planes.push_back(*cut);
  }
}

}  // namespace avo::inline certificate
