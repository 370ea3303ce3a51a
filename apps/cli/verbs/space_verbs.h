// SPDX-License-Identifier: Apache-2.0
// Verbs for scenes with `space: 3`.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "avo_io/judgement.h"
#include "avo_io/space.h"
#include "verbs/verbs.h"

namespace avo_cli {

/// Returns the scene if it is one of space. Throws UsageError where an output is the scene's file.
std::optional<avo::space::Scenario> load_in_space(const SceneArguments& arguments,
                                                  const std::vector<NamedFile>& outputs);

/// Returns a line for each robot that boxes keep from its goal, with the place where its route
/// ends.
std::vector<std::string> told_out_of_reach(const avo::space::Scenario& scenario);

int run_in_space(const RunArguments& arguments, const avo::space::Scenario& scenario);
/// Judges a recording of the scene's robots.
avo_io::Judgement judge_in_space(const CheckArguments& arguments,
                                 const avo::space::Scenario& scenario);
/// Writes the set points of a recording's quadrotors.
int convert_to_set_points(const ConvertArguments& arguments);

}  // namespace avo_cli
