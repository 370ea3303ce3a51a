// SPDX-License-Identifier: Apache-2.0
// One algorithm for every dimension. It starts at the best point of the balls. The half-space that
// the point violates most becomes an equation. The best point of that plane, within those that were
// taken before, is the same program in one dimension less. In one dimension less than two it is one
// number, which fits or does not.
#include "space/program.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "space/kernels.h"
#include "space/program_geometry.h"

namespace avo::space {
namespace {

using namespace geometry;

template <std::size_t K, typename Planes>
bool solve(const std::array<Sphere<K>, 2>& balls, const Objective<K>& objective, Planes& planes,
           ProgramLevel<K>& level, Point<K>& best, std::size_t& failed);

// The best point on the boundary of `on` within the half-spaces that were taken; false: none.
template <std::size_t K>
bool solve_on(const std::array<Sphere<K>, 2>& balls, const Plane<K>& on,
              const Objective<K>& objective, ProgramLevel<K>& level, Point<K>& best) {
  if constexpr (K == 1) {
    best = {on.offset / on.normal[0]};
    for (const Sphere<1>& ball : balls) {
      if (!is_in(ball, best)) return false;
    }
    return std::none_of(level.taken.begin(), level.taken.end(), [&](const Plane<1>& plane) {
      return plane.normal[0] * best[0] < plane.offset - kTolerance;
    });
  } else {
    const Flat<K> flat(on);
    std::array<Sphere<K - 1>, 2> below;
    for (std::size_t k = 0; k < 2; ++k) {
      const double away = on.offset - dot(on.normal, balls[k].center);
      if (std::abs(away) > balls[k].radius + kTolerance) return false;
      const double squared = (balls[k].radius - away) * (balls[k].radius + away);
      below[k] = {flat.down(balls[k].center), std::sqrt(std::max(squared, 0.0))};
    }
    std::vector<Plane<K - 1>>& planes = level.below.planes;
    planes.clear();
    for (const Plane<K>& plane : level.taken) {
      Plane<K - 1> cut{flat.down(plane.normal),
                       plane.offset - on.offset * dot(plane.normal, on.normal)};
      const double length = norm(cut.normal);
      if (length < kParallelNormals) {
        if (cut.offset > kTolerance) return false;
        continue;
      }
      for (double& x : cut.normal) x /= length;
      cut.offset /= length;
      planes.push_back(cut);
    }
    Point<K - 1> point{};
    std::size_t failed = 0;
    const Objective<K - 1> wanted{objective.is_linear, flat.down(objective.wish),
                                  flat.down(objective.direction)};
    if (!solve<K - 1>(below, wanted, planes, level.below, point, failed)) return false;
    best = flat.up(point);
    return true;
  }
}

template <std::size_t K>
bool is_taken(const std::vector<Plane<K>>& taken, const Plane<K>& plane) {
  return std::any_of(taken.begin(), taken.end(), [&](const Plane<K>& other) {
    return other.normal == plane.normal && other.offset == plane.offset;
  });
}

std::size_t size_of(const HalfSpaceColumns& planes) {
  return planes.count;
}
Plane<3> plane_at(const HalfSpaceColumns& planes, std::size_t k) {
  return {{planes.normal[0][k], planes.normal[1][k], planes.normal[2][k]}, planes.offset[k]};
}
template <typename Plane>
std::size_t size_of(const std::vector<Plane>& planes) {
  return planes.size();
}
template <typename Plane>
const Plane& plane_at(const std::vector<Plane>& planes, std::size_t k) {
  return planes[k];
}

// The index of the half-space that the point violates most, by more than `by`; else their number.
template <typename Plane, std::size_t K>
std::size_t most_violated(const std::vector<Plane>& planes, const Point<K>& point, double by) {
  std::size_t worst = planes.size();
  for (std::size_t k = 0; k < planes.size(); ++k) {
    const double violation = planes[k].offset - dot(planes[k].normal, point);
    if (violation > by) by = violation, worst = k;
  }
  return worst;
}
std::size_t most_violated(HalfSpaceColumns& planes, const Point<3>& point, double by) {
  const double most = kernels().find_violations({point[0], point[1], point[2]}, planes);
  if (!(most > by)) return planes.count;
  std::size_t worst = planes.count;
  for (std::size_t k = 0; k < planes.count; ++k) {
    if (planes.violation[k] == most &&
        (worst == planes.count || planes.number[k] < planes.number[worst]))
      worst = k;
  }
  return worst;
}

// Solves for these half-spaces. `failed`: the half-space that leaves nothing, or the number of
// half-spaces where the balls do not meet.
template <std::size_t K, typename Planes>
bool solve(const std::array<Sphere<K>, 2>& balls, const Objective<K>& objective, Planes& planes,
           ProgramLevel<K>& level, Point<K>& best, std::size_t& failed) {
  level.taken.clear();
  failed = size_of(planes);
  if (!best_in_balls<K>(balls, objective, best)) return false;
  for (;;) {
    const std::size_t worst = most_violated(planes, best, kTolerance);
    if (worst == size_of(planes)) return true;
    const Plane<K> plane = plane_at(planes, worst);
    // a half-space that was taken is violated by rounding alone
    if (is_taken<K>(level.taken, plane)) return true;
    if (!solve_on<K>(balls, plane, objective, level, best)) {
      failed = worst;
      return false;
    }
    level.taken.push_back(plane);
  }
}

// Lifts the smallest violation from half-space to half-space: the dual of the program in R^4. The
// half-space `next` leaves nothing beside `unsafe`. The points that violate those no more than
// `next` are half-spaces as well, and of them the farthest along the normal of `next` is sought.
void find_least_unsafe(const std::array<Sphere<3>, 2>& balls, const Point<3>& wish,
                       std::size_t failed, HalfSpaceColumns& all, SpaceProgramWorkspace& workspace,
                       Point<3>& best) {
  ProgramLevel<3>& level = workspace.level;
  std::vector<Plane<3>>& unsafe = workspace.unsafe;
  unsafe = level.taken;
  Plane<3> next = plane_at(all, failed);
  for (;;) {
    HalfSpaceColumns& no_worse = level.planes;
    no_worse.count = 0;
    no_worse.reserve(unsafe.size());
    for (const Plane<3>& plane : unsafe) {
      Point<3> normal = moved(plane.normal, -1.0, next.normal);
      const double length = norm(normal);
      if (length < kParallelNormals) continue;
      for (double& x : normal) x /= length;
      no_worse.add({{normal[0], normal[1], normal[2]}, (plane.offset - next.offset) / length},
                   static_cast<double>(no_worse.count));
    }
    Point<3> point{};
    std::size_t left = 0;
    if (solve<3>(balls, {true, wish, next.normal}, no_worse, level, point, left)) best = point;
    unsafe.push_back(next);
    const double least = next.offset - dot(next.normal, best);
    const std::size_t worst = most_violated(all, best, std::max(least, 0.0) + kTolerance);
    if (worst == all.count) break;
    next = plane_at(all, worst);
    if (is_taken<3>(unsafe, next)) break;
  }
}

}  // namespace

SpaceProgramResult nearest_point(HalfSpaceColumns& half_spaces, const std::array<Ball, 2>& balls,
                                 Vec3 wish, SpaceProgramWorkspace& workspace) {
  ProgramLevel<3>& level = workspace.level;
  half_spaces.reserve(half_spaces.count);
  const std::array<Sphere<3>, 2> spheres{Sphere<3>{point_of(balls[0].center), balls[0].radius},
                                         Sphere<3>{point_of(balls[1].center), balls[1].radius}};
  Point<3> best{};
  std::size_t failed = 0;
  SpaceProgramResult result;
  if (!solve<3>(spheres, {false, point_of(wish), {}}, half_spaces, level, best, failed)) {
    if (failed == half_spaces.count) {
      result.state = SpaceProgramState::balls_disjoint;
      return result;
    }
    find_least_unsafe(spheres, point_of(wish), failed, half_spaces, workspace, best);
    result.state = SpaceProgramState::least_unsafe;
  }
  result.point = {best[0], best[1], best[2]};
  if (result.state == SpaceProgramState::least_unsafe)
    result.violation = std::max(0.0, kernels().find_violations(result.point, half_spaces));
  return result;
}

SpaceProgramResult nearest_point(std::span<const HalfSpace> half_spaces,
                                 const std::array<Ball, 2>& balls, Vec3 wish,
                                 SpaceProgramWorkspace& workspace) {
  HalfSpaceColumns& columns = workspace.columns;
  columns.count = 0;
  columns.reserve(half_spaces.size());
  for (const HalfSpace& half_space : half_spaces)
    columns.add(half_space, static_cast<double>(columns.count));
  return nearest_point(columns, balls, wish, workspace);
}

}  // namespace avo::space
