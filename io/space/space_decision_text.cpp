// SPDX-License-Identifier: Apache-2.0
// The output of avo explain in space, for people and as JSON.
#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "avo/version.h"
#include "avo_io/printable.h"
#include "avo_io/space_decision.h"
#include "io/text/json.h"

namespace avo_io {
namespace {

using avo::Vec3;
using avo::space::Cause;
using avo::space::Explanation;

template <typename Id>
std::uint64_t id_at(const std::vector<Id>& ids, int index) {
  return ids[static_cast<std::size_t>(index)].value;
}

std::string text(Vec3 v) {
  return fmt::format("({:.6g}, {:.6g}, {:.6g})", v.x + 0.0, v.y + 0.0, v.z + 0.0);  // no -0
}

std::string names_in_text(const Explanation& why, const std::vector<Cause>& causes) {
  std::string list;
  for (const Cause cause : causes) list += (list.empty() ? "" : ", ") + name_of(why, cause);
  return list;
}

Json in_json(Vec3 v) {
  return Json::array({v.x, v.y, v.z});
}

/// Returns a robot's id, or the key of an obstacle; null for the robot's own limits.
Json key_of(const Explanation& why, Cause cause) {
  if (cause.neighbor >= 0) return id_at(why.seen.neighbor_ids, cause.neighbor);
  if (cause.box >= 0) return fmt::format("obstacles.{}", id_at(why.seen.box_ids, cause.box));
  if (cause.mover >= 0)
    return fmt::format("moving_obstacles.{}", id_at(why.seen.mover_ids, cause.mover));
  return nullptr;
}

Json keys_of(const Explanation& why, const std::vector<Cause>& causes) {
  Json names = Json::array();
  for (const Cause cause : causes) names.push_back(key_of(why, cause));
  return names;
}

Json in_json(const Explanation& why, const avo::space::Neighbor& other, int index) {
  Json json{{"neighbor", key_of(why, {index, -1, -1})},
            {"position", in_json(other.position)},
            {"velocity", in_json(other.velocity)},
            {"radius", other.radius},
            {"max_acceleration", other.max_acceleration},
            {"priority", other.priority},
            {"vertical", other.vertical},
            {"downwash", other.downwash},
            {"behavior", "decides"}};
  if (other.age > 0) json["age"] = other.age;
  return json;
}

Json in_json(const Explanation& why, const avo::space::Mover& other, int index) {
  Json json{{"neighbor", key_of(why, {-1, -1, index})},
            {"position", in_json(other.position)},
            {"velocity", in_json(other.velocity)},
            {"acceleration", in_json(other.acceleration)},
            {"radius", other.radius},
            {"max_acceleration", 0.0},
            {"priority", nullptr},
            {"vertical", 1.0},
            {"downwash", 0.0},
            {"behavior", "moves_on"}};
  if (other.age > 0) json["age"] = other.age;
  if (other.max_deviation > 0.0) {
    json["max_deviation"] = other.max_deviation;
    json["max_speed"] = std::isfinite(other.max_speed) ? Json(other.max_speed) : Json();
  }
  return json;
}

/// Returns the neighbors and the moving obstacles, nearest first.
Json neighbors_in_json(const Explanation& why) {
  std::vector<std::pair<double, Json>> all;  // with the squared distance
  const auto append = [&](const auto& others) {
    for (int k = 0; const auto& other : others)
      all.emplace_back(norm_squared(other.position - why.seen.robot.position),
                       in_json(why, other, k++));
  };
  append(why.seen.neighbors);
  append(why.seen.movers);
  std::stable_sort(all.begin(), all.end(),
                   [](const auto& a, const auto& b) { return a.first < b.first; });
  Json neighbors = Json::array();
  for (auto& [squared, other] : all) neighbors.push_back(std::move(other));
  return neighbors;
}

/// Returns the half-spaces of boxes, or else those of neighbors and moving obstacles.
Json half_spaces_in_json(const Explanation& why, bool of_boxes) {
  Json half_spaces = Json::array();
  for (const avo::space::CausedHalfSpace& plane : why.decision.half_spaces) {
    if (plane.of == Cause{} || (plane.of.box >= 0) != of_boxes) continue;
    half_spaces.push_back({{of_boxes ? "obstacle" : "neighbor", key_of(why, plane.of)},
                           {"normal", in_json(plane.normal)},
                           {"offset", plane.offset}});
  }
  return half_spaces;
}

/// Returns the stages of the decision.
Json trace_of(const Explanation& why) {
  const avo::space::DecisionTrace& trace = why.decision;
  const bool heeds = trace.heeded >= 0;
  return {{"guide", avo::to_string(why.seen.guide)},
          {"wish", in_json(trace.wish)},
          {"rule", avo::to_string(trace.rule)},
          {"heeded", heeds ? key_of(why, {trace.heeded, -1, -1}) : Json()},
          {"aim", in_json(trace.aim)},
          {"target", in_json(trace.target)},
          {"binding", keys_of(why, trace.binding)},
          {"proposal", in_json(trace.proposal)},
          {"refusing", keys_of(why, trace.refusing)},
          {"detour", trace.detour ? in_json(*trace.detour) : Json()},
          {"refusing_detour", keys_of(why, trace.refusing_detour)}};
}

Json evasion_of(const Explanation& why) {
  if (!why.decision.evasion) return nullptr;
  const avo::space::Evasion& evasion = *why.decision.evasion;
  return {{"neighbor", key_of(why, {-1, -1, evasion.mover})},
          {"velocity", in_json(evasion.velocity)},
          {"until", why.time + evasion.duration}};
}

Json wait_of(const Explanation& why) {
  if (!why.seen.wait) return nullptr;
  const avo::space::Simulation::Wait& wait = *why.seen.wait;
  return {{"passage", in_json(wait.passage)}, {"for", wait.robot.value}, {"inside", wait.inside}};
}

std::string evasion_text(const Explanation& why) {
  const avo::space::Evasion& evasion = *why.decision.evasion;
  const std::string whom =
      evasion.mover >= 0 ? name_of(why, {-1, -1, evasion.mover}) : "the moving obstacles around it";
  if (!(evasion.duration > 0.0)) return whom + ": it brakes";
  return fmt::format("{}: towards {} m/s until {:.6g} s, and then it could brake", whom,
                     text(evasion.velocity), why.time + evasion.duration);
}

std::string counted(std::size_t number, const char* one, const char* many) {
  return fmt::format("{} {}", number, number == 1 ? one : many);
}

using Line = std::function<void(const char*, const std::string&)>;

/// Appends what the robot senses, and the half-spaces of it.
void append_seen(const Explanation& why, const Line& line) {
  const auto& seen = why.seen;
  line("sees", fmt::format("{}, {} and {}", counted(seen.neighbors.size(), "robot", "robots"),
                           counted(seen.boxes.size(), "box", "boxes"),
                           counted(seen.movers.size(), "moving obstacle", "moving obstacles")));
  const auto carried_on = [&](Cause cause, int age) {
    if (age > 0)
      line("carried on", fmt::format("{}, last sensed {} {} ago", name_of(why, cause), age,
                                     age == 1 ? "step" : "steps"));
  };
  for (int k = 0; const auto& other : seen.neighbors) carried_on({k++, -1, -1}, other.age);
  for (int k = 0; const auto& other : seen.movers) carried_on({-1, -1, k++}, other.age);
  for (const avo::space::CausedHalfSpace& plane : why.decision.half_spaces)
    line("half-space", fmt::format("{} . v' >= {:.6g} m/s, of {}", text(plane.normal), plane.offset,
                                   name_of(why, plane.of)));
}

/// Appends the stages between the preferred velocity and the decision that changed something.
void append_stages(const Explanation& why, const Line& line) {
  const avo::space::DecisionTrace& trace = why.decision;
  const auto refused = [&](const std::vector<Cause>& causes) {
    return causes.empty() ? std::string("admitted")
                          : "refused because of " + names_in_text(why, causes);
  };
  if (trace.rule != avo::WishRule::none)
    line("wish", fmt::format("{} m/s, {}", text(trace.wish), avo::to_string(trace.rule)));
  if (!trace.binding.empty())
    line("target", text(trace.target) + " m/s, bound by " + names_in_text(why, trace.binding));
  if (!trace.refusing.empty())
    line("proposal", text(trace.proposal) + " m/s, " + refused(trace.refusing));
  if (trace.detour)
    line("off the route", text(*trace.detour) + " m/s, " + refused(trace.refusing_detour));
}

Cause contact_of(const avo::space::Plan& plan) {
  return {plan.neighbor, plan.box, plan.mover};
}

}  // namespace

std::string readable(const Explanation& why, const std::string& scene) {
  const avo::space::Robot& self = why.seen.robot;
  const avo::space::Plan& plan = why.decision.plan;
  std::string result =
      fmt::format("{}, robot {} at {:.6g} s\n", printable(scene), why.robot.value, why.time);
  const auto line = [&](const char* name, const std::string& value) {
    result += fmt::format("  {:<19} {}\n", name, value);
  };
  line("position", text(self.position) + " m, goal " + text(why.goal) + " m");
  line("velocity", text(self.velocity) + " m/s");
  if (self.priority != 1.0) line("priority", fmt::format("{:.6g}", self.priority));
  append_seen(why, line);
  line("preferred velocity", text(self.preferred_velocity) + " m/s");
  append_stages(why, line);
  line("new velocity", text(plan.new_velocity) + " m/s, the command of Eq. (7)");
  line("next velocity", text(plan.next_velocity) + " m/s, after the step");
  line("acceleration", text(plan.acceleration) + " m/s^2");
  if (why.decision.evasion) line("evades", evasion_text(why));
  if (const auto& wait = why.seen.wait)
    line("waits", fmt::format("at the passage at {} m for robot {}", text(wait->passage),
                              wait->robot.value));
  line("state", plan.state == avo::SafetyState::safe ? "safe: braking avoids contact"
                                                     : "unknown: that it is safe is not proved");
  if (plan.status == avo::PlanStatus::overlapping)
    line("contact", fmt::format("{:.6g} m deep with {}, now or in spite of braking", plan.depth,
                                name_of(why, contact_of(plan))));
  line("status",
       fmt::format("{}, violation {:.6g} m/s", avo::to_string(plan.status), plan.violation));
  line("in words", why.sentence);
  return result;
}

std::string to_json(const Explanation& why, const std::string& scene) {
  const avo::space::Robot& self = why.seen.robot;
  const avo::space::Plan& plan = why.decision.plan;
  const bool overlaps = plan.status == avo::PlanStatus::overlapping;
  Json obstacles = Json::array();
  for (const avo::ObstacleId obstacle : why.seen.box_ids) obstacles.push_back(obstacle.value);
  const Json json{{"scene", scene},
                  {"robot", why.robot.value},
                  {"time", why.time},
                  {"position", in_json(self.position)},
                  {"velocity", in_json(self.velocity)},
                  {"goal", in_json(why.goal)},
                  {"radius", self.radius},
                  {"max_speed", self.max_speed},
                  {"max_acceleration", self.max_acceleration},
                  {"priority", self.priority},
                  {"neighbors", neighbors_in_json(why)},
                  {"obstacles", obstacles},
                  {"half_spaces", half_spaces_in_json(why, false)},
                  {"obstacle_half_spaces", half_spaces_in_json(why, true)},
                  {"detour_angle", why.seen.detour.angle},
                  {"preferred_velocity", in_json(self.preferred_velocity)},
                  {"new_velocity", in_json(plan.new_velocity)},
                  {"next_velocity", in_json(plan.next_velocity)},
                  {"acceleration", in_json(plan.acceleration)},
                  {"trace", trace_of(why)},
                  {"sentence", why.sentence},
                  {"evading", evasion_of(why)},
                  {"waits", wait_of(why)},
                  {"state", avo::to_string(plan.state)},
                  {"status", avo::to_string(plan.status)},
                  {"contact_with", key_of(why, contact_of(plan))},
                  {"contact_depth", overlaps ? Json(plan.depth) : Json()},
                  {"violation", plan.violation},
                  {"version", avo::kVersion}};
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace avo_io
