// SPDX-License-Identifier: Apache-2.0
// The half-planes of many pairs at once: half_plane() of avo/half_plane.h, bit for bit where
// Number is double; in single precision sound all the same (docs/performance.md).
#pragma once
#include <cstddef>
#include <vector>

#include "avo/half_plane.h"

namespace avo {

/// Columns have room for so many more entries than there are, which are read but do not count.
inline constexpr std::size_t kSparePairs = 32;

/// Pairs in columns: see Pair, and reach = δ (a_A + a_B), m/s.
template <typename Number>
struct PairColumns {
  std::size_t count = 0;
  std::vector<Number> p_x, p_y, v_x, v_y, radius, reach;

  /// Room for so many; allocates only while it grows.
  void reserve(std::size_t pairs);
  void add(Vec2 p, Vec2 v, double r, double R) {
    p_x[count] = static_cast<Number>(p.x), p_y[count] = static_cast<Number>(p.y);
    v_x[count] = static_cast<Number>(v.x), v_y[count] = static_cast<Number>(v.y);
    radius[count] = static_cast<Number>(r), reach[count] = static_cast<Number>(R);
    ++count;
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
  std::size_t tip = 0, convex = 0, horn = 0, walk = 0, rest = 0;
};

/// Scratch memory.
template <typename Number>
struct HalfPlaneWorkspace {
  std::vector<Number> d, v_x, v_y, e_x, e_y, side;  // frames
  HalfPlaneQueue<Number> convex, horn, walk, rest;
  HalfPlaneCases cases;  // of the last call
};

/// Fills planes[0 .. pairs.count).
template <typename Number>
void half_planes(PairColumns<Number>& pairs, const Horizon& horizon,
                 HalfPlaneWorkspace<Number>& workspace, PlaneColumns<Number>& planes);

}  // namespace avo
