// SPDX-License-Identifier: Apache-2.0
#include "check/space_hits.h"

#include <algorithm>
#include <iterator>
#include <tuple>

#include "check/counts.h"

namespace avo::judge {
namespace {

constexpr Stick kPoint{};
constexpr int kHalvings = 14;  // of a step

// m/s: a bound of the speed on a piece that lasts so long.
double fastest(const Cubic& path, double duration) {
  double most = 0.0;
  for (std::size_t i = 1; i < path.size(); ++i) most = std::max(most, norm(path[i] - path[i - 1]));
  return 3.0 * most / duration;
}

// Whether the robot moves at some instant of the contact: an instant of it is proof.
bool moves_in_contact(const SpaceEncounter& encounter, const Cubic& path, const Cubic& relative,
                      double duration, int halvings) {
  if (!(fastest(path, duration) > encounter.at_rest)) return false;
  if (!(least_distance(relative, kPoint, encounter.contact) < encounter.contact)) return false;
  const Halves own = halved(path), between = halved(relative);
  const Vec3 velocity = (3.0 / (0.5 * duration)) * (own.second[1] - own.second[0]);
  if (norm(between.second[0]) < encounter.contact && norm(velocity) > encounter.at_rest)
    return true;
  if (halvings == 0) return false;
  const double half = 0.5 * duration;
  return moves_in_contact(encounter, own.first, between.first, half, halvings - 1) ||
         moves_in_contact(encounter, own.second, between.second, half, halvings - 1);
}

}  // namespace

void SpaceHits::meet(const SpaceEncounter& encounter, const Cubic& path, const Cubic& relative) {
  const double nearest = least_distance(relative, kPoint, encounter.contact);
  if (!(nearest < encounter.contact)) return;
  const auto [robot, other, start, duration, contact, at_rest] = encounter;
  CheckedHit& hit =
      hits_.try_emplace(std::pair{robot, other}, CheckedHit{start, robot, other}).first->second;
  const double depth = contact - nearest;
  hit.depth = std::max(hit.depth, depth);
  if (!moves_in_contact(encounter, path, relative, duration, kHalvings)) return;
  if (!hit.moved) ++in_motion_.count;
  hit.moved = true;
  note(in_motion_, {start, robot, other, depth});
}

void SpaceHits::write(CheckReport& report) const {
  report.mover_contacts_moving = in_motion_;
  report.mover_contacts_at_rest = std::ssize(hits_) - in_motion_.count;
  report.mover_hits = listed(hits_);
}

}  // namespace avo::judge
