// SPDX-License-Identifier: Apache-2.0
// Results of a run, measured from the states before and after each step.
#include "avo/metrics.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <vector>

#include "metrics/body.h"
#include "metrics/crowd.h"
#include "metrics/encounters.h"
#include "metrics/first_sights.h"
#include "metrics/flow.h"
#include "metrics/mover_sights.h"
#include "metrics/not_arrived.h"
#include "metrics/trips.h"
#include "metrics/wall_contacts.h"
#include "metrics/watched.h"

namespace avo {
namespace {

constexpr std::size_t kMostListed = 100;  // robots that have not arrived
constexpr double kRounding = 1e-12;       // of a limit: a smaller excess is rounding

// In the order of PlanStatus.
constexpr std::array kCounts{
    &Decisions::optimal,     &Decisions::least_unsafe,  &Decisions::refused, &Decisions::braking,
    &Decisions::overlapping, &Decisions::invalid_input, &Decisions::detour};

void add_arrivals(const Trips& trips, RunSummary& summary) {
  double total = 0.0, last = 0.0;
  for (const Trip& trip : trips.all()) {
    ++summary.robots;
    if (trip.parked) ++summary.parked;
    if (!trip.arrival) continue;
    ++summary.arrived;
    if (!trip.parked) total += *trip.arrival;
    last = std::max(last, *trip.arrival);
  }
  const std::int64_t travelers = summary.arrived - summary.parked;
  if (travelers > 0) summary.mean_arrival = total / static_cast<double>(travelers);
  if (summary.arrived > 0 && summary.arrived == summary.robots) summary.last_arrival = last;
}

void add_encounters(const Encounters& encounters, RunSummary& summary) {
  const auto number = [](const Encounters::Pairs& pairs) {
    return static_cast<std::int64_t>(pairs.size());
  };
  summary.first_collision_time = encounters.first_collision_time;
  summary.min_clearance = encounters.min_clearance;
  summary.collision_pairs = number(encounters.collided);
  summary.one_sided_collisions = number(encounters.one_sided);
  summary.one_sided_collisions_in_motion = number(encounters.one_sided_in_motion);
  summary.mover_collisions = number(encounters.with_mover);
  summary.mover_collisions_in_motion = number(encounters.with_mover_in_motion);
  summary.metrics.collision_robot_steps = encounters.collision_robot_steps;
  summary.metrics.overlap_depth = encounters.overlap_depth;
}

}  // namespace

struct Metrics::State {
  State(const Scenario& scenario, const MetricsOptions& options)
      : settings(scenario),
        trips(scenario, options.judged),
        first_sights(scenario),
        mover_sights(scenario) {
    if (options.crowd) crowd.emplace();
    if (options.line) flow.emplace(*options.line);
  }

  Scenario settings;
  std::optional<Response> response;  // for robots that move by Eqs. (8), (9)
  RunSummary summary;
  Trips trips;
  std::vector<double> step_milliseconds;
  std::vector<double> distances_left;  // m, of robots with unreachable goals, in their order
  FirstSights first_sights;
  MoverSights mover_sights;

  bool started = false;
  double last_time = 0.0, duration = 0.0;  // s, of the last step
  std::uint64_t roster = 0;                // of the setups below; 0: none
  std::vector<RobotSetup> setups;          // they stay, except states and goals
  LastSeen last;
  std::uint64_t seen_roster = 0;  // of the robots that were seen last

  std::vector<BodyRow> rows;      // of the robots that were present before and are present now
  std::uint64_t rows_roster = 0;  // the roster of all rows; 0: some robots came or went
  std::vector<Sweep> sweeps;      // of these robots
  std::vector<Body> robots;       // of these robots, where walls or a line are examined
  std::vector<Body> obstacles;
  Encounters encounters;
  WallContacts walls;
  std::vector<ObstacleId> static_ids;  // of the obstacles that the walls belong to
  std::optional<Crowd> crowd;
  std::optional<LineFlow> flow;

