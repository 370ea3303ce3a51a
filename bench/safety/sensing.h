// SPDX-License-Identifier: Apache-2.0
// Robots that sense each other wrongly or late: how, and the scenes that it is measured over.
#pragma once
#include <cstdint>
#include <vector>

#include "avo/planner.h"

namespace avo::safety {

struct Scene;
struct Outcome;
struct Family;

/// How a sensed state differs from the true one. Of position and velocity alike.
enum class ErrorShape : std::uint8_t {
  uniform,  ///< anywhere in the disc of the bound, anew for every observer, neighbor and step
  rim,      ///< on its rim, likewise
  farther,  ///< on its rim, so that the neighbor looks farther away and as if it went away
  bias,     ///< on its rim, the same for all neighbors and steps of an observer
  flips,    ///< on its rim, farther away in one step, nearer in the next
};
inline constexpr int kErrorShapes = 5;

struct Sensing {
  SensingError error = {};     ///< largest that happens
  SensingError declared = {};  ///< what the robots plan with
  ErrorShape shape = ErrorShape::uniform;
  bool delayed = false;  ///< states are one step old, carried on at constant velocity
  double missed = 0.0;   ///< part of the neighbors that are missed in a step, each anew
};

/// The rows: every kind of sensing in random squares, jittered circles and crushes.
std::vector<Family> sensing_families();

/// The scene of a robots' loop around Planner::plan: every robot knows itself exactly and the others
/// as its sensing tells. Ends as run_scene does. Throws Error on a bad scene.
Outcome run_sensing(const Scene& scene, std::uint64_t seed, const std::string& record);

}  // namespace avo::safety
