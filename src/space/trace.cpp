// SPDX-License-Identifier: Apache-2.0
#include "space/trace.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/ranges.h"
#include "space/arrival.h"
#include "space/evasion.h"
#include "space/mover_planes.h"

namespace avo::space {
namespace {

constexpr double kOnPlane = 1e-7;  // m/s; programs are exact to less

void add(std::vector<Cause>& causes, Cause cause) {
  if (std::find(causes.begin(), causes.end(), cause) == causes.end()) causes.push_back(cause);
}

int number_at(const Bodies& bodies, std::size_t place) {
  return static_cast<int>(bodies.number[place]);
}

// What the rules count of one body ahead, by a look at this body alone.
double ahead_of(const Viewer& look, const Bodies& bodies, std::size_t place) {
  Bodies one;
  one.reserve(1);
  one.add(bodies.neighbor(place), 0);
  fill_braking(look.law, one);
  Viewer alone = look;
  alone.self = -1.0;
  const Run run{0, 1};
  Looked looked;
  look_at(alone, one, {&run, 1}, std::nullopt, looked);
  return looked.ahead;
}

// The nearest neighbor ahead of those that the rule counts.
int nearest_ahead(const Viewer& look, const Bodies& bodies, const SeenColumns& seen) {
  int nearest = -1;
  double least = std::numeric_limits<double>::infinity();  // m²
  for (std::size_t k = 0; k < seen.count; ++k) {
    const double squared = norm_squared(Vec3{seen.p[0][k], seen.p[1][k], seen.p[2][k]});
    const auto place = static_cast<std::size_t>(seen.place[k]);
    if (!(squared < least) || !(ahead_of(look, bodies, place) > 0.0)) continue;
    least = squared, nearest = number_at(bodies, place);
  }
  return nearest;
}

int strongest_push(const Robot& robot, const Bodies& bodies, const Looked& looked,
                   const PushRule& rule) {
  int strongest = -1;
  double most = 0.0;
  Looked alone;
  for (const std::uint32_t place : looked.beside) {
    alone.beside.assign(1, place);
    const Traffic traffic = traffic_of(robot, bodies, alone);
    const double push = norm(rule.moving * traffic.push + rule.at_rest * traffic.push_at_rest);
    if (push > most) most = push, strongest = number_at(bodies, place);
  }
  return strongest;
}

// The bodies that append a half-space each, in the order of the half-spaces.
template <typename Body, typename Append>
std::vector<int> in_order(std::span<const Body> bodies, const Append& append) {
  std::vector<int> order;
  std::vector<HalfSpace> own;
  for (std::size_t k = 0; k < bodies.size(); ++k) {
    own.clear();
    append(bodies.subspan(k, 1), own);
    order.insert(order.end(), own.size(), static_cast<int>(k));
  }
  return order;
}

// Whom the half-spaces of a decision are of, by their numbers.
struct Sources {
  std::vector<int> boxes, movers;
  double hard;

