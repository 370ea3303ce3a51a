// SPDX-License-Identifier: Apache-2.0
// The output of avo explain in space, for people and as JSON.
#include <cmath>
#include <fmt/format.h>

#include "avo/version.h"
#include "avo_io/printable.h"
#include "avo_io/space_decision.h"
#include "io/space/space_words.h"
#include "io/text/json.h"

namespace avo_io {
namespace {

using avo::Vec3;

std::string text(Vec3 v) {
  return fmt::format("({:.6g}, {:.6g}, {:.6g})", v.x + 0.0, v.y + 0.0, v.z + 0.0);  // no -0
}

std::string names_of(const SpaceDecision& decision, const std::vector<SpaceCause>& causes) {
  std::string list;
  for (const SpaceCause cause : causes)
    list += (list.empty() ? "" : ", ") + name_of(decision, cause);
  return list;
}

Json in_json(Vec3 v) {
  return Json::array({v.x, v.y, v.z});
}

Json name_in_json(const SpaceDecision& decision, SpaceCause cause) {
  if (cause.neighbor >= 0)
    return name_of(decision.numbers[static_cast<std::size_t>(cause.neighbor)]);
  return fmt::format("obstacles.{}", decision.obstacles[static_cast<std::size_t>(cause.box)]);
}

Json causes_in_json(const SpaceDecision& decision, const std::vector<SpaceCause>& causes) {
  Json names = Json::array();
  for (const SpaceCause cause : causes) names.push_back(name_in_json(decision, cause));
  return names;
}

Json neighbors_in_json(const SpaceDecision& decision) {
  Json all = Json::array();
  for (std::size_t k = 0; k < decision.neighbors.size(); ++k) {
    const avo::space::Neighbor& other = decision.neighbors[k];
    all.push_back({{"neighbor", decision.numbers[k]},
                   {"position", in_json(other.position)},
                   {"velocity", in_json(other.velocity)},
                   {"radius", other.radius},
                   {"max_acceleration", other.max_acceleration},
                   {"priority", other.priority},
                   {"vertical", other.vertical},
                   {"downwash", other.downwash}});
  }
  return all;
}

}  // namespace

std::string readable(const SpaceDecision& decision) {
  const avo::space::Robot& self = decision.self;
  const avo::space::Plan& plan = decision.plan;
  std::string result = fmt::format("{}, robot {} at {:.6g} s\n", printable(decision.scene),
                                   decision.robot, decision.time);
  const auto line = [&](const char* name, const std::string& value) {
    result += fmt::format("  {:<19} {}\n", name, value);
  };
  line("position", text(self.position) + " m, goal " + text(decision.goal) + " m");
  line("velocity", text(self.velocity) + " m/s");
  if (self.priority != 1.0) line("priority", fmt::format("{:.6g}", self.priority));
  line("sees",
       fmt::format("{} robots and {} boxes", decision.neighbors.size(), decision.boxes.size()));
  for (const NeighborHalfSpace& own : decision.half_spaces)
    line("half-space", fmt::format("{} . v' >= {:.6g} m/s, of {}", text(own.normal), own.offset,
                                   name_of(decision, {own.neighbor, -1})));
  line("preferred velocity", text(self.preferred_velocity) + " m/s");
  if (!decision.heeded.empty()) line("wish", "heeds " + names_of(decision, decision.heeded));
  if (!decision.binding.empty()) line("target", "bound by " + names_of(decision, decision.binding));
  if (!decision.refusing.empty())
    line("proposal", text(decision.proposal) + " m/s, refused because of " +
                         names_of(decision, decision.refusing));
  line("new velocity", text(plan.new_velocity) + " m/s, the command of Eq. (7)");
  line("next velocity", text(plan.next_velocity) + " m/s, after the step");
  line("acceleration", text(plan.acceleration) + " m/s^2");
  line("state", plan.state == avo::SafetyState::safe ? "safe: braking avoids contact"
                                                     : "unknown: that it is safe is not proved");
  line("status",
       fmt::format("{}, violation {:.6g} m/s", avo::to_string(plan.status), plan.violation));
  line("in words", decision.sentence);
  return result;
}

std::string to_json(const SpaceDecision& decision) {
  const avo::space::Robot& self = decision.self;
  const avo::space::Plan& plan = decision.plan;
  Json half_spaces = Json::array();
  for (const NeighborHalfSpace& own : decision.half_spaces)
    half_spaces.push_back({{"neighbor", name_in_json(decision, {own.neighbor, -1})},
                           {"normal", in_json(own.normal)},
                           {"offset", own.offset}});
  const Json json{{"scene", decision.scene},
                  {"robot", decision.robot},
                  {"time", decision.time},
                  {"position", in_json(self.position)},
                  {"velocity", in_json(self.velocity)},
                  {"goal", in_json(decision.goal)},
                  {"radius", self.radius},
                  {"max_speed", self.max_speed},
                  {"max_acceleration", self.max_acceleration},
                  {"priority", self.priority},
                  {"neighbors", neighbors_in_json(decision)},
                  {"boxes", decision.obstacles},
                  {"half_spaces", half_spaces},
                  {"preferred_velocity", in_json(self.preferred_velocity)},
                  {"binding", causes_in_json(decision, decision.binding)},
                  {"heeded", causes_in_json(decision, decision.heeded)},
                  {"proposal", in_json(decision.proposal)},
                  {"refusing", causes_in_json(decision, decision.refusing)},
                  {"new_velocity", in_json(plan.new_velocity)},
                  {"next_velocity", in_json(plan.next_velocity)},
                  {"acceleration", in_json(plan.acceleration)},
                  {"status", avo::to_string(plan.status)},
                  {"violation", plan.violation},
                  {"state", avo::to_string(plan.state)},
                  {"sentence", decision.sentence},
                  {"version", avo::kVersion}};
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace avo_io
