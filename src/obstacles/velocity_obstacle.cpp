// SPDX-License-Identifier: Apache-2.0
// The obstacles as sets: discs, tangents, boundary (paper §III-A, §III-B, appendix).
#include "avo/velocity_obstacle.h"

#include <cmath>

namespace avo {
namespace {

// The change of u = 0 is -base. Obstacles of velocities are centered on the present velocity.
Vec2 base(const Obstacle& obstacle) {
  return obstacle.response.is_acceleration() ? Vec2{} : obstacle.pair.velocity;
}

Vec2 unit(Vec2 a) {
  return a / norm(a);
}

// Points of the arc of `disc` from normal n_0 to normal n_1, both ends left out. The angle between
// them is below a half turn, so that steps along the chord, lengthened to the circle, cover it.
void append_arc(const Disc& disc, Vec2 n_0, Vec2 n_1, int steps, std::vector<Vec2>& arc) {
  for (int k = 1; k < steps; ++k) {
    const double part = static_cast<double>(k) / steps;
    arc.push_back(disc.center + disc.radius * unit((1.0 - part) * n_0 + part * n_1));
  }
}

// The exposed part of the last disc: normals n with n . (p + s(τ) v) >= r, an arc about the
// direction of p + s(τ) v that ends in the two tangent points. None if the last disc lies inside
// the discs just before it.
std::vector<Vec2> last_arc(const Obstacle& obstacle, Vec2 left, Vec2 right, int steps) {
  const double tau = obstacle.time_horizon;
  const Disc last = disc(obstacle, tau);
  const Vec2 middle =
      unit(obstacle.pair.position + obstacle.response.lag(tau) * obstacle.pair.velocity);
  std::vector<Vec2> arc{left};
  append_arc(last, (left - last.center) / last.radius, middle, steps, arc);
  arc.push_back(last.center + last.radius * middle);
  append_arc(last, middle, (right - last.center) / last.radius, steps, arc);
  arc.push_back(right);
  return arc;
}

}  // namespace

Vec2 change(const Obstacle& obstacle, Vec2 u) {
  return u - base(obstacle);
}

// Eq. (9): x(t) = p + t v + g(t) w.
Vec2 relative_position(const Obstacle& obstacle, Vec2 u, double t) {
  return obstacle.pair.position + t * obstacle.pair.velocity +
         obstacle.response.gain(t) * change(obstacle, u);
}

// Eqs. (5), (11), (27), (28): |p + t v + g w| < r is a disc of w about -(p + t v)/g.
Disc disc(const Obstacle& obstacle, double t) {
  const double gain = obstacle.response.gain(t);
  const Vec2 coasting = obstacle.pair.position + t * obstacle.pair.velocity;
  return {base(obstacle) - coasting / gain, obstacle.pair.radius / gain};
}

// Eq. (26).
std::pair<Vec2, Vec2> tangent_points(const Disc& disc) {
  const Vec2 c = disc.center;
  const double rho = disc.radius;
  const double distance = norm(c);
  if (!(distance >= rho)) return {c, c};
  const double length = std::sqrt((distance - rho) * (distance + rho));
  const double scale = length / (distance * distance);
  return {scale * (length * c + rho * perpendicular(c)),
          scale * (length * c - rho * perpendicular(c))};
}

// Eq. (29), with the tangents drawn from where they meet. Deviation: Eq. (26) alone, from the
// origin, gives points inside other discs of the family. Neighboring discs have their common
// tangents through k(t) = c - (ρ/ρ') c' = v - v/g'(t), which is -v/(e^{t/δ} - 1) for proportional
// control and 0 for the velocity obstacle.
Boundary boundary(const Obstacle& obstacle, int samples) {
  Boundary result;
  const Vec2 v = obstacle.pair.velocity;
  for (int k = samples; k >= 1; --k) {
    const double t = obstacle.time_horizon * k / samples;
    const Disc at_t = disc(obstacle, t);
    const Vec2 apex = base(obstacle) - v / obstacle.response.rate(t);
    const Disc seen{at_t.center - apex, at_t.radius};
    // a disc around the apex contains the discs of the next times and has no boundary
    if (!(norm(seen.center) >= seen.radius)) continue;
    const auto [left, right] = tangent_points(seen);
    result.left.push_back(apex + left);
    result.right.push_back(apex + right);
    if (k == samples) {
      result.cap = last_arc(obstacle, result.left.back(), result.right.back(), samples);
    }
  }
  return result;
}

}  // namespace avo
