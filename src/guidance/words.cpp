// SPDX-License-Identifier: Apache-2.0
#include "guidance/words.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

#include "core/plane.h"
#include "guidance/names.h"
#include "guidance/phrases.h"
#include "robots/model.h"

namespace avo::inline guidance {
namespace {

constexpr double kOnGoal = 1.5;  // radii of contact: a robot beside the goal stands on it

bool is_slow(const Explanation& e, Vec2 v) {
  return norm(v) < kResting * e.seen.robot.max_speed;
}

// What the robot does in its next step, e.g. "turns right and slows down".
Words action_of(const Explanation& e) {
  const Plan& plan = e.decision.plan;
  const Vec2 v = e.seen.robot.velocity, next = plan.next_velocity;
  const bool rests = is_slow(e, v);
  if (rests && is_slow(e, next)) {
    const bool turns =
        model_traits(e.seen.robot.model).turns_in_place && plan.new_velocity != Vec2{};
    return turns ? "turns on the spot" : "stays at rest";
  }
  if (rests) return "starts";
  if (next == Vec2{}) return "comes to rest";
  const double turned = cross(v, next), gain = norm(next) - norm(v);
  Words words;
  if (std::abs(turned) >= kLittleTurn * norm(v) * norm(next))
    words = turned > 0.0 ? "turns left" : "turns right";
  if (std::abs(gain) >= kLittleGain * norm(v))
    words += (words.empty() ? "" : " and ") + Words(gain > 0.0 ? "speeds up" : "slows down");
  return words.empty() ? "keeps its velocity" : words;
}

// E.g. "at the door between (4, 2) and (4, 3.6) for robot 7, which is inside".
Words wait_of(const Simulation::Wait& wait) {
  return Words("at the door between ") + place(wait.a) + " and " + place(wait.b) + " for " +
         goes_first(name_of(static_cast<std::int64_t>(wait.robot.value)), wait.inside);
}

// The robot or mover that is nearest to the goal, and beside it at least.
int occupant_of(const Explanation& e) {
  int occupant = -1;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < e.seen.neighbors.size(); ++k) {
    const Neighbor& other = e.seen.neighbors[k];
    const double distance = norm(other.position - e.goal) / (e.seen.robot.radius + other.radius);
    if (distance < least) least = distance, occupant = static_cast<int>(k);
  }
  return least < kOnGoal ? occupant : -1;
}

Words occupied_goal(const Explanation& e, const Words& then) {
  const int occupant = occupant_of(e);
  const Words whom = occupant < 0 ? Words("others") : name_of(e, {occupant, -1});
  if (e.is_at_goal) return "it is at its goal beside " + whom;
  return whom + (occupant < 0 ? " are at its goal, so it " : " is at its goal, so it ") + then;
}

int nearest_of(const Explanation& e) {
  return e.seen.neighbors.empty() ? -1 : 0;  // they come nearest first
}

// What leads the robot elsewhere than along its route; nothing where nothing does.
Words guide_of(const Explanation& e) {
  if (waits_to_start(e.start_time, e.time))
    return Words("it starts at ") + number(e.start_time, 2) + " s";
  switch (e.seen.guide) {
    case Guide::place:
      return occupied_goal(e, e.seen.stop ? "stays near it" : "goes to a free place near it");
    case Guide::mover:
      return occupied_goal(e, "goes beside it");
    case Guide::passage:
      return "it gives way at a passage";
    case Guide::back: {
      const Words whom =
          nearest_of(e) < 0 ? Words() : Words(" with ") + name_of(e, {nearest_of(e), -1});
      return "it goes back out of a jam" + whom;
    }
    case Guide::host:
      return "it goes as it is told";
    case Guide::lane:
    case Guide::route:
      break;
  }
  if (e.distance_left > 0.0 && is_slow(e, e.seen.robot.preferred_velocity))
    return is_kept_from_goal("walls", e.distance_left);
  return "";
}

// The rule that changed what the robot prefers; nothing where none did.
Words rule_of(const Explanation& e) {
  const DecisionTrace& decision = e.decision;
  const Words whom = decision.heeded >= 0 ? name_of(e, {decision.heeded, -1}) : Words("others");
  return does(decision.rule, whom);
}

// The certificate has refused the last velocity that was asked for.
Words refusal_of(const Explanation& e) {
  const DecisionTrace& decision = e.decision;
  const bool is_off = decision.detour.has_value();
  const std::vector<Cause>& causes = is_off ? decision.refusing_detour : decision.refusing;
  if (causes.size() == 1 && causes.front() == Cause{})
    return name_of(e, Cause{}) + " cannot follow " + (is_off ? "its detour" : "what it wants");
  const Words whom = causes.empty() ? Words("others") : list_of(e, causes);
  if (!can_rest(e.seen.robot.model))
    return "after what it wants, its circle would not keep clear of " +
           (causes.empty() ? Words("walls or others") : whom);
  return refused(decision.plan.status, whom, is_off);
}

// What the program leaves of the wish.
Words program_of(const Explanation& e, const Planner& planner) {
  const DecisionTrace& decision = e.decision;
  const Words whom = list_of(e, decision.binding);
  if (decision.plan.status == PlanStatus::least_unsafe)
    return misses(decision.plan.violation, whom, "half-planes",
                  planner.options().certificate != Certificate::none);
  if (whom.empty()) return "";
  if (e.seen.among_movers || avoids_union(planner.options().method))
    return Words("it goes around ") + whom;
  return binds(whom, decision.binding.size() > 1, "half-plane");
}

// A robot off its route, or nearly off.
Words detour_of(const Explanation& e) {
  const DecisionTrace& decision = e.decision;
  std::vector<Cause> causes = decision.refusing.empty() ? decision.binding : decision.refusing;
  if (causes.empty() && nearest_of(e) >= 0) causes.push_back({nearest_of(e), -1});
  const Words whom = causes.empty() ? Words("others") : list_of(e, causes);
  return is_on_detour(static_cast<double>(e.seen.detour.angle), whom, !decision.refusing.empty(),
                      "half-planes");
}

Words limits_of(const Explanation& e, const Planner& planner) {
  switch (e.decision.plan.status) {
    case PlanStatus::refused:
    case PlanStatus::braking:
      return refusal_of(e);
    case PlanStatus::detour:
      return detour_of(e);
    default:
      return program_of(e, planner);
  }
}

Words freedom_of(const Explanation& e) {
  const bool has_it = norm(e.seen.robot.velocity - e.seen.robot.preferred_velocity) < kAsPreferred;
  if (e.is_at_goal && is_slow(e, e.seen.robot.velocity)) return "it is at its goal";
  const bool turns =
      is_slow(e, e.seen.robot.velocity) && model_traits(e.seen.robot.model).turns_in_place;
  if (e.decision.rule == WishRule::steers || turns) return "it turns towards its route";
  return is_free(has_it);
}

Words evasion_of(const Explanation& e) {
  const Evasion& evasion = *e.decision.evasion;
  const Words whom = evasion.neighbor >= 0 ? name_of(e, {evasion.neighbor, -1})
                                           : Words("the moving obstacles around it");
  return evades(whom, !(evasion.duration > 0.0));
}

Words contact_of(const Explanation& e) {
  const Plan& plan = e.decision.plan;
  const bool is_known = plan.neighbor >= 0 || plan.wall >= 0;
  return is_in_contact(is_known ? name_of(e, {plan.neighbor, plan.wall}) : Words());
}

Words reason_of(const Explanation& e, const Planner& planner) {
  const PlanStatus status = e.decision.plan.status;
  if (status == PlanStatus::invalid_input) return kInvalidInput;
  if (status == PlanStatus::overlapping) return contact_of(e);
  if (e.decision.evasion) return evasion_of(e);
  Words reason;
  add_words(guide_of(e), reason);
  if (e.seen.stop) return reason;
  add_words(rule_of(e), reason);
  add_words(limits_of(e, planner), reason);
  if (reason.empty()) reason = freedom_of(e);
  return reason;
}

const char* safety_of(const Simulation::Perception& seen) {
  if (can_rest(seen.robot.model)) return " Braking keeps clear of all others (safe).";
  const bool has_movers = std::any_of(seen.neighbors.begin(), seen.neighbors.end(),
                                      [](const Neighbor& n) { return is_predicted(n); });
  return has_movers
             ? " Its circle keeps clear of all who decide, and it can evade the others (safe)."
             : " Its circle keeps clear of all others (safe).";
}

Words state_of(const Explanation& e) {
  const SafetyReport& state = e.state;
  if (state.state == SafetyState::safe) return safety_of(e.seen);
  if (state.state == SafetyState::unknown) return " Neither safe nor doomed is proved (unknown).";
  const Words whom = name_of(e, {state.neighbor, state.wall});
  if (state.time == 0.0) return Words(" It is in contact with ") + whom + " (doomed).";
  return Words(" Contact with ") + whom + " within " + number(state.time, 2) +
         " s is inevitable, whatever it does (doomed).";
}

}  // namespace

