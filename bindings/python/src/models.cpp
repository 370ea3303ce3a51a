// SPDX-License-Identifier: Apache-2.0
// Motion models, walls and obstacles: immutable values.
#include <pybind11/operators.h>

#include "avo/error.h"
#include "pickles.h"

namespace avo_python {
namespace {

using py::arg;

constexpr double kNoOffset = 0.0;  // for a differential drive without a chosen offset

std::optional<avo::Footprint> if_any(const avo::Footprint& footprint) {
  return footprint ? std::optional(footprint) : std::nullopt;
}

double excess_of(std::optional<double> excess, double width) {
  return excess.value_or(avo::kUsualExcess * width);
}

void bind_footprints(py::module_& module) {
  using avo::Footprint;
  py::class_<Footprint>(module, "Footprint",
                        "Up to five discs of one radius in a row along the heading, which cover a "
                        "body that is no disc.")
      .def(py::init([](int discs, double radius, double first, double spacing) {
             return Footprint{discs, radius, first, spacing};
           }),
           py::kw_only(), arg("discs"), arg("radius"), arg("first") = 0.0, arg("spacing") = 0.0,
           "discs: 1 to 5; radius: m, > 0, of each; first: m, from the position forward to the "
           "rearmost center; spacing: m, >= 0, from one center to the next.")
      .def_static(
          "rectangle",
          [](double length, double width, double offset, std::optional<double> excess) {
            return avo::cover_rectangle(length, width, offset, excess_of(excess, width));
          },
          arg("length"), arg("width"), py::kw_only(), arg("offset") = 0.0,
          arg("excess") = py::none(),
          "The fewest discs that cover a rectangle and exceed its sides by at most excess, m; "
          "None: "
          "a quarter of its width. offset: m, from the position forward to its center.")
      .def_static(
          "polygon",
          [](const std::vector<avo::Vec2>& corners, std::optional<double> excess) {
            double side = 0.0;
            for (const avo::Vec2 corner : corners) side = std::max(side, std::abs(corner.y));
            return avo::cover_polygon(corners, excess_of(excess, 2.0 * side));
          },
          arg("corners"), py::kw_only(), arg("excess") = py::none(),
          "The same for a polygon, by its corners (x, y), m: x along the heading, y to its left.")
      .def(pickled<Footprint>())
      .def(py::self == py::self)
      .def_readonly("discs", &Footprint::discs, "1 to 5")
      .def_readonly("radius", &Footprint::radius, "m, > 0, of each disc")
      .def_readonly("first", &Footprint::first, "m, forward to the rearmost center")
      .def_readonly("spacing", &Footprint::spacing, "m, >= 0, from one center to the next");
}

void bind_cars(py::module_& module) {
  py::class_<avo::CarBody>(module, "CarBody", "The disc that covers a car's body.")
      .def(py::init([](double offset, double radius) {
             return avo::CarBody{offset, radius};
           }),
           py::kw_only(), arg("offset") = 0.0, arg("radius") = 0.5,
           "offset: m, of its center ahead of the rear axle; radius: m, > 0.")
      .def(pickled<avo::CarBody>())
      .def(py::self == py::self)
      .def_readonly("offset", &avo::CarBody::offset,
                    "[e] m, of its center ahead of the rear axle; < 0: behind it")
      .def_readonly("radius", &avo::CarBody::radius, "m, > 0");
  py::class_<avo::Car>(module, "Car", "Car-like: its position is the center of its rear axle.")
      .def(py::init([](double wheelbase, std::optional<double> max_curvature,
                       std::optional<avo::CarBody> body, bool reverse, avo::AccelerationSet set,
                       std::optional<avo::Footprint> footprint) {
             return avo::Car{wheelbase, max_curvature, body,
                             reverse,   set,           footprint.value_or(avo::Footprint{})};
           }),
           py::kw_only(), arg("wheelbase") = 1.0, arg("max_curvature") = py::none(),
           arg("body") = py::none(), arg("reverse") = false, arg("acceleration_set") = "incircle",
           arg("footprint") = py::none(),
           "wheelbase: m, > 0; max_curvature: 1/m, > 0, None: unbounded; body: None: a disc about "
           "the axle; acceleration_set: \"incircle\" or \"exact\"; footprint: from the rear axle, "
           "instead of a body.")
      .def(pickled<avo::Car>())
      .def(py::self == py::self)
      .def_readonly("wheelbase", &avo::Car::wheelbase, "[d] m, > 0")
      .def_readonly("max_curvature", &avo::Car::max_curvature,
                    "[kappa_max] 1/m, > 0; None: unbounded")
      .def_readonly("body", &avo::Car::body, "CarBody; None: about the axle")
      .def_readonly("reverse", &avo::Car::reverse, "whether it may drive backwards")
      .def_readonly("acceleration_set", &avo::Car::acceleration_set, "\"incircle\" or \"exact\"")
      .def_property_readonly(
          "footprint", [](const avo::Car& car) { return if_any(car.footprint); },
          "Footprint from the rear axle; None: one disc");
}

void bind_drives(py::module_& module) {
  using Drive = avo::DifferentialDrive;
  py::class_<Drive>(module, "DifferentialDrive", "Two wheels on one axle, each driven by itself.")
      .def(py::init([](double track, std::optional<double> offset, double speed,
                       double acceleration, std::optional<avo::Footprint> footprint) {
             if (offset == 0.0) throw avo::Error("offset: found 0, must be > 0 m, or None");
             return Drive{track, offset.value_or(kNoOffset), speed, acceleration,
                          footprint.value_or(avo::Footprint{})};
           }),
           py::kw_only(), arg("track") = 0.4, arg("offset") = py::none(), arg("wheel_speed") = 2.0,
           arg("wheel_acceleration") = 3.0, arg("footprint") = py::none(),
           "track: m, > 0; offset: m, > 0, None: a RobotSetup takes usual_offset() of its radius "
           "and the track; wheel_speed: m/s, > 0; wheel_acceleration: m/s^2, > 0; footprint: from "
           "the middle of the axle.")
      .def(pickled<Drive>())
      .def(py::self == py::self)
      .def_readonly("track", &Drive::track, "[b] m, > 0, between the wheels")
      .def_property_readonly(
          "offset",
          [](const Drive& drive) {
            return drive.offset == kNoOffset ? std::nullopt : std::optional(drive.offset);
          },
          "[L] m, > 0, of the center ahead of the axle; None: not chosen yet")
      .def_readonly("wheel_speed", &Drive::wheel_speed,
                    "[w_max] m/s, > 0, of each wheel on the ground")
      .def_readonly("wheel_acceleration", &Drive::wheel_acceleration,
                    "[alpha_w] m/s^2, > 0, of each wheel")
      .def_property_readonly(
          "footprint", [](const Drive& drive) { return if_any(drive.footprint); },
          "Footprint from the middle of the axle; None: one disc");
  module.def("usual_offset", &avo::usual_offset, arg("radius"), arg("track"),
             "[L] m: half of the smaller one of both, m: the offset of a drive that names none.");
}

void bind_airplanes(py::module_& module) {
  py::class_<avo::Airplane>(module, "Airplane", "Cannot stop; it falls back on circling.")
      .def(py::init([](double min_speed, double lateral, avo::AfterGoal after_goal) {
             return avo::Airplane{min_speed, lateral, after_goal};
           }),
           py::kw_only(), arg("min_speed") = 1.0, arg("lateral_acceleration") = 1.0,
           arg("after_goal") = "loiter",
           "min_speed: m/s, > 0; lateral_acceleration: m/s^2, > 0; after_goal: \"loiter\" or "
           "\"leave\".")
      .def(pickled<avo::Airplane>())
      .def(py::self == py::self)
      .def_readonly("min_speed", &avo::Airplane::min_speed, "m/s, > 0")
      .def_readonly("lateral_acceleration", &avo::Airplane::lateral_acceleration,
                    "[a_lat] m/s^2, > 0; max_acceleration is along its path")
      .def_readonly("after_goal", &avo::Airplane::after_goal, "\"loiter\" or \"leave\"");
  py::class_<avo::LoiterCircle>(module, "LoiterCircle",
                                "The circle that an airplane falls back on.")
      .def(py::init([](avo::Vec2 center, double radius) {
             return avo::LoiterCircle{center, radius};
           }),
           py::kw_only(), arg("center"), arg("radius"), "center: m; radius: m, of the circle.")
      .def(pickled<avo::LoiterCircle>())
      .def(py::self == py::self)
      .def_readonly("center", &avo::LoiterCircle::center,
                    "[c] (x, y), m, to the right of the airplane")
      .def_readonly("radius", &avo::LoiterCircle::radius, "[rho] m");
}

void bind_motion_models(py::module_& module) {
  py::class_<avo::Holonomic>(module, "Holonomic", "Accelerates in every direction.")
      .def(py::init<>())
      .def(py::self == py::self)
      .def(py::pickle([](const avo::Holonomic&) { return py::tuple(); },
                      [](const py::tuple&) { return avo::Holonomic{}; }))
      .def("__repr__", [](const avo::Holonomic&) { return "Holonomic()"; });
  bind_footprints(module);
  bind_cars(module);
  bind_drives(module);
  bind_airplanes(module);
}

using TimedTuple = std::tuple<double, double, double>;  // s, m, m

avo::MovingObstacle mover_of(avo::Vec2 position, avo::Vec2 velocity, avo::Vec2 acceleration,
                             double radius, double max_deviation, std::optional<double> max_speed,
                             std::vector<avo::Vec2> path,
                             const std::vector<TimedTuple>& trajectory) {
  avo::MovingObstacle mover{.position = position,
                            .velocity = velocity,
                            .acceleration = acceleration,
                            .radius = radius,
                            .max_deviation = max_deviation,
                            .max_speed = max_speed,
                            .path = std::move(path)};
  for (const auto& [time, x, y] : trajectory) mover.trajectory.push_back({time, {x, y}});
  start_on_trajectory(mover);
  return mover;
}

void bind_walls(py::module_& module) {
  py::class_<avo::Wall>(module, "Wall", "All within `radius` of the segment from a to b.")
      .def(py::init([](avo::Vec2 a, avo::Vec2 b, double radius) {
             return avo::Wall{a, b, radius};
           }),
           arg("a"), arg("b"), py::kw_only(), arg("radius") = 0.0,
           "a, b: (x, y), m; radius: m, >= 0. A disc where a == b.")
      .def(pickled<avo::Wall>())
      .def_readonly("a", &avo::Wall::a, "(x, y), m")
      .def_readonly("b", &avo::Wall::b, "(x, y), m; a disc where it is a")
      .def_readonly("radius", &avo::Wall::radius, "m, >= 0, around the segment");
  py::class_<avo::Chain>(module, "Chain", "Walls from each point to the next one.")
      .def(py::init([](std::vector<avo::Vec2> points, bool closed) {
             return avo::Chain{std::move(points), closed};
           }),
           arg("points"), py::kw_only(), arg("closed") = false,
           "points: one (x, y) or more, m; closed: also from the last one to the first.")
      .def(pickled<avo::Chain>())
      .def(py::self == py::self)
      .def_readonly("points", &avo::Chain::points, "list of (x, y), m")
      .def_readonly("closed", &avo::Chain::closed,
                    "whether a wall leads from the last point to the first");
  py::class_<avo::StaticObstacle>(module, "StaticObstacle", "What does not move.")
      .def(py::init([](std::vector<avo::Chain> chains, double radius, avo::Fill fill,
                       avo::LayerSet layers) {
             return avo::StaticObstacle{std::move(chains), radius, fill, {}, layers};
           }),
           arg("chains"), py::kw_only(), arg("radius") = 0.0, arg("fill") = "none",
           arg("layers") = avo::kAllLayers,
           "chains: of walls; radius: m, >= 0, of all its walls; fill: \"none\", \"solid\" (robots "
           "may not start inside) or \"bounds\" (not outside); layers: robots in one of them heed "
           "it, all of them: every robot does.")
      .def(pickled<avo::StaticObstacle>())
      .def(py::self == py::self)
      .def_readonly("chains", &avo::StaticObstacle::chains, "list of Chain, a copy")
      .def_readonly("radius", &avo::StaticObstacle::radius, "m, >= 0, of its walls")
      .def_readonly("fill", &avo::StaticObstacle::fill,
                    "where no robot may start: \"none\", \"solid\" or \"bounds\"")
      .def_readonly("layers", &avo::StaticObstacle::layers, "robots in these layers heed it")
      .def_readonly("measured", &avo::StaticObstacle::measured,
                    "list of Chain, a copy: the walls of a map whose stairs of cells have become "
                    "straight in chains");
  using Mover = avo::MovingObstacle;
  py::class_<Mover>(module, "MovingObstacle", "A disc that reacts to no robot.")
      .def(pickled<Mover>())
      .def(py::init(&mover_of), py::kw_only(), arg("position"),
           arg("velocity") = py::make_tuple(0.0, 0.0),
           arg("acceleration") = py::make_tuple(0.0, 0.0), arg("radius") = 0.5,
           arg("max_deviation") = 0.0, arg("max_speed") = py::none(),
           arg("path") = std::vector<avo::Vec2>(), arg("trajectory") = std::vector<TimedTuple>(),
           "position: (x, y), m; velocity: m/s; acceleration: m/s^2; radius: m, > 0; "
           "max_deviation: m/s^2, >= 0; max_speed: m/s, > 0, None: unknown; path: list of (x, y), "
           "m; trajectory: list of (time, x, y), s and m, which also says where it starts.")
      .def_readonly("position", &Mover::position, "(x, y), m, where it starts")
      .def_readonly("velocity", &Mover::velocity, "(x, y), m/s")
      .def_readonly("acceleration", &Mover::acceleration, "(x, y), m/s^2; 0 with max_speed")
      .def_readonly("radius", &Mover::radius, "m, > 0")
      .def_readonly(
          "max_deviation", &Mover::max_deviation,
          "m/s^2, >= 0: by how much its acceleration may differ from what it is thought to be")
      .def_readonly("max_speed", &Mover::max_speed,
                    "m/s, > 0, with max_deviation: that it never exceeds; None: unknown")
      .def_readonly("path", &Mover::path,
                    "list of (x, y), m, that it goes round; empty: straight on")
      .def_property_readonly(
          "trajectory",
          [](const Mover& mover) {
            std::vector<TimedTuple> places;
            for (const auto& [time, position] : mover.trajectory)
              places.emplace_back(time, position.x, position.y);
            return places;
          },
          "list of (time, x, y), s and m, by ascending times; empty: it has none");
}

}  // namespace

avo::MotionModel with_offset(avo::MotionModel model, double radius) {
  auto* drive = std::get_if<avo::DifferentialDrive>(&model);
  if (drive != nullptr && drive->offset == kNoOffset)
    drive->offset = avo::usual_offset(radius, drive->track);
  return model;
}

avo::MotionModel checked_offset(avo::MotionModel model) {
  const auto* drive = std::get_if<avo::DifferentialDrive>(&model);
  if (drive != nullptr && drive->offset == kNoOffset)
    throw avo::Error(
        "model: found a DifferentialDrive without offset, must have the one that its controller "
        "steers by, such as usual_offset(radius, track)");
  return model;
}

void bind_models(py::module_& module) {
  bind_motion_models(module);
  bind_walls(module);
}

}  // namespace avo_python
