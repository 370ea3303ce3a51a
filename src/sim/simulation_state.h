// SPDX-License-Identifier: Apache-2.0
// What a simulation is made of besides its world: what is told of it, once somebody asks.
#pragma once
#include <atomic>
#include <cstddef>
#include <memory>
#include <span>

#include "core/mutex.h"
#include "sim/world.h"

namespace avo {

struct Simulation::State : World {
  using World::World;

  // in the order of ids; made when it is asked for
  Mutex looking;
  std::atomic<bool> is_mirrored = false;
  FleetMirror mirror;
  bool has_claims = false;  // of the present generation, for those who ask
  Claims present_claims;

  void forget_views() { is_mirrored = has_claims = false; }

  static std::unique_ptr<State> of(const Scenario& scenario, std::shared_ptr<Executor> executor);
  static std::unique_ptr<State> of(std::span<const std::byte> saved,
                                   std::shared_ptr<Executor> executor);
};

}  // namespace avo
