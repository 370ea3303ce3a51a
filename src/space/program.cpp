// SPDX-License-Identifier: Apache-2.0
// One algorithm for every dimension. It starts at the best point of the balls. The half-space that
// the point violates most becomes an equation. The best point of that plane, within those that were
// taken before, is the same program in one dimension less. In one dimension less than two it is one
// number, which fits or does not.
#include "space/program.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

#include "space/kernels.h"

namespace avo::space {
namespace {

// m/s for velocities: a half-space that is violated by less counts as kept.
constexpr double kTolerance = 1e-10;
// Sine of the angle of two normals below which they are parallel as far as rounding tells.
constexpr double kParallelNormals = 1e-9;

template <std::size_t K>
using Point = std::array<double, K>;
template <std::size_t K>
using Plane = typename ProgramLevel<K>::Plane;

template <std::size_t K>
double dot(const std::array<double, K>& a, const std::array<double, K>& b) {
  double sum = 0.0;
  for (std::size_t i = 0; i < K; ++i) sum += a[i] * b[i];
  return sum;
}
/// a + s b
template <std::size_t K>
std::array<double, K> moved(std::array<double, K> a, double s, const std::array<double, K>& b) {
  for (std::size_t i = 0; i < K; ++i) a[i] += s * b[i];
  return a;
}
template <std::size_t K>
double norm(const std::array<double, K>& a) {
  return std::sqrt(dot(a, a));
}
Point<3> point_of(Vec3 a) {
  return {a.x, a.y, a.z};
}

template <std::size_t K>
struct Sphere {
  Point<K> center;
  double radius;
};

/// What is wanted: the point nearest to `wish`, or the farthest one along `direction`.
template <std::size_t K>
struct Objective {
  bool is_linear = false;
  Point<K> wish{}, direction{};
};

template <std::size_t K>
bool is_in(const Sphere<K>& ball, const Point<K>& a) {
  return norm(moved(a, -1.0, ball.center)) <= ball.radius + kTolerance;
}

// The point of one ball that is best.
template <std::size_t K>
Point<K> best_of(const Sphere<K>& ball, const Objective<K>& objective) {
  if (objective.is_linear) {
    const double length = norm(objective.direction);
    return moved(ball.center, ball.radius / length, objective.direction);
  }
  const Point<K> way = moved(objective.wish, -1.0, ball.center);
  const double length = norm(way);
  return length <= ball.radius ? objective.wish : moved(ball.center, ball.radius / length, way);
}

// The best point of the sphere in which both spheres meet.
template <std::size_t K>
Point<K> best_of_meeting(const std::array<Sphere<K>, 2>& balls, const Objective<K>& objective) {
  Point<K> axis = moved(balls[1].center, -1.0, balls[0].center);
  const double length = norm(axis), r0 = balls[0].radius, r1 = balls[1].radius;
  for (double& x : axis) x /= length;
  const double foot = (length * length + r0 * r0 - r1 * r1) / (2.0 * length);
  const double radius = std::sqrt(std::max((r0 - foot) * (r0 + foot), 0.0));
  const Point<K> center = moved(balls[0].center, foot, axis);
  Point<K> side = objective.is_linear ? objective.direction : moved(objective.wish, -1.0, center);
  side = moved(side, -dot(side, axis), axis);
  const double off = norm(side);
  return off > 0.0 ? moved(center, radius / off, side) : center;
}

// The best point of both balls; false where they do not meet.
template <std::size_t K>
bool best_in_balls(const std::array<Sphere<K>, 2>& balls, Objective<K> objective, Point<K>& best) {
  if (objective.is_linear && !(norm(objective.direction) > kTolerance)) objective.is_linear = false;
  for (std::size_t k = 0; k < 2; ++k) {
    best = best_of(balls[k], objective);
    if (is_in(balls[1 - k], best)) return true;
  }
  const double length = norm(moved(balls[1].center, -1.0, balls[0].center));
  if (!(length <= balls[0].radius + balls[1].radius + kTolerance) || !(length > 0.0)) return false;
  best = best_of_meeting(balls, objective);
  return true;
}

/// A plane of R^K as R^(K-1): its unit normal, its place along the normal, and a basis. The basis
/// is that of a reflection which takes the largest axis to the normal.
template <std::size_t K>
struct Flat {
  Point<K> normal;
  double offset;
  std::array<Point<K>, K - 1> basis;

  explicit Flat(const Plane<K>& plane) : normal(plane.normal), offset(plane.offset) {
    std::size_t largest = 0;
    for (std::size_t i = 1; i < K; ++i) {
      if (std::abs(normal[i]) > std::abs(normal[largest])) largest = i;
    }
    Point<K> mirror = normal;
    mirror[largest] += normal[largest] >= 0.0 ? 1.0 : -1.0;
    const double per_squared = 1.0 / dot(mirror, mirror);
    for (std::size_t i = 0, k = 0; i < K; ++i) {
      if (i == largest) continue;
      Point<K> axis{};
      axis[i] = 1.0;
      basis[k++] = moved(axis, -2.0 * mirror[i] * per_squared, mirror);
    }
  }
  Point<K - 1> down(const Point<K>& a) const {
    Point<K - 1> result;
    for (std::size_t k = 0; k < K - 1; ++k) result[k] = dot(a, basis[k]);
    return result;
  }
  Point<K> up(const Point<K - 1>& a) const {
    // the basis first: turning the axes about each other changes no bit
    Point<K> result{};
    for (std::size_t k = 0; k < K - 1; ++k) result = moved(result, a[k], basis[k]);
    return moved(result, offset, normal);
  }
};

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

void HalfSpaceColumns::reserve(std::size_t half_spaces) {
  const std::size_t size = half_spaces + kSpare;
  if (violation.size() >= size) return;  // this column grows last
  for (Column& column : normal) column.resize(size);
  for (Column* column : {&offset, &number, &violation}) column->resize(size);
}

void HalfSpaceColumns::add(const HalfSpace& half_space, double its_number) {
  const auto& [x, y, z] = half_space.normal;
  normal[0][count] = x, normal[1][count] = y, normal[2][count] = z;
  offset[count] = half_space.offset, number[count] = its_number;
  ++count;
}

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
