// SPDX-License-Identifier: Apache-2.0
// Lists for drawings and tables: half-planes, and the constraints of the certificate, of neighbors
// and of walls, also those that do not bind. The functions are those of the stages of a decision.
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <tuple>
#include <vector>

#include "avo/decision_trace.h"
#include "avo/planner.h"
#include "lp/lens.h"
#include "planner/alone.h"
#include "planner/decision.h"
#include "planner/methods/flight.h"
#include "planner/rules/behind_walls.h"
#include "planner/scratch.h"
#include "planner/stages/certify.h"
#include "planner/stages/contact.h"
#include "planner/stages/demands.h"
#include "planner/stages/disc_pairs.h"
#include "planner/stages/soft_planes.h"
#include "planner/validity.h"
#include "walls/segment.h"

namespace avo {
namespace {

// Makes the robot the only one of scratch.alone, with the neighbors that count. Returns false where
// plan() says invalid_input.
bool take_seen(const Planner& planner, const Robot& robot, std::span<const Neighbor> neighbors,
               std::span<const Wall> walls, PlanWorkspace::Scratch& scratch) {
  if (!can_decide(robot, neighbors, walls, planner.options()) ||
      !take_alone(robot, neighbors, walls, scratch))
    return false;
  leave_out_hidden(planner.options(), certificate_law(planner).step, scratch.alone);
  return true;
}

// The indices of the seen neighbors into those given. Equal neighbors follow each other.
const std::vector<int>& indices_of(const Neighbors& seen, std::span<const Neighbor> given,
                                   PlanWorkspace::Scratch& scratch) {
  std::vector<int>& indices = scratch.indices;
  indices.clear();
  for (std::size_t k = 0; k < seen.size(); ++k) {
    int index = index_in(given, seen[k]);
    if (k > 0 && index_in(given, seen[k - 1]) == index)
      index = index_in(given, seen[k], indices.back());
    indices.push_back(index);
  }
  return indices;
}

// Returns whether the half-plane may cut into the velocities that the robot may choose.
struct Cuts {
  Lens allowed;

