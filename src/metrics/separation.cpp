// SPDX-License-Identifier: Apache-2.0
// Distance of two bodies in continuous time over one step, by subdivision of Bézier curves.
#include "metrics/separation.h"

#include <algorithm>
#include <limits>

namespace avo {
namespace {

// A piece of the relative path and the fractions of the step that it spans.
struct Piece {
  std::array<Vec2, 4> b;
  double from, to;
};

Vec2 middle(Vec2 a, Vec2 b) {
  return 0.5 * (a + b);
}

std::array<Piece, 2> halves(const Piece& piece) {
  const auto& b = piece.b;
  const Vec2 b01 = middle(b[0], b[1]), b12 = middle(b[1], b[2]), b23 = middle(b[2], b[3]);
  const Vec2 b012 = middle(b01, b12), b123 = middle(b12, b23);
  const Vec2 center = middle(b012, b123);
  const double half = 0.5 * (piece.from + piece.to);
  return {
      {{{b[0], b01, b012, center}, piece.from, half}, {{center, b123, b23, b[3]}, half, piece.to}}};
}

// A curve lies in the hull of its control points, so in any direction none of it is nearer to the
// origin than they are; the direction of its middle makes the bound sharp to second order.
double lower_bound(const Piece& piece) {
  const Vec2 towards = piece.b[0] + piece.b[3];
  const double length = norm(towards);
  if (!(length > 0.0)) return 0.0;
  double least = std::numeric_limits<double>::infinity();
  for (const Vec2 point : piece.b) least = std::min(least, dot(towards, point));
  return least / length;
}

Piece relative_path(const StepPath& a, const StepPath& b) {
  Piece piece{{}, 0.0, 1.0};
  for (std::size_t k = 0; k < 4; ++k) piece.b[k] = a.control[k] - b.control[k];
  return piece;
}

Vec2 point_at(const Piece& piece, double u) {
  const double q = 1.0 - u;
  const auto& b = piece.b;
  return (q * q * q) * b[0] + (3.0 * q * q * u) * b[1] + (3.0 * q * u * u) * b[2] +
         (u * u * u) * b[3];
}

}  // namespace

StepPath hermite_path(Vec2 position, Vec2 velocity, Vec2 next_position, Vec2 next_velocity,
                      double time_step) {
  const double third = time_step / 3.0;
  return {{position, position + third * velocity, next_position - third * next_velocity,
           next_position}};
}

Separation separation(const StepPath& a, const StepPath& b, double cutoff) {
  const Piece whole = relative_path(a, b);
  Separation best{norm(whole.b[0]), 0.0};
  if (norm(whole.b[3]) < best.distance) best = {norm(whole.b[3]), 1.0};
  double size = 0.0;
  for (const Vec2 point : whole.b) size = std::max(size, norm(point));
  const double resolution = 1e-13 * size;

  // depth first, the nearer half first; a halving leaves one piece behind, so 64 are enough
  std::array<Piece, 64> stack;
  std::size_t count = 0;
  stack[count++] = whole;
  while (count > 0) {
    const Piece piece = stack[--count];
    const double bound = lower_bound(piece);
    if (bound >= std::min(best.distance, cutoff) - resolution) continue;
    if (count + 2 > stack.size()) continue;
    const auto [left, right] = halves(piece);
    const double at_half = norm(left.b[3]);
    if (at_half < best.distance) best = {at_half, left.to};
    const bool left_first = lower_bound(left) < lower_bound(right);
    stack[count++] = left_first ? right : left;
    stack[count++] = left_first ? left : right;
  }
  return best;
}

double first_below(const StepPath& a, const StepPath& b, double distance, double fraction) {
  const Piece whole = relative_path(a, b);
  if (norm(whole.b[0]) < distance) return 0.0;
  double low = 0.0, high = fraction;
  for (int i = 0; i < 60; ++i) {
    const double half = 0.5 * (low + high);
    (norm(point_at(whole, half)) < distance ? high : low) = half;
  }
  return high;
}

}  // namespace avo
