// SPDX-License-Identifier: Apache-2.0
// The robots near a robot that decides while all others are in motion. Where clocks are free, few
// robots decide at an instant, and robots far from them need not be moved.
#pragma once
#include <cstddef>
#include <cstdint>
#include <vector>

#include "sim/sensing/snapshot.h"

namespace avo::inline sim {

struct World;

/// The present step of a robot, as others need it to compute its place.
struct StepInProgress {
  enum class Kind : std::uint8_t { held, at_once, by_model };
  Vec2 position, velocity;     // m, m/s, at its beginning
  Vec2 change;                 // m/s, of the velocity; at_once: m, of the position
  Instant begin = 0, end = 0;  // ns
  Kind kind = Kind::held;
};

/// Robots in the cells in which they were at an instant, and how far they may have moved since.
struct Whereabouts {
  Snapshot filed;                       // of that instant
  Instant since = -1;                   // that instant; -1: no robots are filed
  std::size_t decisions = 0;            // since then
  double top_speed = 0.0;               // m/s, of any disc
  Instant fast_until = -1;              // until then some robot may exceed its max_speed
  std::vector<StepInProgress> step;     // by place
  std::vector<std::uint32_t> place_of;  // by slot
  // data of one search
  std::vector<std::uint32_t> read, slots;
  std::vector<Vec2> position, velocity;
  std::vector<int> rank;
};

/// Files all robots by the snapshot from which the last robots have decided.
void file(World& world);
/// Returns the snapshot, which must be made anew; no robots are filed any more.
void unfile(World& world);
/// Returns whether robots may decide now by find_near().
bool knows_near(const World& world);
/// Makes a snapshot of the robots near the robot that decides now and has been put in its place. It
/// has all robots that sense() can find.
void find_near(World& world, std::size_t slot);
/// Renews the step of a robot that has decided.
void renew_step(World& world, std::size_t slot);

}  // namespace avo::inline sim
