// SPDX-License-Identifier: Apache-2.0
// Boxes: neither the step of the decision nor the braking after it may come within a robot's radius
// of a box (docs/space.md, "Boxes").
#pragma once
#include <cstddef>
#include <span>
#include <vector>

#include "avo/space/box.h"
#include "avo/space/robot.h"
#include "certificate/braking_path.h"
#include "certificate/deepest.h"
#include "space/program.h"

namespace avo::space {

/// A segment and a box: the distance of both, and where it is.
struct NearestToBox {
  double distance = 0.0;    ///< m, without the radius of the box
  double part = 0.0;        ///< in [0, 1]: the place on the segment
  Vec3 on_segment, on_box;  ///< m
};
NearestToBox nearest(Vec3 a, Vec3 b, const Box& box);

/// The box by so much elsewhere, m.
Box moved(const Box& box, Vec3 by);

/// One box near a robot.
struct NearBox {
  Box box;
  double held = 0.0;    ///< m, that the center keeps from the box without its radius
  double margin = 0.0;  ///< m, covers all rounding; 0 where braking comes too near
  /// Used where the robot does not know exactly where it is. The normal points from the box to the
  /// nearest point of braking, as the robot sees it; the cone is the largest error of this
  /// direction. The robot may move in directions that lead away for all these normals. There are
  /// none from a cone of 1 on.
  Vec3 normal = {};
  double cone = 2.0;
  double lost = 0.0;  ///< m, by which the box may be elsewhere; a part of held
};

/// The demands of boxes on a robot. Scratch memory; allocates only while it grows.
struct BoxConstraints {
  std::vector<NearBox> near;  ///< boxes that a candidate can touch
  Vec3 middle;                ///< [p + s v] m
  Vec3 first;                 ///< [x_1] m, after one step of braking
  Vec3 stop;                  ///< m, where braking ends
  Vec3 backup;                ///< m/s, the velocity after one step of braking
  Deepest broken = {};        ///< the deepest of the boxes that braking touches
  Deepest tight = {};         ///< of the boxes from which braking does not keep the margin as well
  bool must_brake = false;    ///< braking takes the center into a box
  bool doubtful = false;      ///< the error of the robot's own place may hide that braking touches
};

/// m: how far a robot gets in a step and in stopping from its highest speed. Farther boxes change
/// nothing.
double box_reach(const Robot& robot, const StepLaw& law);

void begin_boxes(const Robot& robot, std::span<const Box> boxes, const StepLaw& law,
                 BoxConstraints& constraints);

/// Returns whether the candidate keeps clear of all boxes, or is braking.
bool keeps_boxes(const Robot& robot, Vec3 next_velocity, const StepLaw& law,
                 const BoxConstraints& constraints);

/// Appends for each box that refuses the candidate a half-space in v_1, in the robot's own space.
void append_box_cuts(const Robot& robot, Vec3 next_velocity, const StepLaw& law,
                     const BoxConstraints& constraints, std::vector<HalfSpace>& cuts);

/// Appends for each near box the half-space of the velocities from which the robot can stop before
/// it, in space.
void append_speed_planes(const Robot& robot, std::span<const Box> boxes, const StepLaw& law,
                         std::vector<HalfSpace>& half_spaces);

}  // namespace avo::space
