// SPDX-License-Identifier: Apache-2.0
#include "planner/stages/contact.h"

#include <algorithm>
#include <cmath>

#include "certificate/pair.h"
#include "core/plane.h"
#include "planner/stages/disc_pairs.h"
#include "walls/segment.h"

namespace avo::inline planner {
namespace {

// m, the distance that each needs to stop: the rounding of its velocity acts on it.
double path_length(const Robot& robot, const StepLaw& law) {
  return stopping_length(norm(robot.velocity), decrement_of(robot, law), law);
}

double path_length(const Neighbor& neighbor, const StepLaw& law) {
  if (neighbor.loiter) return 2.0 * neighbor.loiter->radius;
  if (is_predicted(neighbor)) return 0.0;
  return stopping_length(norm(neighbor.velocity), decrement_of(neighbor, law), law);
}

// Takes the bodies in contact, in the order of neighbors and walls.
struct ContactSearch {
  double own_length;
  Contact contact = {};
  double beyond = -kInfinity;  // m, the part of its depth beyond rounding

  // Returns whether no contact of such a depth can be deeper, for any stopping distance of the
  // other body.
  bool is_beaten(double depth, double radii) const {
    return !(depth - feigned_depth(radii, own_length) > beyond);
  }
  void take(int neighbor, int wall, double depth, double radii, double length) {
    const double left = depth - feigned_depth(radii, own_length + length);
    if (!(depth > 0.0) || !(left > beyond)) return;
    contact = {neighbor, wall, depth, left > 0.0};
    beyond = left;
  }
};

// Returns whether discs at rest touch, deeper than the deepest contact so far; for most discs this
// takes little time.
bool is_deeper(const Robot& robot, Vec2 position, double radius, const ContactSearch& search) {
  const double contact = robot.radius + radius, squared = norm_squared(position - robot.position);
  return !(squared > contact * contact) && !search.is_beaten(contact - std::sqrt(squared), contact);
}
bool is_deeper(const Robot& robot, std::span<const Neighbor> neighbors, std::size_t k,
               const ContactSearch& search) {
  return is_deeper(robot, neighbors[k].position, neighbors[k].radius, search);
}
bool is_deeper(const Robot& robot, const Neighbors& neighbors, std::size_t k,
               const ContactSearch& search) {
  const NeighborColumns& columns = *neighbors.columns;
  const std::size_t i = neighbors.first + k;
  return is_deeper(robot, {columns.x[i], columns.y[i]}, columns.radius[i], search);
}

template <typename Neighbors>
Contact find_deepest(const Robot& robot, const Neighbors& neighbors, std::span<const Wall> walls,
                     const StepLaw& law, const Deepest& neighbor, const Deepest& wall) {
  ContactSearch search{path_length(robot, law)};
  const Discs discs = discs_of(robot, law);
  for (std::size_t k = 0; k < neighbors.size(); ++k) {
    const int index = static_cast<int>(k);
    if (index != neighbor.index && !is_deeper(robot, neighbors, k, search)) continue;
    const Neighbor& other = neighbors[k];
    const double hidden = error_against(other, law).position;
    const double radii = robot.radius + other.radius;
    double depth = radii - norm(other.position - robot.position) - hidden;
    if (discs.count > 1 || other.footprint) depth = -nearest_discs(discs, other).gap - hidden;
    if (index == neighbor.index) depth = std::max(depth, neighbor.depth);
    if (depth > 0.0) search.take(index, -1, depth, radii, path_length(other, law));
  }
  for (std::size_t k = 0; k < walls.size(); ++k) {
    const int index = static_cast<int>(k);
    const double radii = robot.radius + walls[k].radius;
    double depth = -kInfinity;
    for (const Robot& disc : discs.all())
      depth = std::max(depth, disc.radius + walls[k].radius - law.localization_error -
                                  distance(disc.position, {walls[k].a, walls[k].b}));
    if (index == wall.index) depth = std::max(depth, wall.depth);
    if (depth > 0.0) search.take(-1, index, depth, radii, 0.0);
  }
  return search.contact;
}

}  // namespace

Contact deepest_contact(const Robot& robot, const Neighbors& neighbors, std::span<const Wall> walls,
                        const StepLaw& law, const Deepest& neighbor, const Deepest& wall) {
  return find_deepest(robot, neighbors, walls, law, neighbor, wall);
}

Contact deepest_contact(const Robot& robot, std::span<const Neighbor> neighbors,
                        std::span<const Wall> walls, const StepLaw& law, const Deepest& neighbor,
                        const Deepest& wall) {
  return find_deepest(robot, neighbors, walls, law, neighbor, wall);
}

double feigned(const Robot& robot, const Wall& wall, const StepLaw& law) {
  return feigned_depth(robot.radius + wall.radius, path_length(robot, law));
}

void tell(const Contact& contact, Plan& plan) {
  if (!contact.is_certain) return;
  plan.status = PlanStatus::overlapping;
  plan.neighbor = contact.neighbor, plan.wall = contact.wall;
  plan.depth = static_cast<float>(contact.depth);
}

int index_in(std::span<const Neighbor> given, const Neighbor& neighbor, int after) {
  const auto same = [&neighbor](const Neighbor& other) {
    return other.position == neighbor.position && other.velocity == neighbor.velocity &&
           other.radius == neighbor.radius;
  };
  const auto found = std::find_if(given.begin() + after + 1, given.end(), same);
  return found == given.end() ? -1 : static_cast<int>(found - given.begin());
}

}  // namespace avo::inline planner
