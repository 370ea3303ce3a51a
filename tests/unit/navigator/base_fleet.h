// SPDX-License-Identifier: Apache-2.0
// A fleet of bases that do not execute exactly, and what each knows of the others.
#pragma once
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include "avo/check.h"
#include "avo/navigator.h"
#include "support/generators.h"
#include "unit/navigator/sluggish_base.h"
#include "unit/navigator/sluggish_drive.h"

namespace avo::test {

inline constexpr double kFleetStep = 0.1;  // s
inline constexpr int kRows = 16;           // of a step
inline constexpr CheckedWall kWall{{-6, -1.3}, {14, -1.3}};

/// What the others know of a robot, and what they do not allow for.
struct Knowledge {
  bool of_reference = false;      // they are told its reference, in place of sensing its body
  bool of_radius = true;          // that its deviation makes its disc larger
  bool of_positions = true;       // that the positions of bodies deviate
  bool of_velocities = true;      // that their velocities do
  bool keeps_a_reference = true;  // else it plans from its body, and sends the next velocity
};

struct Member {
  ExecutionModel model;
  Robot body;
  SluggishBase base;
  std::optional<SluggishDrive> drive;  // in place of the base
  ExecutionError most;
  BaseCommand command;

  void sense() {
    if (drive) body.heading = drive->heading;
    body.position = drive ? drive->position() : base.position;
    body.velocity = drive ? drive->velocity() : base.velocity;
  }
  void execute(Vec2 error) {
    if (drive) drive->tell(command.velocity), drive->error = error;
    base.tell(command.velocity), base.error = error;
  }
  void move(double time) {
    const auto unseen = [](double) {};
    if (drive)
      drive->move(time, 1, unseen);
    else
      base.move(time, 1, unseen);
  }
};

inline ExecutionModel random_base(Random& random) {
  const auto some = [&](double most) { return std::max(0.0, random.uniform(-0.3, 1.0) * most); };
  ExecutionModel model;
  model.time_constant = some(0.4), model.time_constant_error = 0.1 * model.time_constant;
  model.dead_time = some(0.15), model.dead_time_error = std::min(0.005, model.dead_time);
  model.deadband = some(0.1), model.quantum = some(0.05), model.velocity_error = some(0.02);
  return model;
}

inline Member member_of(const ExecutionModel& model, Random& random, Vec2 place) {
  Member one;
  one.model = model;
  one.body.position = place;
  one.body.radius = random.uniform(0.25, 0.5);
  one.body.max_acceleration = random.uniform(0.5, 2.0);
  one.body.max_speed = random.uniform(0.5, 2.0);
  one.base.lag = model.time_constant + random.uniform(-1, 1) * model.time_constant_error;
  one.base.dead_time = model.dead_time + random.uniform(-1, 1) * model.dead_time_error;
  one.base.deadband = model.deadband, one.base.quantum = model.quantum;
  one.base.position = place;
  one.most = execution_error(model, one.body, kFleetStep);
  return one;
}

// A slower robot, with wheels; its disc is about the point ahead of its axle.
inline Member drive_of(ExecutionModel model, Random& random, Vec2 place) {
  model.time_constant *= 0.2, model.time_constant_error *= 0.1, model.velocity_error *= 0.5;
  model.heading_age = kFleetStep / kRows, model.dead_time_error = 0.0;
  model.dead_time = model.heading_age * std::round(model.dead_time / model.heading_age);
  model.deadband *= 0.3, model.quantum *= 0.3;
  Member one;
  one.model = model;
  const DifferentialDrive wheels{
      .track = 0.4, .offset = 0.2, .wheel_speed = 1.0, .wheel_acceleration = 2.0};
  one.body.model = wheels;
  one.body.radius = random.uniform(0.4, 0.6);
  one.body.max_acceleration = random.uniform(0.3, 0.7);
  one.body.max_speed = random.uniform(0.2, 0.5);
  SluggishDrive& drive = one.drive.emplace();
  drive.model = model, drive.drive = wheels, drive.axle = place;
  drive.heading = random.uniform(-3, 3);
  drive.lag = model.time_constant + random.uniform(-1, 1) * model.time_constant_error;
  drive.dead_time = model.dead_time;
  one.most = execution_error(model, one.body, kFleetStep);
  return one;
}

/// Robots in a grid. model: of all; null: of each its own, and every third one has wheels.
inline std::vector<Member> grid_of(std::uint64_t seed, int side, const ExecutionModel* model) {
  Random random(seed);
  std::vector<Member> members;
  for (int k = 0; k < side * side; ++k) {
    const Vec2 place{1.8 * (k / side) + random.uniform(-0.2, 0.2), 1.8 * (k % side)};
    const ExecutionModel own = model != nullptr ? *model : random_base(random);
    const bool has_wheels = model == nullptr && k % 3 == 0;
    members.push_back(has_wheels ? drive_of(own, random, place) : member_of(own, random, place));
  }
  return members;
}

/// Robots beside a wall that decide by navigators, and are judged by their bodies.
struct BaseFleet {
  std::vector<Member> members;
  std::vector<Navigator> navigators;
  Knowledge knowledge;
  Random random;
  Check check{{}};
  double time = 0.0, fraction = 0.0;  // s; the largest deviation, of ε
  int left = 0;                       // cycles with BaseCommand::has_left

