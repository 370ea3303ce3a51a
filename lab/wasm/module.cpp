// SPDX-License-Identifier: Apache-2.0
// A scene, its simulation, and the steps. The host makes its views anew for each address that a
// call returns, because memory that has grown moves.
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "avo/error.h"
#include "avo_io/recording.h"
#include "avo_io/scene.h"
#include "avo_io/space.h"
#include "host.h"
#include "io/files/file_names.h"
#include "io/scene/builtin.h"

namespace avo_lab {
namespace {

std::vector<std::byte> room;

/// Reads the source as the host has stored it. First come name, text, whether robots start at rest
/// and within the admissible speed, and whether the source comes from a recording. Overrides and
/// files follow, each list with its number in front.
avo_io::SceneSource source_of(Input& input) {
  avo_io::SceneSource source{input.text(), input.text(), {}, {}};
  source.start_at_rest = input.whole() != 0;
  source.limit_speed = input.whole() != 0;
  source.recorded = input.whole() != 0;
  for (std::uint32_t left = input.whole(); left > 0; --left)
    source.overrides.push_back(input.text());
  for (std::uint32_t left = input.whole(); left > 0; --left) {
    avo_io::SceneFile file{input.text(), input.text()};
    file.builtin = input.whole() != 0;
    source.files.push_back(std::move(file));
  }
  // behind the given files, which are found first
  for (const avo_io::EmbeddedFile& file : avo_io::embedded_files())
    if (!file.is_scene)
      source.files.push_back({avo_io::path_in(avo_io::folder_of(source.name), file.name),
                              std::string(file.text), true});
  return source;
}

void begin(avo::space::Scenario scenario, bool observed) {
  SpaceRun next{std::move(scenario), nullptr, nullptr};
  next.simulation = std::make_unique<avo::space::Simulation>(next.scenario);
  if (observed) {
    next.metrics = std::make_unique<avo::space::Metrics>(next.scenario);
    next.metrics->observe(*next.simulation);
  }
  run() = std::move(next);
}

void begin(avo::Scenario scenario, bool observed, bool takes_over) {
  Takeover next = takes_over ? taken_over_by(scenario) : Takeover{.start = scenario};
  // moving obstacles begin as the text says, and then continue from their present places
  avo::Scenario start = next.start;
  start.moving_obstacles = scenario.moving_obstacles;
  // the lab shows the consequences, and info() reports them
  start.allow_broken_assumptions = true;
  auto simulation = std::make_unique<avo::Simulation>(start);
  for (const avo::RobotId robot : next.gone) simulation->remove_robot(robot);
  if (takes_over) remember(*simulation, next.goes_on);
  PlaneRun began{std::move(scenario), std::move(next.start), std::move(simulation), nullptr};
  if (observed) {
    began.metrics = std::make_unique<avo::Metrics>(began.start);
    began.metrics->observe(*began.simulation);
  }
  run() = std::move(began);
}

}  // namespace

std::variant<PlaneRun, SpaceRun>& run() {
  static std::variant<PlaneRun, SpaceRun> run;
  return run;
}

PlaneRun& plane() {
  if (auto* found = std::get_if<PlaneRun>(&run())) return *found;
  throw avo::Error("space: found 3, must be 2 for this");
}

std::string name_of(std::int64_t source) {
  return source >= 0 ? "robots." + std::to_string(source)
                     : "moving_obstacles." + std::to_string(-1 - source);
}

std::vector<std::byte> taken_from_room() {
  return std::exchange(room, {});
}

std::size_t into_room(std::span<const std::byte> bytes) {
  room.assign(bytes.begin(), bytes.end());
  return room.size();
}

/// Returns room for `size` bytes, valid until the next call.
AVO_EXPORT(std::byte*, room)(std::size_t size) {
  room.resize(size);
  return room.data();
}

/// Returns the address of the room, for reading.
AVO_EXPORT(const std::byte*, room_begin)() {
  return room.data();
}

/// Reads the scene in the room and makes its first state. Two values follow the scene: whether all
/// steps are observed, and whether it takes over from the present simulation.
AVO_EXPORT(void, read_scene)() {
  Input input(taken_from_room());
  const avo_io::SceneSource source = source_of(input);
  const bool observed = input.whole() != 0, takes_over = input.whole() != 0;
  std::optional<avo::space::Scenario> of_space = avo_io::space_scenario_in(source);
  if (!of_space) return begin(avo_io::parse_scenario(source), observed, takes_over);
  if (takes_over) throw avo::Error("space: found 3, must be 2 for a text that takes over");
  begin(*std::move(of_space), observed);
}

/// Returns 2 for a scene of the plane, 3 for one of space.
AVO_EXPORT(std::uint32_t, dimensions)() {
  return std::holds_alternative<SpaceRun>(run()) ? 3 : 2;
}

/// Continues from the state in the room, as Simulation::save() wrote it on any machine. If there is
/// a scene already, the state must belong to it.
AVO_EXPORT(void, restore)() {
  const std::vector<std::byte> saved = taken_from_room();
  plane().metrics.reset();
  if (plane().simulation)
    plane().simulation->restore(saved);
  else
    plane().simulation = std::make_unique<avo::Simulation>(std::span(saved));
}

/// Saves the state into the room.
AVO_EXPORT(std::size_t, save)() {
  return into_room(plane().simulation->save());
}

AVO_EXPORT(void, step)() {
  with_run([](auto& run) {
    run.simulation->step();
    if (run.metrics) run.metrics->observe(*run.simulation);
  });
}

/// Returns whether the next step ends within the scene's duration.
AVO_EXPORT(bool, can_step)() {
  return with_run(
      [](const auto& run) { return run.simulation->can_step_by(run.scenario.duration); });
}

/// Returns s.
AVO_EXPORT(double, time)() {
  return with_run([](const auto& run) { return run.simulation->time(); });
}

AVO_EXPORT(double, steps)() {
  return with_run([](const auto& run) { return static_cast<double>(run.simulation->steps()); });
}

AVO_EXPORT(bool, all_at_goal)() {
  return with_run([](const auto& run) { return run.simulation->all_at_goal(); });
}

AVO_EXPORT(std::uint64_t, state_hash)() {
  return with_run([](const auto& run) { return run.simulation->state_hash(); });
}

/// Returns JSON.
AVO_EXPORT(std::size_t, info)() {
  return into_room(with_run([](const auto& run) { return info_of(run); }));
}

/// Returns JSON: the pairs that overlap now.
AVO_EXPORT(std::size_t, contacts)() {
  return into_room(with_run([](const auto& run) { return contacts_of(run); }));
}

/// Writes the state into the room, with longer numbers first, so that each column is aligned: time,
/// steps; numbers of robots n and of moving obstacles m. The robots' position, velocity, goal,
/// heading and acceleration follow; then the obstacles' position and velocity. At the end are the
/// robots' clearance, number, status, and whether each has decided and is at its goal. Vectors have
/// as many numbers as dimensions() says, and robots of space have no heading.
AVO_EXPORT(std::size_t, moment)() {
  return into_room(with_run([](const auto& run) { return moment_of(run); }).bytes());
}

/// Returns the same JSON as `avo run --json` for the run so far; nothing if steps were not
/// observed, or if a state was restored.
AVO_EXPORT(std::size_t, summary)() {
  return with_run([](const auto& run) {
    if (!run.metrics) return into_room(std::string_view());
    avo::RunSummary summary = run.metrics->summary();
    return into_room(avo_io::to_json(summary));
  });
}

}  // namespace avo_lab
