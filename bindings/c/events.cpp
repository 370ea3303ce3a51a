// SPDX-License-Identifier: Apache-2.0
// What happened to robots in the last step.
#include "avo/events.h"

#include <string>

#include "simulations.h"
#include "space_simulations.h"

namespace avo_c {
namespace {

static_assert(AVO_EVENT_CONTACT == static_cast<int>(avo::EventKind::contact));
static_assert(AVO_EVENT_ARRIVED == static_cast<int>(avo::EventKind::arrived));

avo_event to_c(const avo::Event& event) {
  const bool is_with_obstacle = event.kind == avo::EventKind::contact && !event.moved_robot;
  return {.kind = static_cast<avo_event_kind>(event.kind),
          .robot = avo_c::to_c(event.robot),
          .moving_obstacle = {is_with_obstacle ? event.moving_obstacle.value + 1 : 0},
          .at_rest = event.at_rest,
          .moved_robot = event.moved_robot ? avo_c::to_c(*event.moved_robot) : avo_robot_id{}};
}

std::span<const avo::Event> happened_in(avo_simulation_id simulation) {
  return simulations.at(simulation).watch.last("avo_simulation_watch");
}

std::span<const avo::Event> happened_in(avo_space_simulation_id simulation) {
  return fleets.at(simulation).watch.last("avo_space_simulation_watch");
}

// Writes the events into the buffer, if they fit.
void list_events(std::span<const avo::Event> events, avo_event* buffer, std::size_t capacity,
                 std::size_t* count) {
  at(count, "count") = events.size();
  if (buffer == nullptr) return;
  require_room(capacity, events.size());
  for (const avo::Event& event : events) *buffer++ = to_c(event);
}

// Writes the sentence of one of them.
void write_sentence(std::span<const avo::Event> events, std::size_t event, char* buffer,
                    std::size_t capacity, std::size_t* size) {
  std::size_t& written = at(size, "size");
  if (event >= events.size())
    fail(AVO_ERROR_INVALID_VALUE, "event: found " + std::to_string(event) +
                                      ", must be less than the number of events, " +
                                      std::to_string(events.size()));
  const std::string& sentence = events[event].sentence;
  write_bytes(sentence.c_str(), sentence.size() + 1, buffer, capacity, written);
}

}  // namespace
}  // namespace avo_c

using namespace avo_c;  // NOLINT(google-build-using-namespace): what follows is C

avo_result avo_simulation_watch(avo_simulation_id simulation, double stuck_after) {
  return guarded([&] {
    Simulation& own = simulations.at(simulation);
    own.watch.begin(own.simulation, stuck_after);
  });
}

avo_result avo_simulation_events(avo_simulation_id simulation, avo_event* buffer, size_t capacity,
                                 size_t* count) {
  return guarded([&] { list_events(happened_in(simulation), buffer, capacity, count); });
}

avo_result avo_simulation_event_sentence(avo_simulation_id simulation, size_t event, char* buffer,
                                         size_t capacity, size_t* size) {
  return guarded([&] { write_sentence(happened_in(simulation), event, buffer, capacity, size); });
}

avo_result avo_space_simulation_watch(avo_space_simulation_id simulation, double stuck_after) {
  return guarded([&] {
    SpaceSimulation& own = fleets.at(simulation);
    own.watch.begin(own, stuck_after);
  });
}

avo_result avo_space_simulation_events(avo_space_simulation_id simulation, avo_event* buffer,
                                       size_t capacity, size_t* count) {
  return guarded([&] { list_events(happened_in(simulation), buffer, capacity, count); });
}

avo_result avo_space_simulation_event_sentence(avo_space_simulation_id simulation, size_t event,
                                               char* buffer, size_t capacity, size_t* size) {
  return guarded([&] { write_sentence(happened_in(simulation), event, buffer, capacity, size); });
}
