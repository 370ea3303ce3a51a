// SPDX-License-Identifier: Apache-2.0
// A* (Hart, Nilsson and Raphael 1968) over places and headings, by short pieces of arcs and of
// straight lines, forward and backwards. Several paths may come to one cell of a lattice with
// nearly the same heading; only the shortest one continues (hybrid A*: Dolgov et al. 2010). From
// each reached place, the last leg to the goal is tried. Arcs end at headings, and straight moves
// at places, that do not depend on the present place of the car. So the next decision also finds
// the rest of the present path.
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "core/plane.h"
#include "robots/maneuver.h"

namespace avo::inline robots {
namespace {

constexpr int kHeadings = 32;  // of a full circle, at which arcs end; a power of two
constexpr int kMostMoves = 6;  // of a path, with the last leg
constexpr double kPiece = 2.0 * std::numbers::pi / kHeadings;  // rad
constexpr double kMostArc = std::numbers::pi;  // rad, of the last leg behind other moves
// times the stopping distance: the distance in which a car comes to rest
constexpr double kEase = 1.25;
// All in radii of the turning circle.
constexpr double kCell = 1.0 / 8.0;         // of the lattice
constexpr double kSideChange = 1.0 / 16.0;  // cost of a change of side, in m of path
// the last leg alone is taken if it is longer by no more than this
constexpr double kDetour = 1.5;
constexpr double kRoomAround = 4.0;  // range of the search for a path

using ManeuverNode = ManeuverMemory::ManeuverNode;
constexpr std::uint32_t kNoNode = ManeuverMemory::kNone;

// In pieces: to the next mark, (0, 1].
double to_mark(double pieces) {
  return std::floor(pieces) + 1.0 - pieces;
}

struct ManeuverSearch {
  const Maneuvering& car;
  ManeuverMemory& memory;
  double best = kInfinity;              // m, the cost of the best path so far
  std::uint32_t before_last = kNoNode;  // start of its last leg; none: the present place of the car
  Move last_move = {};
  ArcLeg last_leg = {};

  // The next move of a path.
  struct Next {
    Move move;
    bool is_first = false;  // of the path
    bool starts = false;    // from rest
    bool same = false;      // the same move as before
    double lead = 0.0;      // m, straight on, before it turns
    Nearness nearness = Nearness::later;
  };
  struct LastLeg {
    double cost = 0.0;  // m, of the whole path
    AxlePose pose;      // after the lead
    ArcLeg leg;
    Next next;
  };

  double left(const AxlePose& pose) const { return norm(car.goal - pose.axle); }
  Move straight_on(double gear) const { return {gear, 0.0, car.planned}; }

  // The key of cell and heading, relative to the goal, and gear.
  std::uint64_t key(const ManeuverNode& node) const {
    const Vec2 place = (1.0 / (kCell * car.turning)) * (node.pose.axle - car.goal);
    const auto whole = [](double x) {
      return static_cast<std::uint64_t>(static_cast<std::int64_t>(std::floor(x)));
    };
    const std::uint64_t heading = whole(node.angle / kPiece + 0.5) & (kHeadings - 1);
    return (whole(place.x) & 0xfffff) << 40 | (whole(place.y) & 0xfffff) << 20 | heading << 1 |
           (node.move.gear > 0.0 ? 1U : 0U);
  }

  // Returns whether no path of at most this length has reached the cell.
  bool is_new(const ManeuverNode& node) {
    const std::uint64_t own = key(node);
    const std::size_t mask = memory.cells.size() - 1;
    std::size_t k = static_cast<std::size_t>((own * 0x9e3779b97f4a7c15U) >> 40) & mask;
    while (memory.cells[k].node != kNoNode && memory.cells[k].key != own) k = (k + 1) & mask;
    ManeuverMemory::NodeCell& cell = memory.cells[k];
    if (cell.node != kNoNode && memory.nodes[cell.node].cost <= node.cost) return false;
    cell = {own, static_cast<std::uint32_t>(memory.nodes.size())};
    return true;
  }

