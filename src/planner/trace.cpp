// SPDX-License-Identifier: Apache-2.0
#include "planner/trace.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <span>
#include <vector>

#include "core/plane.h"
#include "planner/alone.h"
#include "planner/rules/evasion.h"
#include "planner/rules/wishes.h"
#include "planner/scratch.h"
#include "planner/stages/contact.h"
#include "planner/stages/disc_pairs.h"
#include "robots/model.h"

namespace avo::inline planner {
namespace {

constexpr double kOnLine = 1e-7;  // m/s; programs are exact to less

void add(std::vector<Cause>& causes, Cause cause) {
  if (std::find(causes.begin(), causes.end(), cause) == causes.end()) causes.push_back(cause);
}

void add_neighbor(std::vector<Cause>& causes, int neighbor) {
  add(causes, {neighbor, -1});
}

// Returns whether v misses the half-plane by that much, m/s.
bool misses_by(const HalfPlane& plane, Vec2 v, double off) {
  return std::abs(violation(plane, v) - off) <= kOnLine;
}

// The neighbor of the greatest weight; none has less than 0.
template <typename Weight>
int heaviest(const Neighbors& neighbors, const Weight& weight) {
  int heaviest = -1;
  double most = 0.0;
  for (std::size_t k = 0; k < neighbors.size(); ++k) {
    const double own = weight(neighbors[k]);
    if (own > most) most = own, heaviest = static_cast<int>(k);
  }
  return heaviest;
}

// The nearest neighbor ahead, within the range of the rule (m).
int nearest_ahead(const Robot& robot, const Neighbors& neighbors, double range) {
  return heaviest(neighbors, [&](const Neighbor& neighbor) {
    const Vec2 towards = neighbor.position - robot.position, preferred = robot.preferred_velocity;
    const double distance = norm(towards);
    const bool is_ahead = dot(towards, preferred) > kInFront * distance * norm(preferred);
    return is_ahead && distance > 0.0 && distance < range ? 1.0 / distance : 0.0;
  });
}

int strongest_push(const Robot& robot, const Neighbors& neighbors, const StepLaw& law) {
  const Discs discs = discs_of(robot, law);
  return heaviest(neighbors, [&](const Neighbor& neighbor) {
    return norm(push_within(nearest_discs(discs, neighbor)).value_or(Vec2{}));
  });
}

// The demands of walls come first, and then those of the robot's own motion.
void add_binding(const Demands& demands, Vec2 target, std::vector<Cause>& binding) {
  for (std::size_t k = 0; k < demands.planes.size(); ++k)
    if (misses_by(demands.planes[k], target, 0.0))
      add(binding, {-1, k < demands.wall.size() ? demands.wall[k] : -1});
}

void add_refusing(const TrajectoryConstraints& constraints, const CandidatePath& path,
                  const StepLaw& law, std::vector<Cause>& refusing) {
  const ConstraintColumns& columns = constraints.columns;
  for (std::size_t first = 0; first < columns.count;) {
    std::size_t last = first;
    while (last < columns.count && columns.neighbor[last] == columns.neighbor[first]) ++last;
    const WorstConstraint worst = worst_constraint(constraints, path, law, first, last);
    if (worst.coefficient < 0.0) add_neighbor(refusing, static_cast<int>(columns.neighbor[first]));
    first = last;
  }
}

void add_refusing(const WallConstraints& walls, const CandidatePath& path, const StepLaw& law,
                  std::vector<Cause>& refusing) {
  for (const int wall : refusing_walls(walls, path, law)) add(refusing, {-1, wall});
}

// A decision that brakes for contact refuses every motion. The deepest contact is the cause.
void add_broken(const Deepest& neighbor, const Deepest& wall, std::vector<Cause>& refusing) {
  if (!refusing.empty()) return;
  if (neighbor.any()) add_neighbor(refusing, neighbor.index);
  if (wall.any()) add(refusing, {-1, wall.index});
}

}  // namespace

void Recorder::prefers(const RobotColumns& robots) const {
  DecisionTrace& decision = record->decision;
  record->steered = decision.wish = decision.aim = {robots.preferred_x[0], robots.preferred_y[0]};
  if (decision.wish != decision.preferred_velocity) decision.rule = WishRule::steers;
}

void Recorder::wishes(WishRule rule, Vec2 wish, int heeded) const {
  DecisionTrace& decision = record->decision;
  if (wish == decision.wish) return;
  decision.wish = wish, decision.rule = rule, decision.heeded = heeded;
  if (wish != record->steered) return;
  const bool is_steered = wish != decision.preferred_velocity;
  decision.rule = is_steered ? WishRule::steers : WishRule::none, decision.heeded = -1;
}

void Recorder::keeps_right(const RobotColumns& robots, std::size_t i,
                           const DecisionColumns& columns) const {
  wishes(WishRule::keeps_right, columns.wish(i),
         nearest_ahead(robots.robot(i), robots.neighbors[i], columns.range[i]));
}

void Recorder::yields(const RobotColumns& robots, std::size_t i, const StepLaw& law,
                      const PushRule& rule, Vec2 wish) const {
  wishes(rule.settles ? WishRule::settles : WishRule::yields, wish,
         strongest_push(robots.robot(i), robots.neighbors[i], law));
}

void Recorder::stays_in_cell(const Tile& tile, const DecisionColumns& columns) const {
  if (tile.robots.count > 0) wishes(WishRule::in_cell, columns.wish(0));
}

void Recorder::chooses(const Tile& tile, const PlanWorkspace::Scratch& scratch) const {
  if (tile.robots.count == 0) return;
  DecisionTrace& decision = record->decision;
  record->has_target = true;
  if (scratch.demands.out != Vec2{}) wishes(WishRule::leaves_wall, scratch.decisions.wish(0));
  decision.aim = scratch.decisions.aim(0);
  decision.target = decision.proposal = scratch.decisions.target(0);
  if (decision.target == decision.aim) return;
  const std::span<const HalfPlane> planes = scratch.soft.of(0);
  double off = 0.0;
  for (const HalfPlane& plane : planes) off = std::max(off, violation(plane, decision.target));
  for (std::size_t k = 0; k < planes.size(); ++k)
    if (misses_by(planes[k], decision.target, off))
      add_neighbor(decision.binding, static_cast<int>(scratch.soft.neighbor_of(k)));
  add_binding(scratch.demands, decision.target, decision.binding);
}

void Recorder::goes_around(Vec2 target, const PlanWorkspace::Scratch& scratch) const {
  DecisionTrace& decision = record->decision;
  record->has_target = true;
  decision.target = decision.proposal = target;
  if (target == decision.aim) return;
  for (std::size_t k = 0; k < scratch.obstacles.size(); ++k) {
    const PassiveObstacle& obstacle = scratch.obstacles[k];
    if (contains(obstacle.obstacle, decision.aim - obstacle.v_new_B))
      add_neighbor(decision.binding, static_cast<int>(k));
  }
  add_binding(scratch.demands, decision.target, decision.binding);
}

void Recorder::proposes(Vec2 proposal) const {
  record->decision.proposal = proposal;
}

void Recorder::asks(Vec2 proposal) const {
  record->decision.proposal = proposal;
  record->asked = &record->decision.refusing;
}

void Recorder::asks_off(Vec2 detour) const {
  record->decision.detour = detour;
  record->decision.refusing_detour.clear();
  record->asked = &record->decision.refusing_detour;
}

void Recorder::is_refused(const StepLaw& law, const CertificateConstraints& constraints) const {
  std::vector<Cause>& refusing = *record->asked;
  add_refusing(constraints.trajectories, constraints.path, law, refusing);
  for (const DiscConstraints& disc : constraints.footprint.all())
    add_refusing(disc.trajectories, disc.path, law, refusing);
  for (const LoiterLine& line : constraints.loiterers)
    if (!keeps_loiterers({&line, 1}, constraints.path, law)) add_neighbor(refusing, line.neighbor);
  add_refusing(constraints.walls, constraints.path, law, refusing);
  for (const DiscConstraints& disc : constraints.footprint.all())
    add_refusing(disc.walls, disc.path, law, refusing);
  add_broken(constraints.invariant.broken, constraints.walls.broken, refusing);
}

void Recorder::is_refused(const Robot& robot, const FlightConstraints& constraints,
                          const FlightStep& step) const {
  std::vector<Cause>& refusing = record->decision.refusing;
  for (const SeparatingLine& line : constraints.lines)
    if (!keeps_flight({{line}, {}}, robot, step)) add_neighbor(refusing, line.neighbor);
  for (std::size_t k = 0; k < constraints.walls.size(); ++k)
    if (!keeps_flight({{}, {constraints.walls[k]}}, robot, step))
      add(refusing, {-1, static_cast<int>(k)});
  add_broken(constraints.broken, constraints.broken_wall, refusing);
}

void Recorder::evades(const CertificateLaw& law, const Robot& robot,
                      std::span<const Neighbor> neighbors, EvasionWorkspace& workspace,
                      const Plan& plan) const {
  if (!plan.evading) return;
  record->decision.evasion = workspace.chosen;
  record->decision.evasion->neighbor =
      find_evaded(law, robot, neighbors, workspace.put_aside, workspace);
}

}  // namespace avo::inline planner

