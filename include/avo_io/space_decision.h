// SPDX-License-Identifier: Apache-2.0
// One decision of a robot in space, and what it followed from: the output of `avo explain`.
#pragma once
#include <cstdint>
#include <functional>
#include <optional>
#include <string>

#include "avo/export.h"
#include "avo/space/explanation.h"

namespace avo_io {

/// Steps to the last decision of the robot by `time`, s, and explains it. Where go_on() is given,
/// it is asked before each step; the result is none where it returns false. Throws Error unless the
/// scene has that robot, and lasts until `time`.
AVO_API std::optional<avo::space::Explanation> explain_in_space(
    const avo::space::Scenario& scenario, std::int64_t robot, double time, int threads = 0,
    const std::function<bool(double time)>& go_on = {});

/// Returns one line for each fact. scene: its name.
AVO_API std::string readable(const avo::space::Explanation& decision, const std::string& scene);
/// Returns one JSON object (docs/space.md). scene: its name.
AVO_API std::string to_json(const avo::space::Explanation& decision, const std::string& scene);

}  // namespace avo_io
