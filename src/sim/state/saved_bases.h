// SPDX-License-Identifier: Apache-2.0
// Bodies with bases that do not execute exactly, in a saved state.
#pragma once
#include <cstddef>
#include <string>

#include "core/plane.h"
#include "core/ranges.h"
#include "robots/execution_bounds.h"
#include "sim/bases/bases.h"
#include "sim/state/archive.h"

namespace avo::inline sim {

template <bool kReads>
void describe(Archive<kReads>& archive, ExecutionModel& model) {
  for (double* value :
       {&model.time_constant, &model.time_constant_error, &model.dead_time, &model.dead_time_error,
        &model.deadband, &model.quantum, &model.velocity_error, &model.heading_age,
        &model.measured_position_error, &model.measured_velocity_error})
    describe(archive, *value);
}

template <bool kReads>
void describe(Archive<kReads>& archive, Base& base) {
  describe(archive, base.radius), describe(archive, base.added);
  describe(archive, base.position), describe(archive, base.velocity);
  if (!kPositive.contains(base.radius) || !kNotNegative.contains(base.added) ||
      !is_finite(base.position) || !is_finite(base.velocity))
    refuse_saved("a body that no robot can have", "its own");
}

/// Bodies at rest, of the robots in the state.
inline Bases bodies_of(const SavedState& state, const ExecutionModel& model,
                       std::optional<double> declared) {
  Scenario scene;
  scene.execution = model, scene.execution_error = declared;
  scene.time_step = state.scene.time_step, scene.seed = state.scene.seed;
  validate(model, scene.time_step, "saved state: execution.");
  Bases bases(scene);
  for (std::size_t k = 0; k < state.robots.size(); ++k) {
    RobotSetup robot = state.scene.robots[k];
    robot.heading = state.robots[k].heading;
    check_base(model, scene.time_step, robot, "saved state: robots." + std::to_string(k) + ".");
    bases.reserve_one();
    bases.add(state.robots[k].id, robot);
  }
  return bases;
}

template <bool kReads>
void describe_bases(Archive<kReads>& archive, SavedState& state) {
  ExecutionModel model = state.bases.model.value_or(ExecutionModel{});
  describe(archive, model), describe(archive, state.bases.declared);
  if constexpr (kReads) {
    const double most = model.dead_time / state.scene.time_step;
    const auto words = static_cast<double>(archive.unread.size() / kWord);
    if (!(most * static_cast<double>(state.robots.size()) <= words))
      refuse_saved("a dead_time of " + text(model.dead_time) + " s", "one with all commands");
    state.bases = bodies_of(state, model, state.bases.declared);
  }
  for (Base& base : state.bases.all) describe(archive, base);
  for (Vec2& command : state.bases.sent) {
    describe(archive, command);
    if (!is_finite(command)) refuse_saved("a command that is not finite", "finite ones");
  }
}

}  // namespace avo::inline sim
