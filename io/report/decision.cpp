// SPDX-License-Identifier: Apache-2.0
// The output of avo explain as JSON.
#include "avo_io/decision.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <functional>
#include <numeric>
#include <set>

#include "avo/half_plane.h"
#include "avo_io/printable.h"
#include "io/report/risk.h"
#include "io/text/json.h"

namespace avo_io {
namespace {

using avo::Vec2;

Json to_json(Vec2 v) {
  return Json::array({v.x, v.y});
}

Json to_json(const avo::Disc& disc) {
  if (!std::isfinite(disc.radius)) return nullptr;  // no limit
  return {{"center", to_json(disc.center)}, {"radius", disc.radius}};
}

Json to_json(const avo::LoiterCircle& circle) {
  return to_json(avo::Disc{circle.center, circle.radius});
}

/// Returns the robot's share of the evasion between the two.
double share_of(const avo::Robot& self, const avo::Neighbor& neighbor) {
  if (!shares(neighbor)) return 1.0;
  return avo::reciprocal_share(self.max_acceleration, neighbor.max_acceleration, self.priority,
                               neighbor.priority);
}

Json constraints_of(const Decision& decision) {
  Json constraints = Json::array();
  for (const avo::CertificateConstraint& constraint : decision.constraints)
    constraints.push_back(
        {{"neighbor", name_of(decision.seen.source[static_cast<std::size_t>(constraint.neighbor)])},
         {"interval", constraint.interval},
         {"normal", to_json(constraint.normal)},
         {"offset", constraint.offset}});
  return constraints;
}

/// Returns the walls that the robot knows, each with its obstacle or its parked robot.
Json walls_of(const Decision& decision) {
  Json walls = Json::array();
  for (std::size_t k = 0; k < decision.seen.walls.size(); ++k) {
    const avo::Wall& wall = decision.seen.walls[k];
    const std::int64_t source = decision.seen.wall_source[k];
    walls.push_back({{"a", to_json(wall.a)},
                     {"b", to_json(wall.b)},
                     {"radius", wall.radius},
                     {source < 0 ? "robot" : "obstacle", source < 0 ? -1 - source : source}});
  }
  return walls;
}

Json wall_half_planes_of(const avo::WallPlanes& wall_planes) {
  Json planes = Json::array();
  const auto append = [&planes](const char* kind, const std::vector<avo::WallPlane>& of_kind) {
    for (const avo::WallPlane& plane : of_kind)
      planes.push_back({{"wall", plane.wall},
                        {"kind", kind},
                        {"normal", to_json(plane.plane.normal)},
                        {"offset", plane.plane.offset}});
  };
  append("speed", wall_planes.speeds);
  append("obstacle", wall_planes.obstacles);
  return planes;
}

Json wall_constraints_of(const Decision& decision) {
  Json constraints = Json::array();
  for (const avo::WallConstraint& constraint : decision.wall_constraints)
    constraints.push_back({{"wall", constraint.wall},
                           {"held", constraint.held},
                           {"distance", constraint.distance},
                           {"normal", to_json(constraint.normal)}});
  return constraints;
}

/// Returns the name of the neighbor or of the wall, or null if there is neither.
Json name_of_either(const Decision& decision, int neighbor, int wall) {
  if (neighbor >= 0) return name_of(decision.seen.source[static_cast<std::size_t>(neighbor)]);
  if (wall >= 0) return fmt::format("walls.{}", wall);
  return nullptr;
}

/// Returns the robot or wall with which contact is inevitable.
Json doomed_by(const Decision& decision) {
  const avo::SafetyReport& state = decision.state;
  if (state.state != avo::SafetyState::doomed) return nullptr;
  return name_of_either(decision, state.neighbor, state.wall);
}

/// Returns the neighbor that the robot evades, with the velocity and the end of the evasion.
Json evasion_of(const Decision& decision) {
  if (!decision.evasion) return nullptr;
  const auto& [neighbor, velocity, duration] = *decision.evasion;
  return {{"neighbor", name_of_either(decision, neighbor, -1)},
          {"velocity", to_json(velocity)},
          {"until", decision.time + duration}};
}

/// Returns the passage at which the robot waits, and the robot for which it waits.
Json wait_of(const Decision& decision) {
  if (!decision.seen.wait) return nullptr;
  const avo::Simulation::Wait& wait = *decision.seen.wait;
  return {{"passage", to_json(wait.passage)},
          {"for", wait.robot.value},
          {"inside", wait.inside},
          {"between", Json::array({to_json(wait.a), to_json(wait.b)})}};
}

Json causes_of(const Decision& decision, const std::vector<avo::Cause>& causes) {
  Json names = Json::array();
  for (const avo::Cause cause : causes)
    names.push_back(name_of_either(decision, cause.neighbor, cause.wall));
  return names;
}

/// Returns the stages of the decision. A null among causes is the robot's own motion.
Json trace_of(const Decision& decision) {
  const avo::DecisionTrace& trace = decision.trace;
  return {{"guide", avo::to_string(decision.seen.guide)},
          {"wish", to_json(trace.wish)},
          {"rule", avo::to_string(trace.rule)},
          {"heeded", name_of_either(decision, trace.heeded, -1)},
          {"aim", to_json(trace.aim)},
          {"target", to_json(trace.target)},
          {"binding", causes_of(decision, trace.binding)},
          {"proposal", to_json(trace.proposal)},
          {"refusing", causes_of(decision, trace.refusing)},
          {"detour", trace.detour ? to_json(*trace.detour) : Json()},
          {"refusing_detour", causes_of(decision, trace.refusing_detour)}};
}

Json half_planes_of(const Decision& decision) {
  Json half_planes = Json::array();
  for (const avo::NeighborPlane& plane : decision.half_planes.planes)
    half_planes.push_back(
        {{"neighbor", name_of(decision.seen.source[static_cast<std::size_t>(plane.neighbor)])},
         {"normal", to_json(plane.plane.normal)},
         {"offset", plane.plane.offset}});
  return half_planes;
}

bool chooses_in_half_planes(const Decision& decision) {
  return decision.by_half_planes && !avo::avoids_union(decision.method);
}

// Returns the neighbors that the robot senses.
Json neighbors_of(const Decision& decision) {
  const auto& seen = decision.seen;
  Json neighbors = Json::array();
  for (std::size_t k = 0; k < seen.neighbors.size(); ++k) {
    const avo::Neighbor& neighbor = seen.neighbors[k];
    const bool decides = neighbor.behavior == avo::Behavior::decides;
    const bool shares = avo::shares(neighbor);
    neighbors.push_back({{"neighbor", name_of(seen.source[k])},
                         {"position", to_json(neighbor.position)},
                         {"velocity", to_json(neighbor.velocity)},
                         {"acceleration", to_json(neighbor.acceleration)},
                         {"radius", neighbor.radius},
                         {"max_acceleration", shares ? neighbor.max_acceleration : 0.0},
                         {"priority", shares ? Json(neighbor.priority) : Json()},
                         {"behavior", to_string(neighbor.behavior)},
                         {"share", share_of(seen.robot, neighbor)}});
    if (neighbor.age > 0) neighbors.back()["age"] = neighbor.age;
    if (decides) neighbors.back()["max_braking"] = braking_limit(neighbor);
    if (neighbor.loiter) neighbors.back()["loiter"] = to_json(*neighbor.loiter);
    if (!decides && neighbor.likely_deviation > 0.0)
      neighbors.back()["likely_deviation"] = neighbor.likely_deviation;
    if (!decides && neighbor.max_deviation > 0.0) {
      neighbors.back()["max_deviation"] = neighbor.max_deviation;
      neighbors.back()["max_speed"] =
          std::isfinite(neighbor.max_speed) ? Json(neighbor.max_speed) : Json();
    }
    if (!decision.risks.empty()) neighbors.back()["risk"] = decision.risks[k];
  }
  return neighbors;
}

}  // namespace

double risk_of(const Decision& decision) {
  return std::min(1.0, std::accumulate(decision.risks.begin(), decision.risks.end(), 0.0));
}

std::string to_json(const Decision& decision) {
  const auto& seen = decision.seen;
  const avo::Robot& self = seen.robot;
  Json json{{"scene", decision.scene},
            {"robot", decision.robot},
            {"time", decision.time},
            {"position", to_json(self.position)},
            {"velocity", to_json(self.velocity)},
            {"goal", to_json(decision.goal)},
            {"radius", self.radius},
            {"max_speed", self.max_speed},
            {"max_acceleration", self.max_acceleration},
            {"max_braking", braking_limit(self)},
            {"priority", self.priority},
            {"neighbors", neighbors_of(decision)},
            {"target_by", chooses_in_half_planes(decision) ? "half_planes" : "union_of_obstacles"},
            {"half_planes", half_planes_of(decision)},
            {"walls", walls_of(decision)},
            {"wall_half_planes", wall_half_planes_of(decision.wall_planes)}};
  if (decision.is_certified()) {
    json["certificate_kind"] = avo::to_string(decision.certificate);
    json["certificate"] = constraints_of(decision);
    json["wall_certificate"] = wall_constraints_of(decision);
    json["detour_angle"] = seen.detour.angle;
    json["response_time"] = decision.response_time;
  }
  const bool overlaps = decision.plan.status == avo::PlanStatus::overlapping;
  const Json rest{
      {"acceleration_disc", to_json(decision.acceleration_disc)},
      {"speed_disc", to_json(decision.speed_disc)},
      {"preferred_velocity", to_json(self.preferred_velocity)},
      {"new_velocity", to_json(decision.plan.new_velocity)},
      {"next_velocity", to_json(decision.plan.next_velocity)},
      {"acceleration", to_json(decision.plan.acceleration)},
      {"trace", trace_of(decision)},
      {"sentence", decision.sentence},
      {"evading", evasion_of(decision)},
      {"waits", wait_of(decision)},
      {"state", avo::to_string(decision.state.state)},
      {"doomed_by", doomed_by(decision)},
      {"contact_within",
       decision.state.state == avo::SafetyState::doomed ? Json(decision.state.time) : Json()},
      {"status", avo::to_string(decision.plan.status)},
      {"contact_with", name_of_either(decision, decision.plan.neighbor, decision.plan.wall)},
      {"contact_depth", overlaps ? Json(decision.plan.depth) : Json()},
      {"violation", decision.plan.violation}};
  if (decision.has_own_method) json["method"] = avo::to_string(decision.method);
  if (self.loiter) json["loiter"] = to_json(*self.loiter);
  if (!decision.risks.empty()) json["risk"] = risk_of(decision);
  json.update(rest);
  // the scene may have the name of its file, which may be no UTF-8
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace avo_io
