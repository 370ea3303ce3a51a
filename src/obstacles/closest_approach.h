// SPDX-License-Identifier: Apache-2.0
// The cheaper question: not how near the centers come, but whether nearer than a given distance.
#pragma once
#include "avo/velocity_obstacle.h"

namespace avo {

/// closest_approach(obstacle, u).distance < distance, decided as soon as it is plain.
bool comes_within(const Obstacle& obstacle, Vec2 u, double distance);

}  // namespace avo
