// SPDX-License-Identifier: Apache-2.0
// The half-planes of many pairs at once: half_plane() of avo/half_plane.h, bit for bit where
// Number is double; in single precision sound all the same (docs/single_precision.md).
#pragma once
#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <type_traits>
#include <vector>

#include "avo/half_plane.h"
#include "core/neighbor_columns.h"

namespace avo {

/// Columns have room for so many more entries than there are, which are read but do not count.
inline constexpr std::size_t kSparePairs = 32;

/// Of eight pairs, those whose bits are set free and the others constrained.
inline constexpr auto kFreeOrNot = [] {
  std::array<std::array<PairState, 8>, 256> states{};
  for (std::size_t lanes = 0; lanes < 256; ++lanes) {
    for (std::size_t k = 0; k < 8; ++k) {
      states[lanes][k] = (lanes >> k & 1U) != 0 ? PairState::free : PairState::constrained;
    }
  }
  return states;
}();

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
  void put(std::size_t i, Vec2 p, Vec2 v, double r, double R) {
    p_x[i] = static_cast<Number>(p.x), p_y[i] = static_cast<Number>(p.y);
    v_x[i] = static_cast<Number>(v.x), v_y[i] = static_cast<Number>(v.y);
    radius[i] = static_cast<Number>(r);
    if constexpr (std::is_same_v<Number, float>) {
      // not below, nor 0
      reach[i] = static_cast<float>(std::max(R * (1.0 + 0x1p-23), 0x1p-126));
      wide[i] = {{p, v, r}, R};
    } else {
      reach[i] = R;
    }
  }
  void add(Vec2 p, Vec2 v, double r, double R) { put(count++, p, v, r, R); }
};

/// See RelativeHalfPlane; h is -infinity where there is no half-plane.
template <typename Number>
struct PlaneColumns {
  std::vector<Number> n_x, n_y, h, excess;
  std::vector<PairState> state;
};

/// Pairs that wait for their case, with their frames: read by whole packs.
template <typename Number>
struct HalfPlaneQueue {
  std::size_t count = 0;
  std::vector<Number> index, d, v_x, v_y, radius, reach, e_x, e_y, side;
};

/// How many pairs each case had; in contact or, of single precision, too near it to tell.
struct HalfPlaneCases {
  std::size_t contact = 0, tip = 0, convex = 0, horn = 0, walk = 0, follow = 0, rest = 0;
};

/// What single precision leaves to double: pairs, solved in lanes as well.
template <typename Number>
struct LeftToDouble;

/// Scratch memory.
template <typename Number>
struct HalfPlaneWorkspace {
  HalfPlaneQueue<Number> convex, horn;
  std::size_t rest_count = 0;
  std::vector<Number> rest;  // indices
  HalfPlaneCases cases;      // of the last call
  LeftToDouble<Number> left;
};

template <>
struct LeftToDouble<double> {};
template <>
struct LeftToDouble<float> {
  PairColumns<double> pairs;
  HalfPlaneWorkspace<double> workspace;
  PlaneColumns<double> planes;
};

/// Room for so many pairs.
template <typename Number>
void reserve(std::size_t pairs, HalfPlaneWorkspace<Number>& workspace,
             PlaneColumns<Number>& planes);

/// Fills planes[0 .. pairs.count).
template <typename Number>
void half_planes(PairColumns<Number>& pairs, const Horizon& horizon,
                 HalfPlaneWorkspace<Number>& workspace, PlaneColumns<Number>& planes);

/// Robot A of pairs that follow each other, and what it may choose from.
struct PairOwner {
  Vec2 position, velocity;  ///< [p_A] m, [v_A] m/s
  double radius;            ///< [r_A] m
  double max_acceleration;  ///< [a_max] m/s²
  double velocity_change;   ///< [δ a_max] m/s
  double max_speed;         ///< [v_max] m/s
  double raise;             ///< m/s, most by which its offsets are raised later
  std::size_t neighbor;     ///< of its first pair, among those of all; the others follow
  std::size_t end;          ///< behind its pairs, which begin where those of the robot before end
};

/// Eqs. (2), (3), (20): the pairs of robots with their neighbors, and A's share of each. All
/// neighbors decide. δ in s; columns have room for kSparePairs more.
void relate(std::span<const PairOwner> robots, const NeighborColumns& neighbors,
            double control_time, PairColumns<double>& pairs, std::vector<double>& share);

/// Scratch memory and result of share_out().
struct SharedPlanes {
  std::vector<double> offset;         ///< m/s, of A's half-planes, by pair
  std::vector<double> kept;           ///< pairs whose half-plane can cut, robot by robot
  std::vector<std::size_t> kept_end;  ///< behind those of each robot
  bool exceeding = false;             ///< the excess of some is not 0
};

/// Eq. (17): the relative half-planes of pairs as their robots' own, apportioned by the share of
/// Eq. (20). A half-plane is kept unless one of the robot's limits alone keeps to it. Columns have
/// room for kSparePairs more.
void share_out(std::span<const PairOwner> robots, std::span<const double> share,
               const PlaneColumns<double>& relative, SharedPlanes& shared);

}  // namespace avo
