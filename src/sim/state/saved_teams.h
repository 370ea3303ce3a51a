// SPDX-License-Identifier: Apache-2.0
// Teams in a saved state.
#pragma once
#include <cstddef>
#include <cstdint>
#include <string>
#include <variant>
#include <vector>

#include "avo/teams.h"
#include "sim/state/archive.h"

namespace avo::inline sim {

inline constexpr std::size_t kTeamWords = 5, kMemberWords = 5;  // a team has at least

template <bool kReads>
void describe(Archive<kReads>& archive, Queue& queue) {
  describe(archive, queue.line), describe(archive, queue.spacing);
  describe(archive, queue.service);
}
template <bool kReads>
void describe(Archive<kReads>& archive, Follow& follow) {
  describe(archive, follow.spacing), describe(archive, follow.slots);
}
template <bool kReads>
void describe(Archive<kReads>& archive, Patrol& patrol) {
  describe(archive, patrol.points), describe(archive, patrol.pass_distance);
}
template <bool kReads>
void describe(Archive<kReads>& archive, Flow& flow) {
  describe(archive, flow.exits), describe(archive, flow.spacing);
}

template <bool kReads>
void describe(Archive<kReads>& archive, TeamTask& task) {
  std::uint64_t kind = task.index();
  archive.word(kind);
  if constexpr (kReads) {
    if (kind == 1) task = Follow{};
    if (kind == 2) task = Patrol{};
    if (kind == 3) task = Flow{};
    if (kind > 3) refuse_saved("the task " + std::to_string(kind), "0 to 3");
  }
  std::visit([&](auto& one) { describe(archive, one); }, task);
}

template <bool kReads>
void describe_teams(Archive<kReads>& archive, std::vector<Team>& teams) {
  archive.size(teams, kTeamWords);
  for (Team& team : teams) {
    describe(archive, team.task);
    archive.size(team.members, kMemberWords);
    for (TeamMember& member : team.members) {
      describe(archive, member.robot.value), describe(archive, member.is_led);
      describe(archive, member.goal), describe(archive, member.number);
    }
    describe(archive, team.trail);
    describe(archive, team.leader.value), describe(archive, team.since);
  }
}

}  // namespace avo::inline sim
