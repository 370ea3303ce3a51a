// SPDX-License-Identifier: Apache-2.0
// The parts of a simulation besides its world: the views that are made on demand.
#pragma once
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "avo/error.h"
#include "core/mutex.h"
#include "sim/clocks.h"
#include "sim/columns/fleet_mirror.h"
#include "sim/host/nearby.h"
#include "sim/sensing/index.h"
#include "sim/world.h"

namespace avo {

struct Simulation::State : World {
  using World::World;

  // in the order of ids; made on demand
  Mutex looking;
  std::atomic<Columns> mirrored = Columns{};
  FleetMirror mirror;
  std::uint64_t roster = next_roster();
  bool has_claims = false;    // of the present generation, for readers
  bool has_snapshot = false;  // of the present places, for readers
  Nearby nearby;
  std::vector<Claims> present_claims;

  /// See avo::catch_up(), for readers.
  void catch_up() {
    if (is_current) return;
    const Lock lock(looking);
    avo::catch_up(*this);
  }
  /// Lets readers sense what robots sense now.
  void look_at_present() {
    catch_up();
    const Lock lock(looking);
    if (!has_snapshot) avo::look_at_present(*this);
    has_snapshot = true;
  }
  /// The claims of passages as they are now, for readers.
  std::span<const Claims> claims_now() {
    const Lock lock(looking);
    if (changed) find_walls(*this);
    if (!has_claims) collect_claims(*this, serial, present_claims);
    has_claims = true;
    return present_claims;
  }
  /// The discs and walls as they are now, for readers.
  const Nearby& nearby_now() {
    catch_up();
    const Lock lock(looking);
    look_around(*this, nearby);
    return nearby;
  }
  const Nearby& walls_now() {
    const Lock lock(looking);
    look_at_walls(*this, nearby);
    return nearby;
  }
  /// Itself, to be changed. Throws Error within a function that the step calls.
  State& to_change() {
    if (external.is_asked)
      throw Error("external_method: found a change within the step that asks it, must be after it");
    return *this;
  }
  /// Discs have moved, changed or gone.
  void forget_discs() { nearby.has_discs = false; }
  void forget_views() {
    mirrored = Columns{};
    has_claims = has_snapshot = false;
  }
  void forget_robots() {
    forget_views();
    forget_discs();
    roster = next_roster();
  }
  /// Updates the views of one robot alone, which is still present.
  void forget_views_of(RobotId robot) {
    const Columns copied = mirrored;
    if (copied != Columns{})
      mirror.renew(fleet, static_cast<std::size_t>(fleet.rank[*fleet.slot(robot)]), copied);
    has_claims = has_snapshot = false;
  }

  static std::uint64_t next_roster() {
    static std::atomic<std::uint64_t> next = 0;
    return ++next;
  }
  static std::unique_ptr<State> of(const Scenario& scenario, std::shared_ptr<Executor> executor);
  static std::unique_ptr<State> of(std::span<const std::byte> saved,
                                   std::shared_ptr<Executor> executor);
};

void lead_teams(Simulation& simulation, std::vector<Team>& teams);

/// Throws Error after a step that did not end. call: the function that needs a whole step.
void require_whole(const World& world, const char* call);

}  // namespace avo
