// SPDX-License-Identifier: Apache-2.0
#include "avo/space/metrics.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "metrics/ideal_time.h"
#include "metrics/trip.h"
#include "space/own_space.h"

namespace avo::space {

std::vector<CheckedRobot> checked_robots(const Scenario& scenario) {
  std::vector<CheckedRobot> robots;
  for (const RobotSetup& setup : scenario.robots) {
    const Robot robot = robot_of(setup);
    robots.push_back({.radius = robot.radius,
                      .downwash = robot.downwash,
                      .max_acceleration = robot.max_acceleration,
                      .max_speed = robot.max_speed,
                      .vertical = robot.vertical,
                      .climb = robot.climb,
                      .sink = robot.sink,
                      .max_braking = robot.max_braking,
                      .goal = setup.goal});
  }
  return robots;
}

std::vector<CheckedMover> checked_movers(const Scenario& scenario) {
  std::vector<CheckedMover> movers;
  for (const MovingObstacle& obstacle : scenario.moving_obstacles)
    movers.push_back({obstacle.radius, !obstacle.trajectory.empty()});
  return movers;
}

std::vector<CheckedState> mover_states(const Scenario& scenario, double time) {
  std::vector<CheckedState> states;
  for (const MovingObstacle& obstacle : scenario.moving_obstacles) {
    const auto [position, velocity] = state_at(obstacle, time);
    states.push_back({static_cast<std::int64_t>(states.size()), position, velocity});
  }
  return states;
}

struct Metrics::State {
  Scenario scenario;
  Check check;
  std::vector<TripOf<3>> trips;
  std::vector<double> step_times;
  std::size_t arrived = 0;
  RunSummary summary;
  std::vector<Plan> last;
  std::vector<Robot> robots;
  std::vector<RobotId> unreachable;
  std::vector<double> left;  // m, from the end of each robot's route to its goal
  std::vector<CheckedState> mover_rows;
  double time = 0.0;

  explicit State(const Scenario& scene)
      : scenario(scene),
        check(checked_robots(scene), scene.boxes, {.arrival_distance = scene.arrival_distance},
              checked_movers(scene)) {}

