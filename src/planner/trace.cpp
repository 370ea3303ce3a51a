// SPDX-License-Identifier: Apache-2.0
// The stages of a decision. Their velocities are read from what the decision has left in its
// workspace. Which rule, neighbors and walls have caused them is derived from the same data, and
// the certificate is asked once more about the proposal.
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "avo/decision_trace.h"
#include "avo/planner.h"
#include "planner/options.h"
#include "planner/rules/arrival.h"
#include "planner/rules/evasion.h"
#include "planner/scratch.h"
#include "planner/stages/certify.h"
#include "planner/stages/contact.h"
#include "robots/footprint.h"
#include "robots/model.h"

namespace avo::inline planner {
namespace {

constexpr double kOnLine = 1e-7;   // m/s; programs are exact to less
constexpr double kTurned = 1e-10;  // of a length

// The workspace of a decision, and what the decision was given.
struct Decided {
  const Planner& planner;
  const Robot& robot;  // with the velocity and the preferred velocity that were used
  std::span<const Neighbor> given;
  std::span<const Wall> walls;
  const Detour* detour;  // after the decision; none where nothing is remembered
  PlanWorkspace::Scratch& scratch;

  // The index into the neighbors given, of the k-th in the order of planning.
  int given_index(std::size_t k) const {
    return index_in(given, scratch.alone.robots.neighbors[0][k]);
  }
};

void add(std::vector<Cause>& causes, Cause cause) {
  if (std::find(causes.begin(), causes.end(), cause) == causes.end()) causes.push_back(cause);
}

// off: m/s, by how much v misses the half-planes that bind.
bool is_on_line(const HalfPlane& plane, Vec2 v, double off = 0.0) {
  return std::abs(violation(plane, v) - off) <= kOnLine;
}

// The weight with which the robot yields to a neighbor beside it (docs/arrival.md).
double push_weight(const Robot& robot, const Neighbor& neighbor) {
  const double contact = robot.radius + neighbor.radius;
  const double distance = norm(robot.position - neighbor.position);
  if (!(distance > 0.0 && distance < (1.0 + kRoom) * contact)) return 0.0;
  return norm(push_of(robot, neighbor));
}

// The weight of a neighbor ahead, within the range of the rule, falls with the distance.
double ahead_weight(const Robot& robot, const Neighbor& neighbor, double range) {
  const Vec2 towards = neighbor.position - robot.position;
  const double distance = norm(towards);
  const bool is_ahead =
      dot(towards, robot.preferred_velocity) > kInFront * distance * norm(robot.preferred_velocity);
  return is_ahead && distance > 0.0 && distance < range ? 1.0 / distance : 0.0;
}

// The neighbor of the greatest weight, of those that the decision counts.
template <typename Weight>
int heaviest(const Decided& decided, const Weight& weight) {
  const Neighbors& neighbors = decided.scratch.alone.robots.neighbors[0];
  int heaviest = -1;
  double most = 0.0;
  for (std::size_t k = 0; k < neighbors.size(); ++k) {
    const double own = weight(decided.robot, neighbors[k]);
    if (own > most) most = own, heaviest = decided.given_index(k);
  }
  return heaviest;
}

// Returns whether b is a, or a turned: keeping right changes no length, and pushes do.
bool is_turned(Vec2 a, Vec2 b) {
  return std::abs(norm(a) - norm(b)) <= kTurned * norm(a);
}

bool is_out_of_wall(const Decided& decided) {
  return decided.scratch.demands.out != Vec2{};
}

void trace_wish(const Decided& decided, DecisionTrace& trace) {
  const DecisionColumns& decisions = decided.scratch.decisions;
  trace.wish = decisions.wish(0);
  const bool steers = decided.robot.preferred_velocity != trace.preferred_velocity;
  trace.rule = steers ? WishRule::steers : WishRule::none;
  if (trace.wish == decided.robot.preferred_velocity) return;
  if (is_out_of_wall(decided)) {
    trace.rule = WishRule::leaves_wall;
    return;
  }
  if (method_traits(decided.planner.options().method).stays_in_cell) {
    trace.rule = WishRule::in_cell;
    return;
  }
  const Detour* detour = decided.detour;
  const double arrival_distance = decided.planner.options().arrival_distance;
  if (detour != nullptr && settles(decided.robot, *detour, arrival_distance)) {
    trace.rule = WishRule::settles;
  } else {
    const bool keeps_right = is_turned(decided.robot.preferred_velocity, trace.wish);
    trace.rule = keeps_right ? WishRule::keeps_right : WishRule::yields;
  }
  const double range = decisions.range[0];
  const auto ahead = [range](const Robot& robot, const Neighbor& neighbor) {
    return ahead_weight(robot, neighbor, range);
  };
  trace.heeded = trace.rule == WishRule::keeps_right ? heaviest(decided, ahead)
                                                     : heaviest(decided, push_weight);
}

void trace_half_planes(const Decided& decided, DecisionTrace& trace) {
  const auto& [planner, robot, given, walls, detour, scratch] = decided;
  const SoftPlanes& soft = scratch.soft;
  const std::span<const HalfPlane> planes = soft.of(0);
  double off = 0.0;
  for (const HalfPlane& plane : planes) off = std::max(off, violation(plane, trace.target));
  for (std::size_t k = 0; k < planes.size(); ++k) {
    if (is_on_line(planes[k], trace.target, off))
      add(trace.binding, {decided.given_index(soft.neighbor_of(k)), -1});
  }
  WallPlanes of_walls;
  planner.collect_half_planes(robot, walls, of_walls);
  const PlannerOptions& options = planner.options();
  const bool by_speed = slows_before_walls(options.method);
  for (const WallPlane& plane : by_speed ? of_walls.speeds : of_walls.obstacles) {
    if (is_on_line(plane.plane, trace.target)) add(trace.binding, {-1, plane.wall});
  }
  std::vector<HalfPlane> own;
  append_own_half_planes(
      robot, adopts_at_once(options.method) ? options.time_step : options.control_time, own);
  for (const HalfPlane& plane : own) {
    if (is_on_line(plane, trace.target)) add(trace.binding, {});
  }
}

void trace_program(const Decided& decided, DecisionTrace& trace) {
  const DecisionColumns& decisions = decided.scratch.decisions;
  trace_wish(decided, trace);
  trace.aim = decisions.aim(0);
  trace.target = trace.proposal = decisions.target(0);
  if (trace.target != trace.aim) trace_half_planes(decided, trace);
  if (goes_through_certificate(decided.planner.options()))
    trace.proposal = {decisions.next_x[0], decisions.next_y[0]};
}

void trace_union(const Decided& decided, DecisionTrace& trace) {
  const PlanWorkspace::Scratch& scratch = decided.scratch;
  trace.wish = trace.aim = decided.robot.preferred_velocity;
  if (trace.wish != trace.preferred_velocity) trace.rule = WishRule::steers;
  if (!scratch.passive_choice) return;
  trace.target = trace.proposal = *scratch.passive_choice;
  for (std::size_t k = 0; k < scratch.obstacles.size() && trace.target != trace.aim; ++k) {
    const PassiveObstacle& obstacle = scratch.obstacles[k];
    if (contains(obstacle.obstacle, trace.aim - obstacle.v_new_B))
      add(trace.binding, {decided.given_index(k), -1});
  }
}

// The neighbors and walls that refuse, by their constraints, the path that was last judged.
void add_refusing(const Decided& decided, const TrajectoryConstraints& constraints,
                  const CandidatePath& path, const StepLaw& law, std::vector<Cause>& refusing) {
  const ConstraintColumns& columns = constraints.columns;
  for (std::size_t first = 0; first < columns.count;) {
    std::size_t last = first;
    while (last < columns.count && columns.neighbor[last] == columns.neighbor[first]) ++last;
    const WorstConstraint worst = worst_constraint(constraints, path, law, first, last);
    if (worst.coefficient < 0.0)
      add(refusing, {decided.given_index(static_cast<std::size_t>(columns.neighbor[first])), -1});
    first = last;
  }
}

// Returns whether a wall refuses the judged path of the robot, or of one of its discs.
bool refuses(const Wall& wall, const Decided& decided, const StepLaw& law) {
  const CertificateConstraints& own = decided.scratch.certified.constraints;
  WallConstraints alone;
  if (own.footprint.count == 0) {
    begin_walls(decided.robot, {&wall, 1}, law, alone);
    return !keeps_walls(alone, own.path, law);
  }
  FootprintConstraints footprint;
  begin_disc_walls(decided.robot, {&wall, 1}, law, footprint, alone);
  for (std::size_t k = 0; k < footprint.count; ++k)
    if (!keeps_walls(footprint.discs[k].walls, own.footprint.discs[k].path, law)) return true;
  return false;
}

std::vector<Cause> list_refusing(const Decided& decided, const StepLaw& law) {
  std::vector<Cause> refusing;
  const CertificateConstraints& own = decided.scratch.certified.constraints;
  add_refusing(decided, own.trajectories, own.path, law, refusing);
  for (const DiscConstraints& disc : own.footprint.all())
    add_refusing(decided, disc.trajectories, disc.path, law, refusing);
  for (const LoiterLine& line : own.loiterers) {
    if (!keeps_loiterers({&line, 1}, own.path, law))
      add(refusing, {decided.given_index(static_cast<std::size_t>(line.neighbor)), -1});
  }
  for (std::size_t k = 0; k < decided.walls.size(); ++k)
    if (refuses(decided.walls[k], decided, law)) add(refusing, {-1, static_cast<int>(k)});
  return refusing;
}

// Those that refuse a velocity after the step; none where it is admitted.
std::vector<Cause> refusing(const Decided& decided, Vec2 next_velocity) {
  const CertificateLaw law = certificate_law(decided.planner);
  if (law.kind == Certificate::none) return {};
  Robot asked = decided.robot;
  if (asked.velocity == Vec2{} && turns_unnoticed(asked.model)) asked.model = Holonomic{};
  if (!is_holonomic(asked.model))
    next_velocity = within_own_limits(asked, law.step.braking_time, next_velocity);
  if (admits(asked, next_velocity, law, decided.scratch.certified.constraints, Asked::all))
    return {};
  return list_refusing(decided, law.step);
}

void trace_certificate(const Decided& decided, DecisionTrace& trace) {
  const CertifiedWorkspace& certified = decided.scratch.certified;
  if (!certified.proposal) return;
  trace.proposal = *certified.proposal;
  trace.refusing = refusing(decided, trace.proposal);
  trace.detour = certified.detour;
  if (trace.detour) trace.refusing_detour = refusing(decided, *trace.detour);
  // what wheels cannot follow is refused as well
  std::vector<Cause>& last = trace.detour ? trace.refusing_detour : trace.refusing;
  const bool is_refused = trace.plan.status == PlanStatus::refused && !trace.plan.evading;
  if (is_refused && last.empty() && !is_holonomic(decided.robot.model)) last.push_back({});
}

// A robot that flies and may not take the controls for its target: the neighbor with the nearest
// circle.
void trace_flight(const Decided& decided, DecisionTrace& trace) {
  const PlanStatus status = trace.plan.status;
  if (status == PlanStatus::optimal || status == PlanStatus::least_unsafe) return;
  if (trace.plan.evading) return;  // no neighbor has refused its choice
  const FlightConstraints& flight = decided.scratch.flight;
  const auto room = [](const SeparatingLine& line) { return line.part; };
  const auto nearest = std::min_element(
      flight.lines.begin(), flight.lines.end(),
      [&](const SeparatingLine& a, const SeparatingLine& b) { return room(a) < room(b); });
  if (nearest == flight.lines.end()) return;
  add(trace.refusing, {decided.given_index(static_cast<std::size_t>(nearest->neighbor)), -1});
}

void trace_evasion(const Decided& decided, DecisionTrace& trace) {
  EvasionWorkspace& own = decided.scratch.evasion;
  trace.evasion = own.chosen;
  trace.evasion->neighbor = find_evaded(certificate_law(decided.planner), decided.robot,
                                        decided.given, own.put_aside, own);
}

}  // namespace
}  // namespace avo::inline planner

