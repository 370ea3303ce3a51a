// SPDX-License-Identifier: Apache-2.0
// What the half-plane kernels share whatever the instruction set, and their scalar instance: the
// reference that all others equal bit for bit.
#pragma once
#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <type_traits>

#include "avo/horizon.h"
#include "core/scalar.h"
#include "obstacles/half_planes.h"

namespace avo {

// Of Newton's iterations; bisection alone would end by then.
constexpr int kMaxIterations = 64;
// Whether a horn's near side is walked along, and through how many crossings: few of them must be.
enum class Look : unsigned char { quickly, closely, thoroughly };
constexpr std::size_t kMostCrossings = 3;
// Of the near side that a walk along it looks at.
constexpr int kMaxPieces = 24;
// `cusp` may change its sign twice within a stride. Not proved, measured: in 10^7 random close
// passes none did unseen where long strides near R, with a `cusp` near 0, are halved (at most as
// many again).
constexpr double kFlat = 0.1;   // of l²
constexpr double kWide = 0.25;  // of the time, and of R
// Of the last two steps' product, relative, which leaves about its square: a use of second order.
template <typename Number>
constexpr double kTimeTolerance = std::is_same_v<Number, double> ? 1e-4 : 3e-4;
// The same where the near side may have cusps near by.
template <typename Number>
constexpr double kCloseTolerance = std::is_same_v<Number, double> ? 1e-8 : 1e-5;
// Relative, of Newton's last step in σ, which leaves about its square.
template <typename Number>
constexpr double kConvexTolerance = std::is_same_v<Number, double> ? 1e-8 : 1e-4;
// Its square does not underflow.
template <typename Number>
constexpr double kTiniest = std::is_same_v<Number, double> ? 1e-150 : 1e-18;
// |sin| of an angle that may be one of rounding.
template <typename Number>
constexpr double kTie = std::is_same_v<Number, double> ? 1e-9 : 1e-6;
// Of r: nearer than this, what is left is of the order of rounding.
template <typename Number>
constexpr double kContact = std::is_same_v<Number, double> ? 1e-9 : 1e-4;
// Of d + |v| τ: what single precision may do to a path. Of that, the least gap and the most reach
// times g(τ) that it is trusted with.
constexpr double kBlur = 0x1p-19, kLeastGap = 32.0, kMostReach = 0x1p29;
// m: nearer centers are left to double precision, for products of lengths become too small.
constexpr double kLeastDistance = 1e-6;
// m/s; slower is at rest.
template <typename Number>
constexpr double kSlowest = std::is_same_v<Number, double> ? 1e-100 : 1e-18;

namespace scalar {
#include "obstacles/half_plane_kernels.h"
}  // namespace scalar

struct HalfPlaneKernels {
  void (*solve_double)(const PairColumns<double>&, const Horizon&, HalfPlaneWorkspace<double>&,
                       PlaneColumns<double>&);
  void (*solve_single)(const PairColumns<float>&, const Horizon&, HalfPlaneWorkspace<float>&,
                       PlaneColumns<float>&);
  void (*relate)(std::span<const PairOwner>, const NeighborColumns&, double, PairColumns<double>&,
                 std::vector<double>&);
  void (*share_out)(std::span<const PairOwner>, std::span<const double>,
                    const PlaneColumns<double>&, SharedPlanes&);
};

}  // namespace avo
