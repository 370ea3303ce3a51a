// SPDX-License-Identifier: Apache-2.0
#include "guidance/phrases.h"

#include <numbers>

namespace avo::inline guidance {
namespace {

constexpr double kLittleDetour = 0.5;  // degrees

}  // namespace

const char* const kInvalidInput =
    "a number that it knows or senses is not finite or out of range, so it brakes";

Words goes_first(const Words& whom, bool inside) {
  return whom + (inside ? ", which is inside" : ", which goes first");
}

Words does(WishRule rule, const Words& whom) {
  switch (rule) {
    case WishRule::keeps_right:
      return "it keeps to the right of " + whom + " in traffic";
    case WishRule::yields:
      return "it makes room for " + whom;
    case WishRule::settles:
      return "it stays near its goal beside " + whom;
    case WishRule::leaves_wall:
      return "it leaves the wall that it is in";
    case WishRule::in_cell:
      return "it stays within its Voronoi cell";
    case WishRule::steers:
    case WishRule::none:
      break;
  }
  return "";
}

Words refused(PlanStatus status, const Words& whom, bool is_off) {
  if (status == PlanStatus::braking) return "nothing but braking keeps clear of " + whom;
  return Words("it could not surely stop before ") + whom +
         (is_off ? " on its detour" : " with the velocity that it wants");
}

Words misses(double violation, const Words& whom, const Words& half_planes, bool is_certified) {
  return "no velocity keeps to all " + half_planes + ", and this one misses them by the least, " +
         number(violation, 3) + " m/s" + (whom.empty() ? "" : ", because of " + whom) +
         (is_certified ? "; the certificate holds" : "");
}

Words binds(const Words& whom, bool are_several, const Words& half_plane) {
  return are_several ? "the " + half_plane + "s of " + whom + " bind"
                     : "the " + half_plane + " of " + whom + " binds";
}

Words is_on_detour(double radians, const Words& whom, bool is_refused, const Words& half_planes) {
  const double degrees = radians * 180.0 / std::numbers::pi;
  if (degrees < kLittleDetour)
    return (is_refused ? "it could not surely stop before " + whom
                       : half_planes + " of " + whom + " leave too little of its route") +
           ", so it goes on as far as the certificate admits";
  return Words("its route is blocked by ") + whom + ", so it is on a detour of " +
         number(degrees, 0) + " degrees to the right";
}

Words evades(const Words& whom, bool brakes) {
  return "what it would have chosen leaves no evasive maneuver beside " + whom +
         (brakes ? ", so it brakes" : ", so it makes room");
}

Words is_in_contact(const Words& whom) {
  if (whom.empty()) return "it is in contact already, and separates if it can";
  return "it is in contact with " + whom +
         ", or braking no longer avoids that, and it separates if it can";
}

Words is_free(bool has_it) {
  return has_it ? "it has the velocity that it prefers, and nothing refuses that"
                : "nothing refuses the velocity that it prefers";
}

Words is_kept_from_goal(const Words& walls, double left) {
  return walls + " keep it from its goal, " + number(left, 2) +
         " m away, and it is as near as it can come";
}

void add_words(const Words& words, Words& reason) {
  if (words.empty()) return;
  reason += (reason.empty() ? "" : "; ") + words;
}

}  // namespace avo::inline guidance
