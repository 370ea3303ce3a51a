// SPDX-License-Identifier: Apache-2.0
// half_planes() for every instruction set: this file is compiled once for each by
// hwy/foreach_target.h, and the fittest is chosen at run time.
#include "obstacles/half_planes.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/kernel_table.h"
#include "obstacles/horn.h"
#include "obstacles/kernels.h"

#ifdef AVO_HIGHWAY
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "obstacles/half_planes.cpp"
#include <hwy/foreach_target.h>
#if HWY_TARGET & AVO_TARGETS
#include "core/lanes.h"

HWY_BEFORE_NAMESPACE();
namespace avo::HWY_NAMESPACE {
#include "obstacles/half_plane_kernels.h"

constexpr HalfPlaneKernels kKernels{solve<Pack<double>, TwoPacks<double>>,
                                    solve<Pack<float>, TwoPacks<float>>, relate<Pack<double>>,
                                    share_out<Pack<double>>};
}  // namespace avo::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
#endif

#if !defined(AVO_HIGHWAY) || HWY_ONCE
namespace avo {
namespace scalar {
constexpr HalfPlaneKernels kKernels{solve<Pack<double>, Pack<double>>,
                                    solve<Pack<float>, Pack<float>>, relate<Pack<double>>,
                                    share_out<Pack<double>>};
}  // namespace scalar
namespace {

constexpr KernelTable<HalfPlaneKernels> kKernels = AVO_KERNEL_TABLE(kKernels);

void solve(const PairColumns<double>& pairs, const Horizon& horizon,
           HalfPlaneWorkspace<double>& work, PlaneColumns<double>& planes) {
  kKernels->solve_double(pairs, horizon, work, planes);
}
void solve(const PairColumns<float>& pairs, const Horizon& horizon, HalfPlaneWorkspace<float>& work,
           PlaneColumns<float>& planes) {
  kKernels->solve_single(pairs, horizon, work, planes);
}

template <typename T>
void grow(std::vector<T>& column, std::size_t size) {
  if (column.size() < size) column.resize(size);
}

// The least float that is not below.
float not_below(double value) {
  const auto rounded = static_cast<float>(value);
  return rounded < value ? std::nextafter(rounded, std::numeric_limits<float>::infinity())
                         : rounded;
}

// A normal narrowed to float turns by half an ulp at most, which moves no w within reach farther.
float offset_of_narrowed(double h, float reach) {
  return std::min(not_below(h + 0x1p-24 * static_cast<double>(reach)), reach);
}

// Equal centers, and what the general search of the horn is for.
void solve_rest(const PairColumns<double>& pairs, const Horizon& horizon,
                HalfPlaneWorkspace<double>& workspace, PlaneColumns<double>& planes) {
  for (std::size_t k = 0; k < workspace.rest_count; ++k) {
    const auto i = static_cast<std::size_t>(workspace.rest[k]);
    const Pair pair{{pairs.p_x[i], pairs.p_y[i]}, {pairs.v_x[i], pairs.v_y[i]}, pairs.radius[i]};
    const bool equal_centers = !(norm(pair.position) > kTiniest<double>);
    const RelativeHalfPlane plane = equal_centers
                                        ? half_plane(pair, pairs.reach[i], horizon)
                                        : searched_half_plane(pair, pairs.reach[i], horizon);
    planes.state[i] = plane.state;
    planes.n_x[i] = plane.plane.normal.x;
    planes.n_y[i] = plane.plane.normal.y;
    const bool none = plane.state == PairState::free || plane.state == PairState::coincident;
    planes.h[i] = none ? -std::numeric_limits<double>::infinity() : plane.plane.offset;
    planes.excess[i] = plane.excess;
  }
}

void solve_rest(const PairColumns<float>& pairs, const Horizon& horizon,
                HalfPlaneWorkspace<float>& workspace, PlaneColumns<float>& planes) {
  LeftToDouble<float>& left = workspace.left;
  left.pairs.count = 0;
  for (std::size_t k = 0; k < workspace.rest_count; ++k) {
    const auto& [pair, reach] = pairs.wide[static_cast<std::size_t>(workspace.rest[k])];
    left.pairs.add(pair.position, pair.velocity, pair.radius, reach);
  }
  half_planes(left.pairs, horizon, left.workspace, left.planes);
  for (std::size_t k = 0; k < workspace.rest_count; ++k) {
    const auto i = static_cast<std::size_t>(workspace.rest[k]);
    planes.state[i] = left.planes.state[k];
    planes.n_x[i] = static_cast<float>(left.planes.n_x[k]);
    planes.n_y[i] = static_cast<float>(left.planes.n_y[k]);
    planes.h[i] = offset_of_narrowed(left.planes.h[k], pairs.reach[i]);
    planes.excess[i] = not_below(left.planes.excess[k]);
  }
}

}  // namespace

template <typename Number>
void PairColumns<Number>::reserve(std::size_t pairs) {
  for (std::vector<Number>* column : {&p_x, &p_y, &v_x, &v_y, &radius, &reach}) {
    grow(*column, pairs + kSparePairs);
  }
  if constexpr (std::is_same_v<Number, float>) grow(wide, pairs);
}

template <typename Number>
void reserve(std::size_t pairs, HalfPlaneWorkspace<Number>& workspace,
             PlaneColumns<Number>& planes) {
  const std::size_t size = pairs + kSparePairs;
  for (auto* column : {&planes.n_x, &planes.n_y, &planes.h, &planes.excess, &workspace.rest}) {
    grow(*column, size);
  }
  for (HalfPlaneQueue<Number>* queue : {&workspace.convex, &workspace.horn}) {
    for (auto* column : {&queue->index, &queue->d, &queue->v_x, &queue->v_y, &queue->radius,
                         &queue->reach, &queue->e_x, &queue->e_y, &queue->side}) {
      grow(*column, size);
    }
  }
  grow(planes.state, size);
  if constexpr (std::is_same_v<Number, float>) {
    workspace.left.pairs.reserve(pairs);
    reserve(pairs, workspace.left.workspace, workspace.left.planes);
  }
}

template <typename Number>
void half_planes(PairColumns<Number>& pairs, const Horizon& horizon,
                 HalfPlaneWorkspace<Number>& workspace, PlaneColumns<Number>& planes) {
  reserve(pairs.p_x.size() - kSparePairs, workspace, planes);
  workspace.cases = {};
  workspace.convex.count = workspace.horn.count = workspace.rest_count = 0;
  solve(pairs, horizon, workspace, planes);
  solve_rest(pairs, horizon, workspace, planes);
}

void relate(std::span<const PairOwner> robots, const NeighborColumns& neighbors,
            double control_time, PairColumns<double>& pairs, std::vector<double>& share) {
  kKernels->relate(robots, neighbors, control_time, pairs, share);
}

void share_out(std::span<const PairOwner> robots, std::span<const double> share,
               const PlaneColumns<double>& relative, SharedPlanes& shared) {
  grow(shared.offset, relative.h.size());
  grow(shared.kept, relative.h.size());
  grow(shared.kept_end, robots.size());
  kKernels->share_out(robots, share, relative, shared);
}

template void reserve(std::size_t, HalfPlaneWorkspace<double>&, PlaneColumns<double>&);
template void reserve(std::size_t, HalfPlaneWorkspace<float>&, PlaneColumns<float>&);
template struct PairColumns<double>;
template struct PairColumns<float>;
template void half_planes(PairColumns<double>&, const Horizon&, HalfPlaneWorkspace<double>&,
                          PlaneColumns<double>&);
template void half_planes(PairColumns<float>&, const Horizon&, HalfPlaneWorkspace<float>&,
                          PlaneColumns<float>&);

}  // namespace avo
#endif
