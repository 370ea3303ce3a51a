// SPDX-License-Identifier: Apache-2.0
// Many worlds of space at once for learning, as worlds.cpp has those of the plane. The caller gives
// the robots their preferred velocities; each robot decides by a planner.
#include <algorithm>
#include <fmt/format.h>
#include <memory>
#include <utility>

#include "arrays.h"
#include "avo/space/box.h"
#include "avo/space/planner.h"
#include "space.h"
#include "worlds_arrays.h"

namespace avo_python::space {
namespace {

using avo::Vec3;
using py::arg;

struct SpaceWorld {
  std::vector<avo::space::Robot> robots;
  std::vector<Vec3> goals;
  std::vector<avo::space::Box> boxes;
  std::vector<avo::space::MovingObstacle> obstacles;  // that move
  std::vector<avo::space::Mover> movers;              // where these are now
  std::int64_t steps = 0;                             // since it was placed

  /// Sets where the moving obstacles are.
  void move_movers(double time_step) {
    movers.clear();
    for (const avo::space::MovingObstacle& obstacle : obstacles)
      movers.push_back(mover_at(obstacle, static_cast<double>(steps) * time_step));
  }
};

/// E worlds of N robots each, with the settings of one scene.
class SpaceWorlds {
 public:
  SpaceWorlds(std::size_t worlds, const avo::space::Scenario& scenario)
      : planner_(planner_options(scenario)),
        sensing_radius_(sensing_radius_of(scenario)),
        robots_(scenario.robots.size()),
        all_(worlds) {
    for (std::size_t e = 0; e < worlds; ++e) place(e, scenario);
  }

  void place(std::size_t world, const avo::space::Scenario& scenario);
  /// preferred: for all robots of all worlds, m/s. moving: the worlds that take part.
  void step(std::span<const Vec3> preferred, const std::vector<char>& moving) {
    for (std::size_t e = 0; e < all_.size(); ++e)
      if (moving[e] != 0) step(all_[e], preferred.subspan(e * robots_, robots_));
  }
  /// Finds the robots that robot i of the world senses: squared distances, m^2, and numbers,
  /// nearest first. Those of moving obstacles come behind the numbers of robots.
  void find_near(const SpaceWorld& world, std::size_t i,
                 std::vector<std::pair<double, std::size_t>>& near) const;

  [[nodiscard]] std::size_t worlds() const { return all_.size(); }
  [[nodiscard]] std::size_t robots() const { return robots_; }
  [[nodiscard]] const SpaceWorld& world(std::size_t e) const { return all_[e]; }
  [[nodiscard]] double sensing_radius() const { return sensing_radius_; }
  [[nodiscard]] std::atomic<bool>& used() const { return used_; }

 private:
  /// First all robots decide from the same states, and then all robots move.
  void step(SpaceWorld& world, std::span<const Vec3> preferred);