std::string sentence_of(const Explanation& e, const Planner& planner) {
  const Words robot = Words("Robot ") + std::to_string(e.robot.value) + " ";
  const bool rests = is_slow(e, e.seen.robot.velocity);
  const bool waits = e.seen.wait && e.seen.guide == Guide::passage &&
                     e.decision.plan.status != PlanStatus::overlapping && !e.decision.evasion;
  if (!waits) return robot + action_of(e) + ": " + reason_of(e, planner) + "." + state_of(e);
  if (rests) return robot + "waits " + wait_of(*e.seen.wait) + "." + state_of(e);
  return robot + action_of(e) + ": it has to wait " + wait_of(*e.seen.wait) + "." + state_of(e);
}

void explain_decision(const Planner& planner, Explanation& explanation) {
  const Simulation::Perception& seen = explanation.seen;
  DecisionTrace& decision = explanation.decision;
  PlanWorkspace workspace;
  Detour detour = seen.detour;
  decision = planner.explain(seen.robot, seen.neighbors, workspace, &detour, seen.walls);
  if (seen.stop && decision.plan.status != PlanStatus::overlapping) {
    const SafetyState state = decision.plan.state;
    decision.plan = *seen.stop;
    decision.plan.state = state;
    decision.evasion.reset();
  }
  explanation.state = planner.state(seen.robot, seen.neighbors, workspace, seen.walls);
  explanation.sentence = sentence_of(explanation, planner);
}

}  // namespace avo::inline guidance
