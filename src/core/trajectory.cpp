// SPDX-License-Identifier: Apache-2.0
#include "avo/trajectory.h"

#include <algorithm>
#include <cstddef>
#include <string>

#include "core/ranges.h"
#include "core/timed_places.h"

namespace avo {
namespace {

// A number of one of the places, converted to text only where it is refused.
struct OfPlace {
  std::size_t index;
  const char* name;

  explicit operator std::string() const { return "places." + std::to_string(index) + "." + name; }
};

void check_places(std::span<const TimedPlace> places, std::optional<double> repeats_from) {
  if (places.empty()) refuse("places", "none", "one or more");
  bool is_one = !repeats_from;
  for (std::size_t k = 0; k < places.size(); ++k) {
    const auto& [time, position] = places[k];
    require(OfPlace{k, "time"}, time, kAnyValue, "s");
    require(OfPlace{k, "position"}, position, "m");
    if (k > 0 && !(time > places[k - 1].time))
      refuse(std::string(OfPlace{k, "time"}), text(time), "> " + text(places[k - 1].time) + " s");
    is_one = is_one || time == *repeats_from;
  }
  if (!is_one) refuse("repeats_from", text(*repeats_from), "the time of one of the places");
}

}  // namespace

Trajectory::Trajectory(std::span<const TimedPlace> places, double error,
                       std::optional<double> repeats_from) {
  assign(places, error, repeats_from);
}

void Trajectory::assign(std::span<const TimedPlace> places, double error,
                        std::optional<double> repeats_from) {
  check_places(places, repeats_from);
  require("error", error, kNotNegative, "m");
  speed_.reserve(places.size());
  places_.reserve(places.size());
  speed_.resize(places.size());
  places_.assign(places.begin(), places.end());
  error_ = error, repeats_from_ = repeats_from;
  round_ = 0.0;
  double fastest = 0.0;
  for (std::size_t k = places.size(); k-- > 0;) {
    const auto& [time, position] = places[k];
    if (repeats_from && time >= *repeats_from)
      round_ = std::max(round_, norm(position - places.back().position));
    if (k > 0) fastest = std::max(fastest, leg_speed(places[k - 1], places[k]));
    speed_[k] = fastest;
  }
}

double Trajectory::max_speed(double time) const {
  const std::size_t next = first_later(places_, time);
  return speed_[std::min(next, places_.size() - 1)];
}

Vec2 Trajectory::at(double time) const {
  return place_on(*this, first_later(places_, time), time);
}

}  // namespace avo
