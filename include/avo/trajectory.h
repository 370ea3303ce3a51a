// SPDX-License-Identifier: Apache-2.0
// Where a mover will be, where that is known: its plan, or a prediction of it.
#pragma once
#include <optional>
#include <span>
#include <vector>

#include "avo/export.h"
#include "avo/vec.h"

namespace avo {

/// Where somebody is at a time.
struct TimedPlace {
  double time = 0.0;   ///< s, since any moment that is the same for all places of a trajectory
  Vec2 position = {};  ///< m
  friend constexpr bool operator==(const TimedPlace&, const TimedPlace&) = default;
};

/// The future of a mover, see Neighbor::trajectory: straight from place to place, at constant speed
/// on each leg. Before the first place it rests there. Behind the last one it keeps the velocity of
/// its last leg, and so it rests if the last two places are one; or it goes round.
class AVO_API Trajectory {
 public:
  Trajectory() = default;  ///< of nobody: a neighbor with this one is invalid
  /// error: m, >= 0, by which the mover may be off its trajectory at any time. repeats_from: s, the
  /// time of one of the places: behind the last place the mover is, nobody knows when, at any place
  /// where it was from that time on. A trajectory that goes round lasts, from the decision on, for
  /// longer than a robot needs to stop; and a robot goes on beside it only for as long as it lasts.
  /// Throws Error unless there is a place, the times ascend, and all is finite and in range.
  explicit Trajectory(std::span<const TimedPlace> places, double error = 0.0,
                      std::optional<double> repeats_from = {});
  /// The same as a new one, but for memory: allocates only while it grows. Changes nothing where it
  /// throws.
  void assign(std::span<const TimedPlace> places, double error = 0.0,
              std::optional<double> repeats_from = {});

  [[nodiscard]] std::span<const TimedPlace> places() const { return places_; }
  [[nodiscard]] double error() const { return error_; }
  [[nodiscard]] std::optional<double> repeats_from() const { return repeats_from_; }
  /// Where it is at that time (s), m; of one that goes round, behind the last place, that place.
  [[nodiscard]] Vec2 at(double time) const;
  /// m/s, on the fastest leg that ends later than at that time (s), or goes on behind the last
  /// place.
  [[nodiscard]] double max_speed(double time) const;
  /// m, from the last place to the farthest of those to which it goes round; 0 if it does not.
  [[nodiscard]] double round() const { return round_; }

 private:
  std::vector<TimedPlace> places_;
  std::vector<double> speed_;  // m/s, at most, from the place before each of them on
  double error_ = 0.0, round_ = 0.0;
  std::optional<double> repeats_from_;
};

}  // namespace avo
