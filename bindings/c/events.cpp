// SPDX-License-Identifier: Apache-2.0
// What happened to robots in the last step.
#include "avo/events.h"

#include <cstring>
#include <string>

#include "simulations.h"

namespace avo_c {

bool observe_events(Simulation& simulation) noexcept {
  simulation.happened = {};
  if (!simulation.events) return true;
  try {
    simulation.happened = simulation.events->observe(simulation.simulation);
  } catch (...) {
    simulation.events.reset();
  }
  return simulation.events != nullptr;
}

namespace {

static_assert(AVO_EVENT_CONTACT == static_cast<int>(avo::EventKind::contact));
static_assert(AVO_EVENT_ARRIVED == static_cast<int>(avo::EventKind::arrived));

avo_event to_c(const avo::Event& event) {
  const bool is_contact = event.kind == avo::EventKind::contact;
  return {.kind = static_cast<avo_event_kind>(event.kind),
          .robot = avo_c::to_c(event.robot),
          .moving_obstacle = {is_contact ? event.moving_obstacle.value + 1 : 0},
          .at_rest = event.at_rest};
}

std::span<const avo::Event> happened_in(avo_simulation_id simulation) {
  const Simulation& own = simulations.at(simulation);
  if (own.events == nullptr)
    fail(AVO_ERROR_UNSUPPORTED,
         "events: found a simulation that is not watched, must be one after "
         "avo_simulation_watch()");
  return own.happened;
}

}  // namespace
}  // namespace avo_c

using namespace avo_c;  // NOLINT(google-build-using-namespace): what follows is C

avo_result avo_simulation_watch(avo_simulation_id simulation, double stuck_after) {
  return guarded([&] {
    Simulation& own = simulations.at(simulation);
    avo::EventsOptions options;
    if (stuck_after != 0.0) options.stuck_after = stuck_after;
    own.events = std::make_unique<avo::Events>(own.simulation, options);
    own.happened = {};
  });
}

avo_result avo_simulation_events(avo_simulation_id simulation, avo_event* buffer, size_t capacity,
                                 size_t* count) {
  return guarded([&] {
    std::size_t& written = at(count, "count");
    const std::span<const avo::Event> events = happened_in(simulation);
    written = events.size();
    if (buffer == nullptr) return;
    require_room(capacity, events.size());
    for (const avo::Event& event : events) *buffer++ = to_c(event);
  });
}

avo_result avo_simulation_event_sentence(avo_simulation_id simulation, size_t event, char* buffer,
                                         size_t capacity, size_t* size) {
  return guarded([&] {
    std::size_t& written = at(size, "size");
    const std::span<const avo::Event> events = happened_in(simulation);
    if (event >= events.size())
      fail(AVO_ERROR_INVALID_VALUE, "event: found " + std::to_string(event) +
                                        ", must be less than the number of events, " +
                                        std::to_string(events.size()));
    const std::string& sentence = events[event].sentence;
    write_bytes(sentence.c_str(), sentence.size() + 1, buffer, capacity, written);
  });
}
