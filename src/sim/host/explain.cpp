// SPDX-License-Identifier: Apache-2.0
// The next decision of one robot with its reasons: a step of that robot alone. No robot moves.
#include <string>

#include "avo/error.h"
#include "avo/explanation.h"
#include "guidance/words.h"
#include "sim/host/external.h"
#include "sim/simulation_state.h"

namespace avo {

Explanation Simulation::explain(RobotId robot) const {
  const RobotState present = this->robot(robot);
  const std::size_t slot = state_->fleet.find(robot);
  if (!state_->fleet.decides(slot))
    throw Error("robot " + std::to_string(present.id.value) + ": found " +
                (state_->fleet.is_parked(slot) ? "a parked one" : "one that the host moves") +
                ", must be one that decides");
  const Planner& own = planner(robot);
  Explanation explanation{.robot = present.id,
                          .time = time(),
                          .goal = present.goal,
                          .start_time = setup(robot).start_time,
                          .is_at_goal = is_at_goal(robot),
                          .distance_left = route(robot).distance_left,
                          .seen = perceive(robot),
                          .decision = {},
                          .state = {},
                          .sentence = {}};
  choose_externally(*state_, explanation.robot, explanation.goal, explanation.seen);
  explain_decision(own, explanation);
  return explanation;
}

}  // namespace avo
