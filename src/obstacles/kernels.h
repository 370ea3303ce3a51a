// SPDX-License-Identifier: Apache-2.0
// The scalar instance of the half-plane's kernels: the reference that all others equal bit for bit.
#pragma once
#include <span>
#include <vector>

#include "obstacles/half_planes_kernel.h"
#include "obstacles/shares_kernel.h"

namespace avo {

struct HalfPlaneKernels {
  void (*solve)(const PairColumns&, const Horizon&, HalfPlaneWorkspace&, PlaneColumns&);
  void (*relate)(const RobotColumns&, const NeighborColumns&, std::span<const std::size_t>, double,
                 PairColumns&, std::vector<double>&);
  void (*share_out)(const RobotColumns&, std::span<const std::size_t>, std::span<const double>,
                    double, std::span<const double>, const PlaneColumns&, SharedPlanes&);
};

}  // namespace avo
