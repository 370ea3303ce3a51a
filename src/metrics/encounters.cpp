// SPDX-License-Identifier: Apache-2.0
#include "metrics/encounters.h"

#include <algorithm>
#include <limits>

#include "avo/velocity_obstacle.h"
#include "core/plane.h"
#include "metrics/wall_contacts.h"

namespace avo::inline metrics {
namespace {

constexpr double kSurely = 1.0 + 1e-9;  // of lengths
constexpr double kAtRest = 1e-9;        // of max_speed: a slower robot is at rest

// Which of two robots avoid the other.
enum class Avoidance : unsigned char { none, one_sided, mutual };
Avoidance avoidance(const RobotSetup& a, const RobotSetup& b) {
  if (&a == &b) return Avoidance::none;  // two discs of one robot
  const bool of_a = avoids(a, b), of_b = avoids(b, a);
  if (of_a && of_b) return Avoidance::mutual;
  return of_a || of_b ? Avoidance::one_sided : Avoidance::none;
}

// Smallest distance of the centers over the step.
double distance(const Body& a, const Body& b, double cutoff, const StepSpan& step) {
  if (!step.response || !a.exact || !b.exact)
    return separation_of(a, b, step.duration, cutoff).distance;
  const Pair pair{a.position - b.position, a.velocity - b.velocity, a.radius + b.radius};
  const Obstacle obstacle{pair, *step.response, step.duration};
  return closest_approach(obstacle, pair.velocity + (a.w - b.w)).distance;
}

// Returns whether the robot moves within the step.
bool moves(const Body& robot, const StepSpan& step) {
  return path_length(robot) > kAtRest * robot.setup->max_speed * step.duration;
}

// Returns whether the two are surely farther apart than that, m, all the time: a curve lies in the
// hull of its control points, see lower_bound().
bool stay_apart(const StepPath& a, const StepPath& b, double distance) {
  const Vec2 towards = a.control[0] - b.control[0];
  double least = norm_squared(towards);
  const double most = kSurely * distance * distance * least;
  for (std::size_t k = 1; k < 4; ++k)
    least = std::min(least, dot(towards, a.control[k] - b.control[k]));
  return least > 0.0 && least * least > most;
}

// Returns whether the paths are exact, and not interpolations.
bool is_known(const Sweep& a, const Sweep& b, const StepSpan& step) {
  return !step.response && !a.turns && !b.turns;
}

// m: the clearance of any pair bounds the smallest one; this takes the first robot that avoids
// another and its nearest such robot.
std::optional<double> any_clearance(std::span<const Sweep> sweeps,
                                    const std::function<Body(std::size_t)>& body) {
  std::optional<double> nearest;
  for (std::size_t i = 0; i < sweeps.size() && !nearest; ++i) {
    const Body a = body(i);
    for (std::size_t j = i + 1; j < sweeps.size(); ++j) {
      const Body b = body(j);
      if (avoidance(*a.setup, *b.setup) != Avoidance::mutual) continue;
      const double clearance = norm(b.position - a.position) - a.radius - b.radius;
      nearest = std::min(nearest.value_or(clearance), clearance);
    }
  }
  return nearest;
}

// The number of distinct names; it reorders them.
std::int64_t count_distinct(std::vector<std::uint64_t>& names) {
  std::sort(names.begin(), names.end());
  return std::unique(names.begin(), names.end()) - names.begin();
}

}  // namespace

void Encounters::meet(const Body& a, const Body& b, const StepSpan& step) {
  const double contact = a.radius + b.radius;
  const Avoidance kind = avoidance(*a.setup, *b.setup);
  if (kind == Avoidance::none) return;
  if (kind == Avoidance::one_sided) {
    if (!(distance(a, b, contact, step) < contact * (1.0 - kContact))) return;
    const std::pair pair = std::minmax(a.name, b.name);
    const Body& avoiding = avoids(*a.setup, *b.setup) ? a : b;
    one_sided.insert(pair);
    if (moves(avoiding, step)) one_sided_in_motion.insert(pair);
    overlapping.push_back(avoiding.name);
    return;
  }
  const double best = min_clearance.value_or(std::numeric_limits<double>::infinity());
  const double d = distance(a, b, contact + std::max(best, 0.0), step);
  if (d - contact < best) min_clearance = d - contact;
  const double overlaps = contact * (1.0 - kContact);
  if (!(d < overlaps)) return;
  collided.insert(std::minmax(a.name, b.name));
  for (const std::uint64_t name : {a.name, b.name}) {
    overlapping.push_back(name);
    colliding_.push_back(name);
  }
  overlap_depth = std::max(overlap_depth, (contact - d) / contact);
  const judge::Instant closest = separation_of(a, b, step.duration, overlaps);
  const bool turns = a.arc || b.arc;  // any time at which they overlap suffices
  const double fraction =
      turns ? closest.fraction : first_below(a.path, b.path, overlaps).value_or(closest.fraction);
  const double time = step.begin + fraction * step.duration;
  first_collision_time = std::min(first_collision_time.value_or(time), time);
}

void Encounters::meet_mover(const Body& robot, const Body& obstacle, const StepSpan& step) {
  const double contact = robot.radius + obstacle.radius;
  if (!(distance(robot, obstacle, contact, step) < contact * (1.0 - kContact))) return;
  const std::pair pair(robot.name, obstacle.name);
  if (with_mover.insert(pair).second) new_hits.push_back(pair);
  touched_by_movers.push_back(robot.name);
  if (moves(robot, step)) with_mover_in_motion.insert({robot.name, obstacle.name});
}

void Encounters::append_company(std::size_t robot, double reach) {
  if (!is_finite(positions_[robot])) return;
  grid_.list_within(positions_[robot], reach, places_);
  for (const std::uint32_t place : places_) {
    const auto other = static_cast<std::uint32_t>(grid_.index(place));
    if (other > robot) company_.other.push_back(other);
  }
}

// Lists robots farther away than this step needs, for some of the next steps. Where robots are
// crowded, or one moves far, none are listed for a while.
void Encounters::list_company(std::uint64_t roster, double need, double farthest) {
  constexpr double kSteps = 16.0;          // of both robots together
  constexpr std::size_t kMostListed = 32;  // a robot
  constexpr int kPause = 32;               // steps
  company_.roster = 0;
  if (company_.pause > 0) {
    --company_.pause;
    return;
  }
  company_.reach = need + kSteps * farthest;
  grid_.build(positions_, company_.reach);
  company_.first.assign(1, 0), company_.other.clear();
  for (std::size_t i = 0; i < positions_.size(); ++i) {
    append_company(i, company_.reach);
    company_.first.push_back(company_.other.size());
    if (company_.other.size() <= kMostListed * positions_.size()) continue;
    company_.pause = kPause;
    return;
  }
  company_.roster = roster;
}

// Meets the robots that can come nearer than the smallest clearance so far, or overlap, nearest
// first.
void Encounters::meet_company(std::span<const Sweep> sweeps, std::size_t robot, double need,
                              std::span<const std::uint32_t> others,
                              const std::function<Body(std::size_t)>& body, const StepSpan& step) {
  const Sweep& a = sweeps[robot];
  const double clearance = std::max(min_clearance.value_or(0.0), 0.0);
  near_.clear();
  for (const std::uint32_t other : others) {
    const Sweep& b = sweeps[other];
    const double squared = norm_squared(b.path.control[0] - a.path.control[0]);
    if (!(squared <= need * need)) continue;
    if (!is_known(a, b, step) || !stay_apart(a.path, b.path, a.radius + b.radius + clearance))
      near_.emplace_back(squared, other);
  }
  if (near_.empty()) return;
  std::sort(near_.begin(), near_.end());
  std::optional<Body> own;
  for (const auto& [squared, other] : near_) {
    if (is_known(a, sweeps[other], step) && changes_nothing(a, sweeps[other])) continue;
    if (!own) own = body(robot);
    meet(*own, body(other), step);
  }
}

// Returns whether the two neither touch nor come nearer than any pair before, by the distance that
// meet() finds.
bool Encounters::changes_nothing(const Sweep& a, const Sweep& b) const {
  if (!min_clearance) return false;
  const double contact = a.radius + b.radius;
  const double d = separation(a.path, b.path, contact + std::max(*min_clearance, 0.0)).distance;
  return d >= contact && d - contact >= *min_clearance;
}

void Encounters::meet_movers(std::span<const Sweep> sweeps,
                             const std::function<Body(std::size_t)>& body,
                             const std::vector<Body>& obstacles, const StepSpan& step) {
  for (const Body& obstacle : obstacles) {
    for (const NeighborHit& hit : grid_.gather(obstacle.position, -1, sweeps.size(), scratch_))
      meet_mover(body(static_cast<std::size_t>(hit.index)), obstacle, step);
  }
}

void Encounters::observe(std::span<const Sweep> sweeps,
                         const std::function<Body(std::size_t)>& body, std::uint64_t roster,
                         const std::vector<Body>& obstacles, const StepSpan& step) {
  overlapping.clear();
  touched_by_movers.clear();
  new_hits.clear();
  colliding_.clear();
  double largest = 0.0, farthest = 0.0;  // radius and displacement of a step, m
  for (const Sweep& sweep : sweeps) {
    largest = std::max(largest, sweep.radius);
    farthest = std::max(farthest, path_length(sweep.path));
  }
  company_.reach -= 2.0 * farthest_;  // of the step before
  if (!min_clearance) min_clearance = any_clearance(sweeps, body);
  farthest_ = farthest;
  for (const Body& obstacle : obstacles) {
    largest = std::max(largest, obstacle.radius);
    farthest = std::max(farthest, path_length(obstacle));
  }
  const double clearance = std::max(min_clearance.value_or(0.0), 0.0);
  const double need = 2.0 * largest + clearance + 2.0 * farthest;
  const bool is_listed = company_.roster == roster && company_.first.size() == sweeps.size() + 1 &&
                         company_.reach > kSurely * need && obstacles.empty();
  if (!is_listed) {
    positions_.clear();
    for (const Sweep& sweep : sweeps) positions_.push_back(sweep.path.control[0]);
    company_.roster = 0;
    if (obstacles.empty()) list_company(roster, need, farthest_);
    if (company_.roster == 0) grid_.build(positions_, need);
  }
  for (std::size_t i = 0; i < sweeps.size(); ++i) {
    std::span<const std::uint32_t> others = company_.other;
    if (company_.roster == 0) {
      company_.other.clear();
      append_company(i, need);
      others = company_.other;
    } else {
      others = others.subspan(company_.first[i], company_.first[i + 1] - company_.first[i]);
    }
    if (!others.empty()) meet_company(sweeps, i, need, others, body, step);
  }
  meet_movers(sweeps, body, obstacles, step);
  if (step.moves) collision_robot_steps += count_distinct(colliding_);
}

}  // namespace avo::inline metrics