  bool operator()(const HalfPlane& plane, double excess) const {
    return excess > 0.0 || lens_support_min(plane.normal, allowed) < plane.offset;
  }
};

Cuts cuts_of(const Planner& planner, const Robot& robot) {
  return {make_lens(planner.acceleration_disc(robot), robot.max_speed)};
}

// Lists the distance that the circle of a robot that flies keeps from each wall.
void list_walls_of_flight(const Robot& robot, double time_step, std::span<const Wall> walls,
                          std::vector<WallConstraint>& constraints) {
  if (!can_fly(robot, time_step)) return;
  const LoiterCircle circle = *with_circle(robot).loiter;
  for (std::size_t k = 0; k < walls.size(); ++k) {
    const Vec2 away = circle.center - nearest_on({walls[k].a, walls[k].b}, circle.center);
    const double distance = norm(away);
    constraints.push_back({static_cast<int>(k), robot.radius + walls[k].radius,
                           distance - circle.radius, distance > 0.0 ? away / distance : Vec2{}});
  }
}

// Adds the walls near a robot, or near a disc of it. The nearest of several discs counts.
void add_walls(const WallConstraints& walls, std::vector<WallConstraint>& constraints) {
  for (const NearWall& wall : walls.near) {
    const NearestPoints nearest = nearest_points({{}, walls.stop}, wall.segment);
    const Vec2 away = nearest.on_first - nearest.on_second;
    const WallConstraint constraint{wall.index, wall.held, nearest.distance,
                                    nearest.distance > 0.0 ? away / nearest.distance : Vec2{}};
    const auto other = std::find_if(constraints.begin(), constraints.end(),
                                    [&](const auto& c) { return c.wall == wall.index; });
    if (other == constraints.end())
      constraints.push_back(constraint);
    else if (constraint.distance - constraint.held < other->distance - other->held)
      *other = constraint;
  }
}

}  // namespace

void Planner::collect_half_planes(const Robot& robot, std::span<const Neighbor> neighbors,
                                  PlanWorkspace& workspace, HalfPlanes& half_planes,
                                  std::span<const Wall> walls) const {
  half_planes.planes.clear();
  half_planes.overlapping = false;
  PlanWorkspace::Scratch& scratch = PlanWorkspace::Scratch::of(workspace);
  if (!take_seen(*this, robot, neighbors, walls, scratch)) return;
  const Tile& tile = scratch.alone;
  SoftPlanes& soft = scratch.soft;
  collect_soft_planes(options_, *horizon_, certificate_law(*this).step, tile, soft);
  half_planes.overlapping = soft.overlapping[0] != 0;
  const Cuts cuts = cuts_of(*this, robot);
  const std::vector<int>& indices = indices_of(tile.robots.neighbors[0], neighbors, scratch);
  for (std::size_t k = 0; k < soft.of(0).size(); ++k) {
    const HalfPlane& plane = soft.of(0)[k];
    const double excess = soft.excess_of(0)[k];
    if (cuts(plane, excess))
      half_planes.planes.push_back({indices[soft.neighbor_of(k)], plane, excess});
  }
  std::sort(half_planes.planes.begin(), half_planes.planes.end(),
            [](const NeighborPlane& a, const NeighborPlane& b) { return a.neighbor < b.neighbor; });
}

void Planner::collect_half_planes(const Robot& robot, std::span<const Wall> walls,
                                  WallPlanes& half_planes) const {
  half_planes = {};
  if (is_external(options_.method) || !can_decide(robot, {}, walls, options_)) return;
  const StepLaw law = certificate_law(*this).step;
  const Cuts cuts = cuts_of(*this, robot);
  Demands demands;
  collect_demands(*this, robot, walls, law, demands);
  half_planes.overlapping = demands.overlapping;
  const bool by_speed = slows_before_walls(options_.method);
  for (std::size_t k = 0; k < demands.wall.size(); ++k) {
    const double excess = k < demands.excess.size() ? demands.excess[k] : 0.0;
    if (cuts(demands.planes[k], excess))
      (by_speed ? half_planes.speeds : half_planes.obstacles)
          .push_back({demands.wall[k], demands.planes[k], excess});
  }
  if (!method_traits(options_.method).has_rules) return;
  const Discs discs = discs_of(robot, law);
  for (const Robot& disc : discs.all()) {
    for (std::size_t k = 0; k < walls.size(); ++k) {
      const auto own = obstacle_plane(options_, *horizon_, disc, walls[k], static_cast<int>(k),
                                      half_planes.overlapping);
      if (own && cuts(own->plane, own->excess)) half_planes.obstacles.push_back(*own);
    }
  }
}

void Planner::collect_certificate(const Robot& robot, std::span<const Wall> walls,
                                  PlanWorkspace& workspace,
                                  std::vector<WallConstraint>& constraints) const {
  constraints.clear();
  if (options_.certificate == Certificate::none || !can_decide(robot, {}, walls, options_)) return;
  if (!can_rest(robot.model))
    return list_walls_of_flight(robot, options_.time_step, walls, constraints);
  CertificateConstraints& own = PlanWorkspace::Scratch::of(workspace).certified.constraints;
  begin_walls_of(robot, walls, certificate_law(*this), own);
  if (own.footprint.count == 0) add_walls(own.walls, constraints);
  for (const DiscConstraints& disc : own.footprint.all()) add_walls(disc.walls, constraints);
}

void Planner::find_admitted(const Robot& robot, std::span<const Neighbor> neighbors,
                            PlanWorkspace& workspace, std::span<const Vec2> next_velocities,
                            std::span<std::uint8_t> admitted, std::span<const Wall> walls) const {
  std::fill(admitted.begin(), admitted.end(), std::uint8_t{0});
  PlanWorkspace::Scratch& scratch = PlanWorkspace::Scratch::of(workspace);
  if (!can_rest(robot.model) || !take_seen(*this, robot, neighbors, walls, scratch)) return;
  list(scratch.alone.robots.neighbors[0], scratch.listed);
  const CertificateLaw law = certificate_law(*this);
  if (law.kind != Certificate::none)
    collect_constraints(robot, scratch.listed, law, scratch.certified.constraints, walls);
  for (std::size_t k = 0; k < next_velocities.size(); ++k)
    admitted[k] = may_choose(robot, next_velocities[k], law, scratch.certified) ? 1 : 0;
}

void Planner::collect_certificate(const Robot& robot, std::span<const Neighbor> neighbors,
                                  PlanWorkspace& workspace,
                                  std::vector<CertificateConstraint>& constraints,
                                  std::span<const Wall> walls) const {
  constraints.clear();
  PlanWorkspace::Scratch& scratch = PlanWorkspace::Scratch::of(workspace);
  if (!take_seen(*this, robot, neighbors, walls, scratch)) return;
  const Neighbors& seen = scratch.alone.robots.neighbors[0];
  const CertificateLaw law = certificate_law(*this);
  if (can_rest(robot.model)) {
    list(seen, scratch.listed);
    collect_constraints(robot, scratch.listed, law, scratch.certified.constraints);
    list_constraints(scratch.certified.constraints, robot.position, constraints);
  } else {
    const Robot on_circle = with_circle(robot);
    collect_flight(on_circle, seen, {}, law.step, scratch.flight);
    for (const SeparatingLine& line : scratch.flight.lines)
      constraints.push_back(
          {line.neighbor, 0, line.normal,
           dot(line.normal, on_circle.loiter->center) - on_circle.loiter->radius - line.part});
  }
  const std::vector<int>& indices = indices_of(seen, neighbors, scratch);
  for (CertificateConstraint& constraint : constraints)
    constraint.neighbor = indices[static_cast<std::size_t>(constraint.neighbor)];
  const auto key = [](const CertificateConstraint& c) {
    return std::tuple(c.neighbor, c.interval, c.offset);
  };
  std::sort(constraints.begin(), constraints.end(),
            [&](const auto& a, const auto& b) { return key(a) < key(b); });
}

}  // namespace avo
