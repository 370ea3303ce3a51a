// SPDX-License-Identifier: Apache-2.0
#include "planner/rules/turn_to_room.h"

#include "robots/footprint.h"

namespace avo::inline planner {

bool turns_at_rest(const Robot& robot) {
  return robot.velocity == Vec2{} && turns_unnoticed(robot.model);
}

CertifiedChoice choose_as_turned(const Certifying& decision, Vec2 wanted) {
  Robot turned = decision.robot;
  turned.model = Holonomic{};
  return choose_certified(turned, wanted, decision.law, decision.certified);
}

CertifiedChoice choose_admitted(const Certifying& decision, Vec2 wanted, Follows follows) {
  if (!turns_at_rest(decision.robot) || wanted == Vec2{})
    return choose_certified(decision.robot, wanted, decision.law, decision.certified, follows);
  const Vec2 later = choose_as_turned(decision, wanted).next_velocity;
  CertifiedChoice choice =
      choose_certified(decision.robot, later, decision.law, decision.certified);
  if (choice.chosen == Chosen::backup && later != Vec2{})
    choice = choose_certified(decision.robot, turning_first(decision.robot, later), decision.law,
                              decision.certified);
  if (later != wanted && choice.chosen == Chosen::wanted) choice.chosen = Chosen::candidate;
  return choice;
}

}  // namespace avo::inline planner