  avo::space::Planner planner_;
  double sensing_radius_;
  std::size_t robots_;
  std::vector<SpaceWorld> all_;
  mutable std::atomic<bool> used_ = false;
  avo::space::PlanWorkspace workspace_;
  std::vector<Vec3> next_;
  std::vector<std::pair<double, std::size_t>> near_;
  std::vector<avo::space::Neighbor> neighbors_;
  std::vector<avo::space::Mover> movers_;
};

void SpaceWorlds::place(std::size_t world, const avo::space::Scenario& scenario) {
  if (world >= all_.size())
    throw avo::Error(fmt::format("world: found {}, must be 0 to {}", world, all_.size() - 1));
  if (scenario.robots.size() != robots_)
    throw avo::Error(fmt::format("robots: found {} of them, must be {} as in the other worlds",
                                 scenario.robots.size(), robots_));
  const auto refuse = [](const char* name, const char* found, const char* allowed) {
    throw avo::Error(
        fmt::format("{}: found {}, must be {} in worlds for learning", name, found, allowed));
  };
  if (!scenario.sensing.is_exact()) refuse("sensing", "errors", "exact");
  SpaceWorld placed;
  for (const avo::space::RobotSetup& setup : scenario.robots) {
    placed.robots.push_back(avo::space::robot_of(setup));
    placed.goals.push_back(setup.goal);
  }
  placed.boxes = scenario.boxes;
  placed.obstacles = scenario.moving_obstacles;
  placed.move_movers(planner_.options().time_step);
  all_[world] = std::move(placed);
}

void SpaceWorlds::find_near(const SpaceWorld& world, std::size_t i,
                            std::vector<std::pair<double, std::size_t>>& near) const {
  near.clear();
  const auto look_at = [&](Vec3 place, std::size_t number) {
    const double squared = norm_squared(place - world.robots[i].position);
    if (squared <= sensing_radius_ * sensing_radius_) near.emplace_back(squared, number);
  };
  for (std::size_t j = 0; j < robots_; ++j)
    if (j != i) look_at(world.robots[j].position, j);
  for (std::size_t m = 0; m < world.movers.size(); ++m)
    look_at(world.movers[m].position, robots_ + m);
  std::sort(near.begin(), near.end());
}

void SpaceWorlds::step(SpaceWorld& world, std::span<const Vec3> preferred) {
  const double h = planner_.options().time_step, lag = planner_.step_lag();
  next_.clear();
  for (std::size_t i = 0; i < robots_; ++i) {
    avo::space::Robot& self = world.robots[i];
    self.preferred_velocity = preferred[i];
    find_near(world, i, near_);
    neighbors_.clear();
    movers_.clear();
    for (const auto& [squared, j] : near_) {
      if (j < robots_)
        neighbors_.push_back(neighbor_of(world.robots[j]));
      else
        movers_.push_back(world.movers[j - robots_]);
    }
    next_.push_back(
        planner_.plan(self, neighbors_, workspace_, nullptr, world.boxes, movers_).next_velocity);
  }
  for (std::size_t i = 0; i < robots_; ++i) {
    avo::space::Robot& robot = world.robots[i];
    robot.position = robot.position + lag * robot.velocity + (h - lag) * next_[i];
    robot.velocity = next_[i];
  }
  ++world.steps;
  world.move_movers(h);
}

void put(float* row, Vec3 v) {
  row[0] = static_cast<float>(v.x), row[1] = static_cast<float>(v.y);
  row[2] = static_cast<float>(v.z);
}

py::array_t<float> nearest(const SpaceWorlds& self, std::size_t k) {
  return rows_of_nearest(
      self, k, 8,
      [&self](const SpaceWorld& world, std::size_t i, auto& near) {
        self.find_near(world, i, near);
      },
      [](const SpaceWorld& world, std::size_t i, std::size_t number, float* row) {
        const avo::space::Robot& own = world.robots[i];
        const auto put_body = [&](const auto& other, float kind) {
          put(row, other.position - own.position);
          put(row + 3, other.velocity - own.velocity);
          row[6] = static_cast<float>(own.radius + other.radius);
          row[7] = kind;
        };
        const std::size_t robots = world.robots.size();
        if (number < robots)
          put_body(world.robots[number], 1.0F);
        else
          put_body(world.movers[number - robots], -1.0F);
      });
}

py::array_t<float> nearest_boxes(const SpaceWorlds& self, std::size_t k) {
  const double radius = self.sensing_radius();
  return rows_of_nearest(
      self, k, 4,
      [radius](const SpaceWorld& world, std::size_t i, auto& near) {
        find_within(world.boxes, world.robots[i].position, radius, avo::space::displacement_to,
                    near);
      },
      [](const SpaceWorld& world, std::size_t i, std::size_t box, float* row) {
        put(row, displacement_to(world.boxes[box], world.robots[i].position));
        row[3] = 1.0F;
      });
}

template <typename Of>  // Vec3 of(world, robot)
auto points(Of of) {
  return [of](const SpaceWorlds& self) {
    const InUse use(self.used());
    py::array_t<double> array({self.worlds(), self.robots(), std::size_t{3}});
    auto rows = array.mutable_unchecked<3>();
    for (py::ssize_t i = 0; i < rows.shape(0); ++i)
      for (py::ssize_t k = 0; k < rows.shape(1); ++k) {
        const Vec3 v = of(self.world(static_cast<std::size_t>(i)), static_cast<std::size_t>(k));
        rows(i, k, 0) = v.x, rows(i, k, 1) = v.y, rows(i, k, 2) = v.z;
      }
    return array;
  };
}

void step_worlds(SpaceWorlds& self, const py::object& actions, const std::vector<bool>& moving) {
  const Numbers preferred = numbers("actions", actions);
  if (preferred.ndim() != 3 || preferred.shape(0) != static_cast<py::ssize_t>(self.worlds()) ||
      preferred.shape(1) != static_cast<py::ssize_t>(self.robots()) || preferred.shape(2) != 3)
    throw avo::Error(fmt::format("actions: found shape {}, must be ({}, {}, 3)",
                                 shape_of(preferred), self.worlds(), self.robots()));
  if (moving.size() != self.worlds())
    throw avo::Error(
        fmt::format("moving: found {} of them, must be {}", moving.size(), self.worlds()));
  const std::span<const Vec3> all{reinterpret_cast<const Vec3*>(preferred.data()),
                                  self.worlds() * self.robots()};
  if (!std::all_of(all.begin(), all.end(), [](Vec3 v) { return is_finite(v); }))
    throw avo::Error("actions: found a number that is not finite, must be finite");
  const std::vector<char> which(moving.begin(), moving.end());
  const InUse use(self.used());
  const py::gil_scoped_release release;
  self.step(all, which);
}

}  // namespace

void bind_worlds(py::module_& space) {
  static_assert(sizeof(Vec3) == 3 * sizeof(double));
  py::class_<SpaceWorlds>(space, "Worlds",
                          "E worlds of N robots of space; avo.env is made of them.")
      .def(py::init([](std::int64_t worlds, const avo::space::Scenario& scenario) {
             if (worlds < 1)
               throw avo::Error(fmt::format("num_envs: found {}, must be >= 1", worlds));
             return std::make_unique<SpaceWorlds>(static_cast<std::size_t>(worlds), scenario);
           }),
           arg("worlds"), arg("scenario"))
      .def(
          "place",
          [](SpaceWorlds& self, std::size_t world, const avo::space::Scenario& scenario) {
            const InUse use(self.used());
            self.place(world, scenario);
          },
          arg("world"), arg("scenario"),
          "Puts the robots, goals, boxes and moving obstacles of the scenario into that world.")
      .def("step", &step_worlds, arg("preferred"), arg("moving"),
           "preferred: (E, N, 3), m/s; moving: (E,) bool, the worlds that take part.")
      .def("nearest", &nearest, arg("k"),
           "(E, N, k, 8) float32: relative position, m, and velocity, m/s, sum of radii, m, and 1, "
           "or -1 of a moving obstacle, of the k nearest ones within the sensing radius, nearest "
           "first; 0 where there are fewer.")
      .def("nearest_walls", &nearest_boxes, arg("k"),
           "(E, N, k, 4) float32: the vector to the nearest point, m, and 1 of the k nearest boxes "
           "within the sensing radius, nearest first; 0 where there are fewer.")
      .def("position",
           points([](const SpaceWorld& w, std::size_t k) { return w.robots[k].position; }),
           "(E, N, 3) float64, m.")
      .def("velocity",
           points([](const SpaceWorld& w, std::size_t k) { return w.robots[k].velocity; }),
           "(E, N, 3) float64, m/s.")
      .def("goal", points([](const SpaceWorld& w, std::size_t k) { return w.goals[k]; }),
           "(E, N, 3) float64, m.")
      .def("radius", per_robot<SpaceWorlds>([](const SpaceWorld& w, std::size_t k) {
             return w.robots[k].radius;
           }),
           "(E, N) float64, m.")
      .def("max_speed", per_robot<SpaceWorlds>([](const SpaceWorld& w, std::size_t k) {
             return w.robots[k].max_speed;
           }),
           "(E, N) float64, m/s.")
      .def("max_acceleration", per_robot<SpaceWorlds>([](const SpaceWorld& w, std::size_t k) {
             return w.robots[k].max_acceleration;
           }),
           "(E, N) float64, m/s^2.");
}

}  // namespace avo_python::space
