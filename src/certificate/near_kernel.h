// SPDX-License-Identifier: Apache-2.0
// Who is near enough to be braked for. Included into a namespace that has Pack, after
// pair_kernel.h, once per instruction set.

/// See FarBound.
template <typename Real>
AVO_KERNEL auto are_far(const FarBound& bound, Vec<Real> p, const PackNeighbor<Real>& of) {
  const Real a_max(bound.max_acceleration), squared = dot(of.velocity, of.velocity);
  const Real reach =
      Real(bound.reach[0]) + Real(bound.reach[1]) * sqrt(squared) + Real(bound.reach[2]) * squared;
  const Real distance = Real(bound.distance) + of.radius + reach;
  return (dot(p, p) > Real(kFarther) * (distance * distance)) &
         (squared <= Real(bound.speed_squared)) & (of.max_acceleration <= a_max) &
         (of.max_acceleration >= a_max);
}

template <typename Real>
AVO_KERNEL void push(const Robot& robot, Real index, const PackNeighbor<Real>& of, Real neighbor,
                     decltype(Real() < Real()) chosen, NearQueue& queue) {
  const std::size_t first = queue.count;
  const auto same = [first](Real value, NearQueue::Column& column) { value.store(&column[first]); };
  same(index, queue.robot);
  same(robot.position.x, queue.x), same(robot.position.y, queue.y);
  same(robot.velocity.x, queue.v_x), same(robot.velocity.y, queue.v_y);
  same(robot.radius, queue.radius), same(robot.max_acceleration, queue.max_acceleration);
  same(robot.car ? 1.0 : 0.0, queue.is_car);
  const auto own = [&](Real value, NearQueue::Column& column) {
    return store_chosen(chosen, value, &column[first]);
  };
  own(of.position.x, queue.other_x), own(of.position.y, queue.other_y);
  own(of.velocity.x, queue.other_v_x), own(of.velocity.y, queue.other_v_y);
  own(of.radius, queue.other_radius), own(of.max_acceleration, queue.other_max_acceleration);
  queue.count += own(neighbor, queue.neighbor);
}

template <typename Real>
AVO_KERNEL BrakingPair lane_of(const PackPair<Real>& pair, std::size_t lane) {
  const auto number = [lane](Real value) {
    alignas(64) double lanes[Real::kLanes];
    value.store(lanes);
    return lanes[lane];
  };
  const PackBraking<Real>& b = pair.b;
  return {{number(pair.p.x), number(pair.p.y)},
          number(pair.contact),
          number(pair.inflated),
          number(pair.error),
          number(pair.share),
          true,
          {},
          {{number(b.profile.speed), number(b.profile.decrement), number(b.profile.full_steps)},
           {number(b.direction.x), number(b.direction.y)},
           number(b.length),
           number(b.reach),
           number(b.intervals)}};
}

/// Keeps those of the queue that may meet A and can refuse a candidate, and empties it.
template <typename Real>
void judge(const StepLaw& law, NearQueue& queue, std::vector<NearPair>& kept) {
  const bool exact = law.sensing_error == SensingError{};
  for (std::size_t i = 0; i < queue.count; i += Real::kLanes) {
    const auto load = [i](const NearQueue::Column& column) { return Real::load(&column[i]); };
    const PackNeighbor<Real> of{{load(queue.other_x), load(queue.other_y)},
                                {load(queue.other_v_x), load(queue.other_v_y)},
                                load(queue.other_radius),
                                load(queue.other_max_acceleration)};
    PackSelf<Real> self{{load(queue.x), load(queue.y)},
                        {load(queue.v_x), load(queue.v_y)},
                        load(queue.radius),
                        load(queue.max_acceleration),
                        {}};
    self.braking = braking_of(self.velocity, self.max_acceleration, law);
    const PackPair<Real> pair = pair_of(self, of, law);
    const auto is_pair = lane_numbers<Real>() < Real(static_cast<double>(queue.count - i));
    const auto apart = pair.distance - (self.braking.reach + pair.b.reach);
    auto chosen = is_pair & !(apart > pair.inflated + pair.error);
    if (exact) {
      const auto is_car = load(queue.is_car) > Real(0.0);
      chosen = chosen & !refuses_nothing(self, deviation_of(self.braking, is_car, law), pair, of, law);
    }
    for (std::uint32_t lanes = bits(chosen); lanes != 0; lanes &= lanes - 1) {
      const auto lane = static_cast<std::size_t>(std::countr_zero(lanes));
      kept.push_back({static_cast<std::uint32_t>(queue.robot[i + lane]),
                      static_cast<std::uint32_t>(queue.neighbor[i + lane]), lane_of(pair, lane)});
    }
  }
  queue.count = 0;
}

/// Neighbors that are not far go to the queue; returns whether any neighbor does not decide.
template <typename Real>
AVO_KERNEL bool look_for(const Sensing& sensing, std::size_t index, Whom whom, const StepLaw& law,
                         NearPairs& pairs) {
  const auto& [robot, neighbors, trusted] = sensing;
  const NeighborColumns& of = *neighbors.columns;
  const FarBound bound = far_bound_of(*robot, law);
  const Real zero(0.0);
  auto movers = zero < zero;
  for (std::size_t k = 0; k < neighbors.count; k += Real::kLanes) {
    const std::size_t at = neighbors.first + k;
    const auto load = [at](const std::vector<double>& column) { return Real::load(&column[at]); };
    const PackNeighbor<Real> pack{{load(of.x), load(of.y)},
                                  {load(of.v_x), load(of.v_y)},
                                  load(of.radius),
                                  load(of.max_acceleration)};
    const auto counted = lane_numbers<Real>() < Real(static_cast<double>(neighbors.count - k));
    const auto decides = pack.max_acceleration > zero;
    movers = movers | (counted & !decides);
    if (whom == Whom::movers) continue;
    const Vec<Real> p = constant<Real>(robot->position) - pack.position;
    const auto near = counted & decides & !are_far(bound, p, pack);
    if (!any(near)) continue;
    push(*robot, Real(static_cast<double>(index)), pack,
         Real(static_cast<double>(k)) + lane_numbers<Real>(), near, pairs.queue);
    if (pairs.queue.count >= NearQueue::kSize) judge<Real>(law, pairs.queue, pairs.kept);
  }
  return any(movers);
}

template <typename Real>
void find_near(std::span<const Sensing> robots, Whom whom, const StepLaw& law, NearPairs& pairs) {
  pairs.kept.clear();
  pairs.has_movers.resize(robots.size());
  for (std::size_t i = 0; i < robots.size(); ++i) {
    pairs.has_movers[i] = look_for<Real>(robots[i], i, whom, law, pairs) ? 1 : 0;
  }
  judge<Real>(law, pairs.queue, pairs.kept);
  pairs.end.resize(robots.size());
  std::size_t end = 0;
  for (std::size_t i = 0; i < robots.size(); ++i) {
    while (end < pairs.kept.size() && pairs.kept[end].robot == i) ++end;
    pairs.end[i] = end;
  }
}
