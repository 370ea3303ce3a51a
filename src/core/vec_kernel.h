// SPDX-License-Identifier: Apache-2.0
// Plane vectors of packs. Included into a namespace that has Pack, once per instruction set.

template <typename Real>
struct PackVec {
  Real x, y;
  friend AVO_KERNEL PackVec operator+(PackVec a, PackVec b) { return {a.x + b.x, a.y + b.y}; }
  friend AVO_KERNEL PackVec operator-(PackVec a, PackVec b) { return {a.x - b.x, a.y - b.y}; }
  friend AVO_KERNEL PackVec operator*(Real s, PackVec a) { return {s * a.x, s * a.y}; }
  friend AVO_KERNEL PackVec operator/(PackVec a, Real s) { return {a.x / s, a.y / s}; }
  friend AVO_KERNEL Real dot(PackVec a, PackVec b) { return a.x * b.x + a.y * b.y; }
  friend AVO_KERNEL Real norm(PackVec a) { return sqrt(dot(a, a)); }
};

/// Every lane the same.
template <typename Real>
AVO_KERNEL PackVec<Real> constant(Vec2 a) {
  return {Real(a.x), Real(a.y)};
}
