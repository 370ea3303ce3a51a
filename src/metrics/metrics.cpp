// SPDX-License-Identifier: Apache-2.0
// What a run did, measured from the states before and after each step.
#include "avo/metrics.h"

#include <algorithm>
#include <array>
#include <limits>
#include <map>
#include <set>
#include <utility>
#include <vector>

#include "avo/velocity_obstacle.h"
#include "metrics/body.h"
#include "metrics/first_sights.h"
#include "metrics/not_arrived.h"
#include "metrics/wall_contacts.h"
#include "neighbors/uniform_grid.h"

namespace avo {
namespace {

constexpr std::size_t kMostListed = 100;  // of those that have not arrived
constexpr double kRounding = 1e-12;       // of a limit: less excess than that is rounding
constexpr double kAtRest = 1e-9;          // of max_speed: no faster is at rest

// In the order of PlanStatus.
constexpr std::array kCounts{&Decisions::optimal,     &Decisions::least_unsafe,
                             &Decisions::candidate,   &Decisions::braking,
                             &Decisions::overlapping, &Decisions::invalid_input};

// Which of two robots avoid the other. Parked ones cannot help standing where they do.
enum class Avoidance : unsigned char { none, one_sided, mutual };
Avoidance avoidance(const RobotSetup& a, const RobotSetup& b) {
  if (a.parked || b.parked) return a.parked && b.parked ? Avoidance::none : Avoidance::mutual;
  const bool of_a = avoids(a, b), of_b = avoids(b, a);
  if (of_a && of_b) return Avoidance::mutual;
  return of_a || of_b ? Avoidance::one_sided : Avoidance::none;
}

}  // namespace

struct Metrics::State {
  explicit State(const Scenario& scenario) : settings(scenario), first_sights(scenario) {}

  Scenario settings;
  std::optional<Response> response;  // of robots that move by Eqs. (8), (9)
  RunSummary summary;
  std::map<std::uint64_t, std::optional<double>> arrival;  // s, of every robot that ever was
  std::set<std::pair<std::uint64_t, std::uint64_t>> collided, collided_one_sided,
      collided_with_obstacle, collided_in_motion;
  std::set<std::uint64_t> parked;
  std::vector<double> step_milliseconds;
  FirstSights first_sights;

  bool started = false;
  double last_time = 0.0, duration = 0.0;  // s, of the last step
  LastSeen last;

  std::vector<Body> robots, obstacles;
  std::vector<Vec2> positions;
  SearchScratch scratch;
  UniformGrid grid;
  WallContacts walls;
  std::vector<ObstacleId> static_ids;  // whose walls these are

