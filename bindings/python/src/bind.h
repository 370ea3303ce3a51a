// SPDX-License-Identifier: Apache-2.0
// The parts of the extension, one file a subject; module.cpp calls them in this order.
#pragma once
#include <limits>
#include <string>

#include "avo/scenario.h"
#include "casters.h"

namespace avo_python {

namespace py = pybind11;

inline constexpr double kInfinity = std::numeric_limits<double>::infinity();

void bind_models(py::module_& module);
void bind_robots(py::module_& module);
void bind_planner(py::module_& module);
void bind_batches(py::module_& module);
void bind_scenario(py::module_& module);
void bind_simulation(py::module_& module);
void bind_reports(py::module_& module);
void bind_worlds(py::module_& module);

/// From the name of a built-in scene, a path, a dict, or a Scenario itself; `overrides` is a dict
/// by dotted keys, a list of "key=value", or None.
avo::Scenario scenario_of(const py::object& source, const py::object& overrides);

/// Of a robot of that radius, m: a drive without an offset takes usual_offset().
avo::MotionModel with_offset(avo::MotionModel model, double radius);
/// Throws Error where a planner's robot has a drive without an offset.
avo::MotionModel checked_offset(avo::MotionModel model);

/// Of a str, bytes or os.PathLike: as the system has it, in UTF-8 or not.
std::string path_of(const py::object& path);

/// What Python's json makes of the text.
py::object from_json(const std::string& text);

}  // namespace avo_python
