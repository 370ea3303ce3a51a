// SPDX-License-Identifier: Apache-2.0
// Robots of space: what one knows of itself and of others, boxes, quadrotors and their set points.
#include <array>
#include <cstddef>
#include <fmt/format.h>

#include "avo/space/autopilots.h"
#include "avo/space/scenario.h"
#include "fields.h"

namespace avo_python::space {
namespace {

using avo::Vec3;
using py::arg;

const auto kOrigin = [] { return py::make_tuple(0.0, 0.0, 0.0); };

void bind_box(py::module_& space) {
  using avo::space::Box;
  py::class_<Box>(space, "Box",
                  "All points within `radius` of a box that is turned about the vertical. Infinite "
                  "bounds make a floor, a ceiling or a wall at all heights.")
      .def(py::init([](Vec3 min, Vec3 max, double heading, double radius) {
             return Box{min, max, heading, radius};
           }),
           py::kw_only(), arg("min") = Vec3{-kInfinity, -kInfinity, -kInfinity},
           arg("max") = Vec3{kInfinity, kInfinity, kInfinity}, arg("heading") = 0.0,
           arg("radius") = 0.0,
           "min, max: (x, y, z), m, in the frame of the box; heading: rad, about the origin; "
           "radius: m, >= 0.")
      .def_readwrite("min", &Box::min, "(x, y, z), m, in the frame of the box")
      .def_readwrite("max", &Box::max, "(x, y, z), m, >= min")
      .def_readwrite("heading", &Box::heading,
                     "rad, counter-clockwise from above, about the origin")
      .def_readwrite("radius", &Box::radius, "m, >= 0");
}

void bind_quadrotor(py::module_& space) {
  using avo::space::Quadrotor;
  py::class_<Quadrotor>(space, "Quadrotor", "What flies behind a robot, its reference.")
      .def(
          py::init([](double mass, double max_thrust, std::optional<double> min_thrust,
                      double max_tilt, double attitude_time, std::optional<double> tracking_error) {
            const Quadrotor made{mass,     max_thrust,    min_thrust,
                                 max_tilt, attitude_time, tracking_error};
            validate(made, "Quadrotor");
            return made;
          }),
          py::kw_only(), arg("mass") = 1.0, arg("max_thrust") = 20.0,
          arg("min_thrust") = py::none(), arg("max_tilt") = 0.6, arg("attitude_time") = 0.15,
          arg("tracking_error") = py::none(),
          "mass: kg; max_thrust, min_thrust: N; max_tilt: rad; attitude_time: s; tracking_error: "
          "m. Raises Error on values out of range.")
      .def_readonly("mass", &Quadrotor::mass, "kg, > 0")
      .def_readonly("max_thrust", &Quadrotor::max_thrust, "N, of all rotors, > its weight")
      .def_readonly("min_thrust", &Quadrotor::min_thrust, "N; None: a tenth of its weight")
      .def_readonly("max_tilt", &Quadrotor::max_tilt, "rad, of thrust from the vertical")
      .def_readonly("attitude_time", &Quadrotor::attitude_time,
                    "s: mean delay of the acceleration behind its command")
      .def_readonly("tracking_error", &Quadrotor::tracking_error,
                    "m, as measured; None: max_acceleration attitude_time^2")
      .def_property_readonly(
          "max_acceleration", [](const Quadrotor& own) { return limits_of(own).max_acceleration; },
          "m/s^2, of its reference")
      .def_property_readonly(
          "deviation", [](const Quadrotor& own) { return limits_of(own).deviation; },
          "m: how far it may be from its reference of attitude_time ago");
}

void bind_filter(py::module_& space) {
  using avo::space::Filter;
  using avo::space::SetPoint;
  py::class_<SetPoint>(space, "SetPoint", "What an autopilot is told for one instant.")
      .def_readonly("position", &SetPoint::position, "(x, y, z), m")
      .def_readonly("velocity", &SetPoint::velocity, "(x, y, z), m/s")
      .def_readonly("acceleration", &SetPoint::acceleration,
                    "(x, y, z), m/s^2, to feed forward, without gravity");
  py::class_<Filter>(space, "Filter", "Makes set points of the reference of one quadrotor.")
      .def(py::init(
               [](const avo::space::Quadrotor& quadrotor, double fleet_delay, double time_step) {
                 return Filter(limits_of(quadrotor), fleet_delay, time_step);
               }),
           arg("quadrotor"), py::kw_only(), arg("fleet_delay"), arg("time_step"),
           "fleet_delay: s, the largest attitude_time of the fleet; time_step: s, of the "
           "reference. Raises Error on values out of range.")
      .def("add", &Filter::add, arg("position"), arg("velocity"), arg("acceleration"),
           "Adds the next step of the reference: its start, and its acceleration. Raises Error on "
           "values that are not finite or beyond 1e12, and adds nothing then.")
      .def_property_readonly("begin", &Filter::begin, "s: set points are known from here on")
      .def_property_readonly("end", &Filter::end, "s: until here")
      .def("at", &Filter::at, arg("time"), "The SetPoint of that time, s.");
}

// A member of a set point as a tuple.
template <typename Point, std::size_t Size>
auto tuple_of(std::array<float, Size> Point::*member) {
  return [member](const Point& point) { return py::tuple(py::cast(point.*member)); };
}

template <typename Point>
void bind_motion(py::class_<Point>& point) {
  point.def_property_readonly("position", tuple_of(&Point::position), "m")
      .def_property_readonly("velocity", tuple_of(&Point::velocity), "m/s")
      .def_property_readonly("acceleration", tuple_of(&Point::acceleration),
                             "m/s^2, without gravity");
}

void bind_autopilots(py::module_& space) {
  using avo::space::CrazyflieSetPoint;
  using avo::space::Px4SetPoint;
  py::class_<Px4SetPoint> px4(
      space, "Px4SetPoint",
      "The message TrajectorySetpoint of PX4: north, east, down. NaN is what PX4 may choose.");
  px4.def_readonly("timestamp", &Px4SetPoint::timestamp, "microseconds");
  bind_motion(px4);
  px4.def_property_readonly("jerk", tuple_of(&Px4SetPoint::jerk), "NaN")
      .def_readonly("yaw", &Px4SetPoint::yaw, "NaN")
      .def_readonly("yawspeed", &Px4SetPoint::yawspeed, "NaN");
  py::class_<CrazyflieSetPoint> crazyflie(
      space, "CrazyflieSetPoint",
      "What send_full_state_setpoint() of the Crazyflie's library takes, with a level attitude.");
  bind_motion(crazyflie);
  crazyflie
      .def_property_readonly("orientation", tuple_of(&CrazyflieSetPoint::orientation),
                             "quaternion x, y, z, w")
      .def_readonly("roll_rate", &CrazyflieSetPoint::roll_rate, "degrees/s")
      .def_readonly("pitch_rate", &CrazyflieSetPoint::pitch_rate, "degrees/s")
      .def_readonly("yaw_rate", &CrazyflieSetPoint::yaw_rate, "degrees/s");
  space.def(
      "px4_set_point", &avo::space::px4_set_point, arg("point"), arg("time"),
      "The SetPoint for PX4. x of the scene points east, y north, z up. time: s, >= 0, of the "
      "autopilot's clock. Raises Error on other times, and on values beyond 1e12.");
  space.def("crazyflie_set_point", &avo::space::crazyflie_set_point, arg("point"),
            "The SetPoint for a Crazyflie. Raises Error on values beyond 32.767 m, m/s or m/s^2: a "
            "packet has thousandths in 16 bits.");
}

void bind_setup(py::module_& space) {
  using avo::space::RobotSetup;
  py::class_<RobotSetup> setup(space, "RobotSetup",
                               "What a scene of space says of a robot. Read only.");
  bind_fields(setup, avo_io::space_robot_fields(), "max_acceleration");
  setup
      .def_property_readonly(
          "max_acceleration", [](const RobotSetup& own) { return robot_of(own).max_acceleration; },
          "m/s^2, along the horizontal; of a quadrotor that of its limits")
      .def_readonly("quadrotor", &RobotSetup::quadrotor, "Quadrotor, or None");
}

void bind_robot(py::module_& space) {
  using avo::space::Robot;
  py::class_<Robot>(space, "Robot", "Robot A, the robot that decides.")
      .def(py::init([](Vec3 position, Vec3 velocity, Vec3 preferred_velocity, double radius,
                       double max_acceleration, double max_speed, double vertical, double climb,
                       double sink, double downwash, double priority,
                       std::optional<double> max_braking, double distance_to_goal) {
             return Robot{position,
                          velocity,
                          preferred_velocity,
                          radius,
                          max_acceleration,
                          max_speed,
                          vertical,
                          climb,
                          sink,
                          downwash,
                          priority,
                          max_braking,
                          distance_to_goal};
           }),
           py::kw_only(), arg("position"), arg("velocity") = kOrigin(),
           arg("preferred_velocity") = kOrigin(), arg("radius") = 0.5,
           arg("max_acceleration") = 1.0, arg("max_speed") = 2.0, arg("vertical") = 1.0,
           arg("climb") = kInfinity, arg("sink") = kInfinity, arg("downwash") = 0.0,
           arg("priority") = 1.0, arg("max_braking") = py::none(),
           arg("distance_to_goal") = kInfinity,
           "position: (x, y, z), m; velocity, preferred_velocity: m/s; radius, downwash: m; "
           "max_acceleration, max_braking: m/s^2; max_speed, climb, sink: m/s; vertical: limits "
           "along the vertical, as a part of those along the horizontal; distance_to_goal: m.")
      .def_readwrite("position", &Robot::position, "[p_A] (x, y, z), m, the center of its ball")
      .def_readwrite("velocity", &Robot::velocity, "[v_A] (x, y, z), m/s")
      .def_readwrite("preferred_velocity", &Robot::preferred_velocity, "[v_A^pref] m/s")
      .def_readwrite("radius", &Robot::radius, "[r_A] m, > 0")
      .def_readwrite("max_acceleration", &Robot::max_acceleration, "[a_A^max] m/s^2, > 0")
      .def_readwrite("max_speed", &Robot::max_speed, "[v_A^max] m/s, > 0")
      .def_readwrite("vertical", &Robot::vertical,
                     "[e_A] > 0: limits along the vertical, as a part of the horizontal ones")
      .def_readwrite("climb", &Robot::climb, "m/s, > 0: the largest v_z")
      .def_readwrite("sink", &Robot::sink, "m/s, > 0: the largest -v_z")
      .def_readwrite("downwash", &Robot::downwash, "[w_A] m, >= 0: no robot may be so far below it")
      .def_readwrite("priority", &Robot::priority, "> 0, as in the plane")
      .def_readwrite("max_braking", &Robot::max_braking, "[b_A] m/s^2; None: max_acceleration")
      .def_readwrite("distance_to_goal", &Robot::distance_to_goal, "m; inf: it has none");
}

void bind_neighbor(py::module_& space) {
  using avo::space::Neighbor;
  py::class_<Neighbor>(space, "Neighbor", "Another robot B as A senses it; B decides as well.")
      .def(py::init([](Vec3 position, Vec3 velocity, double radius, double max_acceleration,
                       double vertical, double downwash, double priority,
                       std::optional<double> max_braking, int age) {
             return Neighbor{position, velocity,    radius, max_acceleration, vertical, downwash,
                             priority, max_braking, age};
           }),
           py::kw_only(), arg("position"), arg("velocity") = kOrigin(), arg("radius") = 0.5,
           arg("max_acceleration") = 1.0, arg("vertical") = 1.0, arg("downwash") = 0.0,
           arg("priority") = 1.0, arg("max_braking") = py::none(), arg("age") = 0,
           "position: (x, y, z), m; velocity: m/s; age: steps since it was sensed; the others as "
           "those of Robot.")
      .def_readwrite("position", &Neighbor::position, "[p_B] (x, y, z), m")
      .def_readwrite("velocity", &Neighbor::velocity, "[v_B] (x, y, z), m/s")
      .def_readwrite("radius", &Neighbor::radius, "[r_B] m, > 0")
      .def_readwrite("max_acceleration", &Neighbor::max_acceleration, "[a_B^max] m/s^2, > 0")
      .def_readwrite("vertical", &Neighbor::vertical, "[e_B] > 0, see Robot.vertical")
      .def_readwrite("downwash", &Neighbor::downwash, "[w_B] m, >= 0, see Robot.downwash")
      .def_readwrite("priority", &Neighbor::priority, "> 0")
      .def_readwrite("max_braking", &Neighbor::max_braking, "[b_B] m/s^2; None: max_acceleration")
      .def_readwrite("age", &Neighbor::age,
                     "[d] steps since it was sensed; extrapolated at constant velocity");
}

void bind_mover(py::module_& space) {
  using avo::space::Mover;
  py::class_<Mover>(space, "Mover", "A moving obstacle as a robot senses it; it decides nothing.")
      .def(py::init([](Vec3 position, Vec3 velocity, Vec3 acceleration, double radius,
                       double max_deviation, double max_speed, int age) {
             return Mover{position, velocity, acceleration, radius, max_deviation, max_speed, age};
           }),
           py::kw_only(), arg("position"), arg("velocity") = kOrigin(),
           arg("acceleration") = kOrigin(), arg("radius") = 0.5, arg("max_deviation") = 0.0,
           arg("max_speed") = kInfinity, arg("age") = 0,
           "position: (x, y, z), m; velocity, max_speed: m/s; acceleration, max_deviation: m/s^2; "
           "radius: m; age: steps since it was sensed.")
      .def_readwrite("position", &Mover::position, "(x, y, z), m, the center of its ball")
      .def_readwrite("velocity", &Mover::velocity, "(x, y, z), m/s")
      .def_readwrite("acceleration", &Mover::acceleration,
                     "(x, y, z), m/s^2, kept up to max_deviation; 0 with max_speed")
      .def_readwrite("radius", &Mover::radius, "m, > 0")
      .def_readwrite("max_deviation", &Mover::max_deviation,
                     "[η] m/s^2, >= 0: the largest difference of its acceleration")
      .def_readwrite("max_speed", &Mover::max_speed,
                     "[V] m/s, > 0, with max_deviation: that it never exceeds; inf: unknown")
      .def_readwrite("age", &Mover::age,
                     "[d] steps since it was sensed; extrapolated by its acceleration");
}

}  // namespace

void bind_robots(py::module_& space) {
  bind_box(space);
  bind_quadrotor(space);
  bind_filter(space);
  bind_autopilots(space);
  bind_setup(space);
  bind_robot(space);
  bind_neighbor(space);
  bind_mover(space);
}

}  // namespace avo_python::space
