// SPDX-License-Identifier: Apache-2.0
// These tests check how deep the certificate's cuts go. No second proposal is in vain, and no robot
// backs off at rest.
#include <gtest/gtest.h>
#include <vector>

#include "planner/stages/certified.h"
#include "support/certificates.h"

namespace avo::test {
namespace {

// What robot A chooses beside robot B, and from how many cuts.
struct Outcome {
  CertifiedChoice choice;
  std::size_t cuts = 0;
};

Outcome choose_beside(const Robot& a, const Robot& b, Vec2 wanted, const CertificateLaw& law) {
  CertifiedWorkspace workspace;
  collect_constraints(a, std::vector<Neighbor>{seen(b)}, law, workspace.constraints);
  const CertifiedChoice choice = choose_certified(a, wanted, law, workspace);
  return {choice, workspace.hard.size()};
}

// Most refused wishes of pairs that meet take one cut. What is chosen is no farther from the wish
// than needed: a velocity nearer by a fifth of their distance is refused.
TEST(Cuts, lead_from_a_refused_wish_to_what_is_admitted_at_once) {
  const CertificateLaw law =
      law_of(options_of(Certificate::braking_trajectories, Motion::held, 0.1, 2.0));
  Random random(7);
  int refused = 0, at_once = 0, nearest = 0;
  while (refused < 300) {
    Robot a, b;
    a.velocity = random.uniform(1.0, 2.0) * Vec2{1.0, 0.0};
    b.position = random.uniform(1.2, 6.0) * random.direction();
    b.velocity = random.uniform(0.0, 2.0) * random.direction();
    const Vec2 wanted = a.velocity + random.uniform(0.0, 0.1) * random.direction();
    if (norm(wanted) > a.max_speed) continue;
    CertificateConstraints constraints;
    collect_constraints(a, std::vector<Neighbor>{seen(b)}, law, constraints);
    if (constraints.invariant.broken.any() || admits(a, wanted, law, constraints)) continue;
    const auto [choice, cuts] = choose_beside(a, b, wanted, law);
    if (choice.chosen != Chosen::candidate) continue;
    ++refused;
    at_once += cuts == 1 ? 1 : 0;
    const Vec2 nearer = choice.next_velocity + 0.2 * (wanted - choice.next_velocity);
    nearest += admits(a, nearer, law, constraints) ? 0 : 1;
  }
  EXPECT_GT(at_once, 270);
  EXPECT_GT(nearest, 270);
}

// Two at rest with little room between them, each of which would drive at the other one, come
// nearer: cuts by a part of the wish alone would send them backward.
TEST(Cuts, send_nobody_backward_who_rests_with_room_ahead) {
  const CertificateLaw law =
      law_of(options_of(Certificate::braking_trajectories, Motion::held, 0.1, 2.0));
  for (const double gap : {1e-6, 1e-5, 1e-4, 1e-3}) {
    Robot a, b;
    b.position = {a.radius + b.radius + gap, 0.0};
    const auto [choice, cuts] = choose_beside(a, b, {0.1, 0.0}, law);
    EXPECT_GT(choice.next_velocity.x, 0.0) << gap;
    EXPECT_GE(cuts, 1U) << gap;
  }
}

}  // namespace
}  // namespace avo::test
