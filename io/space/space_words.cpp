// SPDX-License-Identifier: Apache-2.0
#include "io/space/space_words.h"

#include <cmath>
#include <fmt/format.h>
#include <vector>

#include "avo/vec.h"

namespace avo_io {
namespace {

using avo::PlanStatus;
using avo::Vec3;

constexpr double kResting = 0.01;      // of v_max: a slower robot is at rest
constexpr double kLittleGain = 0.002;  // of the speed, in a step: not worth a word
constexpr double kLittleTurn = 0.004;  // rad, in a step: not worth a word
constexpr double kAsPreferred = 1e-6;  // m/s

bool is_slow(const SpaceDecision& decision, Vec3 v) {
  return norm(v) < kResting * decision.self.max_speed;
}

// E.g. "turns right, climbs more and slows down".
std::string action_of(const SpaceDecision& decision) {
  const Vec3 v = decision.self.velocity, next = decision.plan.next_velocity;
  const bool rests = is_slow(decision, v);
  if (rests) return is_slow(decision, next) ? "stays at rest" : "starts";
  if (next == Vec3{}) return "comes to rest";
  std::vector<std::string> words;
  const double turned = v.x * next.y - v.y * next.x;
  const double horizontal = norm(avo::Vec2{v.x, v.y}) * norm(avo::Vec2{next.x, next.y});
  if (std::abs(turned) >= kLittleTurn * horizontal && horizontal > 0.0)
    words.emplace_back(turned > 0.0 ? "turns left" : "turns right");
  const double rise = next.z / norm(next) - v.z / norm(v);
  if (std::abs(rise) >= kLittleTurn) words.emplace_back(rise > 0.0 ? "turns up" : "turns down");
  const double gain = norm(next) - norm(v);
  if (std::abs(gain) >= kLittleGain * norm(v))
    words.emplace_back(gain > 0.0 ? "speeds up" : "slows down");
  if (words.empty()) return "keeps its velocity";
  std::string text = words.front();
  for (std::size_t k = 1; k < words.size(); ++k)
    text += (k + 1 == words.size() ? " and " : ", ") + words[k];
  return text;
}

// At most four names, then how many more there are.
std::string list_of(const SpaceDecision& decision, const std::vector<SpaceCause>& causes) {
  constexpr std::size_t kMost = 4;
  if (causes.empty()) return "others";
  const std::size_t named = causes.size() > kMost ? kMost - 1 : causes.size();
  std::string text;
  for (std::size_t k = 0; k < named; ++k) {
    const bool is_last = k + 1 == causes.size();
    text += (k == 0 ? "" : is_last ? " and " : ", ") + name_of(decision, causes[k]);
  }
  if (named < causes.size()) text += fmt::format(" and {} more", causes.size() - named);
  return text;
}

std::string contact_of(const SpaceDecision& decision) {
  const avo::space::Plan& plan = decision.plan;
  if (plan.neighbor < 0 && plan.box < 0) return "it is in contact already, and separates if it can";
  // the simulation counts neighbors in another order, so they are not named
  const std::string whom =
      plan.box >= 0 ? name_of(decision, {-1, plan.box}) : std::string("another robot");
  return "it is in contact with " + whom +
         ", or braking no longer avoids that, and it separates if it can";
}

std::string program_of(const SpaceDecision& decision) {
  const std::string whom = list_of(decision, decision.binding);
  if (decision.plan.status == PlanStatus::least_unsafe)
    return fmt::format(
        "no velocity keeps to all half-spaces, and this one misses them by the least, {:.3f} m/s; "
        "the certificate holds",
        decision.plan.violation);
  if (decision.binding.empty() && !decision.heeded.empty())
    return "it keeps to the right of " + list_of(decision, decision.heeded) +
           " in traffic, or makes room";
  if (decision.binding.empty()) return "";
  return decision.binding.size() > 1 ? "the half-spaces of " + whom + " bind"
                                     : "the half-space of " + whom + " binds";
}

std::string freedom_of(const SpaceDecision& decision) {
  const avo::space::Robot& self = decision.self;
  if (decision.is_at_goal && is_slow(decision, self.velocity)) return "it is at its goal";
  return norm(self.velocity - self.preferred_velocity) < kAsPreferred
             ? "it has the velocity that it prefers, and nothing refuses that"
             : "nothing refuses the velocity that it prefers";
}

std::string reason_of(const SpaceDecision& decision) {
  const std::string refusing = list_of(decision, decision.refusing);
  switch (decision.plan.status) {
    case PlanStatus::invalid_input:
      return "a number that it knows or senses is not finite or out of range, so it brakes";
    case PlanStatus::overlapping:
      return contact_of(decision);
    case PlanStatus::braking:
      return "nothing but braking keeps clear of " + refusing;
    case PlanStatus::refused:
      return "it could not surely stop before " + refusing + " with the velocity that it wants";
    case PlanStatus::detour:
      return "its way is blocked by " +
             list_of(decision, decision.refusing.empty() ? decision.binding : decision.refusing) +
             ", so it is on a detour to the right";
    case PlanStatus::optimal:
    case PlanStatus::least_unsafe:
      break;
  }
  const std::string program = program_of(decision);
  return program.empty() ? freedom_of(decision) : program;
}

}  // namespace

std::string name_of(const SpaceDecision& decision, SpaceCause cause) {
  if (cause.neighbor >= 0)
    return fmt::format("robot {}", decision.numbers[static_cast<std::size_t>(cause.neighbor)]);
  return fmt::format("obstacle {}", decision.obstacles[static_cast<std::size_t>(cause.box)]);
}

std::string sentence_of(const SpaceDecision& decision) {
  std::string text =
      fmt::format("Robot {} {}: {}.", decision.robot, action_of(decision), reason_of(decision));
  if (decision.plan.state == avo::SafetyState::safe)
    text += " Braking keeps clear of all others (safe).";
  return text;
}

}  // namespace avo_io
