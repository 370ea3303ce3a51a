// SPDX-License-Identifier: Apache-2.0
// Words for starts that break what a certificate assumes.
#pragma once
#include <functional>
#include <string>

#include "avo/assumptions.h"

namespace avo::inline sim {

/// The names that the readers of the words use.
struct Wording {
  RemedyNames remedies = {};
  std::function<std::string(BodyId)> name_of;
  std::function<std::string(ObstacleId)> name_of_static;
};

std::string complaint(const BrokenStart& start, const Scenario& scenario, const Wording& wording);
std::string complaint(const WallStart& start, const Scenario& scenario, const Wording& wording);
std::string complaint(const MisplacedStart& start, const Scenario& scenario,
                      const Wording& wording);
std::string complaint(const FastStart& start, const Scenario& scenario, const Wording& wording);

/// Throws Error with the complaint, and with the option that accepts such a start.
[[noreturn]] void refuse_start(const std::string& complaint);

/// Throws Error with the first broken assumption of the scene, unless the scene allows it.
void require_assumptions(const Scenario& scenario);

}  // namespace avo::inline sim
