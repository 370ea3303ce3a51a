// SPDX-License-Identifier: Apache-2.0
// A scene, its simulation, and the steps. The host makes its views anew for each address that a
// call returns, because memory that has grown moves.
#include <bit>
#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "avo/error.h"
#include "avo_io/recording.h"
#include "avo_io/scene.h"
#include "host.h"
#include "io/files/file_names.h"
#include "io/scene/builtin.h"

namespace avo_lab {
namespace {

std::vector<std::byte> room;

/// Reads the source as the host has stored it: name, text, whether robots start at rest and within
/// the admissible speed, whether it comes from a recording. Overrides and files follow, each list
/// with its number in front.
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

}  // namespace

Lab& lab() {
  static Lab lab;
  return lab;
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
  avo::Scenario scenario = avo_io::parse_scenario(source_of(input));
  const bool observed = input.whole() != 0, takes_over = input.whole() != 0;
  Takeover next = takes_over ? taken_over_by(scenario) : Takeover{.start = scenario};
  // moving obstacles begin as the text says, and then continue from their present places
  avo::Scenario start = next.start;
  start.moving_obstacles = scenario.moving_obstacles;
  // the lab shows the consequences, and info() reports them
  start.allow_broken_assumptions = true;
  auto simulation = std::make_unique<avo::Simulation>(start);
  for (const avo::RobotId robot : next.gone) simulation->remove_robot(robot);
  if (takes_over) remember(*simulation, next.goes_on);
  lab().simulation = std::move(simulation);
  lab().scenario = std::move(scenario);
  lab().start = std::move(next.start);
  lab().metrics.reset();
  if (!observed) return;
  lab().metrics = std::make_unique<avo::Metrics>(lab().start);
  lab().metrics->observe(*lab().simulation);
}

/// Continues from the state in the room, as Simulation::save() wrote it on any machine; if there is
/// a scene already, the state must belong to it.
AVO_EXPORT(void, restore)() {
  const std::vector<std::byte> saved = taken_from_room();
  lab().metrics.reset();
  if (lab().simulation)
    lab().simulation->restore(saved);
  else
    lab().simulation = std::make_unique<avo::Simulation>(std::span(saved));
}

/// Saves the state into the room.
AVO_EXPORT(std::size_t, save)() {
  return into_room(lab().simulation->save());
}

AVO_EXPORT(void, step)() {
  lab().simulation->step();
  if (lab().metrics) lab().metrics->observe(*lab().simulation);
}

/// Returns whether the next step ends within the scene's duration.
AVO_EXPORT(bool, can_step)() {
  return lab().simulation->can_step_by(lab().scenario.duration);
}

/// Returns s.
AVO_EXPORT(double, time)() {
  return lab().simulation->time();
}

AVO_EXPORT(double, steps)() {
  return static_cast<double>(lab().simulation->steps());
}

AVO_EXPORT(bool, all_at_goal)() {
  return lab().simulation->all_at_goal();
}

AVO_EXPORT(std::uint64_t, state_hash)() {
  return lab().simulation->state_hash();
}

/// Returns the same JSON as `avo run --json` for the run so far; nothing if steps were not
/// observed, or if a state was restored.
AVO_EXPORT(std::size_t, summary)() {
  if (!lab().metrics) return into_room(std::string_view());
  avo::RunSummary summary = lab().metrics->summary();
  return into_room(avo_io::to_json(summary));
}

}  // namespace avo_lab
