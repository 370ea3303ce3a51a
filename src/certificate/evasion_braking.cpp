// SPDX-License-Identifier: Apache-2.0
#include "certificate/evasion_braking.h"

#include "core/plane.h"

namespace avo::inline certificate {

FullBraking braking_from(const EvasionOptions& options, const EvasionState& state,
                         EvasionDiscs& discs) {
  FullBraking braking;
  const double speed = norm(state.velocity);
  braking.profile = braking_profile(speed, options.decrement);
  if (options.footprint) braking.footprint = brake_discs(options, state, discs);
  braking.position = braking.end = state.position;
  if (is_rest(state.velocity)) return braking;
  braking.direction = state.velocity / speed;
  braking.steps = braking.profile.full_steps + 1.0;
  braking.end = state.position + stopping_length(braking.profile, options.law) * braking.direction;
  return braking;
}

Hull interval_of(const FullBraking& braking, const StepLaw& law, std::size_t m) {
  const BrakingDistances along = braking_distances(braking.profile, law, static_cast<int>(m));
  return {braking.position + along.start * braking.direction,
          braking.position + along.middle * braking.direction,
          braking.position + along.end * braking.direction};
}

bool stays_clear(const Predicted& other, const FullBraking& braking, double time) {
  if (braking.footprint.empty()) return rests_clear(other, braking.end, time);
  return std::all_of(braking.footprint.begin(), braking.footprint.end(),
                     [&](const BrakingDisc& disc) {
                       return rests_clear(other, braking.end + disc.offset, time, disc.grown);
                     });
}

}  // namespace avo::inline certificate
