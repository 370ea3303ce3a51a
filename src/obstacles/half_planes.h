// SPDX-License-Identifier: Apache-2.0
// The half-planes of many pairs at once: half_plane() of avo/half_plane.h, bit for bit.
#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "avo/half_plane.h"
#include "core/robot_columns.h"

namespace avo::inline obstacles {

/// Columns have room for so many extra entries, which are read but do not count.
inline constexpr std::size_t kSparePairs = 16;

template <typename T>
void grow(std::vector<T>& column, std::size_t size) {
  if (column.size() < size) column.resize(size);
}

/// The states of eight pairs: pairs with set bits are free, the others constrained.
inline constexpr auto kFreeOrNot = [] {
  std::array<std::array<PairState, 8>, 256> states{};
  for (std::size_t lanes = 0; lanes < 256; ++lanes) {
    for (std::size_t k = 0; k < 8; ++k) {
      states[lanes][k] = (lanes >> k & 1U) != 0 ? PairState::free : PairState::constrained;
    }
  }
  return states;
}();

/// Pairs in columns.
struct PairColumns {
  std::size_t count = 0;
  std::vector<double> p_x, p_y, v_x, v_y, radius;
  std::vector<double> reach;  // δ (a_A + a_B), m/s

  /// Reserves room for so many; allocates only while it grows.
  void reserve(std::size_t pairs);
  void add(Vec2 p, Vec2 v, double r, double R) {
    p_x[count] = p.x, p_y[count] = p.y;
    v_x[count] = v.x, v_y[count] = v.y;
    radius[count] = r, reach[count] = R;
    ++count;
  }
  Pair operator[](std::size_t i) const { return {{p_x[i], p_y[i]}, {v_x[i], v_y[i]}, radius[i]}; }
};

/// See RelativeHalfPlane; h is -infinity where there is no half-plane.
struct PlaneColumns {
  std::vector<double> n_x, n_y, h, excess;
  std::vector<PairState> state;

  void set(std::size_t i, const RelativeHalfPlane& plane);
};

/// The numbers of pairs that wait for their case; read by whole packs.
struct HalfPlaneQueue {
  std::size_t count = 0;
  std::vector<double> index;
};

/// The number of pairs of each case.
struct HalfPlaneCases {
  std::size_t contact = 0, tip = 0, convex = 0, horn = 0, follow = 0, rest = 0;
  friend bool operator==(const HalfPlaneCases&, const HalfPlaneCases&) = default;
};

/// Scratch memory.
struct HalfPlaneWorkspace {
  HalfPlaneQueue convex, horn, rest;
  HalfPlaneCases cases;  // of the last call
};

/// Reserves room for so many pairs.
void reserve(std::size_t pairs, HalfPlaneWorkspace& workspace, PlaneColumns& planes);

/// Fills planes[0 .. pairs.count).
void half_planes(const PairColumns& pairs, const Horizon& horizon, HalfPlaneWorkspace& workspace,
                 PlaneColumns& planes);

/// The same of orca_half_plane(). Only the cases in contact are counted.
void orca_half_planes(const PairColumns& pairs, double time_horizon, double time_step,
                      HalfPlaneWorkspace& workspace, PlaneColumns& planes);

/// The half-plane of a pair that coincides in place and velocity, and parts along a direction that
/// is not 0.
RelativeHalfPlane parting_half_plane(double radius, Vec2 direction, double reach,
                                     const Horizon& horizon) noexcept;

/// Eqs. (2), (3), (20): the pairs of robots with their neighbors, and A's share of each. The pairs
/// of robot r end at pair_end[r], where those of the next robot begin; they are its first
/// neighbors. All neighbors decide. δ in s; columns must have room for kSparePairs more.
void relate(const RobotColumns& robots, const NeighborColumns& neighbors,
            std::span<const std::size_t> pair_end, double control_time, PairColumns& pairs,
            std::vector<double>& share);

/// The radius of contact with room for noise, q (σ_p + t σ_v), where t is the time until a pair is
/// nearest, τ at most. It is less where there is no room: noise alone brings no pair into contact.
/// docs/half_plane.md, "Noise".
struct Reserve {
  double position, velocity;  ///< [σ_p, σ_v] m, m/s
  double quantile;            ///< [q]
  double horizon;             ///< [τ] s
};
double reserved_radius(const Pair& pair, const Reserve& reserve);
/// Sets the radius of all pairs to reserved_radius().
void reserve_room(const Reserve& reserve, PairColumns& pairs);

/// Scratch memory and result of share_out().
struct SharedPlanes {
  std::vector<double> offset;         ///< m/s, of A's half-planes, by pair
  std::vector<double> kept;           ///< pairs with a half-plane that can cut, robot by robot
  std::vector<std::size_t> kept_end;  ///< one past the pairs of each robot
  bool exceeding = false;             ///< whether some excess is not 0
};

/// Eq. (17): turns the relative half-planes of pairs into their robots' own, apportioned by the
/// share of Eq. (20). A half-plane is left out if one of the robot's limit discs lies inside it,
/// even with its offset raised by raise[r], m/s. Columns must have room for kSparePairs more.
void share_out(const RobotColumns& robots, std::span<const std::size_t> pair_end,
               std::span<const double> raise, double control_time, std::span<const double> share,
               const PlaneColumns& relative, SharedPlanes& shared);

}  // namespace avo::inline obstacles
