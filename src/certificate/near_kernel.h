// SPDX-License-Identifier: Apache-2.0
// Who is near enough to be braked for. Included into a namespace that has Pack, after
// pair_kernel.h, once per instruction set.

/// Of all that was given.
template <typename Real>
void fill(const StepLaw& law, BrakingColumns& own) {
  for (std::size_t i = 0; i < own.count; i += Real::kLanes) {
    const auto load = [i](const std::vector<double>& column) { return Real::load(&column[i]); };
    const auto store = [i](Real value, std::vector<double>& column) { value.store(&column[i]); };
    const Real a_max = load(own.max_acceleration);
    const PackBraking<Real> a = braking_of({load(own.v_x), load(own.v_y)}, a_max, law);
    store(a.profile.speed, own.speed), store(a.profile.decrement, own.decrement);
    store(a.profile.full_steps, own.full_steps);
    store(a.direction.x, own.direction_x), store(a.direction.y, own.direction_y);
    store(a.length, own.length), store(a.reach, own.reach), store(a.intervals, own.intervals);

    const auto is_car = load(own.is_car) > Real(0.0);
    const PackDeviation<Real> deviation = deviation_of(a, is_car, law);
    const auto& [ahead, across, anyhow, fast, slow, most_ahead, most_aside] = deviation;
    store(ahead.start, own.ahead_start), store(ahead.per_distance, own.ahead_slope);
    store(across.start, own.across_start), store(across.per_distance, own.across_slope);
    store(anyhow.start, own.anyhow_start), store(anyhow.per_distance, own.anyhow_slope);
    store(fast.speed, own.fast_speed), store(fast.full_steps, own.fast_steps);
    store(slow.speed, own.slow_speed), store(slow.full_steps, own.slow_steps);
    store(most_ahead, own.most_ahead), store(most_aside, own.most_aside);

    const PackFarBound<Real> bound = far_bound_of({load(own.x), load(own.y)}, load(own.radius),
                                                  a.profile, load(own.max_speed), law);
    store(bound.distance, own.far_distance), store(bound.speed_squared, own.far_speed_squared);
    for (std::size_t k = 0; k < 3; ++k) store(bound.reach[k], own.far_reach[k]);
  }
}

/// Of one robot i and the chosen of its neighbors.
template <typename Real>
AVO_KERNEL void push(const BrakingColumns& a, std::size_t i, const PackNeighbor<Real>& of,
                     Real neighbor, decltype(Real() < Real()) chosen, NearQueue& queue) {
  const std::size_t first = queue.count;
  const auto all = [first](double value, NearQueue::Column& column) {
    Real(value).store(&column[first]);
  };
  all(static_cast<double>(i), queue.robot);
  all(a.x[i], queue.x), all(a.y[i], queue.y), all(a.v_x[i], queue.v_x), all(a.v_y[i], queue.v_y);
  all(a.radius[i], queue.radius), all(a.max_acceleration[i], queue.max_acceleration);
  all(a.full_steps[i], queue.full_steps), all(a.length[i], queue.length);
  all(a.direction_x[i], queue.direction_x), all(a.direction_y[i], queue.direction_y);
  all(a.reach[i], queue.reach), all(a.intervals[i], queue.intervals);
  all(a.most_ahead[i], queue.most_ahead), all(a.most_aside[i], queue.most_aside);
  const auto some = [&](Real value, NearQueue::Column& column) {
    return store_chosen(chosen, value, &column[first]);
  };
  some(of.position.x, queue.other_x), some(of.position.y, queue.other_y);
  some(of.velocity.x, queue.other_v_x), some(of.velocity.y, queue.other_v_y);
  some(of.radius, queue.other_radius), some(of.max_acceleration, queue.other_max_acceleration);
  queue.count += some(neighbor, queue.neighbor);
}

