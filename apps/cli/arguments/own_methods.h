// SPDX-License-Identifier: Apache-2.0
// Methods of the user's own, from shared libraries (docs/own_method.md).
#pragma once
#include <string>
#include <vector>

#include "avo_io/sweep.h"

namespace CLI {
class App;
}

namespace avo_cli {

/// Adds --method. several: it may be repeated.
void add_own_methods(CLI::App& verb, std::vector<std::string>& given, bool several);

/// The methods of "NAME=LIBRARY[:FUNCTION][,certified][,unclamped]". The libraries stay loaded.
/// Throws UsageError.
std::vector<avo_io::OwnMethod> own_methods_of(const std::vector<std::string>& given);

/// The function behind the method that a recorded scene names; none where nothing is given. A
/// recording says itself what its method was: throws UsageError where more than the library is
/// given, and that differs.
avo::ExternalMethod method_behind(const std::vector<std::string>& given,
                                  const avo::Scenario& recorded);

}  // namespace avo_cli
