// SPDX-License-Identifier: Apache-2.0
// One robot's decision (paper §IV-D): collect a half-plane per neighbor, choose the allowed
// velocity nearest the preferred one.
#include "avo/planner.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

#include "avo/half_plane.h"
#include "core/elementary.h"
#include "core/plane.h"
#include "core/ranges.h"
#include "lp/linear_program.h"
#include "planner/arrival.h"
#include "planner/certify.h"
#include "planner/clamped.h"
#include "planner/contact.h"
#include "planner/demands.h"
#include "planner/flight.h"
#include "planner/neighbor_order.h"
#include "planner/options.h"
#include "planner/passive_obstacles.h"
#include "planner/reciprocal_obstacles.h"
#include "planner/scratch.h"
#include "planner/soft_planes.h"
#include "robots/model.h"

namespace avo {
namespace {

constexpr std::size_t kMostConstraints = 8192;  // for more, memory grows when it is needed

// 1 or 0, to be joined without a branch: nearly all are.
int is_known(double value) {
  return static_cast<int>(std::abs(value) <= kLargest);
}
int is_known(Vec2 value) {
  return is_known(value.x) & is_known(value.y);
}
int is_size(double value) {
  return static_cast<int>(value >= kSmallest) & static_cast<int>(value <= kLargest);
}

// Where the robot is does not matter for slowing down.
bool can_brake(const Robot& robot) {
  const int velocity = is_known(robot.velocity);
  const int braking = robot.max_braking ? is_size(*robot.max_braking) : 1;
  return (velocity & is_size(robot.max_acceleration) & is_size(robot.max_speed) & braking) != 0;
}

bool can_drive(const Robot& robot) {
  return is_known(robot.heading) != 0 &&
         is_valid(robot.model, change_limit(robot), robot.max_speed);
}

// v' that comes to rest within the step if the limits allow, and otherwise brakes straight along
// -v, Eq. (7); |v' - v| <= δ b always, |v'| <= v_max unless that is farther than δ b away.
// rate: the part of v' - v that one step turns into velocity.
Vec2 braking_velocity(const Robot& robot, double control_time, double rate) noexcept {
  const double speed = norm(robot.velocity);
  if (!(speed > 0.0)) return {};
  const double limit = control_time * braking_limit(robot);
  const double change = std::min({speed / rate, limit, std::max(speed + robot.max_speed, 0.0)});
  return ((speed - change) / speed) * robot.velocity;
}

}  // namespace

bool is_valid(const Robot& robot) {
  const int places = is_known(robot.position) & is_known(robot.preferred_velocity);
  if (robot.loiter && (is_known(robot.loiter->center) & is_size(robot.loiter->radius)) == 0)
    return false;
  const int lengths = is_size(robot.radius) & is_size(robot.priority) &
                      static_cast<int>(robot.distance_to_goal >= 0.0);
  return can_brake(robot) && (places & lengths) != 0 &&
         (is_holonomic(robot.model) || can_drive(robot));
}

bool follows_heading(const Robot& robot) {
  if (!moves_along_heading(robot.model) || is_rest(robot.velocity)) return true;
  const Vec2 v = robot.velocity, heading = elementary::direction(robot.heading);
  const bool backwards = can_reverse(robot.model) && dot(v, heading) < 0.0;
  return norm_squared(v - norm(v) * (backwards ? -heading : heading)) <=
         kHeadingTolerance * kHeadingTolerance * norm_squared(v);
}

namespace {

bool is_deviation(double value) {
  return value >= 0.0 && value <= kLargest;
}

// What nearly all of them have is asked of all in is_valid().
bool is_valid_mover(const Neighbor& mover) {
  return is_deviation(mover.max_deviation) && mover.max_speed >= kSmallest && !mover.loiter;
}

bool is_valid_loiterer(const Neighbor& neighbor) {
  const LoiterCircle& circle = *neighbor.loiter;
  return (is_known(circle.center) & is_size(circle.radius)) != 0 &&
         !has_errors_of_its_own(neighbor);
}

}  // namespace

bool is_valid(const Neighbor& neighbor) {
  const int dated = static_cast<int>(neighbor.age >= 0) &
                    static_cast<int>(neighbor.age <= kMostAge) &
                    static_cast<int>(is_deviation(neighbor.position_error));
  if ((is_known(neighbor.position) & is_known(neighbor.velocity) & is_known(neighbor.acceleration) &
       is_size(neighbor.radius) & dated) == 0)
    return false;
  if (neighbor.behavior == Behavior::moves_on) return is_valid_mover(neighbor);
  const double a_max = neighbor.max_acceleration;
  const int able = static_cast<int>(a_max > 0.0) & static_cast<int>(a_max <= kLargest) &
                   is_size(neighbor.priority) & is_known(neighbor.parting);
  if (able == 0) return false;
  if (neighbor.max_braking && is_size(*neighbor.max_braking) == 0) return false;
  if (neighbor.age > 0 && !is_deviation(neighbor.max_deviation)) return false;
  return !neighbor.loiter || is_valid_loiterer(neighbor);
}

bool is_valid(const Wall& wall) {
  const int places = is_known(wall.a) & is_known(wall.b);
  return (places & static_cast<int>(wall.radius >= 0.0) & is_known(wall.radius)) != 0;
}

bool all_valid(const Robot& robot, std::span<const Neighbor> neighbors) {
  return is_valid(robot) && std::all_of(neighbors.begin(), neighbors.end(),
                                        [](const Neighbor& n) { return is_valid(n); });
}

bool all_valid(const Robot& robot, const Neighbors& neighbors) {
  if (!is_valid(robot)) return false;
  for (std::size_t k = 0; k < neighbors.size(); ++k) {
    if (!is_valid(neighbors[k])) return false;
  }
  return true;
}

namespace {

template <typename Neighbors>
bool can_follow_among(const Robot& robot, const Neighbors& neighbors,
                      const PlannerOptions& options) {
  const bool flies = is_airplane(robot.model);
  bool loiters = flies;
  for (std::size_t k = 0; k < neighbors.size(); ++k) {
    const Neighbor& neighbor = neighbors[k];
    if (flies && (has_errors_of_its_own(neighbor) || neighbor.behavior != Behavior::decides))
      return false;
    if (!neighbor.loiter) continue;
    loiters = true;
    if (!is_on_circle(neighbor)) return false;
  }
  if (flies && !can_fly(robot, options.time_step)) return false;
  if (loiters && !allows_loiterers(options)) return false;
  return is_holonomic(robot.model) || options.certificate == Certificate::none ||
         options.motion == Motion::held;
}

}  // namespace

bool can_follow(const Robot& robot, const Neighbors& neighbors, const PlannerOptions& options) {
  if (!is_airplane(robot.model) && !neighbors.columns->has_loiterers)  // nearly always
    return can_follow_among(robot, std::span<const Neighbor>{}, options);
  return can_follow_among(robot, neighbors, options);
}
bool can_follow(const Robot& robot, std::span<const Neighbor> neighbors,
                const PlannerOptions& options) {
  return can_follow_among(robot, neighbors, options);
}

bool can_decide(const Robot& robot, std::span<const Neighbor> neighbors,
                std::span<const Wall> walls, const PlannerOptions& options) {
  return all_valid(robot, neighbors) &&
         std::all_of(walls.begin(), walls.end(), [](const Wall& wall) { return is_valid(wall); }) &&
         follows_heading(robot) && can_follow(robot, neighbors, options);
}

PlanWorkspace::PlanWorkspace() : scratch_(std::make_unique<Scratch>()) {}
PlanWorkspace::~PlanWorkspace() = default;
PlanWorkspace::PlanWorkspace(PlanWorkspace&&) noexcept = default;
PlanWorkspace& PlanWorkspace::operator=(PlanWorkspace&&) noexcept = default;

void PlanWorkspace::Scratch::reserve_choice(std::size_t neighbors, std::size_t braking_steps) {
  reserve_planes(neighbors, 0);
  reserve_constraints(neighbors, braking_steps, kMostConstraints, certified.constraints);
}

void PlanWorkspace::Scratch::reserve_walls(std::size_t neighbors, std::size_t most_walls) {
  certified.constraints.walls.near.reserve(most_walls);
  reserve_planes(neighbors, most_walls);
}

// Room for those of one program, and for the cuts of its rounds.
void PlanWorkspace::Scratch::reserve_planes(std::size_t neighbors, std::size_t most_walls) {
  const std::size_t cuts = kMostCuts * (neighbors + most_walls) + kMostOwnPlanes;
  certified.hard.reserve(cuts);
  certified.rows.reserve(program_rows(cuts));
  const std::size_t hard = most_walls + kMostOwnPlanes;
  demands.reserve(hard);
  hard_and_soft.reserve(neighbors + hard);
  rows.reserve(program_rows(neighbors + hard));
}

void PlanWorkspace::reserve(std::size_t neighbors, std::size_t braking_steps) {
  Scratch& scratch = *scratch_;
  scratch.reserve_choice(neighbors, braking_steps);
  scratch.order.reserve(neighbors);
  scratch.ordered.reserve(neighbors);
  scratch.alone.reserve(1, neighbors);
  scratch.decisions.reserve(1);
  avo::reserve(1, neighbors, scratch.soft);
}

Planner::Planner(const PlannerOptions& options) : options_(options) {
  validate(options, "PlannerOptions.");
  if (reaches_within_step(options.method)) options_.control_time = options.time_step;
  horizon_ = std::make_shared<const Horizon>(options_.control_time, options.time_horizon,
                                             options.time_step);
}

Disc Planner::acceleration_disc(const Robot& robot) const {
  if (disregards_acceleration(options_.method))
    return {{}, std::numeric_limits<double>::infinity()};
  const double most = options_.control_time * robot.max_acceleration;
  return {robot.velocity, is_holonomic(robot.model) ? most : reach_of(robot.model) * most};
}

Disc Planner::speed_disc(const Robot& robot) const {
  return {{}, robot.max_speed};
}

double Planner::step_rate() const {
  if (adopts_at_once(options_.method)) return 1.0;
  return options_.motion == Motion::held ? options_.time_step / options_.control_time
                                         : horizon_->step().rate;
}

double Planner::step_lag() const {
  if (adopts_at_once(options_.method)) return 0.0;
  return options_.motion == Motion::held ? 0.5 * options_.time_step : horizon_->step().lag;
}

namespace {

// An airplane can hold its speed and turn right, which is all that is left to it where a number is
// wrong, wherever it is: if its place or its circle is unknown, as if it were at the origin.
std::optional<Robot> flying(const Robot& robot, double time_step) {
  if (!can_brake(robot) || !can_drive(robot)) return std::nullopt;
  if (is_known(robot.position) != 0 && can_fly(robot, time_step)) return robot;
  Robot anywhere = robot;
  anywhere.position = {}, anywhere.loiter = {};
  return can_fly(anywhere, time_step) ? std::optional(anywhere) : std::nullopt;
}

}  // namespace

Plan brake(const Planner& planner, const Robot& robot, PlanStatus status, double violation) {
  if (!can_brake(robot)) return {.status = PlanStatus::invalid_input};
  const PlannerOptions& options = planner.options();
  if (is_airplane(robot.model)) {
    const auto airplane = flying(robot, options.time_step);
    return airplane ? loiter_on(planner, *airplane, status, violation)
                    : Plan{.status = PlanStatus::invalid_input};
  }
  if (adopts_at_once(options.method))
    return plan_of(options, robot.velocity, {}, status, violation);
  if (options.method == Method::avo) {
    const CertificateLaw law = certificate_law(planner);
    return plan_under(law, robot, backup_velocity(robot, law), status, violation);
  }
  return plan_of(options, robot.velocity,
                 braking_velocity(robot, options.control_time, planner.step_rate()), status,
                 violation);
}

Plan as_followed(const Planner& planner, const Robot& robot, Plan plan) {
  const PlannerOptions& options = planner.options();
  if (options.certificate != Certificate::none || !has_limits_within_steps(robot.model) ||
      !can_brake(robot) || !can_drive(robot))
    return plan;
  const double time_step = options.time_step;
  const Vec2 wanted = robot.velocity + time_step * plan.acceleration;
  const Vec2 v = within_own_limits(robot, time_step, wanted);
  if (v == wanted) return plan;
  plan.acceleration = (v - robot.velocity) / time_step;
  const double control_time = adopts_at_once(options.method) ? time_step : options.control_time;
  plan.new_velocity = robot.velocity + control_time * plan.acceleration;
  return plan;
}

Plan decide_among_obstacles(const Planner& planner, const Robot& robot,
                            std::span<const Neighbor> given, std::span<const Wall> walls,
                            PlanWorkspace::Scratch& scratch) {
  const PlannerOptions& options = planner.options();
  if (!all_valid(robot, given) || !follows_heading(robot) || !can_follow(robot, given, options)) {
    return brake(planner, robot, PlanStatus::invalid_input, 0.0);
  }
  const std::span<const Neighbor> obstacles = nearest_first(robot, given, scratch);
  const Response response = disregards_acceleration(options.method)
                                ? Response::velocity()
                                : Response::proportional(options.control_time);
  bool overlapping = false;
  scratch.obstacles.clear();
  for (const Neighbor& obstacle : obstacles) {
    const Pair pair = relative(robot, obstacle);
    overlapping = overlapping || norm(pair.position) < pair.radius;
    if (options.method == Method::reciprocal_velocity_obstacle) {
      scratch.obstacles.push_back(reciprocal_obstacle(options, robot, obstacle));
      continue;
    }
    const double kept = obstacle.behavior == Behavior::decides ? 0.0 : 1.0;
    const Vec2 v_new_B =
        obstacle.velocity + (response.control_time() * kept) * obstacle.acceleration;
    scratch.obstacles.push_back(
        {{pair, response, options.time_horizon}, v_new_B, options.time_step});
  }
  Demands& demands = scratch.demands;
  demands.clear();
  // what the certificate refuses, it finds a way around
  if (options.method != Method::avo)
    collect_demands(planner, robot, walls, certificate_law(planner).step, demands);
  overlapping = overlapping || demands.overlapping;
  // Eq. (14)
  PassiveChoice choice = choose_among_obstacles(scratch.obstacles, planner.acceleration_disc(robot),
                                                planner.speed_disc(robot), robot.preferred_velocity,
                                                scratch.passive, demands.planes);
  if (choice.state == PassiveState::discs_disjoint) {
    return brake(planner, robot, PlanStatus::braking, choice.violation);
  }
  if (choice.state == PassiveState::least_unsafe &&
      options.method == Method::reciprocal_velocity_obstacle)
    choice = least_penalty(scratch.obstacles, planner.speed_disc(robot), options.time_horizon,
                           robot.preferred_velocity, scratch.passive);
  if (options.method == Method::orca_clamped)
    choice = clamped(choice, robot, options.time_step, scratch.passive.limits);
  Plan plan;
  if (options.method == Method::avo) {
    plan = certify_among_movers(planner, robot, obstacles, walls, choice, overlapping, scratch);
  } else {
    const double violation =
        with_excess(demands.planes, demands.excess, choice.velocity, choice.violation);
    const bool is_free = choice.state == PassiveState::free && !(violation > 0.0);
    const PlanStatus status = is_free ? PlanStatus::optimal : PlanStatus::least_unsafe;
    plan = plan_of(options, robot.velocity, choice.velocity, status, violation);
    if (overlapping)
      tell(deepest_contact(robot, obstacles, walls, certificate_law(planner).step), plan);
  }
  if (plan.neighbor >= 0)
    plan.neighbor = index_in(given, obstacles[static_cast<std::size_t>(plan.neighbor)]);
  return plan;
}

namespace {

// Lists lie where the caller keeps them, far from the caches where it asks for many robots in turn.
void prefetch(const Neighbor* neighbor) {
  constexpr std::size_t kLine = 64;  // bytes
  for (std::size_t at = 0; at < sizeof(Neighbor); at += kLine)
    __builtin_prefetch(reinterpret_cast<const char*>(neighbor) + at);
}

// The only ones of the tile, nearest first; nothing where one is invalid. In one pass where they
// come in that order.
std::optional<Neighbors> take_neighbors(const Robot& robot, std::span<const Neighbor> given,
                                        PlanWorkspace::Scratch& scratch) {
  NeighborColumns& columns = scratch.alone.neighbors;
  columns.reserve(given.size());
  constexpr std::size_t kAhead = 8;
  double last = 0.0;  // m²
  bool in_order = true;
  for (const Neighbor& neighbor : given) {
    prefetch(&neighbor + kAhead);
    if (!is_valid(neighbor)) return std::nullopt;
    const double squared = distance_squared(robot, neighbor);
    in_order = in_order && squared >= last;
    last = squared;
    columns.add(neighbor);
  }
  if (!in_order) return in_columns(nearest_first(robot, given, scratch), columns);
  return Neighbors{&columns, 0, given.size()};
}

Robot at_rest(Robot robot) {
  robot.velocity = {};
  return robot;
}

// Moved as a simulation moves it.
Plan with_next_velocity(const Planner& planner, const Robot& robot, Plan plan) {
  if (!can_brake(robot)) return plan;
  if (!is_holonomic(robot.model) && can_drive(robot) && follows_heading(robot)) {
    MotionState state{{}, robot.velocity, robot.heading};
    if (is_airplane(robot.model)) {
      const auto airplane = flying(robot, planner.options().time_step);
      if (!airplane) return plan;
      state.position = airplane->position, state.circle = *with_circle(*airplane).loiter;
    }
    const MotionLimits limits{planned_braking(robot), robot.max_speed};
    plan.next_velocity =
        advance(robot.model, limits, state, plan, planner.options().time_step).next.velocity;
  } else {
    plan.next_velocity = advance({{}, robot.velocity}, plan, step_response(planner)).next.velocity;
  }
  return plan;
}

}  // namespace

Plan Planner::plan(const Robot& robot, std::span<const Neighbor> neighbors,
                   PlanWorkspace& workspace, Detour* detour, std::span<const Wall> walls) const {
  if (is_rest(robot.velocity) && robot.velocity != Vec2{})
    return plan(at_rest(robot), neighbors, workspace, detour, walls);
  Detour next = detour != nullptr && is_sound(*detour) ? *detour : Detour{};
  Plan plan;
  PlanWorkspace::Scratch& scratch = PlanWorkspace::Scratch::of(workspace);
  Tile& tile = scratch.alone;
  tile.clear();
  const bool walls_valid =
      std::all_of(walls.begin(), walls.end(), [](const Wall& wall) { return is_valid(wall); });
  const bool robot_valid = is_valid(robot) && follows_heading(robot);
  const auto listed = robot_valid && walls_valid ? take_neighbors(robot, neighbors, scratch)
                                                 : std::optional<Neighbors>{};
  if (listed) {
    StageClock clock;
    tile.robots.reserve(1);
    tile.robots.add(robot, *listed);
    tile.detour.push_back(&next);
    tile.plan.push_back(&plan);
    tile.slot.push_back(0);
    tile.remembers = detour != nullptr;
    if (!walls.empty()) tile.walls.push_back(walls);
    plan_together(*this, tile, scratch, clock);
    if (plan.neighbor >= 0)  // of the order in which it was planned with
      plan.neighbor =
          index_in(neighbors, tile.robots.neighbors[0][static_cast<std::size_t>(plan.neighbor)]);
  } else {
    plan = brake(*this, robot, PlanStatus::invalid_input, 0.0);
  }
  if (detour != nullptr) *detour = next;
  return with_next_velocity(*this, robot, plan);
}

Plan Planner::plan_among_obstacles(const Robot& robot, std::span<const Neighbor> obstacles,
                                   PlanWorkspace& workspace) const {
  Robot steering = is_rest(robot.velocity) ? at_rest(robot) : robot;
  if (is_valid(robot)) steering.preferred_velocity = steered(robot, approach_of(options_));
  if (options_.method == Method::buffered_voronoi) {
    std::vector<Neighbor>& movers = PlanWorkspace::Scratch::of(workspace).movers;
    movers.assign(obstacles.begin(), obstacles.end());
    for (Neighbor& mover : movers) {
      if (!is_valid(mover)) continue;  // as it is, for plan() to refuse
      if (mover.behavior == Behavior::decides) mover.acceleration = {}, mover.max_deviation = 0.0;
      mover.behavior = Behavior::moves_on;
    }
    return plan(robot, movers, workspace);
  }
  const Plan plan =
      decide_among_obstacles(*this, steering, obstacles, {}, PlanWorkspace::Scratch::of(workspace));
  return with_next_velocity(*this, robot, as_followed(*this, robot, plan));
}

}  // namespace avo