  void push(const ManeuverNode& node) {
    const auto number = static_cast<std::uint32_t>(memory.nodes.size());
    if (number == ManeuverMemory::kMostNodes || !is_new(node)) return;
    memory.open.push_back({node.cost + left(node.pose), number});
    std::push_heap(memory.open.begin(), memory.open.end(), ManeuverMemory::is_later);
    memory.nodes.push_back(node);
  }

  // None where the car could not stop comfortably before it changes gear, or would have to brake at
  // once.
  std::optional<Next> next_of(const ManeuverNode& from, std::uint32_t number, double gear,
                              double side) const {
    Next next{.move = {gear, side, car.planned}, .is_first = number == kNoNode};
    if (next.is_first) {
      next.starts = !car.goes_on(gear);
      next.lead = car.lead_left(gear);
      next.nearness = next.starts ? Nearness::next : Nearness::begun;
      return next;
    }
    next.starts = gear != from.move.gear;
    next.same = !next.starts && side == from.move.side;
    const bool may_be_fast = from.is_first_gear && car.goes_on(from.move.gear) && !from.stops;
    if (next.starts && may_be_fast && from.since < kEase * car.stopping_vector())
      return std::nullopt;
    next.lead = next.starts ? car.lead : 0.0;
    if (next.same) next.nearness = from.nearness;
    return next;
  }

  // m of path, additional cost of the move
  double extra_cost(const Next& next) const {
    if (next.is_first) return car.change_from_now(next.move.gear);
    if (next.starts) return kGearChange * car.turning;
    return next.same ? 0.0 : kSideChange * car.turning;
  }

  // Adds a piece of a move, where it is clear.
  void go(const ManeuverNode& from, std::uint32_t number, const Next& next, double length,
          bool stops = false) {
    const double lead = next.move.side == 0.0 ? 0.0 : next.lead;
    ManeuverNode node{.pose = from.pose, .angle = from.angle, .move = next.move, .parent = number};
    node.moves = from.moves + (next.same ? 0 : 1);
    node.nearness = next.nearness, node.stops = stops;
    node.cost = from.cost + lead + length + extra_cost(next);
    node.since = (next.is_first || next.starts ? 0.0 : from.since) + lead + length;
    node.is_first_gear = next.is_first || (from.is_first_gear && !next.starts);
    if (node.moves >= kMostMoves || !is_clear(from.pose, next, lead)) return;
    if (lead > 0.0) node.pose = after(node.pose, straight_on(next.move.gear), lead, car.turns);
    if (car.clear_length(node.pose, next.move, length, next.nearness) < length) return;
    node.pose = after(node.pose, next.move, length, car.turns);
    node.angle += next.move.side * length / next.move.radius;
    const double room = kRoomAround * car.turning;
    if (norm_squared(node.pose.axle - car.pose.axle) <= room * room) push(node);
  }

  bool is_clear(const AxlePose& from, const Next& next, double lead) const {
    return car.clear_length(from, straight_on(next.move.gear), lead, next.nearness) >= lead;
  }

  // m, of a piece
  double piece() const { return kPiece * car.planned; }

  // m, to the next place or heading where pieces end
  double length_to_mark(const ManeuverNode& from, const Move& move) const {
    if (move.side != 0.0) return to_mark(move.side * from.angle / kPiece) * piece();
    const double along = move.gear * dot(from.pose.axle - car.goal, from.pose.heading);
    return to_mark(along / piece()) * piece();
  }

  // A car on its path may stop as soon as it can, or continue to the planned end.
  void go_on(const ManeuverNode& from, std::uint32_t number, const Next& next, double length) {
    const double stop = car.stopping_vector() - next.lead;
    if (stop > 0.0) go(from, number, next, stop, true);
    go(from, number, next, length);
  }

  void expand(const ManeuverNode& from, std::uint32_t number) {
    for (int k = 0; k < car.gears(); ++k) {
      for (const double side : {-1.0, 0.0, 1.0}) {
        const auto next = next_of(from, number, k == 0 ? 1.0 : -1.0, side);
        if (!next) continue;
        const double length = length_to_mark(from, next->move);
        if (next->is_first && !next->starts) go_on(from, number, *next, length);
        // no other move begins for less than half a piece
        const bool is_short = length < 0.5 * piece();
        if (is_short || !next->is_first || next->starts)
          go(from, number, *next, is_short ? length + piece() : length);
      }
    }
  }

