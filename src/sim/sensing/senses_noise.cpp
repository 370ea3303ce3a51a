// SPDX-License-Identifier: Apache-2.0
// Bounds of what measurements err by, and what robots err by in their own places.
#include <numbers>

#include "core/draws.h"
#include "sim/sensing/senses.h"
#include "sim/world.h"

namespace avo::inline sim {
namespace {

MeasurementNoise as_measured(const LocalizationNoise& model) {
  return {model.position, 0.0, model.distribution, model.truncated};
}

}  // namespace

SensingError most_noise(const MeasurementNoise& model) {
  constexpr double kBoth = std::numbers::sqrt2 * (1.0 + 0x1p-40);
  const double most = kBoth * most_of_coordinate(model);
  return {most * model.position, most * model.velocity};
}

double most_lost(const LocalizationNoise& model) {
  return most_noise(as_measured(model)).position;
}

Vec2 own_error(const World& world, std::size_t slot) {
  const LocalizationNoise& model = world.settings.sensing.localization;
  if (!(model.position > 0.0)) return {};
  const std::uint64_t own = world.fleet.id[slot].value;
  Draws numbers(Draws::key_of(world.settings.seed, world.steps, own), own);
  const auto drawn = noise<2>(as_measured(model), numbers);
  return model.position * Vec2{drawn[0], drawn[1]};
}

}  // namespace avo::inline sim
