// SPDX-License-Identifier: Apache-2.0
// What happened to robots since the last look.
#include "avo/events.h"

#include <fmt/format.h>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "avo/space/events.h"
#include "renamed.h"
#include "simulation.h"
#include "space.h"

namespace avo_python {
namespace {

using avo::Event;
using avo::EventKind;
using py::arg;

/// An observer that threads share, like its simulation.
template <typename Events, typename Simulation>
class SharedEvents {
 public:
  SharedEvents(Simulation& simulation, double stuck_after) : simulation_(simulation) {
    simulation_.alone([&](const auto& s) {
      events_ = std::make_unique<Events>(s, avo::EventsOptions{stuck_after});
    });
  }
  std::vector<Event> observe() {
    return simulation_.alone([&](const auto& s) {
      const auto events = events_->observe(s);  // alone, by the simulation's mutex
      return std::vector<Event>(events.begin(), events.end());
    });
  }

 private:
  Simulation& simulation_;
  std::unique_ptr<Events> events_;
};

template <typename Events, typename Simulation>
void bind_observer(py::module_& module) {
  using Observer = SharedEvents<Events, Simulation>;
  py::class_<Observer>(module, "Events",
                       "What happens to robots from step to step, so that a host need not ask each "
                       "of them.")
      .def(py::init<Simulation&, double>(), py::keep_alive<1, 2>(), arg("simulation"),
           py::kw_only(), arg("stuck_after") = avo::EventsOptions{}.stuck_after,
           "stuck_after: s; a robot that makes no progress for so long is stuck. What holds now is "
           "no event.")
      .def("observe", &Observer::observe,
           "The events since the last look, a list of Event, by robot and kind. Call it after "
           "every step().");
}

std::string text_of(const Event& event) {
  const std::string what = fmt::format("{} {}", to_string(event.kind), event.robot.value);
  if (event.kind == EventKind::contact) {
    const std::uint64_t id =
        event.moved_robot ? event.moved_robot->value : event.moving_obstacle.value;
    return fmt::format("<avo.Event {} with {} {}{}>", what,
                       event.moved_robot ? "moved robot" : "moving obstacle", id,
                       event.at_rest ? ", at rest" : "");
  }
  return event.kind == EventKind::stuck ? fmt::format("<avo.Event {}: {}>", what, event.sentence)
                                        : fmt::format("<avo.Event {}>", what);
}

}  // namespace

void bind_events(py::module_& module) {
  py::class_<Event> type(module, "Event", "What happened to one robot.");
  refuse_renamed(type, {{"obstacle", "moving_obstacle"}});
  type.def_property_readonly(
          "kind", [](const Event& event) { return std::string(to_string(event.kind)); },
          "gone (removed, or an airplane that left), came (added), left (its goal: it was pushed "
          "away, is steered, or has a new one), arrived, unreachable (its goal, by walls), stuck, "
          "contact (with a moving obstacle, or with a robot that the host moves).")
      .def_property_readonly(
          "robot", [](const Event& event) { return event.robot.value; }, "Its id.")
      .def_property_readonly(
          "moving_obstacle",
          [](const Event& event) -> std::optional<std::uint64_t> {
            if (event.kind != EventKind::contact || event.moved_robot) return std::nullopt;
            return event.moving_obstacle.value;
          },
          "Id of the moving obstacle of a contact; else None.")
      .def_property_readonly(
          "moved_robot",
          [](const Event& event) {
            return event.moved_robot ? std::optional(event.moved_robot->value) : std::nullopt;
          },
          "Of a contact, id of the robot that the host moves; else None.")
      .def_property_readonly(
          "at_rest",
          [](const Event& event) -> std::optional<bool> {
            if (event.kind != EventKind::contact) return std::nullopt;
            return event.at_rest;
          },
          "Of a contact: whether the robot has not moved since the last look; else None.")
      .def_property_readonly(
          "sentence",
          [](const Event& event) -> std::optional<std::string> {
            if (event.kind != EventKind::stuck) return std::nullopt;
            return event.sentence;
          },
          "Why a robot is stuck, as Simulation.explain() says; else None.")
      .def("__repr__", &text_of);
  bind_observer<avo::Events, SharedSimulation>(module);
}

namespace space {

void bind_events(py::module_& module) {
  bind_observer<avo::space::Events, SharedSpaceSimulation>(module);
}

}  // namespace space

}  // namespace avo_python