  explicit Sources(const Deciding& decision)
      : hard(static_cast<double>(decision.scratch.hard.count)) {
    const Robot& robot = decision.robot;
    boxes = in_order(decision.around.boxes, [&](std::span<const Box> one, auto& own) {
      append_speed_planes(robot, one, decision.law, own);
    });
    movers = in_order(decision.around.movers, [&](std::span<const Mover> one, auto& own) {
      append_mover_planes(robot, one, decision.options, decision.full_horizon, own);
    });
  }
  // See collect_hard() and all_half_spaces().
  [[nodiscard]] Cause of(double number) const {
    const double robots = static_cast<double>(kMostRobots);
    if (number >= robots) return {-1, -1, movers[static_cast<std::size_t>(number - robots)]};
    if (number >= 0.0) return {static_cast<int>(number), -1, -1};
    const auto climbs = hard - static_cast<double>(boxes.size());
    const double box = number + hard - climbs;
    return box < 0.0 ? Cause{} : Cause{-1, boxes[static_cast<std::size_t>(box)], -1};
  }
};

// The neighbors or moving obstacles with constraints that refuse the path that was tested.
std::vector<int> refusing(const ConstraintColumns& columns) {
  std::vector<int> bodies;
  for (std::size_t k = 0; k < columns.tested; ++k) {
    const int body = static_cast<int>(columns.neighbor[k]);
    if (columns.coefficient[k] < 0.0 && (bodies.empty() || bodies.back() != body))
      bodies.push_back(body);
  }
  return bodies;
}

// A decision that brakes for contact refuses every motion, and so does one beside a body that
// brakes for too long.
void add_broken(const Constraints& constraints, std::vector<Cause>& causes) {
  if (!causes.empty()) return;
  if (constraints.invariant.broken.any()) add(causes, {constraints.invariant.broken.index, -1, -1});
  if (constraints.boxes.broken.any()) add(causes, {-1, constraints.boxes.broken.index, -1});
  if (!constraints.invariant.unknown) return;
  const Bodies& bodies = *constraints.bodies;
  for (std::size_t k = 0; k < bodies.count; ++k)
    if (!(bodies.intervals[k] <= kMostIntervals)) add(causes, {number_at(bodies, k), -1, -1});
  if (causes.empty()) causes.emplace_back();  // it brakes for too long itself
}

}  // namespace

void Recorder::wishes(WishRule rule, Vec3 wish, int heeded) const {
  DecisionTrace& decision = record->decision;
  if (wish == decision.wish) return;
  decision.wish = wish, decision.rule = rule, decision.heeded = heeded;
  if (wish == decision.preferred_velocity) decision.rule = WishRule::none, decision.heeded = -1;
}

void Recorder::keeps_right(const Viewer& look, const Bodies& bodies, const Looked& looked,
                           Vec3 wish) const {
  wishes(WishRule::keeps_right, wish, nearest_ahead(look, bodies, looked.seen));
}

void Recorder::yields(const Robot& robot, const Bodies& bodies, const Looked& looked,
                      const PushRule& rule, Vec3 wish) const {
  wishes(rule.settles ? WishRule::settles : WishRule::yields, wish,
         strongest_push(robot, bodies, looked, rule));
}

void Recorder::chooses(const Deciding& decision, Vec3 own_aim, const Target& target) const {
  DecisionTrace& trace = record->decision;
  trace.aim = decision.in_space(own_aim);
  trace.target = trace.proposal = decision.in_space(target.own);
  const Sources sources(decision);
  const HalfSpaceColumns& all = decision.scratch.half_spaces.columns;
  double off = 0.0;  // m/s, of the soft ones
  for (std::size_t k = 0; k < all.count; ++k) {
    const HalfSpace own = all.at(k);
    const HalfSpace plane = to_own(own, 1.0 / decision.robot.vertical);  // back in space
    trace.half_spaces.push_back({sources.of(all.number[k]), plane.normal, plane.offset});
    if (all.number[k] >= 0.0) off = std::max(off, violation(own, target.own));
  }
  if (target.own == own_aim) return;
  for (std::size_t k = 0; k < all.count; ++k) {
    const double missed = violation(all.at(k), target.own);
    if (std::abs(missed - (all.number[k] < 0.0 ? 0.0 : off)) <= kOnPlane)
      add(trace.binding, trace.half_spaces[k].of);
  }
}

void Recorder::asks(Vec3 proposal) const {
  record->decision.proposal = proposal;
  record->asked = &record->decision.refusing;
}

void Recorder::asks_off(Vec3 detour) const {
  record->decision.detour = detour;
  record->decision.refusing_detour.clear();
  record->asked = &record->decision.refusing_detour;
}

void Recorder::is_refused() const {
  add(*record->asked, {});
}

void Recorder::is_refused(const Robot& robot, Vec3 candidate, const StepLaw& law,
                          Constraints& constraints) const {
  std::vector<Cause>& causes = *record->asked;
  admits(robot, candidate, law, Asked::all, constraints);  // so that all of them are tested
  for (const int neighbor : refusing(constraints.columns)) add(causes, {neighbor, -1, -1});
  for (const int mover : refusing(constraints.movers.columns)) add(causes, {-1, -1, mover});
  for (std::size_t k = 0; k < record->movers.size() && constraints.movers.counts; ++k) {
    MoverConstraints alone;
    begin_movers(robot, record->movers.subspan(k, 1), constraints.own, constraints.own_direction,
                 constraints.deviation, law, alone);
    if (alone.must_rest(constraints.path.moving)) add(causes, {-1, -1, static_cast<int>(k)});
  }
  BoxConstraints alone;
  for (std::size_t k = 0; k < record->boxes.size(); ++k) {
    begin_boxes(robot, record->boxes.subspan(k, 1), law, alone);
    if (!keeps_boxes(robot, candidate, law, alone)) add(causes, {-1, static_cast<int>(k), -1});
  }
  add_broken(constraints, causes);
}

void Recorder::evades(const PlannerOptions& options, const StepLaw& law, const Robot& robot,
                      const Sight& sight, PlanWorkspace::Scratch& scratch) const {
  Evasion evasion = scratch.evasions.chosen;
  evasion.mover = find_evaded(options, law, robot, sight.movers, scratch.evasions.put_aside,
                              scratch.evasions, scratch.choice);
  record->decision.evasion = evasion;
}

}  // namespace avo::space
