// SPDX-License-Identifier: Apache-2.0
// Errors and remedies for scenes that break the assumptions of their certificate.
#pragma once
#include "verbs/verbs.h"

namespace avo_cli {

/// Applies --start-at-rest and --limit-speed, and reports what they changed.
void apply_remedies(const SceneArguments& arguments, avo::Scenario& scenario);

/// Throws BrokenScene if the scene breaks an assumption.
void require_assumptions(const std::string& scene, const avo::Scenario& scenario);

}  // namespace avo_cli
