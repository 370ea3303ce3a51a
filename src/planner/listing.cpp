// SPDX-License-Identifier: Apache-2.0
// The inputs of a decision, listed for inspection: half-planes, and the demands of the certificate,
// of neighbors and of walls.
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "avo/decision_trace.h"
#include "avo/planner.h"
#include "lp/lens.h"
#include "planner/alone.h"
#include "planner/decision.h"
#include "planner/methods/flight.h"
#include "planner/rules/behind_walls.h"
#include "planner/rules/evasion.h"
#include "planner/rules/way_out.h"
#include "planner/scratch.h"
#include "planner/stages/certify.h"
#include "planner/stages/contact.h"
#include "planner/stages/demands.h"
#include "planner/stages/disc_pairs.h"
#include "planner/stages/neighbor_order.h"
#include "planner/stages/soft_planes.h"
#include "planner/validity.h"
#include "walls/segment.h"

namespace avo {
namespace {

// Leaves out hidden neighbors as plan() does, among the given numbers.
void leave_out_hidden(const Planner& planner, const Robot& robot,
                      std::span<const Neighbor> neighbors, std::span<const Wall> walls,
                      std::vector<std::uint32_t>& numbers) {
  if (planner.options().certificate == Certificate::none || walls.empty()) return;
  const StepLaw law = certificate_law(planner).step;
  const auto hidden = [&](std::uint32_t k) { return is_hidden(robot, neighbors[k], walls, law); };
  numbers.erase(std::remove_if(numbers.begin(), numbers.end(), hidden), numbers.end());
}

// Sets scratch.listed to the neighbors that a certificate uses, in the order of scratch.order.
void list_seen(const Planner& planner, const Robot& robot, std::span<const Neighbor> neighbors,
               std::span<const Wall> walls, PlanWorkspace::Scratch& scratch) {
  rank(robot, neighbors, scratch);
  std::sort(scratch.order.begin(), scratch.order.end());
  leave_out_hidden(planner, robot, neighbors, walls, scratch.order);
  scratch.listed.clear();
  for (const std::uint32_t k : scratch.order) scratch.listed.push_back(neighbors[k]);
}

// Lists the distance that the circle of a robot that flies keeps from each wall.
void list_walls_of_flight(const Robot& robot, double time_step, std::span<const Wall> walls,
                          std::vector<WallConstraint>& constraints) {
  if (!can_fly(robot, time_step)) return;
  const LoiterCircle circle = *with_circle(robot).loiter;
  for (std::size_t k = 0; k < walls.size(); ++k) {
    if (!is_valid(walls[k])) continue;
    const Vec2 away = circle.center - nearest_on({walls[k].a, walls[k].b}, circle.center);
    const double distance = norm(away);
    constraints.push_back({static_cast<int>(k), robot.radius + walls[k].radius,
                           distance - circle.radius, distance > 0.0 ? away / distance : Vec2{}});
  }
}

// The disc of a robot that is nearest to the wall.
Robot nearest_disc(const Discs& discs, const Wall& wall) {
  const auto gap = [&wall](const Robot& disc) {
    return distance(disc.position, Segment{wall.a, wall.b}) - disc.radius;
  };
  const std::span<const Robot> all = discs.all();
  return *std::min_element(all.begin(), all.end(),
                           [&](const Robot& a, const Robot& b) { return gap(a) < gap(b); });
}

}  // namespace

void Planner::collect_half_planes(const Robot& robot, std::span<const Neighbor> neighbors,
                                  PlanWorkspace& workspace, HalfPlanes& half_planes,
                                  std::span<const Wall> walls) const {
  half_planes.planes.clear();
  half_planes.overlapping = false;
  if (!can_decide(robot, neighbors, walls, options_)) return;
  PlanWorkspace::Scratch& scratch = PlanWorkspace::Scratch::of(workspace);
  Tile& tile = scratch.alone;
  if (!take_alone(robot, neighbors, walls, scratch)) return;
  if (options_.certificate != Certificate::none && !walls.empty())
    avo::leave_out_hidden(options_, certificate_law(*this).step, tile);
  collect_soft_planes(options_, *horizon_, certificate_law(*this).step, tile, scratch.soft);
  const SoftPlanes& soft = scratch.soft;
  half_planes.overlapping = soft.overlapping[0] != 0;
  const Lens allowed = make_lens(acceleration_disc(robot), robot.max_speed);
  for (std::size_t k = 0; k < soft.of(0).size(); ++k) {
    const HalfPlane& plane = soft.of(0)[k];
    const double excess = soft.excess_of(0)[k];
    if (excess <= 0.0 && lens_support_min(plane.normal, allowed) >= plane.offset) continue;
    const Neighbor neighbor = tile.robots.neighbors[0][soft.neighbor_of(k)];
    int index = index_in(neighbors, neighbor);
    if (!half_planes.planes.empty() && half_planes.planes.back().neighbor == index)
      index = index_in(neighbors, neighbor, index);  // of equal neighbors, which follow each other
    half_planes.planes.push_back({index, plane, excess});
  }
  std::sort(half_planes.planes.begin(), half_planes.planes.end(),
            [](const NeighborPlane& a, const NeighborPlane& b) { return a.neighbor < b.neighbor; });
}

void Planner::collect_half_planes(const Robot& robot, std::span<const Wall> walls,
                                  WallPlanes& half_planes) const {
  half_planes.speeds.clear();
  half_planes.obstacles.clear();
  half_planes.overlapping = false;
  if (!can_decide(robot, {}, {}, options_)) return;
  const Lens allowed = make_lens(acceleration_disc(robot), robot.max_speed);
  const auto cuts = [&allowed](const HalfPlane& plane) {
    return lens_support_min(plane.normal, allowed) < plane.offset;
  };
  std::vector<HalfPlane> speeds;
  const bool by_speed = slows_before_walls(options_.method);
  const StepLaw law = certificate_law(*this).step;
  const Discs discs = discs_of(robot, law);
  const Vec2 out = by_speed ? velocity_out(discs.discs[0], walls, law) : Vec2{};
  for (std::size_t k = 0; k < walls.size(); ++k) {
    if (!is_valid(walls[k])) continue;
    const int index = static_cast<int>(k);
    const Robot disc = nearest_disc(discs, walls[k]);
    speeds.clear();
    if (by_speed) append_speed_planes(disc, walls.subspan(k, 1), law, out, speeds);
    if (!speeds.empty() && cuts(speeds[0])) half_planes.speeds.push_back({index, speeds[0], 0.0});
    if (method_traits(options_.method).stays_in_cell || is_external(options_.method)) continue;
    const auto own =
        obstacle_plane(options_, *horizon_, disc, walls[k], index, half_planes.overlapping);
    if (own && (own->excess > 0.0 || cuts(own->plane))) half_planes.obstacles.push_back(*own);
  }
}

void Planner::collect_certificate(const Robot& robot, std::span<const Wall> walls,
                                  PlanWorkspace& workspace,
                                  std::vector<WallConstraint>& constraints) const {
  constraints.clear();
  if (options_.certificate == Certificate::none || !can_decide(robot, {}, {}, options_)) return;
  if (!can_rest(robot.model))
    return list_walls_of_flight(robot, options_.time_step, walls, constraints);
  WallConstraints& own = PlanWorkspace::Scratch::of(workspace).certified.constraints.walls;
  const StepLaw law = certificate_law(*this).step;
  const Discs discs = discs_of(robot, law);
  for (std::size_t k = 0; k < walls.size(); ++k) {
    if (!is_valid(walls[k])) continue;
    begin_walls(nearest_disc(discs, walls[k]), walls.subspan(k, 1), law, own);
    if (own.near.empty()) continue;
    const NearWall& wall = own.near[0];
    const NearestPoints nearest = nearest_points({{}, own.stop}, wall.segment);
    const Vec2 away = nearest.on_first - nearest.on_second;
    constraints.push_back({static_cast<int>(k), wall.held, nearest.distance,
                           nearest.distance > 0.0 ? away / nearest.distance : Vec2{}});
  }
}

void Planner::find_admitted(const Robot& robot, std::span<const Neighbor> neighbors,
                            PlanWorkspace& workspace, std::span<const Vec2> next_velocities,
                            std::span<std::uint8_t> admitted, std::span<const Wall> walls) const {
  std::fill(admitted.begin(), admitted.end(), std::uint8_t{0});
  if (!can_rest(robot.model) || !can_decide(robot, neighbors, walls, options_)) return;
  PlanWorkspace::Scratch& scratch = PlanWorkspace::Scratch::of(workspace);
  list_seen(*this, robot, neighbors, walls, scratch);
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
  if (!can_decide(robot, neighbors, walls, options_)) return;
  PlanWorkspace::Scratch& scratch = PlanWorkspace::Scratch::of(workspace);
  list_seen(*this, robot, neighbors, walls, scratch);
  if (!can_rest(robot.model)) {
    const Robot on_circle = with_circle(robot);
    collect_flight(on_circle, in_columns(scratch.listed, scratch.alone.neighbors), {},
                   certificate_law(*this).step, scratch.flight);
    for (const SeparatingLine& line : scratch.flight.lines)
      constraints.push_back(
          {static_cast<int>(scratch.order[static_cast<std::size_t>(line.neighbor)]), 0, line.normal,
           dot(line.normal, on_circle.loiter->center) - on_circle.loiter->radius - line.part});
    return;
  }
  CertificateConstraints& own = scratch.certified.constraints;
  collect_constraints(robot, scratch.listed, certificate_law(*this), own);
  list_constraints(own, robot.position, constraints);
  for (CertificateConstraint& constraint : constraints)
    constraint.neighbor =
        static_cast<int>(scratch.order[static_cast<std::size_t>(constraint.neighbor)]);
}

std::optional<Evasion> Planner::evasion(const Robot& robot, std::span<const Neighbor> neighbors,
                                        PlanWorkspace& workspace, const Detour* detour,
                                        std::span<const Wall> walls) const {
  Detour next = detour != nullptr ? *detour : Detour{};
  return explain(robot, neighbors, workspace, detour != nullptr ? &next : nullptr, walls).evasion;
}

bool Planner::has_way_out(const Robot& robot, std::span<const Neighbor> neighbors,
                          PlanWorkspace& workspace, std::span<const Wall> walls) const {
  return can_decide(robot, neighbors, walls, options_) &&
         avo::has_way_out(certificate_law(*this), robot, {neighbors, walls, options_.wall_range},
                          PlanWorkspace::Scratch::of(workspace).evasion);
}

}  // namespace avo
