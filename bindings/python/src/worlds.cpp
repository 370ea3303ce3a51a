// SPDX-License-Identifier: Apache-2.0
// Many worlds at once for learning. The caller gives the robots their preferred velocities; each
// robot decides by a planner, as in a simulation.
#include <algorithm>
#include <atomic>
#include <fmt/format.h>
#include <memory>
#include <optional>
#include <variant>
#include <vector>

#include "arrays.h"
#include "workspace.h"
#include "worlds_arrays.h"

namespace avo_python {
namespace {

using py::arg;

/// Throws Error for features that worlds do not support.
void require_plain(const avo::Scenario& scenario) {
  const auto refuse = [](const char* what, std::string_view found, const char* allowed) {
    throw avo::Error(fmt::format("{}: found {}, must be {} in these worlds", what, found, allowed));
  };
  if (scenario.clock != avo::Clock::common) refuse("clock", "free", "common");
  if (!scenario.sensing.is_exact()) refuse("sensing", "errors", "exact");
  // the learner decides where robots go, and which robot waits at a passage
  if (scenario.navigation == true) refuse("navigation", "true", "false or left out");
  for (std::size_t k = 0; k < scenario.robots.size(); ++k) {
    const avo::RobotSetup& robot = scenario.robots[k];
    const std::string name = fmt::format("robots.{}", k);
    if (std::holds_alternative<avo::Airplane>(robot.model))
      refuse((name + ".model").c_str(), "airplane", "holonomic, car or differential_drive");
    if (robot.method) refuse((name + ".method").c_str(), to_string(*robot.method), "left out");
    if (robot.arrival_distance) refuse((name + ".arrival_distance").c_str(), "one", "left out");
    if (robot.start_time != 0.0) refuse((name + ".start_time").c_str(), "one", "left out");
    if (robot.behavior != avo::Behavior::decides)
      refuse((name + ".behavior").c_str(), to_string(robot.behavior), "decides");
    if (robot.time_horizon) refuse((name + ".time_horizon").c_str(), "one", "left out");
    if (robot.layers != avo::LayerSet{1} || !avoids(robot, robot))
      refuse((name + ".layers").c_str(), "others", "the usual ones");
  }
}

avo::Robot robot_of(const avo::RobotSetup& setup) {
  return {.position = disc_center(setup),
          .velocity = setup.velocity,
          .radius = disc_radius(setup),
          .max_acceleration = setup.max_acceleration,
          .max_speed = setup.max_speed,
          .priority = setup.priority,
          .max_braking = setup.max_braking};
}

avo::Neighbor seen(const avo::Robot& robot) {
  return {.position = robot.position,
          .velocity = robot.velocity,
          .radius = robot.radius,
          .max_acceleration = robot.max_acceleration,
          .priority = robot.priority,
          .max_braking = robot.max_braking};
}

/// A moving obstacle as robots sense it.
avo::Neighbor seen(const avo::MovingObstacle& mover) {
  return {.position = mover.position,
          .velocity = mover.velocity,
          .radius = mover.radius,
          .behavior = avo::Behavior::moves_on,
          .max_deviation = mover.max_deviation,
          .acceleration = mover.acceleration,
          .max_speed = mover.max_speed.value_or(kInfinity)};
}

/// Moves it by a step, as a simulation does. time: s, the end of the step.
void move(avo::MovingObstacle& mover, std::uint32_t& target, double time_step, double time) {
  if (mover.trajectory.empty() && mover.path.empty()) {
    mover.position = mover.position + time_step * mover.velocity +
                     (0.5 * time_step * time_step) * mover.acceleration;
    mover.velocity = mover.velocity + time_step * mover.acceleration;
    return;
  }
  const avo::PathWalk next =
      mover.trajectory.empty()
          ? avo::next_on_path(mover, {mover.position, mover.velocity, target}, time_step)
          : avo::on_trajectory(mover, time);
  mover.position = next.position, mover.velocity = next.velocity, target = next.next_point;
}

bool has_wheels(const avo::Scenario& scenario) {
  return std::any_of(scenario.robots.begin(), scenario.robots.end(),
                     [](const avo::RobotSetup& robot) { return !is_holonomic(robot.model); });
}

/// A simulation with robots that keep no routes.
std::unique_ptr<avo::Simulation> simulation_of(avo::Scenario scenario) {
  scenario.navigation = false;
  return std::make_unique<avo::Simulation>(scenario, 1);
}

/// Takes what others sense from the simulation.
void follow(World& world) {
  const avo::FleetView fleet = world.wheels->fleet();
  for (std::size_t k = 0; k < world.robots.size(); ++k) {
    avo::Robot& robot = world.robots[k];
    robot.position = avo::disc_center(robot.model, fleet.position[k], fleet.heading[k]);
    robot.velocity = fleet.velocity[k];
  }
  const avo::MovingObstacleView movers = world.wheels->moving_obstacles();
  for (std::size_t k = 0; k < world.movers.size(); ++k)
    world.movers[k].position = movers.position[k], world.movers[k].velocity = movers.velocity[k];
}

}  // namespace

Worlds::Worlds(std::size_t worlds, const avo::Scenario& scenario)
    : planner_(planner_options(scenario)),
      sensing_radius_(avo::sensing_radius_of(scenario)),
      robots_(scenario.robots.size()) {
  if (worlds == 0) throw avo::Error("num_envs: found 0, must be >= 1");
  all_.resize(worlds);
  for (std::size_t e = 0; e < worlds; ++e) place(e, scenario);
}

void Worlds::place(std::size_t world, const avo::Scenario& scenario) {
  require_plain(scenario);
  if (world >= all_.size())
    throw avo::Error(fmt::format("world: found {}, must be 0 to {}", world, all_.size() - 1));
  if (scenario.robots.size() != robots_)
    throw avo::Error(fmt::format("robots: found {} of them, must be {} as in the other worlds",
                                 scenario.robots.size(), robots_));
  World placed;
  for (const avo::RobotSetup& setup : scenario.robots) {
    placed.robots.push_back(robot_of(setup));
    placed.goals.push_back(setup.goal);
  }
  placed.walls = avo::walls_of(heeded(scenario.obstacles, avo::RobotSetup{}.layers));
  placed.movers = scenario.moving_obstacles;
  placed.targets.assign(placed.movers.size(), 0);
  if (has_wheels(scenario)) {
    placed.wheels = simulation_of(scenario);
    for (std::size_t k = 0; k < robots_; ++k) placed.robots[k].model = scenario.robots[k].model;
    follow(placed);
  }
  all_[world] = std::move(placed);
}

void Worlds::find_near(const World& world, std::size_t i,
                       std::vector<std::pair<double, std::size_t>>& near) const {
  near.clear();
  const auto look_at = [&](avo::Vec2 position, std::size_t j) {
    const double squared = norm_squared(position - world.robots[i].position);
    if (j != i && squared <= sensing_radius_ * sensing_radius_) near.emplace_back(squared, j);
  };
  for (std::size_t j = 0; j < robots_; ++j) look_at(world.robots[j].position, j);
  for (std::size_t k = 0; k < world.movers.size(); ++k)
    look_at(world.movers[k].position, robots_ + k);
  std::sort(near.begin(), near.end());
}

avo::Neighbor Worlds::neighbor(const World& world, std::size_t j) const {
  return j < robots_ ? seen(world.robots[j]) : seen(world.movers[j - robots_]);
}

void Worlds::step(World& world, std::span<const avo::Vec2> preferred) {
  const double h = planner_.options().time_step, lag = planner_.step_lag();
  next_.clear();
  for (std::size_t i = 0; i < robots_; ++i) {
    avo::Robot& self = world.robots[i];
    self.preferred_velocity = preferred[i];
    find_near(world, i, near_);
    neighbors_.clear();
    for (const auto& [squared, j] : near_) neighbors_.push_back(neighbor(world, j));
    next_.push_back(
        planner_.plan(self, neighbors_, workspace(), nullptr, world.walls).next_velocity);
  }
  for (std::size_t i = 0; i < robots_; ++i) {
    avo::Robot& robot = world.robots[i];
    robot.position = robot.position + lag * robot.velocity + (h - lag) * next_[i];
    robot.velocity = next_[i];
  }
  ++world.steps;
  for (std::size_t k = 0; k < world.movers.size(); ++k)
    move(world.movers[k], world.targets[k], h, static_cast<double>(world.steps) * h);
}

void Worlds::drive(World& world, std::span<const avo::Vec2> preferred, std::span<const bool> home) {
  const std::span<const avo::RobotId> all = world.wheels->fleet().id;
  const std::vector<avo::RobotId> ids(all.begin(), all.end());
  for (std::size_t k = 0; k < ids.size(); ++k)
    world.wheels->set_preferred_velocity(
        ids[k], !home.empty() && home[k] ? std::nullopt : std::optional<avo::Vec2>(preferred[k]));
  world.wheels->step();
  ++world.steps;
  follow(world);
}

namespace {

template <typename Of>  // Vec2 of(world, robot)
auto points(Of of) {
  return [of](const Worlds& self) {
    const InUse use(self.used());
    const auto e = static_cast<py::ssize_t>(self.worlds()),
               n = static_cast<py::ssize_t>(self.robots());
    py::array_t<double> array({e, n, py::ssize_t{2}});
    auto rows = array.mutable_unchecked<3>();
    for (py::ssize_t i = 0; i < e; ++i)
      for (py::ssize_t k = 0; k < n; ++k) {
        const avo::Vec2 v =
            of(self.world(static_cast<std::size_t>(i)), static_cast<std::size_t>(k));
        rows(i, k, 0) = v.x;
        rows(i, k, 1) = v.y;
      }
    return array;
  };
}

void step(Worlds& self, const py::object& actions, const std::vector<bool>& moving,
          const py::array_t<bool, py::array::c_style | py::array::forcecast>& home) {
  const Numbers preferred = numbers("actions", actions);
  if (preferred.ndim() != 3 || preferred.shape(0) != static_cast<py::ssize_t>(self.worlds()) ||
      preferred.shape(1) != static_cast<py::ssize_t>(self.robots()) || preferred.shape(2) != 2)
    throw avo::Error(fmt::format("actions: found shape {}, must be ({}, {}, 2)",
                                 shape_of(preferred), self.worlds(), self.robots()));
  if (moving.size() != self.worlds())
    throw avo::Error(
        fmt::format("moving: found {} of them, must be {}", moving.size(), self.worlds()));
  const auto all = rows("actions", preferred);
  if (!std::all_of(all.begin(), all.end(), [](avo::Vec2 v) { return is_finite(v); }))
    throw avo::Error("actions: found a number that is not finite, must be finite");
  const auto all_robots = static_cast<py::ssize_t>(self.worlds() * self.robots());
  if (home.size() != 0 && home.size() != all_robots)
    throw avo::Error(
        fmt::format("home: found {} of them, must be {} or none", home.size(), all_robots));
  const std::vector<char> which(moving.begin(), moving.end());
  const InUse use(self.used());
  const py::gil_scoped_release release;
  self.step(all, which, {home.data(), static_cast<std::size_t>(home.size())});
}

}  // namespace

void bind_worlds(py::module_& module) {
  module.def("_numbers", &numbers, arg("name"), arg("given"),
             "float64 of real numbers; raises Error on all else.");
  py::class_<Worlds>(module, "Worlds", "E worlds of N robots; avo.env is made of them.")
      .def(py::init([](std::int64_t worlds, const avo::Scenario& scenario) {
             if (worlds < 1)
               throw avo::Error(fmt::format("num_envs: found {}, must be >= 1", worlds));
             return std::make_unique<Worlds>(static_cast<std::size_t>(worlds), scenario);
           }),
           arg("worlds"), arg("scenario"))
      .def(
          "place",
          [](Worlds& self, std::size_t world, const avo::Scenario& scenario) {
            const InUse use(self.used());
            self.place(world, scenario);
          },
          arg("world"), arg("scenario"),
          "Puts the robots, goals and walls of the scenario into that world.")
      .def("step", &step, arg("preferred"), arg("moving"), arg("home") = py::array_t<bool>(0),
           "preferred: (E, N, 2), m/s; moving: (E,) bool, the worlds that take part; home: (E, N) "
           "bool, the robots that go to their goals by themselves where they have wheels.")
      .def("nearest", &nearest, arg("k"),
           "(E, N, k, 6) float32: relative position, m, and velocity, m/s, sum of radii, m, and 1 "
           "of a robot or -1 of a moving obstacle, of the k nearest within the sensing radius, "
           "nearest first; 0 where there are fewer.")
      .def("nearest_walls", &nearest_walls, arg("k"),
           "(E, N, k, 3) float32: the vector to the nearest point, m, and 1 of the k nearest walls "
           "within the sensing radius, nearest first; 0 where there are fewer.")
      .def("movers", &movers_of, arg("world"),
           "(m, 3) float64: places and radii of its moving obstacles, m.")
      .def("position", points([](const World& w, std::size_t k) { return w.position(k); }),
           "(E, N, 2) float64, m; of a robot with wheels the middle of its axle.")
      .def("center", points([](const World& w, std::size_t k) { return w.robots[k].position; }),
           "(E, N, 2) float64, m, of the discs.")
      .def("heading", per_robot<Worlds>([](const World& w, std::size_t k) { return w.heading(k); }),
           "(E, N) float64, rad; 0 of robots without wheels.")
      .def_property_readonly(
          "has_wheels", [](const Worlds& self) { return self.world(0).wheels != nullptr; },
          "Whether some of the robots are cars or differential drives.")
      .def("velocity", points([](const World& w, std::size_t k) { return w.robots[k].velocity; }),
           "(E, N, 2) float64, m/s.")
      .def("goal", points([](const World& w, std::size_t k) { return w.goals[k]; }),
           "(E, N, 2) float64, m.")
      .def("radius",
           per_robot<Worlds>([](const World& w, std::size_t k) { return w.robots[k].radius; }),
           "(E, N) float64, m.")
      .def("max_speed",
           per_robot<Worlds>([](const World& w, std::size_t k) { return w.robots[k].max_speed; }),
           "(E, N) float64, m/s.")
      .def("max_acceleration", per_robot<Worlds>([](const World& w, std::size_t k) {
             return w.robots[k].max_acceleration;
           }),
           "(E, N) float64, m/s^2.");
}

}  // namespace avo_python
