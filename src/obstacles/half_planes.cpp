// SPDX-License-Identifier: Apache-2.0
// half_planes() for every instruction set; the best one is chosen at run time.
#include "obstacles/half_planes.h"

#include <algorithm>
#include <limits>

#include "obstacles/half_planes_kernel.h"
#include "obstacles/horn.h"

namespace avo::inline obstacles {
struct HalfPlaneKernels {
  void (*solve)(const PairColumns&, const Horizon&, HalfPlaneWorkspace&, PlaneColumns&);
  void (*relate)(const RobotColumns&, const NeighborColumns&, std::span<const std::size_t>, double,
                 PairColumns&, std::vector<double>&);
  void (*reserve_room)(const Reserve&, PairColumns&);
  void (*share_out)(const RobotColumns&, std::span<const std::size_t>, std::span<const double>,
                    double, std::span<const double>, const PlaneColumns&, SharedPlanes&);
};
}  // namespace avo::inline obstacles

#define AVO_KERNEL_HEADER "obstacles/half_planes_kernel.h"
#define AVO_KERNEL_HEADER_2 "obstacles/shares_kernel.h"
#define AVO_KERNEL_STRUCT HalfPlaneKernels
#define AVO_KERNEL_FUNCTIONS                                                       \
  solve<Pack<double>, TwoPacks>, relate<Pack<double>>, reserve_room<Pack<double>>, \
      share_out<Pack<double>>
#include "core/kernel_passes.h"

namespace avo::inline obstacles {
namespace {

// Solves equal centers, and the pairs for the general search of the horn.
void solve_rest(const PairColumns& pairs, const Horizon& horizon, HalfPlaneWorkspace& workspace,
                PlaneColumns& planes) {
  for (std::size_t k = 0; k < workspace.rest.count; ++k) {
    const auto i = static_cast<std::size_t>(workspace.rest.index[k]);
    const Pair pair = pairs[i];
    const bool equal_centers = !(norm(pair.position) > kTiniest);
    planes.set(i, equal_centers ? half_plane(pair, pairs.reach[i], horizon)
                                : searched_half_plane(pair, pairs.reach[i], horizon));
  }
}

}  // namespace

void PlaneColumns::set(std::size_t i, const RelativeHalfPlane& plane) {
  const bool none = plane.state == PairState::free || plane.state == PairState::coincident;
  n_x[i] = plane.plane.normal.x, n_y[i] = plane.plane.normal.y;
  h[i] = none ? -std::numeric_limits<double>::infinity() : plane.plane.offset;
  excess[i] = plane.excess;
  state[i] = plane.state;
}

void PairColumns::reserve(std::size_t pairs) {
  for (std::vector<double>* column : {&p_x, &p_y, &v_x, &v_y, &radius, &reach}) {
    grow(*column, pairs + kSparePairs);
  }
}

void reserve(std::size_t pairs, HalfPlaneWorkspace& workspace, PlaneColumns& planes) {
  const std::size_t size = pairs + kSparePairs;
  if (planes.state.size() >= size) return;  // this column grows last
  for (auto* column : {&planes.n_x, &planes.n_y, &planes.h, &planes.excess, &workspace.convex.index,
                       &workspace.horn.index, &workspace.rest.index})
    grow(*column, size);
  grow(planes.state, size);
}

void half_planes(const PairColumns& pairs, const Horizon& horizon, HalfPlaneWorkspace& workspace,
                 PlaneColumns& planes) {
  reserve(pairs.p_x.size() - kSparePairs, workspace, planes);
  workspace.cases = {};
  workspace.convex.count = workspace.horn.count = workspace.rest.count = 0;
  kKernels->solve(pairs, horizon, workspace, planes);
  solve_rest(pairs, horizon, workspace, planes);
}

void orca_half_planes(const PairColumns& pairs, double time_horizon, double time_step,
                      HalfPlaneWorkspace& workspace, PlaneColumns& planes) {
  reserve(pairs.p_x.size() - kSparePairs, workspace, planes);
  workspace.cases = {};
  for (std::size_t i = 0; i < pairs.count; ++i) {
    const RelativeHalfPlane plane = orca_half_plane(pairs[i], time_horizon, time_step);
    planes.set(i, plane);
    if (plane.state != PairState::constrained) ++workspace.cases.contact;
  }
}

void relate(const RobotColumns& robots, const NeighborColumns& neighbors,
            std::span<const std::size_t> pair_end, double control_time, PairColumns& pairs,
            std::vector<double>& share) {
  kKernels->relate(robots, neighbors, pair_end, control_time, pairs, share);
}

double reserved_radius(const Pair& pair, const Reserve& reserve) {
  using Real = scalar::Pack<double>;
  return scalar::reserved_radius(scalar::constant<Real>(pair.position),
                                 scalar::constant<Real>(pair.velocity), Real(pair.radius), reserve)
      .value;
}

void reserve_room(const Reserve& reserve, PairColumns& pairs) {
  kKernels->reserve_room(reserve, pairs);
}

void share_out(const RobotColumns& robots, std::span<const std::size_t> pair_end,
               std::span<const double> raise, double control_time, std::span<const double> share,
               const PlaneColumns& relative, SharedPlanes& shared) {
  grow(shared.offset, relative.h.size());
  grow(shared.kept, relative.h.size());
  grow(shared.kept_end, robots.count);
  kKernels->share_out(robots, pair_end, raise, control_time, share, relative, shared);
}

}  // namespace avo::inline obstacles
