// SPDX-License-Identifier: Apache-2.0
#include "space/words.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include "guidance/names.h"
#include "guidance/phrases.h"

namespace avo::space {
namespace {

bool is_slow(const Explanation& e, Vec3 v) {
  return norm(v) < kResting * e.seen.robot.max_speed;
}

// The names of those that are not the robot itself.
Words list_of(const Explanation& e, const std::vector<Cause>& causes) {
  std::vector<Words> names;
  for (const Cause cause : causes)
    if (cause != Cause{}) names.push_back(name_of(e, cause));
  return guidance::list_of(names);
}

// The neighbor or moving obstacle with the nearest center.
Cause nearest_of(const Explanation& e) {
  Cause nearest;
  double least = std::numeric_limits<double>::infinity();  // m²
  const auto look_at = [&](Vec3 place, Cause cause) {
    const double squared = norm_squared(place - e.seen.robot.position);
    if (squared < least) least = squared, nearest = cause;
  };
  for (int k = 0; const Neighbor& other : e.seen.neighbors) look_at(other.position, {k++, -1, -1});
  for (int k = 0; const Mover& other : e.seen.movers) look_at(other.position, {-1, -1, k++});
  return nearest;
}

// E.g. "turns right, turns up and slows down".
Words action_of(const Explanation& e) {
  const Vec3 v = e.seen.robot.velocity, next = e.decision.plan.next_velocity;
  const bool rests = is_slow(e, v);
  if (rests) return is_slow(e, next) ? "stays at rest" : "starts";
  if (next == Vec3{}) return "comes to rest";
  std::vector<Words> all;
  const double turned = v.x * next.y - v.y * next.x;
  const double horizontal = norm(Vec2{v.x, v.y}) * norm(Vec2{next.x, next.y});
  if (std::abs(turned) >= kLittleTurn * horizontal && horizontal > 0.0)
    all.emplace_back(turned > 0.0 ? "turns left" : "turns right");
  const double rise = next.z / norm(next) - v.z / norm(v);
  if (std::abs(rise) >= kLittleTurn) all.emplace_back(rise > 0.0 ? "turns up" : "turns down");
  const double gain = norm(next) - norm(v);
  if (std::abs(gain) >= kLittleGain * norm(v))
    all.emplace_back(gain > 0.0 ? "speeds up" : "slows down");
  return all.empty() ? "keeps its velocity" : guidance::list_of(all);
}

Words wait_of(const Simulation::Wait& wait) {
  const Vec3 p = wait.passage;
  return Words("at the passage at (") + number(p.x, 2) + ", " + number(p.y, 2) + ", " +
         number(p.z, 2) + ") for " +
         goes_first("robot " + std::to_string(wait.robot.value), wait.inside);
}

// What leads the robot elsewhere than along its route; nothing where nothing does.
Words guide_of(const Explanation& e) {
  if (e.seen.guide == Guide::passage) return "it gives way at a passage";
  if (e.seen.guide == Guide::place) {
    const bool stays = e.seen.robot.preferred_velocity == Vec3{};
    return Words("others have its goal as well, so it ") +
           (stays ? "stays near it" : "goes to a free place near it");
  }
  if (e.distance_left > 0.0 && is_slow(e, e.seen.robot.preferred_velocity))
    return is_kept_from_goal("obstacles", e.distance_left);
  return "";
}

Words rule_of(const Explanation& e) {
  const int heeded = e.decision.heeded;
  const Cause cause = heeded >= 0 ? Cause{heeded, -1, -1} : nearest_of(e);
  return does(e.decision.rule, cause != Cause{} ? name_of(e, cause) : Words("others"));
}

// The last velocity that was asked for has been refused.
Words refusal_of(const Explanation& e) {
  const DecisionTrace& decision = e.decision;
  const bool is_off = decision.detour.has_value();
  const Words whom = list_of(e, is_off ? decision.refusing_detour : decision.refusing);
  if (!whom.empty()) return refused(decision.plan.status, whom, is_off);
  return decision.plan.status == PlanStatus::braking
             ? "nothing but braking keeps to its own limits"
             : Words("its own limits leave too little of ") +
                   (is_off ? "its detour" : "the velocity that it wants");
}

// What the program leaves of the wish.
Words program_of(const Explanation& e, bool is_certified) {
  const DecisionTrace& decision = e.decision;
  const Words whom = list_of(e, decision.binding);
  if (decision.plan.violation > 0.0)
    return misses(decision.plan.violation, whom, "half-spaces", is_certified);
  return whom.empty() ? "" : binds(whom, decision.binding.size() > 1, "half-space");
}

Words detour_of(const Explanation& e) {
  const DecisionTrace& decision = e.decision;
  Words whom = list_of(e, decision.refusing.empty() ? decision.binding : decision.refusing);
  if (whom.empty() && nearest_of(e) != Cause{}) whom = name_of(e, nearest_of(e));
  return is_on_detour(static_cast<double>(e.seen.detour.angle), whom.empty() ? "others" : whom,
                      !decision.refusing.empty(), "half-spaces");
}

Words limits_of(const Explanation& e, bool is_certified) {
  const PlanStatus status = e.decision.plan.status;
  if (status == PlanStatus::detour) return detour_of(e);
  const bool is_refused = status == PlanStatus::refused || status == PlanStatus::braking;
  return is_refused ? refusal_of(e) : program_of(e, is_certified);
}

Words contact_of(const Explanation& e) {
  const Plan& plan = e.decision.plan;
  const Cause cause{plan.neighbor, plan.box, plan.mover};
  return is_in_contact(cause == Cause{} ? Words() : name_of(e, cause));
}

Words freedom_of(const Explanation& e) {
  const Robot& robot = e.seen.robot;
  if (e.is_at_goal && is_slow(e, robot.velocity)) return "it is at its goal";
  return is_free(norm(robot.velocity - robot.preferred_velocity) < kAsPreferred);
}

Words reason_of(const Explanation& e, bool is_certified) {
  const DecisionTrace& decision = e.decision;
  if (decision.plan.status == PlanStatus::invalid_input) return kInvalidInput;
  if (decision.plan.status == PlanStatus::overlapping) return contact_of(e);
  if (decision.evasion)
    return evades(decision.evasion->mover >= 0 ? name_of(e, {-1, -1, decision.evasion->mover})
                                               : Words("the moving obstacles around it"),
                  !(decision.evasion->duration > 0.0));
  Words reason;
  add_words(guide_of(e), reason);
  add_words(rule_of(e), reason);
  add_words(limits_of(e, is_certified), reason);
  return reason.empty() ? freedom_of(e) : reason;
}

const char* state_of(const Explanation& e) {
  if (e.decision.plan.state != SafetyState::safe)
    return " That it is safe is not proved (unknown).";
  return e.seen.movers.empty() ? " Braking keeps clear of all others (safe)."
                               : " Braking keeps clear of all robots and static obstacles (safe).";
}

std::string sentence_of(const Explanation& e, bool is_certified) {
  const Words robot = Words("Robot ") + std::to_string(e.robot.value) + " ";
  const DecisionTrace& decision = e.decision;
  const bool waits =
      e.seen.wait && decision.plan.status != PlanStatus::overlapping && !decision.evasion;
  if (!waits) return robot + action_of(e) + ": " + reason_of(e, is_certified) + "." + state_of(e);
  if (is_slow(e, e.seen.robot.velocity))
    return robot + "waits " + wait_of(*e.seen.wait) + "." + state_of(e);
  return robot + action_of(e) + ": it has to wait " + wait_of(*e.seen.wait) + "." + state_of(e);
}

}  // namespace

std::string name_of(const Explanation& explanation, Cause cause) {
  const auto named = [](const char* kind, const auto& ids, int index) {
    return kind + std::to_string(ids[static_cast<std::size_t>(index)].value);
  };
  const Simulation::Perception& seen = explanation.seen;
  if (cause.neighbor >= 0) return named("robot ", seen.neighbor_ids, cause.neighbor);
  if (cause.box >= 0) return named("obstacle ", seen.box_ids, cause.box);
  if (cause.mover >= 0) return named("moving obstacle ", seen.mover_ids, cause.mover);
  return "its own limits";
}

void explain_decision(const Planner& planner, Explanation& explanation) {
  const Simulation::Perception& seen = explanation.seen;
  PlanWorkspace workspace;
  Detour detour = seen.detour;
  explanation.decision =
      planner.explain(seen.robot, seen.neighbors, workspace, &detour, seen.boxes, seen.movers);
  const bool is_certified = planner.options().certificate != Certificate::none;
  explanation.sentence = sentence_of(explanation, is_certified);
}

}  // namespace avo::space
