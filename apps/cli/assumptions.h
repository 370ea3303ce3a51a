// SPDX-License-Identifier: Apache-2.0
// What is said of scenes that break what their certificate assumes, and what is done about it.
#pragma once
#include "verbs/verbs.h"

namespace avo_cli {

/// --start-at-rest and --limit-speed; tells what they changed.
void apply_remedies(const SceneArguments& arguments, avo::Scenario& scenario);

/// Throws BrokenScene.
void require_assumptions(const std::string& scene, const avo::Scenario& scenario);

}  // namespace avo_cli
