// SPDX-License-Identifier: Apache-2.0
// avo._avo: the library for Python.
#include <fmt/format.h>
#include <utility>

#include "avo/version.h"
#include "avo_io/nearest.h"
#include "avo_io/printable.h"
#include "bind.h"

namespace avo_python {

void refuse_word(const char* name, const std::string& found,
                 const std::vector<std::string_view>& words) {
  constexpr std::size_t kLongest = 60;  // characters
  for (const avo::Removed& gone : avo::kRemoved)
    if (gone.key == name && gone.value == found)
      throw avo::Error(
          fmt::format("{}: found \"{}\", must be {}", name, found, allowed_instead(gone)));
  throw avo::Error(fmt::format("{}: found \"{}\", {}", name, avo_io::printable(found, kLongest),
                               avo_io::allowed_words(found, words)));
}

py::object from_json(const std::string& text) {
  return py::module_::import("json").attr("loads")(text);
}

namespace {

template <typename Enum>
py::tuple tuple_of_words() {
  const auto all = words<Enum>();
  py::tuple tuple(all.size());
  for (std::size_t k = 0; k < all.size(); ++k) tuple[k] = py::str(std::string(all[k]));
  return tuple;
}

}  // namespace
}  // namespace avo_python

PYBIND11_MODULE(_avo, module) {
  using namespace avo_python;
  module.doc() = "Multi-robot collision avoidance that respects acceleration limits. SI units.";
  auto& error = py::register_exception<avo::Error>(module, "Error", PyExc_ValueError);
  error.attr("__module__") = "avo";
  error.attr("__doc__") = "Bad input: one line that says where, what was found, what is allowed.";
  module.attr("__version__") = avo::kVersion;
  module.attr("PLAN_STATUS") = tuple_of_words<avo::PlanStatus>();
  module.attr("SAFETY_STATE") = tuple_of_words<avo::SafetyState>();
  bind_models(module);
  bind_robots(module);
  bind_setup(module);
  bind_planner(module);
  bind_navigator(module);
  bind_batches(module);
  bind_scenario(module);
  bind_simulation(module);
  bind_events(module);
  bind_teams(module);
  bind_reports(module);
  bind_sweeps(module);
  bind_worlds(module);
  bind_space(module);
}
