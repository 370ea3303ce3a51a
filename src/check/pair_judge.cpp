// SPDX-License-Identifier: Apache-2.0
#include "check/pair_judge.h"

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <string>
#include <tuple>
#include <vector>

#include "avo/error.h"
#include "check/counts.h"
#include "check/kinematics.h"
#include "core/plane.h"

namespace avo::judge {
namespace {

// A robot is at rest up to this part of max_speed (of 1 m/s where there is none).
constexpr double kAtRest = 1e-9;
constexpr std::size_t kMostPairs = 10'000'000;

std::uint64_t key(std::int64_t a, std::int64_t b) {
  return static_cast<std::uint64_t>(a) << 32U | static_cast<std::uint64_t>(b);
}

double overlap_distance(const MovingDisc& a, const MovingDisc& b, const JudgedStep& step) {
  return (a.radius + b.radius) * (1.0 - step.relative_tolerance) - a.error - b.error;
}

// s: the time of a fraction of the step, for this pair.
double instant(const MovingDisc& a, const MovingDisc& b, const JudgedStep& step, double fraction) {
  return step.from + (end_only(a, b) ? 1.0 : fraction) * step.duration;
}

// Call it before the pair is added.
template <typename Pairs>
void require_room(const Pairs& pairs, std::uint64_t pair) {
  if (pairs.size() >= kMostPairs && !pairs.contains(pair))
    throw Error("found more than " + std::to_string(kMostPairs) + " overlapping pairs");
}

}  // namespace

void PairJudge::meet_robots(const MovingDisc& a, const MovingDisc& b, const JudgedStep& step) {
  const auto path = relative_pieces(a, b, step.duration);
  const double contact = a.radius + b.radius, limit = overlap_distance(a, b, step);
  const std::uint64_t pair = key(a.index, b.index);
  const double best = least_clearance_.value_or(kInfinity);
  // the rows themselves are not interpolated
  const double at_start = norm(path.piece(0).control.front());
  const double at_rows = std::min(at_start, norm(a.to - b.to));
  const double row_limit = contact * (1.0 - step.relative_tolerance);
  const double known = overlapping_.contains(pair) ? row_limit - overlaps_.worst : row_limit;
  if (lower_bound(path) > std::max(contact + best, known) * (1.0 + 1e-12)) return;
  const Instant nearest = nearest_instant(path);
  least_clearance_ = std::min(best, nearest.distance - contact);
  const double depth = std::max(limit - nearest.distance, row_limit - at_rows);
  if (!(depth > 0.0)) return;
  require_room(overlapping_, pair);
  overlapping_.insert(pair);
  CheckViolation overlap{step.from, a.index, b.index, depth};
  overlaps_.worst = std::max(overlaps_.worst, overlap.amount);
  if (overlaps_.first && overlaps_.first->time < step.from) return;
  const double first_row = at_start < row_limit ? 0.0 : 1.0;
  const double instant_seen = at_rows < row_limit ? first_row : nearest.fraction;
  overlap.time =
      instant(a, b, step, std::min(first_below(path, limit).value_or(instant_seen), instant_seen));
  note(overlaps_, overlap);
}

// A robot that moves at all in a step rests only at single instants of it. So the first and the
// last instant of the contact suffice.
void PairJudge::meet_mover(const MovingDisc& robot, const MovingDisc& other, const JudgedStep& step,
                           Contacts& contacts) {
  const auto path = relative_pieces(robot, other, step.duration);
  const double limit = overlap_distance(robot, other, step);
  if (lower_bound(path) > limit) return;
  const double nearest = nearest_instant(path).distance;
  if (!(nearest < limit)) return;
  const std::uint64_t pair = key(robot.index, other.index);
  require_room(contacts.hits, pair);
  const double first = first_below(path, limit).value_or(0.0);
  const double last = last_below(path, limit).value_or(1.0);
  const double time = instant(robot, other, step, first);
  CheckedHit& hit =
      contacts.hits.try_emplace(pair, CheckedHit{time, robot.index, other.index}).first->second;
  hit.depth = std::max(hit.depth, limit - nearest);
  const double at_rest = kAtRest * speed_scale(step.robots[static_cast<std::size_t>(robot.index)]);
  if (!(speed_bound(robot, first, last, step.duration) > at_rest)) return;
  if (!hit.moved) ++contacts.in_motion.count;
  hit.moved = true;
  note(contacts.in_motion, {time, robot.index, other.index, limit - nearest});
}

void PairJudge::meet(const MovingDisc& a, const MovingDisc& b, const JudgedStep& step) {
  if (a.is_mover) return;                         // then both are
  if (!b.is_mover && a.index == b.index) return;  // two discs of one robot
  if (b.is_mover) return meet_mover(a, b, step, with_movers_);
  switch (duty(step.robots[static_cast<std::size_t>(a.index)],
               step.robots[static_cast<std::size_t>(b.index)])) {
    case Duty::nobody:
      return;
    case Duty::first:
      return meet_mover(a, b, step, one_sided_);
    case Duty::second:
      return meet_mover(b, a, step, one_sided_);
    case Duty::both:
      return meet_robots(a, b, step);
  }
}

double PairJudge::reach() const {
  const double unmet = kinds_.mutual ? kInfinity : 0.0;
  return std::max(least_clearance_.value_or(unmet), 0.0);
}

void PairJudge::write(CheckReport& report) const {
  const auto at_rest = [](const Contacts& contacts) {
    return std::ssize(contacts.hits) - contacts.in_motion.count;
  };
  report.overlaps = overlaps_;
  report.overlaps.count = std::ssize(overlapping_);
  report.mover_contacts_moving = with_movers_.in_motion;
  report.mover_contacts_at_rest = at_rest(with_movers_);
  report.mover_hits = listed(with_movers_.hits);
  report.one_sided_contacts_moving = one_sided_.in_motion;
  report.one_sided_contacts_at_rest = at_rest(one_sided_);
  report.one_sided_hits = listed(one_sided_.hits);
  report.least_clearance = least_clearance_;
}

}  // namespace avo::judge
