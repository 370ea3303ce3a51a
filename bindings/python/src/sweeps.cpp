// SPDX-License-Identifier: Apache-2.0
// Many runs, also with methods of the caller's own.
#include <fmt/format.h>
#include <map>
#include <utility>

#include "avo_io/output_file.h"
#include "avo_io/recording.h"
#include "avo_io/sweep.h"
#include "external.h"

namespace avo_python {
namespace {

using py::arg;

/// What avo.OwnMethod holds.
struct Own {
  py::object function;
  bool clamped = true, certified = false;
  std::string output;
};

std::vector<avo_io::OwnMethod> methods_of(const std::map<std::string, Own>& own) {
  std::vector<avo_io::OwnMethod> methods;
  for (const auto& [name, method] : own)
    methods.push_back({name, external_of(method.function, output_of(method.output)), method.clamped,
                       method.certified, ""});
  return methods;
}

avo_io::SweepSpec spec_of(const py::object& spec, const std::map<std::string, Own>& own) {
  if (!py::isinstance<py::dict>(spec)) return avo_io::load_sweep(path_of(spec), methods_of(own));
  const auto text = py::module_::import("json").attr("dumps")(spec).cast<std::string>();
  return avo_io::parse_sweep(text, "dict", methods_of(own));
}

/// A number, a text, or None where there is no value.
py::object value_of(const std::string& field) {
  if (field.empty()) return py::none();
  if (const auto number = avo_io::number_in(field)) return py::float_(*number);
  return py::str(field);
}

void write(const avo_io::SweepTable& table, const std::string& path) {
  avo_io::OutputFile file(path);
  if (avo_io::is_hdf5_path(path))
    write_sweep_hdf5(table, file.temporary(), path);
  else
    file.write(to_csv(table));
  file.commit();
}

py::list sweep(const py::object& spec, const std::map<std::string, Own>& own, int jobs,
               const py::object& out) {
  const avo_io::SweepSpec known = spec_of(spec, own);
  const std::string path = out.is_none() ? "" : path_of(out);
  avo_io::SweepTable table;
  {
    const py::gil_scoped_release release;
    bool interrupted = false;
    const auto heed = [&](std::int64_t, std::int64_t) {
      const py::gil_scoped_acquire acquire;
      interrupted = interrupted || PyErr_CheckSignals() != 0;
      if (interrupted) throw py::error_already_set();
    };
    if (jobs < 0) throw avo::Error(fmt::format("jobs: found {}, must be >= 0", jobs));
    table = run_sweep(known, {.jobs = jobs, .journal = "", .progress = heed}).table;
    if (!path.empty()) write(table, path);
  }
  py::list rows;
  for (const std::vector<std::string>& fields : table.rows) {
    py::dict row;
    for (std::size_t k = 0; k < fields.size(); ++k)
      row[py::str(table.columns[k])] = value_of(fields[k]);
    rows.append(row);
  }
  return rows;
}

}  // namespace

void bind_sweeps(py::module_& module) {
  py::class_<Own>(module, "OwnMethod", "A method of your own in a sweep.")
      .def(py::init([](const py::object& function, bool clamped, bool certified,
                       const std::string& output) {
             return Own{function, clamped, certified, output};
           }),
           arg("function"), py::kw_only(), arg("clamped") = true, arg("certified") = false,
           arg("output") = "velocity", "As Scenario.with_method().");
  module.def("sweep", &sweep, arg("spec"), py::kw_only(), arg("own") = std::map<std::string, Own>(),
             arg("jobs") = 0, arg("out") = py::none(),
             "Many runs, as `avo sweep`: a list of one dict a run, by the columns of its table. "
             "spec: a file, or a dict with the same keys. own: methods of your own by the names "
             "that \"methods\" has for them. jobs: runs at a time, 0: all processors. out: the "
             "table as a file that `avo compare` and `avo report` read, .csv or .h5.");
}

}  // namespace avo_python
