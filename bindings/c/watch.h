// SPDX-License-Identifier: Apache-2.0
// The events of the steps of a simulation, of the plane or of space.
#pragma once
#include <memory>
#include <span>
#include <string>

#include "avo/events.h"
#include "errors.h"

namespace avo_c {

template <typename Events>
struct Watch {
  std::unique_ptr<Events> events;          // where the simulation is watched
  std::span<const avo::Event> happened{};  // in the last step

  template <typename Simulation>
  void begin(const Simulation& simulation, double stuck_after) {
    avo::EventsOptions options;
    if (stuck_after != 0.0) options.stuck_after = stuck_after;
    events = std::make_unique<Events>(simulation, options);
    happened = {};
  }

  /// Takes the events of the step, if the simulation is watched. Returns false where memory ran out
  /// for them: then they end.
  template <typename Simulation>
  bool observe(const Simulation& simulation) noexcept {
    happened = {};
    if (!events) return true;
    try {
      happened = events->observe(simulation);
    } catch (...) {
      events.reset();
    }
    return events != nullptr;
  }

  /// The events of the last step; function: that begins the watch. Throws Failure where there is
  /// none.
  [[nodiscard]] std::span<const avo::Event> last(const char* function) const {
    if (events == nullptr)
      fail(AVO_ERROR_UNSUPPORTED,
           std::string("events: found a simulation that is not watched, must be one after ") +
               function + "()");
    return happened;
  }
};

/// has_events: as observe() returned.
inline void require_events(bool has_events) {
  if (!has_events)
    fail(AVO_ERROR_OUT_OF_MEMORY, "events: memory ran out, the step is done, they end");
}

}  // namespace avo_c
