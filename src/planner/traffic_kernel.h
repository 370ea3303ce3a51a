// SPDX-License-Identifier: Apache-2.0
// A robot's neighbors, as many at once as Pack has lanes. Included into a namespace that has Pack,
// once per instruction set.

template <typename Real>
Traffic look_around(const Robot& robot, const Neighbors& neighbors, const TrafficLimits& limits) {
  const NeighborColumns& of = *neighbors.columns;
  const Real zero(0.0), one(1.0), per_range(1.0 / limits.range);
  const Real range_squared(limits.range * limits.range), slow_squared(limits.slow * limits.slow);
  const Vec<Real> p = constant<Real>(robot.position), v = constant<Real>(robot.velocity);
  const Vec<Real> way = constant<Real>(robot.preferred_velocity);
  Traffic traffic;
  for (std::size_t k = 0; k < neighbors.count; k += Real::kLanes) {
    const auto load = [at = neighbors.first + k](const std::vector<double>& column) {
      return Real::load(&column[at]);
    };
    const auto counted = lane_numbers<Real>() < Real(static_cast<double>(neighbors.count - k));
    const Vec<Real> towards = Vec<Real>{load(of.x), load(of.y)} - p;
    const Vec<Real> velocity{load(of.v_x), load(of.v_y)};
    const Real squared = dot(towards, towards);
    const auto closing = dot(towards, velocity - v) < zero;
    const auto rests = dot(velocity, velocity) < slow_squared;
    const auto near = (squared < range_squared) & (dot(towards, way) > zero);
    const Real weight = one - per_range * sqrt(squared);
    // one after the other, so that no number of lanes has a say
    alignas(64) double weights[Real::kLanes];
    select(counted & near & (closing | rests), weight, zero).store(weights);
    for (const double each : weights) traffic.ahead += each;

    const Real contact = Real(robot.radius) + load(of.radius);
    const Real reach = contact + Real(kRoom) * contact;
    const auto beside = counted & (squared < reach * reach) & (squared > zero);
    for (std::uint32_t lanes = bits(beside); lanes != 0; lanes &= lanes - 1) {
      const auto lane = static_cast<std::size_t>(std::countr_zero(lanes));
      traffic.push = traffic.push + push_of(robot, neighbors[k + lane]);
    }
  }
  return traffic;
}
