// SPDX-License-Identifier: Apache-2.0
#include "metrics/mover_contacts.h"

#include <algorithm>

#include "avo/discs.h"
#include "core/plane.h"
#include "metrics/wall_contacts.h"

namespace avo::inline metrics {
namespace {

bool is_before(const MoverContact& a, const MoverContact& b) {
  return a.robot != b.robot ? a.robot < b.robot : a.obstacle < b.obstacle;
}

// For a robot with a footprint, where it is now.
bool touches_disc(const RobotSetup& robot, const MovingObstacleView& movers, std::size_t mover) {
  const std::vector<Disc> discs = discs_at(robot, robot.position, robot.heading);
  return std::any_of(discs.begin(), discs.end(), [&](const Disc& disc) {
    const double contact = disc.radius + movers.setup[mover].radius;
    return norm(movers.position[mover] - disc.center) < contact * (1.0 - kContact);
  });
}

}  // namespace

void MoverContacts::take(const FleetView& fleet) {
  discs_.clear();
  for (std::size_t row = 0; row < fleet.id.size(); ++row) {
    const RobotSetup& setup = fleet.setup[row];
    discs_.push_back({fleet.id[row].value, is_parked(setup), disc_radius(setup),
                      norm(disc_center(setup) - setup.position),
                      footprint_of(setup.model).discs > 0});
  }
}

// Meets the movers with centers that are within that reach, m.
void MoverContacts::meet(const Simulation& simulation, Vec2 position, std::size_t row,
                         double reach) {
  const MovingObstacleView movers = simulation.moving_obstacles();
  const RowDisc& disc = discs_[row];
  const auto first = static_cast<std::ptrdiff_t>(now_.size());
  if (!is_finite(position)) return;
  movers_.list_within(position, reach, near_);
  const RobotId robot{disc.robot};
  for (const std::uint32_t place : near_) {
    const std::uint32_t k = movers_.order()[place];
    const double contact = disc.radius + movers.setup[k].radius, near = contact + disc.offset;
    if (norm_squared(movers.position[k] - position) > near * near) continue;
    const Vec2 center = disc.offset > 0.0 ? disc_center(simulation.setup(robot)) : position;
    const bool touches = disc.is_covered
                             ? touches_disc(simulation.setup(robot), movers, k)
                             : norm(movers.position[k] - center) < contact * (1.0 - kContact);
    if (touches) now_.push_back({disc.robot, movers.id[k].value, row});
  }
  std::sort(now_.begin() + first, now_.end(), is_before);
}

void MoverContacts::observe(const Simulation& simulation, std::span<const Vec2> positions) {
  std::swap(now_, before_);
  now_.clear(), begun_.clear();
  const MovingObstacleView movers = simulation.moving_obstacles();
  if (movers.id.empty()) return;
  double widest = 0.0, largest = 0.0;  // m
  for (const RowDisc& disc : discs_) widest = std::max(widest, disc.radius + disc.offset);
  for (const MovingObstacle& mover : movers.setup) largest = std::max(largest, mover.radius);
  movers_.build(movers.position, widest + largest);
  near_.reserve(movers.id.size());  // later steps allocate nothing
  for (std::size_t row = 0; row < discs_.size(); ++row) {
    if (!discs_[row].parked) meet(simulation, positions[row], row, widest + largest);
  }
  for (const MoverContact& contact : now_) {
    if (!std::binary_search(before_.begin(), before_.end(), contact, is_before))
      begun_.push_back(contact);
  }
  before_.reserve(now_.capacity());  // the next call allocates nothing for the same contacts
}

}  // namespace avo::inline metrics