namespace avo {

DecisionTrace Planner::explain(const Robot& robot, std::span<const Neighbor> neighbors,
                               PlanWorkspace& workspace, Detour* detour,
                               std::span<const Wall> walls) const {
  PlanWorkspace::Scratch& scratch = PlanWorkspace::Scratch::of(workspace);
  scratch.demands.clear();
  scratch.certified.proposal.reset(), scratch.certified.detour.reset();
  scratch.passive_choice.reset();
  DecisionTrace trace;
  trace.plan = plan(robot, neighbors, workspace, detour, walls);
  trace.preferred_velocity = trace.wish = trace.aim = robot.preferred_velocity;
  trace.target = trace.proposal = trace.plan.next_velocity;
  if (trace.plan.status == PlanStatus::invalid_input) return trace;
  const RobotColumns& columns = scratch.alone.robots;
  Robot used = robot;
  used.velocity = columns.velocity(0);
  used.preferred_velocity = {columns.preferred_x[0], columns.preferred_y[0]};
  const Decided decided{*this, used, neighbors, walls, detour, scratch};
  if (columns.count == 0) {
    trace_union(decided, trace);
  } else {
    trace_program(decided, trace);
  }
  if (can_rest(robot.model)) {
    trace_certificate(decided, trace);
  } else {
    trace_flight(decided, trace);
  }
  if (trace.plan.evading) trace_evasion(decided, trace);
  return trace;
}

}  // namespace avo