  void begin(const Simulation& simulation, std::size_t k);
  void count(const Plan& plan);
  void check_movers(const Simulation& simulation);
};

// The judge is told of all edits, and gets the present rows.
void Metrics::State::check_movers(const Simulation& simulation) {
  mover_rows.clear();
  const std::span<const MovingObstacleId> ids = simulation.moving_obstacle_ids();
  for (std::size_t k = 0; k < ids.size(); ++k) {
    const auto [position, velocity] = simulation.movers_before()[k];
    mover_rows.push_back({static_cast<std::int64_t>(ids[k].value), position, velocity});
  }
  check.set_movers(checked_movers(simulation.scenario()), mover_rows);
  for (std::size_t k = 0; k < ids.size(); ++k) {
    mover_rows[k].position = simulation.movers()[k].position;
    mover_rows[k].velocity = simulation.movers()[k].velocity;
  }
}

void Metrics::State::begin(const Simulation& simulation, std::size_t k) {
  const RobotSetup& setup = scenario.robots[k];
  const Robot& robot = simulation.robots()[k];
  TripOf<3>& trip = trips.emplace_back();
  const Vec3 ahead = simulation.goal({k}) - robot.position;
  const double straight = norm(ahead);
  const Simulation::Route route = simulation.route({k});
  const double distance = std::isfinite(route.length) ? route.length : straight;
  const double per = straight > 0.0 ? 1.0 / own_length(ahead / straight, robot.vertical) : 1.0;
  trip.robot = k;
  trip.goal = simulation.goal({k});
  trip.begin = trip.end = simulation.time();
  trip.step = scenario.time_step;
  trip.preferred_speed = setup.preferred_speed;
  trip.way = trip.way_left = trip.progress = distance;
  trip.acceleration_limit = robot.max_acceleration;
  trip.ideal_time =
      ideal_time({.way = distance,
                  .margin = scenario.arrival_distance,
                  .speed = straight > 0.0 ? dot(robot.velocity, ahead) / straight : 0.0,
                  .top_speed = std::min(setup.preferred_speed, per * setup.max_speed),
                  .acceleration = per * robot.max_acceleration});
  trip.position = robot.position;
  trip.velocity = robot.velocity;
}

void Metrics::State::count(const Plan& plan) {
  Decisions& all = summary.decisions;
  switch (plan.status) {
    case PlanStatus::optimal:
      ++all.optimal;
      break;
    case PlanStatus::least_unsafe:
      ++all.least_unsafe;
      break;
    case PlanStatus::refused:
      ++all.refused;
      break;
    case PlanStatus::braking:
      ++all.braking;
      break;
    case PlanStatus::overlapping:
      ++all.overlapping;
      break;
    case PlanStatus::invalid_input:
      ++all.invalid_input;
      break;
    case PlanStatus::detour:
      ++all.detour;
      break;
  }
  if (plan.violation > 0.0) ++summary.infeasible_steps;
}

Metrics::Metrics(const Scenario& scenario) : state_(std::make_unique<State>(scenario)) {}
Metrics::~Metrics() = default;
Metrics::Metrics(Metrics&&) noexcept = default;
Metrics& Metrics::operator=(Metrics&&) noexcept = default;

void Metrics::add_step_time(double milliseconds) {
  state_->step_times.push_back(milliseconds);
}

bool Metrics::all_arrived() const {
  return state_->arrived == state_->scenario.robots.size();
}

void Metrics::observe(const Simulation& simulation) {
  State& state = *state_;
  std::vector<CheckedState> rows;
  const bool is_first = state.trips.empty();
  for (std::size_t k = 0; k < simulation.size(); ++k) {
    const Robot& robot = simulation.robots()[k];
    rows.push_back({static_cast<std::int64_t>(k), robot.position, robot.velocity});
    if (is_first) {
      state.begin(simulation, k);
    } else {
      state.count(simulation.plans()[k]);
    }
    TripOf<3>& trip = state.trips[k];
    const double left = norm(trip.goal - robot.position);
    if (!is_first && !trip.arrival) {
      trip.end = simulation.time();
      go_on(trip, robot.position, robot.velocity, left, state.scenario.time_step, true);
    }
    if (!trip.arrival && simulation.is_at_goal({k})) {
      trip.arrival = simulation.time();
      ++state.arrived;
    }
  }
  state.check_movers(simulation);
  state.check.add(simulation.time(), rows, state.mover_rows);
  state.robots.assign(simulation.robots().begin(), simulation.robots().end());
  state.last.assign(simulation.plans().begin(), simulation.plans().end());
  state.summary.steps = simulation.steps();
  state.time = simulation.time();
  state.unreachable = simulation.unreachable();
  state.left.assign(simulation.size(), 0.0);
  for (const RobotId robot : state.unreachable)
    state.left[static_cast<std::size_t>(robot.value)] = simulation.route(robot).distance_left;
}

RunSummary Metrics::summary() const {
  const State& state = *state_;
  RunSummary summary = state.summary;
  const CheckReport report = state.check.report();
  summary.scene = state.scenario.name;
  summary.seed = state.scenario.seed;
  for (const RobotId robot : state.unreachable) summary.unreachable.push_back(robot.value);
  summary.robots = static_cast<std::int64_t>(state.scenario.robots.size());
  summary.arrived = static_cast<std::int64_t>(state.arrived);
  summary.collision_pairs = report.overlaps.count;
  if (report.overlaps.first) summary.first_collision_time = report.overlaps.first->time;
  summary.mover_collisions_in_motion = report.mover_contacts_moving.count;
  summary.mover_collisions = report.mover_contacts_moving.count + report.mover_contacts_at_rest;
  summary.static_collisions = report.static_contacts.count;
  summary.min_clearance = report.least_clearance;
  summary.min_static_clearance = report.least_static_clearance;
  summary.max_acceleration = report.largest_acceleration;
  summary.max_speed = report.largest_speed;
  summary.acceleration_excess = report.accelerations.worst;
  double sum = 0.0, last = 0.0;
  std::vector<const TripOf<3>*> trips;
  for (const TripOf<3>& trip : state.trips) {
    trips.push_back(&trip);
    if (trip.arrival) sum += *trip.arrival, last = std::max(last, *trip.arrival);
  }
  if (state.arrived > 0) summary.mean_arrival = sum / static_cast<double>(state.arrived);
  if (all_arrived()) summary.last_arrival = last;
  describe_trips<3>(trips, summary.metrics);
  if (report.overlaps.count > 0) {  // it is not known which trips they ended
    summary.metrics.success.reset();
    summary.metrics.collision.reset();
    summary.metrics.timeout.reset();
  }
  constexpr std::size_t kNamed = 100;
  for (std::size_t k = 0; k < state.trips.size() && summary.not_arrived.size() < kNamed; ++k) {
    if (state.trips[k].arrival) continue;
    NotArrived& entry = summary.not_arrived.emplace_back();
    entry.robot = k;
    entry.distance_left = state.left[k];
    entry.distance = norm(state.trips[k].goal - state.robots[k].position);
    entry.speed = norm(state.robots[k].velocity);
    entry.status = state.last[k].status;
  }
  std::vector<double> times = state.step_times;
  if (!times.empty()) {
    summary.step_milliseconds_median = summary.metrics.step_ms_p50 = quantile(times, 0.5);
    summary.metrics.step_ms_p99 = quantile(times, 0.99);
  }
  return summary;
}

}  // namespace avo::space
