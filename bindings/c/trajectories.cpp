// SPDX-License-Identifier: Apache-2.0
// The known future of movers.
#include <cmath>
#include <memory>
#include <optional>
#include <span>

#include "avo/trajectory.h"
#include "convert.h"
#include "handles.h"
#include "layouts.h"

namespace avo_c {
namespace {

AVO_C_CONSTINIT Handles<avo_trajectory_id, avo::Trajectory> trajectories("trajectory");

}  // namespace

const avo::Trajectory* trajectory_of(avo_trajectory_id trajectory) {
  const bool is_null = trajectory.index == 0 && trajectory.generation == 0;
  return is_null ? nullptr : &trajectories.at(trajectory);
}

}  // namespace avo_c

using namespace avo_c;  // NOLINT(google-build-using-namespace): what follows is C

avo_result avo_create_trajectory(const avo_timed_place* places, size_t count, double error,
                                 double repeats_from, avo_trajectory_id* trajectory) {
  return guarded([&] {
    avo_trajectory_id& id = at(trajectory, "trajectory");
    require_array(places, count, "places");
    const std::optional<double> round =
        std::isnan(repeats_from) ? std::nullopt : std::optional(repeats_from);
    id = trajectories.add(std::make_unique<avo::Trajectory>(
        std::span(reinterpret_cast<const avo::TimedPlace*>(places), count), error, round));
  });
}

avo_result avo_destroy_trajectory(avo_trajectory_id trajectory) {
  return guarded([&] { trajectories.take(trajectory); });
}

bool avo_trajectory_is_valid(avo_trajectory_id trajectory) {
  return trajectories.find(trajectory) != nullptr;
}
