// SPDX-License-Identifier: Apache-2.0
// Everything of the library.
#pragma once
#include "avo/assumptions.h"
#include "avo/check.h"
#include "avo/error.h"
#include "avo/export.h"
#include "avo/geometry.h"
#include "avo/half_plane.h"
#include "avo/metrics.h"
#include "avo/planner.h"
#include "avo/response.h"
#include "avo/robot.h"
#include "avo/scenario.h"
#include "avo/simd.h"
#include "avo/simulation.h"
#include "avo/vec.h"
#include "avo/velocity_obstacle.h"
#include "avo/version.h"
