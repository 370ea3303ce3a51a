// SPDX-License-Identifier: Apache-2.0
// The half-planes of many pairs at once: half_plane() of avo/half_plane.h, bit for bit where
// Number is double; in single precision sound all the same (docs/single_precision.md).
#pragma once
#include <cstddef>
#include <type_traits>
#include <vector>

#include "avo/half_plane.h"

namespace avo {

/// Columns have room for so many more entries than there are, which are read but do not count.
inline constexpr std::size_t kMostLanes = 16;

struct PairInReach {
  Pair pair;
  double reach;  // δ (a_A + a_B), m/s
};

/// Pairs in columns; single precision has what it was narrowed from beside them.
template <typename Number>
struct PairColumns {
  std::size_t count = 0;
  std::vector<Number> p_x, p_y, v_x, v_y, radius, reach;
  std::vector<PairInReach> wide;  // of float only

  /// Room for so many; allocates only while it grows.
  void reserve(std::size_t pairs);
  void add(Vec2 p, Vec2 v, double r, double R) {
    p_x[count] = static_cast<Number>(p.x), p_y[count] = static_cast<Number>(p.y);
    v_x[count] = static_cast<Number>(v.x), v_y[count] = static_cast<Number>(v.y);
    radius[count] = static_cast<Number>(r);
    if constexpr (std::is_same_v<Number, float>) {
      reach[count] = static_cast<float>(R * (1.0 + 0x1p-23));  // not below
      wide[count] = {{p, v, r}, R};
    } else {
      reach[count] = R;
    }
    ++count;
  }
  [[nodiscard]] PairInReach at(std::size_t i) const {
    if constexpr (std::is_same_v<Number, float>) return wide[i];
    return {{{p_x[i], p_y[i]}, {v_x[i], v_y[i]}, radius[i]}, reach[i]};
  }
};

/// See RelativeHalfPlane.
template <typename Number>
struct PlaneColumns {
  std::vector<Number> n_x, n_y, h, excess;
  std::vector<PairState> state;
};

/// Pairs that wait for their case; as Number, since kernels look up by it.
template <typename Number>
struct HalfPlaneQueue {
  std::size_t count = 0;
  std::vector<Number> index;
};

/// How many pairs each case had.
struct HalfPlaneCases {
  std::size_t tip = 0, convex = 0, horn = 0, rest = 0;
};

/// Scratch memory.
template <typename Number>
struct HalfPlaneWorkspace {
  std::vector<Number> d, v_x, v_y, e_x, e_y, side;  // frames
  HalfPlaneQueue<Number> convex, horn, rest;
  HalfPlaneCases cases;  // of the last call
};

/// Fills planes[0 .. pairs.count).
template <typename Number>
void half_planes(PairColumns<Number>& pairs, const Horizon& horizon,
                 HalfPlaneWorkspace<Number>& workspace, PlaneColumns<Number>& planes);

}  // namespace avo
