// SPDX-License-Identifier: Apache-2.0
#include "sim/sensing/snapshot.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "certificate/discs.h"
#include "robots/footprint.h"

namespace avo::inline sim {
namespace {

// Where a search finds more, cells of half its radius leave fewer candidates.
constexpr double kCrowd = 24.0;

}  // namespace

void lay_out(const Fleet& fleet, double radius, double near, std::size_t most, Snapshot& snapshot) {
  double side = radius;
  const auto robots = static_cast<double>(fleet.size());
  if (snapshot.crowding > 0 && snapshot.side > 0.0 && std::isfinite(snapshot.side)) {
    // others in the cell of a robot, and so in a square meter
    const double others = std::max(static_cast<double>(snapshot.crowding) / robots - 1.0, 1e-9);
    const double density = others / (snapshot.side * snapshot.side);
    const double nearest = std::sqrt(static_cast<double>(most) / (std::numbers::pi * density));
    side = std::min(std::max(near, nearest), radius);
    if (density * std::numbers::pi * side * side > kCrowd) side *= 0.5;
    side = std::max(side, radius / kMostSides);
  }
  snapshot.side = side;
  snapshot.cells = make_cells(fleet.position, side);
}

namespace {

void take_poses(const Fleet& fleet, const StepLaw& law, std::vector<BrakingPose>& poses) {
  poses.assign(fleet.has_footprints ? fleet.size() : 0, {});
  for (std::size_t slot = 0; slot < poses.size(); ++slot) {
    const MotionModel* model = fleet.own_model(slot);
    if (model == nullptr || !has_footprint(*model)) continue;
    poses[slot] = braking_pose(*model, fleet.velocity[slot], fleet.heading[slot],
                               fleet.traits[slot].max_braking, law);
  }
}

}  // namespace

void prepare(const Fleet& fleet, const StepLaw& law, Snapshot& snapshot) {
  take_poses(fleet, law, snapshot.pose);
  snapshot.grid.prepare(snapshot.cells, fleet.size());
  snapshot.sensed.resize(fleet.size());
  snapshot.circle.resize(fleet.flights.empty() ? 0 : fleet.size());
}

std::uint64_t take(const Fleet& fleet, std::size_t part, std::size_t parts, Snapshot& snapshot) {
  const SortedPart sorted =
      snapshot.grid.build_part(fleet.cell, fleet.position, fleet.rank, part, parts);
  const std::span<const std::uint32_t> order = snapshot.grid.order();
  for (std::size_t place = sorted.first; place < sorted.last; ++place) {
    const std::uint32_t slot = order[place];
    const RobotTraits& robot_traits = fleet.traits[slot];
    snapshot.sensed[place] = {fleet.velocity[slot], robot_traits.radius,
                              robot_traits.max_acceleration};
    if (!snapshot.circle.empty())
      snapshot.circle[place] = fleet.circle(slot).value_or(LoiterCircle{});
  }
  return sorted.crowding;
}

}  // namespace avo::inline sim