namespace avo {
namespace {

// Numbers the neighbors as given, not in the order of planning.
void number_as_given(std::span<const Neighbor> given, const Neighbors& planned,
                     DecisionTrace& trace) {
  const auto number = [&](int& neighbor) {
    if (neighbor >= 0) neighbor = index_in(given, planned[static_cast<std::size_t>(neighbor)]);
  };
  number(trace.heeded);
  for (std::vector<Cause>* causes : {&trace.binding, &trace.refusing, &trace.refusing_detour})
    for (Cause& cause : *causes) number(cause.neighbor);
  if (trace.evasion) number(trace.evasion->neighbor);
}

// What wheels cannot follow is refused as well.
void add_own_motion(const Robot& robot, DecisionTrace& trace) {
  std::vector<Cause>& last = trace.detour ? trace.refusing_detour : trace.refusing;
  const bool is_refused = trace.plan.status == PlanStatus::refused && !trace.plan.evading;
  if (is_refused && last.empty() && !is_holonomic(robot.model)) last.push_back({});
}

}  // namespace

DecisionTrace Planner::explain(const Robot& robot, std::span<const Neighbor> neighbors,
                               PlanWorkspace& workspace, Detour* detour,
                               std::span<const Wall> walls) const {
  TraceRecord record;
  DecisionTrace& trace = record.decision;
  trace.preferred_velocity = trace.wish = trace.aim = robot.preferred_velocity;
  const DecisionTrace undecided = trace;
  PlanWorkspace::Scratch::of(workspace).demands.clear();
  const Plan plan =
      plan_alone(*this, robot, neighbors, workspace, detour, walls, Recorder{&record});
  if (plan.status == PlanStatus::invalid_input) trace = undecided;
  trace.plan = plan;
  if (!record.has_target) trace.target = trace.proposal = plan.next_velocity;
  if (plan.status == PlanStatus::invalid_input) return trace;
  number_as_given(neighbors, PlanWorkspace::Scratch::of(workspace).alone.robots.neighbors[0],
                  trace);
  add_own_motion(robot, trace);
  return trace;
}

std::optional<Evasion> Planner::evasion(const Robot& robot, std::span<const Neighbor> neighbors,
                                        PlanWorkspace& workspace, const Detour* detour,
                                        std::span<const Wall> walls) const {
  Detour next = detour != nullptr ? *detour : Detour{};
  return explain(robot, neighbors, workspace, detour != nullptr ? &next : nullptr, walls).evasion;
}

}  // namespace avo
