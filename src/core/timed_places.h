// SPDX-License-Identifier: Apache-2.0
// Places with ascending times, straight in between.
#pragma once
#include <algorithm>
#include <cstddef>
#include <span>

#include "avo/trajectory.h"

namespace avo::inline core {

/// The index of the first of the places from `from` on that is later than that; their number where
/// there is none. It searches near `from` first.
inline std::size_t first_later(std::span<const TimedPlace> places, double time,
                               std::size_t from = 0) {
  const auto later = [](double t, const TimedPlace& place) { return t < place.time; };
  std::size_t step = 1;
  for (; from + step < places.size() && places[from + step].time <= time; step *= 2) from += step;
  const auto begin = places.begin() + static_cast<std::ptrdiff_t>(from);
  const auto end =
      places.begin() + static_cast<std::ptrdiff_t>(std::min(from + step, places.size()));
  return static_cast<std::size_t>(std::upper_bound(begin, end, time, later) - places.begin());
}

/// m/s, from one place to the next.
inline double leg_speed(const TimedPlace& from, const TimedPlace& to) {
  return norm(to.position - from.position) / (to.time - from.time);
}

/// Trajectory::at(), m, where first_later() of its places is known.
inline Vec2 place_on(const Trajectory& trajectory, std::size_t later, double time) {
  const std::span<const TimedPlace> places = trajectory.places();
  const std::size_t count = places.size();
  if (later == 0) return places[0].position;
  if (later == count && (trajectory.repeats_from() || count == 1))
    return places[count - 1].position;
  const std::size_t k = std::min(later, count - 1);
  const TimedPlace &a = places[k - 1], &b = places[k];
  return a.position + ((time - a.time) / (b.time - a.time)) * (b.position - a.position);
}

}  // namespace avo::inline core
