// SPDX-License-Identifier: Apache-2.0
// The output of avo explain for people, one line for each fact.
#include <cmath>
#include <fmt/format.h>
#include <functional>
#include <set>

#include "avo_io/decision.h"
#include "avo_io/printable.h"
#include "io/report/risk.h"

namespace avo_io {
namespace {

using avo::Vec2;

std::string text(Vec2 v) {
  return fmt::format("({:.6g}, {:.6g})", v.x + 0.0, v.y + 0.0);  // no -0
}

std::string text_of(std::int64_t source) {
  return source >= 0 ? fmt::format("robot {}", source)
                     : fmt::format("moving obstacle {}", -1 - source);
}

std::string text_of(const avo::Wall& wall) {
  const std::string thick = wall.radius > 0.0 ? fmt::format(", radius {:.6g}", wall.radius) : "";
  return wall.a == wall.b
             ? fmt::format("the disc at {}{}", text(wall.a), thick)
             : fmt::format("the wall from {} to {}{}", text(wall.a), text(wall.b), thick);
}

/// A parked robot is a wall for others, and has its own name.
std::string text_of_wall(const Decision& decision, int index) {
  const auto wall = static_cast<std::size_t>(index);
  const std::int64_t source = decision.seen.wall_source[wall];
  return source < 0 ? text_of(-1 - source) : text_of(decision.seen.walls[wall]);
}

std::string text_of_either(const Decision& decision, int neighbor, int wall) {
  return neighbor >= 0 ? text_of(decision.seen.source[static_cast<std::size_t>(neighbor)])
                       : text_of_wall(decision, wall);
}

/// Returns text about a decision during an overlap.
std::string contact_text(const Decision& decision) {
  const avo::Plan& plan = decision.plan;
  return fmt::format("{:.6g} m deep with {}, now or in spite of braking", plan.depth,
                     text_of_either(decision, plan.neighbor, plan.wall));
}

const char* safe_text(const avo::Simulation::Perception& seen) {
  if (can_rest(seen.robot.model)) return "safe: braking avoids contact";
  const bool has_movers =
      std::any_of(seen.neighbors.begin(), seen.neighbors.end(), avo::is_predicted);
  return has_movers
             ? "safe: its circle keeps clear of all that decide, and it has an evasive maneuver"
             : "safe: its circle keeps clear of all others";
}

std::string state_text(const Decision& decision) {
  const avo::SafetyReport& state = decision.state;
  if (state.state == avo::SafetyState::safe) return safe_text(decision.seen);
  if (state.state == avo::SafetyState::unknown) return "unknown: neither safe nor doomed is proved";
  return fmt::format("doomed: contact with {} within {:.6g} s, whatever it does",
                     text_of_either(decision, state.neighbor, state.wall), state.time);
}

/// Appends a line for each half-plane of a wall that may cut, and one for what the certificate
/// keeps.
void append_walls(const Decision& decision,
                  const std::function<void(const char*, const std::string&)>& line) {
  const auto append = [&](const char* name, const std::vector<avo::WallPlane>& planes) {
    for (const avo::WallPlane& plane : planes)
      line(name, fmt::format("{} . v' >= {:.6g} m/s, of {}", text(plane.plane.normal),
                             plane.plane.offset, text_of_wall(decision, plane.wall)));
  };
  const bool is_avo = avo::method_traits(decision.method).has_rules;
  append("speed before wall", decision.wall_planes.speeds);
  append(is_avo ? "wall's obstacle" : "half-plane", decision.wall_planes.obstacles);
  for (const avo::WallConstraint& constraint : decision.wall_constraints)
    line("wall constraint",
         fmt::format("{:.6g} m from {}, braking leaves {:.6g} m", constraint.held,
                     text_of_wall(decision, constraint.wall), constraint.distance));
}

/// Appends the number of constraints, and the first one of each of the nearest neighbors.
void append_certificate(const Decision& decision,
                        const std::function<void(const char*, const std::string&)>& line) {
  constexpr int kNamed = 3;
  const auto& constraints = decision.constraints;
  std::set<int> neighbors;
  for (const avo::CertificateConstraint& constraint : constraints)
    neighbors.insert(constraint.neighbor);
  line("certificate",
       fmt::format("{}, {} constraints of {} neighbors", avo::to_string(decision.certificate),
                   constraints.size(), neighbors.size()));
  int named = 0, last = -1;
  for (const avo::CertificateConstraint& constraint : constraints) {
    if (named == kNamed) break;
    if (constraint.neighbor == last) continue;
    last = constraint.neighbor;
    ++named;
    line("constraint", fmt::format("{} . q >= {:.6g} m on step {}, of {}", text(constraint.normal),
                                   constraint.offset, constraint.interval,
                                   text_of(decision.seen.source[static_cast<std::size_t>(last)])));
  }
  if (decision.seen.detour.angle > 0.0)
    line("detour", fmt::format("{:.6g} rad to the right", decision.seen.detour.angle));
}

/// Appends the stages between the preferred velocity and the decision that changed something.
void append_stages(const Decision& decision,
                   const std::function<void(const char*, const std::string&)>& line) {
  const avo::DecisionTrace& trace = decision.trace;
  const auto names = [&](const std::vector<avo::Cause>& causes) {
    std::string list;
    for (const avo::Cause cause : causes) {
      const bool is_own = cause.neighbor < 0 && cause.wall < 0;
      list += (list.empty() ? "" : ", ") +
              (is_own ? "its own motion" : text_of_either(decision, cause.neighbor, cause.wall));
    }
    return list;
  };
  if (trace.rule != avo::WishRule::none)
    line("wish", fmt::format("{} m/s, {}", text(trace.wish), avo::to_string(trace.rule)));
  if (!trace.binding.empty())
    line("target", text(trace.target) + " m/s, bound by " + names(trace.binding));
  if (!trace.refusing.empty())
    line("proposal", text(trace.proposal) + " m/s, refused because of " + names(trace.refusing));
  if (trace.detour)
    line("off the route", text(*trace.detour) + " m/s, " +
                              (trace.refusing_detour.empty()
                                   ? "admitted"
                                   : "refused because of " + names(trace.refusing_detour)));
}

std::string evasion_text(const Decision& decision) {
  const auto& [neighbor, velocity, duration] = *decision.evasion;
  const std::string whom =
      neighbor >= 0 ? text_of_either(decision, neighbor, -1) : "the moving obstacles around it";
  if (!(duration > 0.0)) return whom + ": it brakes";
  return fmt::format("{}: towards {} m/s until {:.6g} s, and then it could {}", whom,
                     text(velocity), decision.time + duration,
                     can_rest(decision.seen.robot.model) ? "brake" : "circle");
}

}  // namespace

std::string readable(const Decision& decision) {
  const avo::Robot& self = decision.seen.robot;
  std::string result = fmt::format("{}, robot {} at {:.6g} s\n", avo_io::printable(decision.scene),
                                   decision.robot, decision.time);
  const auto line = [&](const char* name, const std::string& value) {
    result += fmt::format("  {:<19} {}\n", name, value);
  };
  line("position", text(self.position) + " m, goal " + text(decision.goal) + " m");
  line("velocity", text(self.velocity) + " m/s");
  if (decision.has_own_method) line("method", avo::to_string(decision.method));
  if (self.loiter)
    line("may circle",
         fmt::format("about {} m, {:.6g} m away", text(self.loiter->center), self.loiter->radius));
  if (self.priority != 1.0) line("priority", fmt::format("{:.6g}", self.priority));
  const avo::Disc& reach = decision.acceleration_disc;
  line("may choose", (std::isfinite(reach.radius) ? fmt::format("|v' - {}| <= {:.6g} m/s, ",
                                                                text(reach.center), reach.radius)
                                                  : std::string()) +
                         fmt::format("|v'| <= {:.6g} m/s", decision.speed_disc.radius));
  const std::size_t count = decision.seen.neighbors.size();
  line("sees",
       fmt::format("{} {}", count,
                   count == 1 ? "robot or moving obstacle" : "robots and moving obstacles"));
  for (std::size_t k = 0; k < decision.seen.neighbors.size(); ++k) {
    if (const int age = decision.seen.neighbors[k].age; age > 0)
      line("carried on", fmt::format("{}, last sensed {} {} ago", text_of(decision.seen.source[k]),
                                     age, age == 1 ? "step" : "steps"));
  }
  if (!decision.by_half_planes) line("avoids", "the union of their obstacles");
  for (const avo::NeighborPlane& plane : decision.half_planes.planes)
    line("half-plane",
         fmt::format("{} . v' >= {:.6g} m/s, of {}", text(plane.plane.normal), plane.plane.offset,
                     text_of(decision.seen.source[static_cast<std::size_t>(plane.neighbor)])));
  append_walls(decision, line);
  if (decision.is_certified()) append_certificate(decision, line);
  line("preferred velocity", text(self.preferred_velocity) + " m/s");
  append_stages(decision, line);
  line("new velocity", text(decision.plan.new_velocity) + " m/s, the command of Eq. (7)");
  line("next velocity", text(decision.plan.next_velocity) + " m/s, after the step");
  if (avo::method_traits(decision.method).has_rules)
    line("response time", decision.response_time > 0.0
                              ? fmt::format("{:.6g} s", decision.response_time)
                              : std::string("0: at once"));
  line("acceleration", text(decision.plan.acceleration) + " m/s^2");
  if (decision.evasion) line("evades", evasion_text(decision));
  if (const auto& wait = decision.seen.wait)
    line("waits", fmt::format("at the passage at {} m for robot {}", text(wait->passage),
                              wait->robot.value));
  if (!decision.risks.empty())
    line("risk",
         fmt::format("{:.3g} or less that noise hides a broken half-plane", risk_of(decision)));
  line("state", state_text(decision));
  if (decision.plan.status == avo::PlanStatus::overlapping) line("contact", contact_text(decision));
  line("status", fmt::format("{}, violation {:.6g} m/s", avo::to_string(decision.plan.status),
                             decision.plan.violation));
  line("in words", decision.sentence);
  return result;
}

}  // namespace avo_io
