// SPDX-License-Identifier: Apache-2.0
// Whether there is a certificate with promises for metrics to examine.
#pragma once
#include <algorithm>

#include "avo/scenario.h"

namespace avo::inline metrics {

/// Returns whether some robot keeps one.
inline bool some_keep_certificate(const Scenario& scenario) {
  return std::any_of(scenario.robots.begin(), scenario.robots.end(), [&](const RobotSetup& robot) {
    return certificate_of(scenario, robot) != Certificate::none;
  });
}

}  // namespace avo::inline metrics