  void remember(const Simulation& simulation);
  void collect_walls(const Simulation& simulation);
  void observe_limits(const Simulation& simulation);
  void observe_arrivals(const Simulation& simulation);
  void observe_separation();
  std::optional<double> any_clearance() const;
  double distance(const Body& a, const Body& b, double cutoff) const;
  void meet(const Body& a, const Body& b);
  void meet_obstacle(const Body& robot, const Body& obstacle);
};

void Metrics::State::remember(const Simulation& simulation) {
  last_time = simulation.time();
  last.look_at(simulation);
}

// Those that the step was taken among.
void Metrics::State::collect_walls(const Simulation& simulation) {
  const StaticObstacleView now = simulation.static_obstacles();
  if (std::equal(now.id.begin(), now.id.end(), static_ids.begin(), static_ids.end())) return;
  static_ids.assign(now.id.begin(), now.id.end());
  walls.search = WallSearch(walls_of(now.setup));
}

// Smallest distance of the centers over the step.
double Metrics::State::distance(const Body& a, const Body& b, double cutoff) const {
  if (!response || !a.exact || !b.exact) return separation_of(a, b, duration, cutoff).distance;
  const Pair pair{a.position - b.position, a.velocity - b.velocity, a.radius + b.radius};
  const Obstacle obstacle{pair, *response, duration};
  return closest_approach(obstacle, pair.velocity + (a.w - b.w)).distance;
}

void Metrics::State::meet(const Body& a, const Body& b) {
  const double contact = a.radius + b.radius;
  const Avoidance kind = avoidance(*a.setup, *b.setup);
  if (kind == Avoidance::none) return;
  if (kind == Avoidance::one_sided) {
    if (distance(a, b, contact) < contact * (1.0 - kContact))
      collided_one_sided.insert(std::minmax(a.name, b.name));
    return;
  }
  const double best = summary.min_clearance.value_or(std::numeric_limits<double>::infinity());
  const double d = distance(a, b, contact + std::max(best, 0.0));
  if (d - contact < best) summary.min_clearance = d - contact;
  const double overlapping = contact * (1.0 - kContact);
  if (!(d < overlapping)) return;
  collided.insert(std::minmax(a.name, b.name));
  const Separation closest = separation_of(a, b, duration, overlapping);
  const bool turns = a.arc || b.arc;  // some time at which they overlap will do
  const double fraction =
      turns ? closest.fraction : first_below(a.path, b.path, overlapping, closest.fraction);
  const double time = last_time + fraction * duration;
  summary.first_collision_time = std::min(summary.first_collision_time.value_or(time), time);
}

void Metrics::State::meet_obstacle(const Body& robot, const Body& obstacle) {
  const double contact = robot.radius + obstacle.radius;
  if (!(distance(robot, obstacle, contact) < contact * (1.0 - kContact))) return;
  collided_with_obstacle.insert({robot.name, obstacle.name});
  const double at_rest = kAtRest * robot.setup->max_speed * settings.time_step;
  if (way_of(robot) > at_rest) collided_in_motion.insert({robot.name, obstacle.name});
}

// m: any pair bounds the smallest clearance, here the first robot that avoids somebody and its
// nearest.
std::optional<double> Metrics::State::any_clearance() const {
  std::optional<double> nearest;
  for (std::size_t i = 0; i < robots.size() && !nearest; ++i) {
    const Body& a = robots[i];
    for (std::size_t j = i + 1; j < robots.size(); ++j) {
      const Body& b = robots[j];
      if (avoidance(*a.setup, *b.setup) != Avoidance::mutual) continue;
      const double clearance = norm(b.position - a.position) - a.radius - b.radius;
      nearest = std::min(nearest.value_or(clearance), clearance);
    }
  }
  return nearest;
}

// Every pair that can come nearer than the smallest clearance so far, or overlap.
void Metrics::State::observe_separation() {
  double largest = 0.0, farthest = 0.0;  // radius and way of a step, m
  const auto measure = [&](const Body& body) {
    largest = std::max(largest, body.radius);
    farthest = std::max(farthest, way_of(body));
  };
  std::for_each(robots.begin(), robots.end(), measure);
  if (!summary.min_clearance) summary.min_clearance = any_clearance();
  std::for_each(obstacles.begin(), obstacles.end(), measure);

  positions.clear();
  for (const Body& body : robots) positions.push_back(body.position);
  const double clearance = std::max(summary.min_clearance.value_or(0.0), 0.0);
  grid.build(positions, 2.0 * largest + clearance + 2.0 * farthest);
  const std::size_t all = robots.size();
  for (std::size_t i = 0; i < robots.size(); ++i) {
    for (const NeighborHit& hit : grid.gather(positions[i], static_cast<int>(i), all, scratch)) {
      const auto j = static_cast<std::size_t>(hit.index);
      if (j > i) meet(robots[i], robots[j]);
    }
  }
  for (const Body& obstacle : obstacles) {
    for (const NeighborHit& hit : grid.gather(obstacle.position, -1, all, scratch)) {
      meet_obstacle(robots[static_cast<std::size_t>(hit.index)], obstacle);
    }
  }
}

void Metrics::State::observe_limits(const Simulation& simulation) {
  const FleetView fleet = simulation.fleet();
  for (std::size_t i = 0; i < fleet.id.size(); ++i) {
    summary.max_speed = std::max(summary.max_speed, norm(fleet.velocity[i]));
    if (!started) continue;
    const RobotSetup& setup = fleet.setup[i];
    const double a = fleet.applied_acceleration[i];
    const double a_max = acceleration_limit(setup.model, setup.max_acceleration);
    summary.max_acceleration = std::max(summary.max_acceleration, a);
    if (a > a_max * (1.0 + kRounding)) {
      summary.acceleration_excess = std::max(summary.acceleration_excess, a - a_max);
    }
    if (!simulation.decided(i)) continue;
    if (fleet.plan[i].violation > 0.0) ++summary.infeasible_steps;
    ++(summary.decisions.*kCounts[static_cast<std::size_t>(fleet.plan[i].status)]);
  }
}

void Metrics::State::observe_arrivals(const Simulation& simulation) {
  const FleetView fleet = simulation.fleet();
  for (std::size_t i = 0; i < fleet.id.size(); ++i) {
    std::optional<double>& time = arrival[fleet.id[i].value];
    if (time) continue;
    if (fleet.setup[i].parked) parked.insert(fleet.id[i].value);
    if (simulation.is_at_goal(i)) time = simulation.time();
  }
  summary.unreachable.clear();
  for (const RobotId robot : simulation.unreachable()) summary.unreachable.push_back(robot.value);
}

Metrics::Metrics(const Scenario& scenario) : state_(std::make_unique<State>(scenario)) {
  if (!adopts_at_once(scenario.method) && scenario.motion == Motion::exponential)
    state_->response = Response::proportional(planner_options(scenario).control_time);
  state_->settings.robots.clear();
  state_->settings.moving_obstacles.clear();
  state_->settings.obstacles.clear();
  state_->summary.scene = scenario.name;
  state_->summary.seed = scenario.seed;
}
Metrics::~Metrics() = default;

void Metrics::observe(const Simulation& simulation) {
  State& state = *state_;
  const bool is_free = state.settings.clock == Clock::free;
  state.duration = is_free ? simulation.time() - state.last_time : state.settings.time_step;
  state.observe_arrivals(simulation);
  state.observe_limits(simulation);
  state.first_sights.observe(simulation);
  if (!state.started) state.remember(simulation);  // before the first step nothing moves
  const BodyStep step{state.last, state.duration, state.started,
                      adopts_at_once(state.settings.method)};
  collect_robots(simulation.fleet(), step, state.robots);
  collect_obstacles(simulation.obstacles(), step, state.obstacles);
  state.collect_walls(simulation);
  state.observe_separation();
  state.walls.observe(state.robots, state.response, state.duration);
  state.remember(simulation);
  state.summary.steps = simulation.steps();
  state.started = true;
}

void Metrics::add_step_time(double milliseconds) {
  state_->step_milliseconds.push_back(milliseconds);
}

bool Metrics::all_arrived() const {
  return std::all_of(state_->arrival.begin(), state_->arrival.end(),
                     [](const auto& robot) { return robot.second.has_value(); });
}

RunSummary Metrics::summary() const {
  RunSummary summary = state_->summary;
  summary.robots = static_cast<std::int64_t>(state_->arrival.size());
  double total = 0.0, last = 0.0;
  for (const auto& [robot, time] : state_->arrival) {
    if (!time) continue;
    ++summary.arrived;
    if (!state_->parked.contains(robot)) total += *time;
    last = std::max(last, *time);
  }
  summary.parked = static_cast<std::int64_t>(state_->parked.size());
  const std::int64_t travelers = summary.arrived - summary.parked;
  if (travelers > 0) summary.mean_arrival = total / static_cast<double>(travelers);
  if (summary.arrived > 0 && summary.arrived == summary.robots) summary.last_arrival = last;
  summary.collision_pairs = static_cast<std::int64_t>(state_->collided.size());
  summary.one_sided_collisions = static_cast<std::int64_t>(state_->collided_one_sided.size());
  summary.obstacle_collisions = static_cast<std::int64_t>(state_->collided_with_obstacle.size());
  summary.obstacle_collisions_in_motion =
      static_cast<std::int64_t>(state_->collided_in_motion.size());
  summary.collision_obstacles = static_cast<std::int64_t>(state_->walls.touched.size());
  summary.min_obstacle_clearance = state_->walls.least_clearance;
  summary.first_seen_too_late = state_->first_sights.too_late();
  for (std::size_t i = 0; i < state_->last.robots.size(); ++i) {
    if (summary.not_arrived.size() == kMostListed) break;
    if (state_->arrival.at(state_->last.robots[i].id.value)) continue;
    summary.not_arrived.push_back(state_->last.describe(i));
  }
  std::vector<double> times = state_->step_milliseconds;
  if (!times.empty()) {
    const auto half = times.begin() + static_cast<std::ptrdiff_t>(times.size() / 2);
    std::nth_element(times.begin(), half, times.end());
    summary.step_milliseconds_median = *half;
  }
  return summary;
}

}  // namespace avo