  BaseFleet(std::vector<Member> fleet, Knowledge known)
      : members(std::move(fleet)), knowledge(known), random(members.size()) {
    for (Member& one : members) {
      one.sense();
      CheckedRobot robot;
      robot.radius = one.body.radius, robot.straight = true;
      robot.max_speed = robot.max_acceleration = std::numeric_limits<double>::infinity();
      check.add_robot(robot);
    }
    equip();
    look(0.0);
  }

  void equip() {
    NavigatorOptions options;
    SensingError& error = options.planner.sensing_error;
    for (const Member& one : members) {
      if (knowledge.of_positions) error.position = std::max(error.position, one.most.position);
      if (knowledge.of_velocities) error.velocity = std::max(error.velocity, one.most.velocity);
    }
    if (knowledge.of_reference) error = {};
    const StaticObstacle wall{{{{kWall.a, kWall.b}}}};
    check.set_walls({kWall});
    for (const Member& one : members) {
      if (knowledge.keeps_a_reference) options.execution = one.model;
      navigators.emplace_back(options, std::vector<StaticObstacle>{wall});
      ++options.id.value;
    }
  }

  void look(double at) {
    std::vector<CheckedState> rows;
    for (const Member& one : members)
      rows.push_back({static_cast<std::int64_t>(rows.size()),
                      one.drive ? one.drive->position() : one.base.position,
                      {}});
    check.add(at, rows);
  }

  [[nodiscard]] Neighbor seen(const Member& one) const {
    const bool is_told = knowledge.of_reference && time > 0.0;  // all begin at their references
    return {.position = is_told ? one.command.next_reference : one.body.position,
            .velocity = is_told ? one.command.next_velocity : one.body.velocity,
            .radius = one.body.radius + (knowledge.of_radius ? one.most.position : 0.0),
            .max_acceleration = one.body.max_acceleration};
  }

  BaseCommand decide(std::size_t k, const std::vector<Neighbor>& all) {
    std::vector<Neighbor> others = all;
    others.erase(others.begin() + static_cast<std::ptrdiff_t>(k));
    Robot robot = members[k].body;
    const bool is_larger = knowledge.keeps_a_reference;  // by itself
    if (is_larger != knowledge.of_radius)
      robot.radius += (is_larger ? -1.0 : 1.0) * members[k].most.position;
    const NavigatorDecision decision = navigators[k].step(robot, others, time);
    return decision.command.value_or(BaseCommand{.velocity = decision.plan.next_velocity});
  }

  void step() {
    std::vector<Neighbor> all;
    for (Member& one : members) {
      one.sense();
      all.push_back(seen(one));
    }
    for (std::size_t k = 0; k < members.size(); ++k) {
      Member& one = members[k];
      one.command = decide(k, all);
      one.execute(one.model.velocity_error * random.direction());
      fraction = std::max(fraction, one.command.deviation / one.most.position);
      left += one.command.has_left ? 1 : 0;
    }
    for (int row = 1; row <= kRows; ++row) {
      for (Member& one : members) one.move(kFleetStep / kRows);
      look(time + kFleetStep * row / kRows);
    }
    time += kFleetStep;
  }
};

}  // namespace avo::test
