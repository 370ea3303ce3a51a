// SPDX-License-Identifier: Apache-2.0
#include "sim/scene/one_sided.h"

#include <algorithm>
#include <cstdint>
#include <vector>

#include "robots/model.h"

namespace avo::inline sim {
namespace {

// All robots of the same kind avoid the same others.
struct AvoidanceKind {
  std::uint32_t layers, avoids;
  bool flies, swings;

  friend bool operator==(const AvoidanceKind&, const AvoidanceKind&) = default;
};

struct Example {
  AvoidanceKind kind;
  std::size_t robot;
};

// One robot of each kind; there are few kinds.
std::vector<Example> examples_of(std::span<const RobotSetup> robots) {
  std::vector<Example> examples;
  for (std::size_t i = 0; i < robots.size(); ++i) {
    if (is_parked(robots[i])) continue;
    const AvoidanceKind own{robots[i].layers.bits, robots[i].avoids.bits,
                            !can_rest(robots[i].model), model_traits(robots[i].model).swings};
    const bool known = std::any_of(examples.begin(), examples.end(),
                                   [&](const Example& example) { return example.kind == own; });
    if (!known) examples.push_back({own, i});
  }
  return examples;
}

}  // namespace

std::optional<OneSided> find_impossible(std::span<const RobotSetup> robots) {
  const std::vector<Example> examples = examples_of(robots);
  for (const auto& [a, i] : examples) {
    for (const auto& [b, j] : examples) {
      if ((a.avoids & b.layers) == 0 || (b.avoids & a.layers) != 0) continue;
      if (a.flies || b.flies) return OneSided{i, j, "one of them cannot stop"};
      if (b.swings) return OneSided{i, j, "its body is not over its axle"};
    }
  }
  return std::nullopt;
}

}  // namespace avo::inline sim
