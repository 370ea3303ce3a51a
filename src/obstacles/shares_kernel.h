// SPDX-License-Identifier: Apache-2.0
// Eqs. (17)-(20) for many robots. Included after half_planes_kernel.h, once per instruction set.

/// {A's plane is n . v' >= n . v_A + α h}; kept unless D(0, v_max) or D(v_A, δ a_max) by itself
/// keeps to it.
template <typename Real>
void share_out(std::span<const OwnLimits> robots, std::span<const double> share,
               const PlaneColumns<double>& relative, SharedPlanes& shared) {
  shared.kept.clear();
  std::size_t first = 0;
  for (const OwnLimits& own : robots) {
    const Real v_x = own.velocity.x, v_y = own.velocity.y, change = own.velocity_change;
    const Real slowest = -own.max_speed, raise = own.raise;
    for (std::size_t i = first; i < own.end; i += Real::kLanes) {
      const Real along = Real::load(&relative.n_x[i]) * v_x + Real::load(&relative.n_y[i]) * v_y;
      const Real offset = along + Real::load(&share[i]) * Real::load(&relative.h[i]);
      offset.store(&shared.offset[i]);
      const auto cuts = (offset + raise > max(slowest, along - change)) |
                        (Real::load(&relative.excess[i]) > Real(0.0));
      std::uint32_t lanes = bits(cuts);
      if (own.end - i < Real::kLanes) lanes &= (1U << (own.end - i)) - 1U;
      for (; lanes != 0; lanes &= lanes - 1) {
        shared.kept.push_back(
            static_cast<std::uint32_t>(i + static_cast<std::size_t>(std::countr_zero(lanes))));
      }
    }
    first = own.end;
    shared.kept_end.push_back(shared.kept.size());
  }
}
