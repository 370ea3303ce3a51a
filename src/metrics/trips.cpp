// SPDX-License-Identifier: Apache-2.0
#include "metrics/trips.h"

#include <algorithm>
#include <cmath>

#include "core/plane.h"
#include "metrics/ideal_time.h"

namespace avo::inline metrics {
namespace {

// Begins the trip at the place of the robot with that index into the fleet.
void begin(Trip& trip, const Simulation& simulation, const FleetView& fleet, std::size_t i,
           double usual_distance) {
  const RobotSetup& setup = fleet.setup[i];
  const Simulation::Route route = simulation.route(fleet.id[i]);
  const Vec2 position = fleet.position[i], ahead = route.next - position;
  const double distance = norm(ahead), a = setup.max_acceleration;
  trip.robot = fleet.id[i].value;
  trip.parked = is_parked(setup);
  trip.begin = trip.end = simulation.time();
  trip.goal = fleet.goal[i];
  trip.preferred_speed = setup.preferred_speed;
  trip.route_length = trip.route_left = trip.progress = route.length;
  trip.ideal_time =
      ideal_time({.distance = route.length,
                  .margin = setup.arrival_distance.value_or(usual_distance),
                  .speed = distance > 0.0 ? dot(fleet.velocity[i], ahead) / distance : 0.0,
                  .top_speed = std::min(setup.preferred_speed, setup.max_speed),
                  .acceleration = a,
                  .stops = can_rest(setup.model)});
  trip.acceleration_limit = acceleration_limit(setup.model, a);
  trip.position = position;
  trip.velocity = fleet.velocity[i];
}

}  // namespace

Trips::Trips(const Scenario& scenario, std::span<const RobotId> judged)
    : step_(scenario.time_step), arrival_distance_(scenario.arrival_distance) {
  for (const RobotId robot : judged) judged_.push_back(robot.value);
  std::sort(judged_.begin(), judged_.end());
}

bool Trips::is_judged(std::uint64_t robot) const {
  return judged_.empty() || std::binary_search(judged_.begin(), judged_.end(), robot);
}

bool Trips::all_arrived() const {
  if (judged_.empty()) return arrived_ == trips_.size();
  return std::all_of(judged_.begin(), judged_.end(),
                     [this](std::uint64_t robot) { return arrival(robot).has_value(); });
}

std::size_t Trips::find(std::uint64_t robot, std::size_t from) const {
  const auto place =
      std::lower_bound(trips_.begin() + static_cast<std::ptrdiff_t>(from), trips_.end(), robot,
                       [](const Trip& trip, std::uint64_t id) { return trip.robot < id; });
  return static_cast<std::size_t>(place - trips_.begin());
}

bool Trips::is_travelling(std::uint64_t robot) const {
  const std::size_t place = find(robot, 0);
  if (place == trips_.size() || trips_[place].robot != robot || trips_[place].parked) return false;
  if (!is_judged(robot)) return false;
  const Trip& trip = trips_[place];
  return !trip.arrival || (*trip.arrival == now_ && trip.begin < now_);
}

std::optional<double> Trips::arrival(std::uint64_t robot) const {
  const std::size_t place = find(robot, 0);
  if (place == trips_.size() || trips_[place].robot != robot) return std::nullopt;
  return trips_[place].arrival;
}

void Trips::observe(const Simulation& simulation, const FleetView& fleet, double duration) {
  now_ = simulation.time();
  std::size_t k = 0;  // ids ascend in both
  for (std::size_t i = 0; i < fleet.id.size(); ++i, ++k) {
    const RobotId id = fleet.id[i];
    const std::uint64_t robot = id.value;
    if (k == trips_.size() || trips_[k].robot != robot) k = find(robot, std::min(k, trips_.size()));
    const bool is_new = k == trips_.size() || trips_[k].robot != robot;
    if (is_new) {
      trips_.insert(trips_.begin() + static_cast<std::ptrdiff_t>(k), Trip{.robot = robot});
      const std::optional<double> own = fleet.setup[i].time_step;
      trips_[k].step = own.value_or(step_);
    }
    Trip& trip = trips_[k];
    if (trip.arrival) continue;
    if (is_new) {
      begin(trip, simulation, fleet, i, arrival_distance_);
    } else if ((!(trip.goal == fleet.goal[i]) && !simulation.is_at_goal(id)) ||
               waits_to_start(fleet.setup[i].start_time, trip.end)) {
      trip = {.robot = robot, .step = trip.step};
      begin(trip, simulation, fleet, i, arrival_distance_);
    } else if (duration > 0.0) {
      go_on(trip, fleet.position[i], fleet.velocity[i], simulation.route(id).length, duration,
            simulation.decided(id));
      trip.end = now_;
    }
    if (simulation.is_at_goal(id)) {
      trip.arrival = now_;
      ++arrived_;
    }
  }
}

void Trips::add_overlaps(std::span<const std::uint64_t> robots) {
  for (const std::uint64_t robot : robots) {
    const std::size_t place = find(robot, 0);
    if (place == trips_.size() || trips_[place].robot != robot) continue;
    Trip& trip = trips_[place];
    if (!trip.arrival || *trip.arrival == now_) trip.overlapped = true;
  }
}

void Trips::add_touched(std::span<const std::uint64_t> robots) {
  for (const std::uint64_t robot : robots) {
    const std::size_t place = find(robot, 0);
    if (place < trips_.size() && trips_[place].robot == robot) trips_[place].overlapped = true;
  }
}

}  // namespace avo::inline metrics
