// SPDX-License-Identifier: Apache-2.0
#include "metrics/mover_contacts.h"

#include <algorithm>
#include <tuple>

#include "avo/discs.h"
#include "core/plane.h"
#include "metrics/wall_contacts.h"

namespace avo::inline metrics {
namespace {

bool is_before(const MoverContact& a, const MoverContact& b) {
  return std::tuple(a.robot, a.is_with_robot, a.mover) <
         std::tuple(b.robot, b.is_with_robot, b.mover);
}

// For a robot with a footprint, where it is now.
bool touches_disc(const RobotSetup& robot, Vec2 center, double radius) {
  const std::vector<Disc> discs = discs_at(robot, robot.position, robot.heading);
  return std::any_of(discs.begin(), discs.end(), [&](const Disc& disc) {
    return norm(center - disc.center) < (disc.radius + radius) * (1.0 - kContact);
  });
}

}  // namespace

void MoverContacts::take(const Simulation& simulation, const FleetView& fleet) {
  discs_.clear(), moved_.clear();
  for (std::size_t row = 0; row < fleet.id.size(); ++row) {
    const RobotSetup& setup = fleet.setup[row];
    discs_.push_back({fleet.id[row].value, is_parked(setup), disc_radius(setup),
                      norm(disc_center(setup) - setup.position),
                      footprint_of(setup.model).discs > 0, setup.layers, setup.avoids});
    if (simulation.is_moved(fleet.id[row])) moved_.push_back(row);
  }
}

void MoverContacts::take_movers(const Simulation& simulation, std::span<const Vec2> positions) {
  const MovingObstacleView obstacles = simulation.moving_obstacles();
  movers_.clear();
  centers_.assign(obstacles.position.begin(), obstacles.position.end());
  for (std::size_t k = 0; k < obstacles.id.size(); ++k)
    movers_.push_back({obstacles.id[k].value, false, obstacles.setup[k].radius});
  for (const std::size_t row : moved_) {
    const RowDisc& disc = discs_[row];
    movers_.push_back({disc.robot, true, disc.radius, disc.layers});
    centers_.push_back(positions[row]);  // it has no heading
  }
}

// Meets the movers with centers that are within that reach, m.
void MoverContacts::meet(const Simulation& simulation, Vec2 position, std::size_t row,
                         double reach) {
  const RowDisc& disc = discs_[row];
  const auto first = static_cast<std::ptrdiff_t>(now_.size());
  if (!is_finite(position)) return;
  grid_.list_within(position, reach, near_);
  const RobotId robot{disc.robot};
  for (const std::uint32_t place : near_) {
    const std::uint32_t k = grid_.order()[place];
    const MoverDisc& mover = movers_[k];
    if (mover.is_robot && (mover.id == disc.robot || (mover.layers.bits & disc.avoids.bits) == 0))
      continue;
    const double contact = disc.radius + mover.radius, near = contact + disc.offset;
    if (norm_squared(centers_[k] - position) > near * near) continue;
    const Vec2 center = disc.offset > 0.0 ? disc_center(simulation.setup(robot)) : position;
    const bool touches = disc.is_covered
                             ? touches_disc(simulation.setup(robot), centers_[k], mover.radius)
                             : norm(centers_[k] - center) < contact * (1.0 - kContact);
    if (touches) now_.push_back({disc.robot, mover.is_robot, mover.id, row});
  }
  std::sort(now_.begin() + first, now_.end(), is_before);
}

void MoverContacts::observe(const Simulation& simulation, std::span<const Vec2> positions) {
  std::swap(now_, before_);
  now_.clear(), begun_.clear();
  take_movers(simulation, positions);
  if (movers_.empty()) return;
  double widest = 0.0, largest = 0.0;  // m
  for (const RowDisc& disc : discs_) widest = std::max(widest, disc.radius + disc.offset);
  for (const MoverDisc& mover : movers_) largest = std::max(largest, mover.radius);
  grid_.build(centers_, widest + largest);
  near_.reserve(movers_.size());  // later steps allocate nothing
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
