// SPDX-License-Identifier: Apache-2.0
// External methods that are functions of Python.
#pragma once
#include "avo/external_method.h"
#include "bind.h"

namespace avo_python {

/// What a function returns.
enum class Output : std::uint8_t { velocity, acceleration };
/// Throws Error for another word.
Output output_of(const std::string& word);

/// The function is called with Python's lock, which the caller need not hold. None: no method.
avo::ExternalMethod external_of(const py::object& function, Output output);

/// The scene with that method for all its robots that have none of their own.
avo::Scenario with_method(const avo::Scenario& scenario, const std::string& name,
                          const py::object& function, bool clamped, bool certified,
                          const std::string& output);

}  // namespace avo_python