  FleetView look_at(const Simulation& simulation);
  void remember(const Simulation& simulation, const FleetView& fleet);
  void collect_walls(const Simulation& simulation);
  void observe_limits(const Simulation& simulation, const FleetView& fleet);
  void observe_bodies(const FleetView& fleet);
  void leave_out_put_down(const FleetView& fleet);
  void observe_step(const Simulation& simulation, const FleetView& fleet);
};

FleetView Metrics::State::look_at(const Simulation& simulation) {
  if (simulation.roster() != roster) {
    const std::span<const RobotSetup> all = simulation.fleet(Columns::setup).setup;
    setups.assign(all.begin(), all.end());
    roster = simulation.roster();
  }
  FleetView fleet = simulation.fleet(Columns::id | Columns::position | Columns::velocity |
                                     Columns::heading | Columns::goal | Columns::detour |
                                     Columns::plan | Columns::applied_acceleration);
  fleet.setup = setups;
  return fleet;
}

void Metrics::State::remember(const Simulation& simulation, const FleetView& fleet) {
  last_time = simulation.time();
  last.look_at(simulation, fleet);
  seen_roster = roster;
}

// Collects the walls of the step.
void Metrics::State::collect_walls(const Simulation& simulation) {
  const StaticObstacleView now = simulation.obstacles();
  if (std::equal(now.id.begin(), now.id.end(), static_ids.begin(), static_ids.end())) return;
  static_ids.assign(now.id.begin(), now.id.end());
  walls.take(now.setup);
}

void Metrics::State::observe_limits(const Simulation& simulation, const FleetView& fleet) {
  double fastest = 0.0;  // m²/s²
  for (const Vec2 velocity : fleet.velocity) fastest = std::max(fastest, norm_squared(velocity));
  summary.max_speed = std::max(summary.max_speed, std::sqrt(fastest));
  if (!started) return;
  for (std::size_t i = 0; i < fleet.id.size(); ++i) {
    const RobotSetup& setup = fleet.setup[i];
    const double a = fleet.applied_acceleration[i];
    const double a_max = acceleration_limit(setup.model, change_limit(setup));
    if (!settings.execution) summary.max_acceleration = std::max(summary.max_acceleration, a);
    if (a > a_max * (1.0 + kRounding)) {
      summary.acceleration_excess = std::max(summary.acceleration_excess, a - a_max);
    }
    if (!simulation.decided(fleet.id[i])) continue;
    if (fleet.plan[i].violation > 0.0) ++summary.infeasible_steps;
    ++(summary.decisions.*kCounts[static_cast<std::size_t>(fleet.plan[i].status)]);
  }
}

// The applied accelerations are those of the references; results are about the bodies.
void Metrics::State::observe_bodies(const FleetView& fleet) {
  for (const BodyRow& row : rows) {
    const Vec2 change = fleet.velocity[row.now] - last.robots[row.before].velocity;
    summary.max_acceleration = std::max(summary.max_acceleration, norm(change) / duration);
  }
}

// A robot that the host has put down elsewhere passed nobody on its way there.
void Metrics::State::leave_out_put_down(const FleetView& fleet) {
  const double reach_squared = (kPutDown * duration) * (kPutDown * duration);  // s²
  const auto is_put_down = [&](const BodyRow& row) {
    const LastSeen::LastRobot& before = last.robots[row.before];
    const double moved_squared = norm_squared(fleet.position[row.now] - before.position);
    if (!(moved_squared > reach_squared * norm_squared(before.velocity))) return false;
    const double top = fleet.setup[row.now].max_speed;
    return moved_squared > reach_squared * top * top &&
           moved_squared > reach_squared * norm_squared(fleet.velocity[row.now]);
  };
  if (std::erase_if(rows, is_put_down) > 0) rows_roster = 0;
}

// Observes everything that happened since the last observation.
void Metrics::State::observe_step(const Simulation& simulation, const FleetView& fleet) {
  const BodyStep step{last, duration, started, settings.method};
  if (seen_roster != roster || rows_roster != roster) {
    collect_rows(fleet, last, rows);
    rows_roster = seen_roster == roster ? roster : 0;
  }
  if (started) leave_out_put_down(fleet);
  if (started && settings.execution) observe_bodies(fleet);
  sweeps.resize(rows.size());
  for (std::size_t k = 0; k < rows.size(); ++k) sweeps[k] = sweep_of(fleet, step, rows[k]);
  collect_movers(simulation.moving_obstacles(), step, obstacles);
  collect_walls(simulation);
  encounters.observe(sweeps, [&](std::size_t k) { return body_of(fleet, step, rows[k]); }, roster,
                     obstacles, {last_time, duration, started, response});
  robots.clear();
  if (flow || !walls.walls.empty()) collect_robots(fleet, step, rows, robots);
  walls.observe(robots, response, duration);
  trips.add_overlaps(encounters.overlapping);
  trips.add_touched(encounters.touched_by_movers);
  mover_sights.take_hits(encounters.new_hits);
  trips.add_overlaps(walls.touching);
  if (!started) return;
  if (crowd) crowd->observe(simulation, trips, duration);
  if (!flow) return;
  const auto is_same = [](const Body& a, const Body& b) { return a.name == b.name; };
  robots.erase(std::unique(robots.begin(), robots.end(), is_same), robots.end());
  flow->observe(robots, last_time, duration);
}

Metrics::Metrics(const Scenario& scenario, const MetricsOptions& options)
    : state_(std::make_unique<State>(scenario, options)) {
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
  const FleetView fleet = state.look_at(simulation);
  state.trips.observe(simulation, fleet, state.duration);
  state.observe_limits(simulation, fleet);
  state.first_sights.observe(simulation);
  if (!state.started) state.remember(simulation, fleet);  // before the first step nothing moves
  state.observe_step(simulation, fleet);
  state.mover_sights.observe(simulation);
  state.remember(simulation, fleet);
  state.summary.steps = simulation.steps();
  state.summary.unreachable.clear();
  state.distances_left.clear();
  for (const RobotId robot : simulation.unreachable()) {
    state.summary.unreachable.push_back(robot.value);
    state.distances_left.push_back(simulation.route(robot).distance_left);
  }
  state.started = true;
}

void Metrics::add_step_time(double milliseconds) {
  state_->step_milliseconds.push_back(milliseconds);
}

bool Metrics::all_arrived() const {
  return state_->trips.all_arrived();
}

RunSummary Metrics::summary() const {
  RunSummary summary = state_->summary;
  add_arrivals(state_->trips, summary);
  add_encounters(state_->encounters, summary);
  state_->trips.describe(summary.metrics);
  if (state_->crowd) state_->crowd->describe(summary.metrics);
  if (state_->flow) state_->flow->describe(summary.metrics);
  summary.static_collisions = static_cast<std::int64_t>(state_->walls.touched.size());
  summary.min_static_clearance = state_->walls.least_clearance;
  summary.first_seen_too_late = state_->first_sights.too_late();
  summary.mover_collisions_evadable = state_->mover_sights.evadable();
  const std::vector<LastSeen::LastRobot>& robots = state_->last.robots;
  for (std::size_t i = 0; i < robots.size(); ++i) {
    if (summary.not_arrived.size() == kMostListed) break;
    if (state_->trips.arrival(robots[i].id.value)) continue;
    NotArrived& entry = summary.not_arrived.emplace_back(state_->last.describe(i, state_->setups));
    const auto& unreachable = summary.unreachable;
    const auto place = std::lower_bound(unreachable.begin(), unreachable.end(), entry.robot);
    if (place != unreachable.end() && *place == entry.robot)
      entry.distance_left =
          state_->distances_left[static_cast<std::size_t>(place - unreachable.begin())];
  }
  std::vector<double> times = state_->step_milliseconds;
  if (!times.empty()) {
    summary.step_milliseconds_median = summary.metrics.step_ms_p50 = quantile(times, 0.50);
    summary.metrics.step_ms_p99 = quantile(times, 0.99);
  }
  return summary;
}

}  // namespace avo
