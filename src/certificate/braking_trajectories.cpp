// SPDX-License-Identifier: Apache-2.0
// Braking trajectories: the constraints of neighbors.
#include "certificate/braking_trajectories.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

#include "certificate/discs.h"
#include "certificate/kernels.h"
#include "certificate/take_off.h"

namespace avo::inline certificate {
namespace {

using Real = scalar::Pack<double>;

// The radius of a disc that covers a footprint may have been rounded to a float.
constexpr double kCoverRounding = 1.0 + 1e-5;

// For a pair that nearly coincides, drops the intervals on which the direction between the two is
// unknown. There they are not apart, or errors hide it. In a crowd these intervals would refuse all
// but braking, for ever.
void drop_undirected(std::size_t first, ConstraintColumns& columns) {
  for (std::size_t k = first; k < columns.count; ++k) {
    const bool has_direction = columns.normal[0][k] != 0.0 || columns.normal[1][k] != 0.0;
    if (!has_direction || columns.cone[k] > 0.0) columns.needs[k] = kNoConstraint;
  }
}

void collect_pair(const BrakingPair& pair, const Neighbor& neighbor, int index, const StepLaw& law,
                  TrajectoryConstraints& constraints, Invariant& invariant) {
  const double infinity = std::numeric_limits<double>::infinity();
  const bool is_followed = !pair.decides && neighbor.trajectory != nullptr;
  const double inflation =
      pair.decides || is_followed ? 0.0 : parabola_error(neighbor.acceleration, law);
  const double inflated = pair.inflated + inflation;
  PairConstraints wanted{
      pair,
      neighbor,
      index,
      static_cast<std::size_t>(std::max(pair.a.intervals, pair.b.intervals)),
      inflated,
      inflated,
      pair.decides ? infinity
                   : braking_steps_at_least(pair.a.profile.speed, pair.a.profile.decrement),
      pair.decides && law.has_free_clocks()};
  if (is_followed) {
    constraints.trajectory.begin(*neighbor.trajectory, neighbor.trajectory_time, neighbor.position,
                                 law.time_step);
    constraints.trajectory.look_ahead(wanted.intervals);
    wanted.trajectory = &constraints.trajectory;
  }
  const std::size_t first = constraints.columns.count;
  constraints.columns.reserve(first + wanted.intervals);
  const double nearest =
      append_constraints(wanted, law, constraints.own_columns, constraints.columns);
  wanted.held = held_distance(pair, nearest, index, invariant) + inflation;
  if (inflation > 0.0 && nearest < pair.contact + pair.error + inflation) invariant.doubtful = true;
  if (!wanted.is_free) {
    if (constraints.columns.count > first) hold(wanted, first, constraints.columns);
  } else if (wanted.held != inflated) {
    constraints.columns.count = first;
    append_constraints(wanted, law, constraints.own_columns, constraints.columns);
  }
  if (pair.decides && nearest < pair.contact - pair.error && nearly_coincide(nearest, pair.contact))
    drop_undirected(first, constraints.columns);
  if (!pair.decides && nearest < pair.contact - pair.error) invariant.touched = true;
  if (!pair.decides || !law.is_exact()) take_off(wanted, first, law, constraints);
}

StepLaw law_against(const Neighbor& neighbor, const StepLaw& law) {
  StepLaw result = law;
  result.sensing_error = error_against(neighbor, law);
  return result;
}

// Collects the constraints if the pair can refuse a candidate.
void collect_close(const BrakingPair& pair, const Neighbor& neighbor, std::size_t index,
                   const StepLaw& law, TrajectoryConstraints& constraints, Invariant& invariant) {
  const double most = std::max(pair.a.intervals, pair.b.intervals);
  if (!(most <= kMostIntervals)) {
    invariant.unknown = true;
    return;
  }
  const auto intervals = static_cast<std::size_t>(most);
  if (intervals > constraints.own_columns.count) {
    constraints.own_columns.count = intervals;
    constraints.own_columns.reserve(intervals);
    fill_own(pair.a, constraints.deviation, law, constraints.own_columns);
  }
  collect_pair(pair, neighbor, static_cast<int>(index), law, constraints, invariant);
}

void collect_near(const NearPair& near, const StepLaw& law, TrajectoryConstraints& constraints,
                  Invariant& invariant) {
  constexpr static Neighbor kDecides;  // the pair has all its data that matter
  collect_close(near.with(constraints.own), kDecides, near.neighbor, law, constraints, invariant);
}

}  // namespace

void begin_trajectories(const Robot& robot, const Neighbors& neighbors, const NearPairs& near,
                        std::size_t i, const StepLaw& law, TrajectoryConstraints& constraints,
                        Invariant& invariant) {
  constraints.columns.count = constraints.columns.tested = 0;
  constraints.own_columns.count = constraints.own_columns.filled = 0;
  constraints.stays_at_rest = constraints.has_cones = false;
  constraints.waiting.clear();
  const bool has_others = near.has_others[i] != 0;
  if (near.of(i).empty() && !has_others) return;
  constraints.own = near.own.braking(i);
  constraints.deviation = near.own.deviation(i);
  for (const NearPair& pair : near.of(i)) constraints.waiting.push_back(&pair);
  if (has_others)
    collect_one_by_one({robot, robot}, neighbors, Selected::left_out, law, constraints, invariant);
}

namespace {

// Collects the constraints of one disc of a neighbor, towards the robot or one disc of it.
void collect_disc(const OneDisc& self, const Neighbor& other, double other_lever, std::size_t index,
                  const StepLaw& law, TrajectoryConstraints& constraints, Invariant& invariant) {
  BrakingPair pair = braking_pair(self.disc, other, constraints.own, law);
  pair.inflated += rounding_of_discs(pair, self.lever, other_lever);
  const double nearest = pair.contact + law.sensing_error.position;
  if (!pair.decides && norm(pair.p) < nearest) invariant.touched = true;
  collect_close(pair, other, index, law, constraints, invariant);
}

// Returns whether the lanes have the constraints of this neighbor, or others have them.
bool is_elsewhere(const Neighbor& neighbor, Selected selected) {
  if (neighbor.behavior != Behavior::decides) return false;
  if (neighbor.loiter) return true;
  return selected == Selected::left_out && !has_errors_of_its_own(neighbor) && !neighbor.footprint;
}

}  // namespace

void collect_one_by_one(const OneDisc& self, const Neighbors& neighbors, Selected selected,
                        const StepLaw& law, TrajectoryConstraints& constraints,
                        Invariant& invariant) {
  for (std::size_t k = 0; k < neighbors.size(); ++k) {
    const Neighbor other = neighbors[k];
    if (is_elsewhere(other, selected)) continue;
    const StepLaw pair_law = has_errors_of_its_own(other) ? law_against(other, law) : law;
    BrakingPair whole = braking_pair(self.robot, other, constraints.own, pair_law);
    if (self.lever != 0.0 || has_discs(other)) whole.inflated *= kCoverRounding;
    if (cannot_meet(whole, other, pair_law)) continue;
    for (int l = 0; l < disc_count(other); ++l)
      collect_disc(self, disc_of(other, l), has_discs(other) ? other.footprint.ahead(l) : 0.0, k,
                   pair_law, constraints, invariant);
  }
}

void collect_refusing(const Robot& robot, const CandidatePath& path, const StepLaw& law,
                      TrajectoryConstraints& constraints, Invariant& invariant) {
  if (constraints.waiting.empty()) return;
  double ahead = constraints.deviation.most_ahead, aside = constraints.deviation.most_aside;
  if (is_holonomic(robot.model)) {
    const auto deviation = scalar::candidate_deviation(
        scalar::constant<Real>(constraints.own), scalar::constant<Real>(path.next_velocity), law);
    ahead = deviation.ahead.value, aside = deviation.aside.value;
  }
  std::size_t left = 0;
  for (const NearPair* pair : constraints.waiting) {
    if (pair->gap > pair->against * ahead + aside) {
      constraints.waiting[left++] = pair;
    } else {
      collect_near(*pair, law, constraints, invariant);
    }
  }
  constraints.waiting.resize(left);
}

void collect_waiting(const StepLaw& law, TrajectoryConstraints& constraints, Invariant& invariant) {
  for (const NearPair* pair : constraints.waiting) collect_near(*pair, law, constraints, invariant);
  constraints.waiting.clear();
}

}  // namespace avo::inline certificate
