// SPDX-License-Identifier: Apache-2.0
// Who is near a robot that decides while all others are on their ways: where clocks are free, few
// decide at an instant, and those who are far from them need not be moved.
#pragma once
#include <cstddef>
#include <cstdint>
#include <vector>

#include "sim/snapshot.h"

namespace avo::inline sim {

struct World;

/// The step that a robot is in, as others need it to know where it is.
struct StepUnderWay {
  enum class Kind : std::uint8_t { held, at_once, by_model, parked };
  Vec2 position, velocity;     // m, m/s, at its beginning
  Vec2 change;                 // m/s, of the velocity; at_once: m, of the position
  Instant begin = 0, end = 0;  // ns
  Kind kind = Kind::held;
};

/// Robots in the cells in which they were at an instant, and how far they may have come since.
struct Whereabouts {
  Snapshot filed;                       // of that instant
  Instant since = -1;                   // it; -1: nobody is filed
  std::size_t decisions = 0;            // since then
  double top_speed = 0.0;               // m/s, of any disc
  Instant fast_until = -1;              // until then somebody may exceed its max_speed
  std::vector<StepUnderWay> step;       // by place
  std::vector<std::uint32_t> place_of;  // by slot
  // of one search
  std::vector<std::uint32_t> read, slots;
  std::vector<Vec2> position, velocity;
  std::vector<int> rank;
};

/// Files everybody by the snapshot that those who just decided have decided from.
void file(World& world);
/// Gives the snapshot back, which has to be made anew; nobody is filed any more.
void unfile(World& world);
/// Whether robots may decide now by find_near().
bool knows_near(const World& world);
/// Makes a snapshot of those near the robot, who decides now and has been put in its place: all
/// whom sense() can find of all.
void find_near(World& world, std::size_t slot);
/// That robot has decided.
void renew_step(World& world, std::size_t slot);

}  // namespace avo::inline sim
