// SPDX-License-Identifier: Apache-2.0
// Checks of a scene's teams.
#include <string>
#include <vector>

#include "core/ranges.h"
#include "core/retell.h"
#include "sim/scene/scene_checks.h"

namespace avo::inline sim {
namespace {

void check_members(const std::string& path, const Team& team, const Scenario& scenario,
                   std::vector<bool>& is_member) {
  if (team.members.empty()) refuse(path + "members", "none", "at least one");
  for (const TeamMember& member : team.members) {
    const std::string number = std::to_string(member.robot.value);
    if (member.robot.value >= scenario.robots.size())
      refuse(path + "members", "robot " + number,
             "0 to " + std::to_string(scenario.robots.size() - 1));
    const auto k = static_cast<std::size_t>(member.robot.value);
    if (is_parked(scenario.robots[k]))
      refuse(path + "members", "robot " + number + ", which is parked", "robots that move");
    if (is_member[k]) refuse(path + "members", "robot " + number + " again", "in one team at most");
    is_member[k] = true;
  }
}

}  // namespace

void check_teams(const Scenario& scenario) {
  std::vector<bool> is_member(scenario.teams.empty() ? 0 : scenario.robots.size());
  for (std::size_t k = 0; k < scenario.teams.size(); ++k) {
    const std::string path = "teams." + std::to_string(k) + ".";
    retelling<Error>([&] { validate(scenario.teams[k].task); },
                     [&](const Error& error) { throw Error(path + error.what()); });
    check_members(path, scenario.teams[k], scenario, is_member);
  }
}

}  // namespace avo::inline sim
