// SPDX-License-Identifier: Apache-2.0
// The parts of the extension, one file for each subject; module.cpp calls them in this order.
#pragma once
#include <limits>
#include <string>
#include <vector>

#include "avo/scenario.h"
#include "avo_io/scene.h"
#include "casters.h"

namespace avo_python {

namespace py = pybind11;

inline constexpr double kInfinity = std::numeric_limits<double>::infinity();

void bind_models(py::module_& module);
void bind_robots(py::module_& module);
void bind_setup(py::module_& module);
void bind_planner(py::module_& module);
void bind_navigator(py::module_& module);
void bind_batches(py::module_& module);
void bind_scenario(py::module_& module);
void bind_simulation(py::module_& module);
void bind_events(py::module_& module);
void bind_teams(py::module_& module);
void bind_reports(py::module_& module);
void bind_sweeps(py::module_& module);
void bind_worlds(py::module_& module);
void bind_space(py::module_& module);
namespace space {  // the parts of it
void bind_robots(py::module_& module);
void bind_planner(py::module_& module);
void bind_scenes(py::module_& module);
void bind_events(py::module_& module);
void bind_runs(py::module_& module);
void bind_worlds(py::module_& module);
void bind_batches(py::module_& module);
}  // namespace space

/// Returns the scenario of the name of a built-in scene, a path, a dict, or a Scenario itself.
/// `overrides` is a dict by dotted keys, a list of "key=value", or None. made_of, if given,
/// receives the texts that a scene with a name, a path or a dict is made of.
avo::Scenario scenario_of(const py::object& source, const py::object& overrides,
                          avo_io::SceneSource* made_of = nullptr);

/// Returns the model for a robot of that radius, m: a differential drive without an offset takes
/// usual_offset().
avo::MotionModel with_offset(avo::MotionModel model, double radius);
/// Sets the fields of a setup that have a name among these; TypeError for another name or type.
void set_fields(avo::RobotSetup& setup, const py::kwargs& given);
/// Returns the options of a planner by their names; None and what is left out: what is customary.
avo::PlannerOptions options_of(const py::kwargs& given);
/// Returns the arguments that make these options.
py::dict arguments_of(const avo::PlannerOptions& options);
/// Adds the constructor of planners, and their options as attributes.
void bind_options(py::class_<avo::Planner>& planner);
/// Throws Error if a planner's robot has a differential drive without an offset.
avo::MotionModel checked_offset(avo::MotionModel model);

/// Returns the value as JSON, which is YAML; numbers and arrays of numpy become plain ones.
std::string json_of(const py::handle& value);
/// Returns overrides as "key=value", of what scenario_of() takes.
std::vector<std::string> overrides_of(const py::object& overrides);

/// Returns the path of a str, bytes or os.PathLike in the bytes of the system, which may be no
/// UTF-8.
std::string path_of(const py::object& path);
/// The path of a recording to write. Throws Error for the endings of other formats.
std::string recording_path(const py::object& path);

/// Returns the object that Python's json makes of the text.
py::object from_json(const std::string& text);

}  // namespace avo_python
