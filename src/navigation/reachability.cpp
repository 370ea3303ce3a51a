// SPDX-License-Identifier: Apache-2.0
#include "avo/reachability.h"

#include "core/ranges.h"
#include "navigation/reachable_places.h"

namespace avo {

struct Reachability::State : ReachablePlaces {
  using ReachablePlaces::ReachablePlaces;
};

Reachability::Reachability(std::span<const Wall> walls, double radius) {
  require("radius", radius, kPositive, "m");
  state_ = std::make_unique<State>(walls, radius);
}
Reachability::~Reachability() = default;
Reachability::Reachability(Reachability&&) noexcept = default;
Reachability& Reachability::operator=(Reachability&&) noexcept = default;

bool Reachability::connects(Vec2 from, Vec2 to) {
  return state_->is_free(from) && state_->is_free(to) && state_->are_connected(from, to);
}

Vec2 Reachability::nearest(Vec2 from, Vec2 to) {
  return state_->nearest_reached(from, to);
}

}  // namespace avo