template <typename Real>
AVO_KERNEL NearPair lane_of(const PackPair<Real>& pair, std::size_t lane, double robot,
                            double neighbor) {
  const auto number = [lane](Real value) {
    alignas(64) double lanes[Real::kLanes];
    value.store(lanes);
    return lanes[lane];
  };
  const PackBraking<Real>& b = pair.b;
  return {static_cast<std::uint32_t>(robot),
          static_cast<std::uint32_t>(neighbor),
          {number(pair.p.x), number(pair.p.y)},
          number(pair.contact),
          number(pair.inflated),
          number(pair.error),
          number(pair.share),
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
    const auto is_pair = lane_numbers<Real>() < Real(static_cast<double>(queue.count - i));
    const PackNeighbor<Real> of{
        {load(queue.other_x), load(queue.other_y)},
        {load(queue.other_v_x), load(queue.other_v_y)},
        load(queue.other_radius),
        select(is_pair, load(queue.other_max_acceleration), Real(1.0))};  // a divisor
    const PackSelf<Real> self{{load(queue.x), load(queue.y)},
                              {load(queue.v_x), load(queue.v_y)},
                              load(queue.radius),
                              load(queue.max_acceleration),
                              {{{}, {}, load(queue.full_steps)},
                               {load(queue.direction_x), load(queue.direction_y)},
                               load(queue.length),
                               load(queue.reach),
                               load(queue.intervals)}};
    const PackPair<Real> pair = pair_of(self, of, law);
    const auto apart = pair.distance - (self.braking.reach + pair.b.reach);
    auto chosen = is_pair & !(apart > pair.inflated + pair.error);
    if (exact) {
      chosen = chosen & !refuses_nothing(self, load(queue.most_ahead), load(queue.most_aside), pair,
                                         of, law);
    }
    for (std::uint32_t lanes = bits(chosen); lanes != 0; lanes &= lanes - 1) {
      const auto lane = static_cast<std::size_t>(std::countr_zero(lanes));
      kept.push_back(lane_of(pair, lane, queue.robot[i + lane], queue.neighbor[i + lane]));
    }
  }
  queue.count = 0;
}

/// Neighbors of robot i that are not far go to the queue; returns whether any does not decide.
template <typename Real>
AVO_KERNEL bool look_for(const Neighbors& neighbors, std::size_t i, Whom whom, const StepLaw& law,
                         NearPairs& pairs) {
  const NeighborColumns& columns = *neighbors.columns;
  const BrakingColumns& own = pairs.own;
  const Vec<Real> p{own.x[i], own.y[i]};
  const PackFarBound<Real> bound{own.far_distance[i],
                                 {own.far_reach[0][i], own.far_reach[1][i], own.far_reach[2][i]},
                                 own.far_speed_squared[i]};
  const Real zero(0.0), a_max(own.max_acceleration[i]);
  auto movers = zero < zero;
  for (std::size_t k = 0; k < neighbors.count; k += Real::kLanes) {
    const auto load = [at = neighbors.first + k](const std::vector<double>& column) {
      return Real::load(&column[at]);
    };
    const PackNeighbor<Real> of{{load(columns.x), load(columns.y)},
                                {load(columns.v_x), load(columns.v_y)},
                                load(columns.radius),
                                load(columns.max_acceleration)};
    const auto counted = lane_numbers<Real>() < Real(static_cast<double>(neighbors.count - k));
    const auto decides = load(columns.decides) > zero;
    movers = movers | (counted & !decides);
    if (whom == Whom::movers) continue;
    const auto near = counted & decides & !are_far(bound, a_max, p - of.position, of);
    if (!any(near)) continue;
    push(own, i, of, Real::numbers_from(k), near, pairs.queue);
    if (pairs.queue.count >= NearQueue::kSize) judge<Real>(law, pairs.queue, pairs.kept);
  }
  return any(movers);
}

template <typename Real>
void find_near(std::span<const Sensing> robots, Whom whom, const StepLaw& law, NearPairs& pairs) {
  BrakingColumns& own = pairs.own;
  own.reserve(robots.size());
  own.count = 0;
  for (const Sensing& each : robots) own.add(*each.robot);
  fill<Real>(law, own);
  pairs.kept.clear();
  pairs.queue.count = 0;  // some are left where memory ran out
  pairs.has_movers.resize(robots.size());
  for (std::size_t i = 0; i < robots.size(); ++i) {
    pairs.has_movers[i] = look_for<Real>(robots[i].neighbors, i, whom, law, pairs) ? 1 : 0;
  }
  judge<Real>(law, pairs.queue, pairs.kept);
  pairs.end.resize(robots.size());
  std::size_t end = 0;
  for (std::size_t i = 0; i < robots.size(); ++i) {
    while (end < pairs.kept.size() && pairs.kept[end].robot == i) ++end;
    pairs.end[i] = end;
  }
}
