// SPDX-License-Identifier: Apache-2.0
// Pairs that overlap already: outside the paper, whose guarantee starts from a free pair.
// Included into a namespace that has Pack, once per instruction set.

/// [m/s] What n . w must be for a pair `depth` > 0 deep, n . v = along, over the shortest window T
/// in [Δt, τ] at whose end it can be apart. That takes d(T) = (depth - T along)/g(T), which falls
/// as long as it is positive: the window is Δt where d(Δt) is within reach R, and else that of
/// d = R. More than R: even τ is too short.
template <typename Real>
AVO_KERNEL Real separating(Real depth, Real along, Real R, const Horizon& horizon) {
  const auto demand = [&](const ResponseAt& window) {
    return (depth - Real(window.time) * along) * Real(1.0 / window.gain);
  };
  return min(demand(horizon.step()), max(demand(horizon.end()), R));
}