  // The shortest clear leg, if it makes the best path so far; of equal ones the first.
  void try_last_leg(const ManeuverNode& from, std::uint32_t number) {
    std::array<LastLeg, 4> legs;
    std::size_t count = 0;
    for (int k = 0; k < car.gears(); ++k) {
      for (const double side : {-1.0, 1.0}) {
        const auto next = next_of(from, number, k == 0 ? 1.0 : -1.0, side);
        if (!next) continue;
        const AxlePose pose = after(from.pose, straight_on(next->move.gear), next->lead, car.turns);
        const auto leg = leg_to(pose, next->move, car.goal);
        if (!leg || (!next->is_first && leg->arc > kMostArc * car.planned)) continue;
        const double cost = from.cost + next->lead + leg->arc + leg->straight + extra_cost(*next);
        if (!(cost < best)) continue;
        std::size_t place = count++;
        for (; place > 0 && legs[place - 1].cost > cost; --place) legs[place] = legs[place - 1];
        legs[place] = {cost, pose, *leg, *next};
      }
    }
    for (std::size_t k = 0; k < count; ++k) {
      if (!is_clear_last(from, legs[k])) continue;
      best = legs[k].cost, before_last = number;
      last_move = legs[k].next.move, last_leg = legs[k].leg;
      return;
    }
  }

  bool is_clear_last(const ManeuverNode& from, const LastLeg& end) const {
    return is_clear(from.pose, end.next, end.next.lead) &&
           car.is_clear_leg(end.pose, end.next.move, end.leg, end.next.nearness);
  }

  // The first part of the best path.
  Beginning beginning() const {
    if (before_last == kNoNode) return {last_move, last_leg.arc / car.planned, kInfinity, true};
    std::uint32_t move_end = kNoNode, gear_end = kNoNode;
    for (std::uint32_t k = before_last; k != kNoNode; k = memory.nodes[k].parent) {
      if (gear_end == kNoNode && memory.nodes[k].is_first_gear) gear_end = k;
      if (move_end == kNoNode && memory.nodes[k].moves == 1) move_end = k;
    }
    const ManeuverNode& end = memory.nodes[move_end];
    const bool stays = gear_end == before_last && last_move.gear == end.move.gear;
    double arc = end.move.side == 0.0 ? 0.0 : end.since;
    if (move_end == before_last && stays && last_move.side == end.move.side) arc += last_leg.arc;
    return {end.move, arc / car.planned, stays ? kInfinity : memory.nodes[gear_end].since, false};
  }
};

}  // namespace

void ManeuverMemory::begin() {
  nodes.clear(), open.clear();
  nodes.reserve(kMostNodes), open.reserve(kMostNodes);
  cells.assign(2 * kMostNodes, {0, kNone});
}

bool ManeuverMemory::is_later(const Open& a, const Open& b) {
  return a.cost > b.cost || (a.cost == b.cost && a.node > b.node);
}

std::optional<Beginning> begin_maneuver(const Maneuvering& car, ManeuverMemory& memory) {
  ManeuverSearch search{car, memory};
  ManeuverNode start;
  start.pose = car.pose;
  start.angle = car.robot.heading;
  search.try_last_leg(start, kNoNode);
  if (search.best <= search.left(car.pose) + kDetour * car.turning) return search.beginning();
  memory.begin();
  search.expand(start, kNoNode);
  while (!memory.open.empty()) {
    std::pop_heap(memory.open.begin(), memory.open.end(), ManeuverMemory::is_later);
    const ManeuverMemory::Open next = memory.open.back();
    memory.open.pop_back();
    if (next.cost >= search.best) break;
    const ManeuverNode from = memory.nodes[next.node];
    search.try_last_leg(from, next.node);
    search.expand(from, next.node);
  }
  if (search.best == kInfinity) return std::nullopt;
  return search.beginning();
}

}  // namespace avo::inline robots
