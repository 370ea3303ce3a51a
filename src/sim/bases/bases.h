// SPDX-License-Identifier: Apache-2.0
// The bodies of a fleet with bases that do not execute exactly. The fleet's columns are the
// references, which move exactly as decided. Each body follows its reference by commands. No
// decision depends on a body, but for the heading of a drive (docs/certificate/execution.md).
#pragma once
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "avo/execution.h"
#include "avo/ids.h"
#include "avo/scenario.h"

namespace avo::inline sim {

struct World;

/// One body, and its true base.
struct Base {
  double radius = 0.0;      // m, of the body
  double added = 0.0;       // m, what its reference adds to that
  Vec2 position, velocity;  // m, m/s, of its disc
  double heading = 0.0;     // rad, of a drive
  double offset = 0.0;      // [ℓ] m, from a drive's axle to the center of its disc
  double lag = 0.0;         // [T'] s
  // A command acts whole_steps and `rest` (s, less than a step) after it is given.
  std::size_t whole_steps = 0;
  double rest = 0.0;
  // 1 - e^(-t/T') of both parts of a step: until a command begins to act, and from then on. For a
  // drive: of a substep in each of them.
  double before = 1.0, after = 1.0;

  /// m: its reported place.
  Vec2 place() const;
};

/// By rank; none where bases execute exactly.
struct Bases {
  std::optional<ExecutionModel> model = {};
  std::optional<double> declared = {};  // m, see Scenario::execution_error
  double time_step = 0.0;               // s
  std::uint64_t seed = 0;
  std::vector<Base> all;
  std::vector<Vec2> sent;  // m/s, `depth` commands for each: that of step k is at k mod depth
  std::size_t depth = 0;

  Bases() = default;
  /// Without bodies.
  explicit Bases(const Scenario& scenario);

  bool are_exact() const { return !model; }
  /// m: what a robot of these limits adds to the radius that robots know of it.
  double added_radius(const RobotSetup& body) const;
  /// The robot that decides for the body: its reference, which begins at the body.
  RobotSetup reference_of(const RobotSetup& body) const;
  /// So that add() throws nothing.
  void reserve_one();
  /// Adds a body at rest.
  void add(RobotId robot, const RobotSetup& body);
  void remove(std::size_t rank);
  /// Puts the body down at rest; position: of its disc.
  void put_down(std::size_t rank, Vec2 position);
};

/// How wrong others are about the reference of a robot of the scene whose body they sense exactly.
/// Zero where robots tell each other their references.
SensingError body_error(const Scenario& scenario);

/// The scene of the references: robots with larger radii, and bases that execute exactly. Where
/// bodies are sensed, it declares how wrong that is.
Scenario with_references(const Scenario& scenario);

/// The bodies of its robots, which are numbered from 0 on.
Bases bases_of(const Scenario& scenario);

/// Commands all bodies for the step that the references have just made, and moves them.
void move_bases(World& world);

/// Throws Error where the scene cannot have bases that do not execute exactly.
void check_execution(const Scenario& scenario);
/// Throws Error on a robot that cannot have such a base; `name` is that of the robot, as in
/// "robots.3.". time_step: s.
void check_base(const ExecutionModel& model, double time_step, const RobotSetup& robot,
                const std::string& name);
/// The same, and on a robot of that method that such a scene cannot have.
void check_body(const ExecutionModel& model, double time_step, const RobotSetup& robot,
                Method method, const std::string& name);

std::uint64_t hash_of(const Bases& bases, std::uint64_t hash);

}  // namespace avo::inline sim
