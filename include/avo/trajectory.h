// SPDX-License-Identifier: Apache-2.0
// The future places of a mover, where they are known: its plan, or a prediction.
#pragma once
#include <optional>
#include <span>
#include <vector>

#include "avo/export.h"
#include "avo/vec.h"

namespace avo {

/// A place at a time.
struct TimedPlace {
  double time = 0.0;   ///< s, since any moment that is the same for all places of a trajectory
  Vec2 position = {};  ///< m
  friend constexpr bool operator==(const TimedPlace&, const TimedPlace&) = default;
};

/// The future of a mover, see Neighbor::trajectory: straight from place to place, at constant speed
/// on each leg. Before the first place the mover rests there. After the last place it keeps the
/// velocity of its last leg, so it rests if the last two places are one. Or it repeats a part of
/// its trajectory.
class AVO_API Trajectory {
 public:
  Trajectory() = default;  ///< empty: a neighbor with this trajectory is invalid
  /// error: m, >= 0, by which the mover may be off its trajectory at any time. repeats_from: s, the
  /// time of one of the places. After the last place the mover is, at unknown times, at any place
  /// where it was from that time on. A repeating trajectory must last, from the decision on, for
  /// longer than a robot needs to stop. A robot moves beside it only for as long as it lasts.
  /// Throws Error unless there is a place, the times ascend, and all values are finite and in
  /// range.
  explicit Trajectory(std::span<const TimedPlace> places, double error = 0.0,
                      std::optional<double> repeats_from = {});
  /// Sets the trajectory as the constructor does, but allocates only while it grows. Changes
  /// nothing where it throws.
  void assign(std::span<const TimedPlace> places, double error = 0.0,
              std::optional<double> repeats_from = {});

  [[nodiscard]] std::span<const TimedPlace> places() const { return places_; }
  [[nodiscard]] double error() const { return error_; }
  [[nodiscard]] std::optional<double> repeats_from() const { return repeats_from_; }
  /// m: the place at that time (s). For a repeating trajectory it is the last place at all later
  /// times.
  [[nodiscard]] Vec2 at(double time) const;
  /// m/s, on the fastest leg that ends later than that time (s), or that goes on after the last
  /// place.
  [[nodiscard]] double max_speed(double time) const;
  /// m, from the last place to the farthest place of the part that repeats; 0 if no part repeats.
  [[nodiscard]] double round() const { return round_; }

 private:
  std::vector<TimedPlace> places_;
  std::vector<double> speed_;  // m/s, the highest speed from the place before each of them on
  double error_ = 0.0, round_ = 0.0;
  std::optional<double> repeats_from_;
};

}  // namespace avo
