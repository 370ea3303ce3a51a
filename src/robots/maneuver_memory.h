// SPDX-License-Identifier: Apache-2.0
// The memory of a search for paths of several moves.
#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include "avo/vec.h"
#include "robots/model.h"

namespace avo::inline robots {

/// The middle of the axle.
struct AxlePose {
  Vec2 axle, heading;
};

struct Move {
  double gear = 1.0;    // 1 forward, -1 backwards
  double side = 0.0;    // 1 to the left of its driving direction, -1 to the right, 0 straight
  double radius = 0.0;  // m, of its circle
};

/// Unit vectors of the turns of one search, which uses few of them many times.
struct KnownTurns {
  static constexpr std::size_t kKnown = 64;
  std::array<double, kKnown> turns;  // rad; NaN: none yet
  std::array<Vec2, kKnown> directions;

  void begin() { turns.fill(std::numeric_limits<double>::quiet_NaN()); }
  /// elementary::direction(turn)
  Vec2 direction(double turn);
};

/// Reuse it and nothing is allocated after the first search.
struct ManeuverMemory {
  // of a search; more nodes find hardly any other path
  static constexpr std::size_t kMostNodes = 2048;
  static constexpr std::uint32_t kNone = 0xffffffff;
  struct ManeuverNode {
    AxlePose pose;
    double angle = 0.0;            // rad, of the heading
    double cost = 0.0;             // m of path, up to this node
    double since = 0.0;            // m, since the last change of gear
    Move move;                     // the move that led there
    std::uint32_t parent = kNone;  // none: the present place of the car
    int moves = 0;                 // until there
    Nearness nearness = Nearness::later;
    bool stops = false;          // the car brakes up to this node
    bool is_first_gear = false;  // no change of gear before this node
  };
  struct Open {
    double cost;  // m, with a lower bound of the rest
    std::uint32_t node;
  };
  struct NodeCell {
    std::uint64_t key;
    std::uint32_t node;
  };
  KnownTurns turns;
  std::vector<ManeuverNode> nodes;
  std::vector<Open> open;       // a heap, the cheapest first
  std::vector<NodeCell> cells;  // a hash table: the cheapest node of each

  void begin();
  static bool is_later(const Open& a, const Open& b);
};

}  // namespace avo::inline robots
