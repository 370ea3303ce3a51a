// SPDX-License-Identifier: Apache-2.0
// The next decision of one robot with its reasons: a step of that robot alone, which moves nobody.
#include <string>

#include "avo/error.h"
#include "avo/explanation.h"
#include "sim/external.h"
#include "sim/simulation_state.h"
#include "sim/words.h"

namespace avo {

Explanation Simulation::explain(std::size_t robot) const {
  const RobotState present = this->robot(robot);
  if (state_->fleet.conduct[state_->fleet.slot_of[robot]].parked)
    throw Error("robot " + std::to_string(present.id.value) +
                ": found a parked one, must be one that decides");
  const Planner& own = planner(robot);
  Explanation explanation{.robot = present.id,
                          .time = time(),
                          .goal = present.goal,
                          .is_at_goal = is_at_goal(robot),
                          .distance_left = way(robot).distance_left,
                          .seen = perceive(robot),
                          .decision = {},
                          .state = {},
                          .sentence = {}};
  choose_externally(*state_, explanation.robot, explanation.goal, explanation.seen);
  const Perception& seen = explanation.seen;
  DecisionTrace& decision = explanation.decision;
  PlanWorkspace workspace;
  Detour detour = seen.detour;
  decision = own.explain(seen.robot, seen.neighbors, workspace, &detour, seen.walls);
  if (seen.stop && decision.plan.status != PlanStatus::overlapping) {
    const SafetyState state = decision.plan.state;
    decision.plan = *seen.stop;
    decision.plan.state = state;
    decision.evasion.reset();
  }
  explanation.state = own.state(seen.robot, seen.neighbors, workspace, seen.walls);
  explanation.sentence = sentence_of(explanation, own);
  return explanation;
}

}  // namespace avo
