// SPDX-License-Identifier: Apache-2.0
// What happened to robots of space since the last look: the events of avo/events.h.
#pragma once
#include <memory>
#include <span>

#include "avo/events.h"
#include "avo/export.h"
#include "avo/space/simulation.h"

namespace avo::space {

/// Call observe() after every step. What holds when the object is made is no event. Each event is a
/// difference from the last look, also after edits. Robots of a simulation neither come nor go, and
/// the host steers none. A contact is that of two balls, whatever the robot's downwash.
class AVO_API Events {
 public:
  /// Throws Error on a bad stuck_after.
  explicit Events(const Simulation& simulation, const EventsOptions& options = {});
  ~Events();
  /// The events since the last look, by robot and then by kind; contacts of one robot are by
  /// moving obstacle. They are valid until the next call. A call allocates nothing where nothing
  /// happens. As Simulation::explain(), it excludes other calls.
  std::span<const Event> observe(const Simulation& simulation);

 private:
  struct AVO_LOCAL State;
  std::unique_ptr<State> state_;
};

}  // namespace avo::space
