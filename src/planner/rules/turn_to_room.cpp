// SPDX-License-Identifier: Apache-2.0
#include "planner/rules/turn_to_room.h"

#include "robots/footprint.h"

namespace avo::inline planner {

bool turns_at_rest(const Robot& robot) {
  return robot.velocity == Vec2{} && turns_unnoticed(robot.model);
}

template <typename Trace>
CertifiedChoice choose_as_turned(const Certifying& decision, Vec2 wanted, Trace trace) {
  Robot turned = decision.robot;
  turned.model = Holonomic{};
  return choose_certified(turned, wanted, decision.law, decision.certified, Follows::perhaps,
                          trace);
}

template <typename Trace>
CertifiedChoice choose_admitted(const Certifying& decision, Vec2 wanted, Follows follows,
                                Trace trace) {
  if (!turns_at_rest(decision.robot) || wanted == Vec2{})
    return choose_certified(decision.robot, wanted, decision.law, decision.certified, follows,
                            trace);
  const Vec2 later = choose_as_turned(decision, wanted, trace).next_velocity;
  CertifiedChoice choice =
      choose_certified(decision.robot, later, decision.law, decision.certified);
  if (choice.chosen == Chosen::backup && later != Vec2{})
    choice = choose_certified(decision.robot, turning_first(decision.robot, later), decision.law,
                              decision.certified);
  if (later != wanted && choice.chosen == Chosen::wanted) choice.chosen = Chosen::candidate;
  return choice;
}

template CertifiedChoice choose_as_turned(const Certifying&, Vec2, NoTrace);
template CertifiedChoice choose_admitted(const Certifying&, Vec2, Follows, NoTrace);
template CertifiedChoice choose_admitted(const Certifying&, Vec2, Follows, Recorder);

}  // namespace avo::inline planner
