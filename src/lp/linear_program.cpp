// SPDX-License-Identifier: Apache-2.0
// Eqs. (22), (23) for one robot: a group of one lane, scaled where its numbers are not ordinary.
#include "lp/linear_program.h"

#include <algorithm>
#include <cmath>

#include "lp/lens.h"
#include "lp/program_kernel.h"

namespace avo::inline lp {
namespace {

using Real = scalar::Pack<double>;

// A point farther away than kFarthest has the same nearest points as the point at that distance.
Vec2 within_farthest(Vec2 u, double scale) {
  const double size = std::max(std::abs(u.x), std::abs(u.y)), limit = kFarthest / scale;
  return size > limit ? (limit / size) * u : u;
}

void fill(ProgramGroup<1>& group, const Disc& acceleration, double top_speed, Vec2 preferred,
          double scale) {
  *group.c_x = scale * acceleration.center.x, *group.c_y = scale * acceleration.center.y;
  *group.radius = scale * acceleration.radius, *group.top_speed = scale * top_speed;
  const Vec2 wish = scale * within_farthest(preferred, scale);
  *group.p_x = wish.x, *group.p_y = wish.y;
}

ProgramResult nearest_to_speed_disc(const Disc& acceleration, double top_speed) {
  const Lens lens = make_lens(acceleration, top_speed);
  const Vec2 towards = plain(lens.scaled.larger_center / lens.scaled.distance);
  ProgramResult result;
  result.point = acceleration.center +
                 acceleration.radius * (lens.scaled.speed_is_larger.bit ? towards : -towards);
  result.violation = norm(lens.scale * result.point) / lens.scale - top_speed;
  result.state = ProgramState::discs_disjoint;
  return result;
}

// The largest violation of the half-planes as given. It is positive even where scaling the point
// back has made it 0, among denormal numbers.
double violation_at(std::span<const HalfPlane> planes, Vec2 u, double scaled_back) {
  double largest = 0.0;
  for (const HalfPlane& plane : planes) largest = std::max(largest, violation(plane, u));
  return largest > 0.0 ? largest : scaled_back;
}

}  // namespace

ProgramResult nearest_point(std::span<const HalfPlane> planes, const Disc& acceleration,
                            double top_speed, Vec2 preferred, ProgramRows& scratch) {
  const double scale = safe_scale(acceleration, top_speed);
  const std::size_t count = planes.size();
  if (scratch.size() < program_rows(count)) scratch.resize(program_rows(count));
  ProgramGroup<1> group{};
  fill(group, acceleration, top_speed, preferred, scale);
  *group.planes = static_cast<double>(count);
  group.count = count;
  for (std::size_t i = 0; i < count; ++i) {
    ProgramRow<1>& row = scratch[i];
    *row.n_x = planes[i].normal.x, *row.n_y = planes[i].normal.y;
    *row.offset = scale * planes[i].offset;
  }
  scalar::planar::solve_pack<Real>(group, scratch.data(), scratch.data() + count, 0, 1);
  if (group.settled == 0) return nearest_to_speed_disc(acceleration, top_speed);
  ProgramResult result;
  result.point = group.moved != 0 ? Vec2{*group.x, *group.y} / scale : preferred;
  result.violation = *group.violation;
  if (result.violation > 0.0) {
    result.state = ProgramState::least_unsafe;
    if (scale != 1.0) {
      result.violation = violation_at(planes, result.point, result.violation / scale);
    }
  }
  return result;
}

}  // namespace avo::inline lp
