// SPDX-License-Identifier: Apache-2.0
// The parts of a scene file that become robots and walls: groups, placements, goals, obstacles,
// maps.
#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "avo/geometry.h"
#include "avo/scenario.h"
#include "avo/teams.h"

namespace avo_io {

/// N robots on a circle of radius max(min_radius, spacing * N / 2π), evenly spaced, from angle 0.
struct CirclePlacement {
  avo::Vec2 center;
  double min_radius = 0.0;
  double spacing = 2.25;
};
/// A body that is no disc: a rectangle, or a polygon in the robot's frame.
struct FootprintShape {
  std::optional<double> length, width;  ///< m, of a rectangle
  double offset = 0.0;                  ///< m, from the position forward to its center
  std::vector<avo::Vec2> polygon;       ///< m; x along the heading, y to its left
  std::optional<double> excess;         ///< m, of its discs at its sides
};

/// Robots row by row from `corner` towards +x, then +y.
struct GridPlacement {
  avo::Vec2 corner;
  double spacing = 2.0;
  int columns = 1;
};
/// Robots evenly spaced from `from` to `to`.
struct LinePlacement {
  avo::Vec2 from, to;
};
/// Robots uniform in the rectangle from min to max, no disc nearer than `clearance` to another one.
struct RandomPlacement {
  avo::Vec2 min, max;
  double clearance = 0.0;
};
/// Robots at random on a circle, and up to `noise` off along x and along y. No disc is nearer than
/// `clearance` to the start or the goal of another robot.
struct RingPlacement {
  avo::Vec2 center;
  double radius = 4.0;
  double noise = 0.0;
  double clearance = 0.0;
};
using Placement =
    std::variant<CirclePlacement, GridPlacement, LinePlacement, RandomPlacement, RingPlacement>;

/// The start, reflected in the center of the placement.
struct AntipodalGoals {};
/// The start, moved by `by`.
struct OffsetGoals {
  avo::Vec2 by;
};
/// The starts of the group, permuted in one random cycle: no robot keeps its own.
struct PermutationGoals {};
/// Goals uniform in the rectangle from min to max, no goal's disc nearer than `clearance` to
/// another.
struct RandomGoals {
  avo::Vec2 min, max;
  double clearance = 0.0;
};
/// Slots of a formation about a center, dealt so that straight lines to them do not cross.
struct FormationGoals {
  avo::Formation shape = avo::Formation::block;
  double spacing = 1.5;
  avo::Vec2 center;
  double heading = 0.0;
};
using Goals =
    std::variant<AntipodalGoals, OffsetGoals, PermutationGoals, RandomGoals, FormationGoals>;

enum class GroupHeading : std::uint8_t { goal, random, given };

/// Many robots of the same kind.
struct Group {
  int number = 0;
  avo::RobotSetup robot;  ///< all values except position and goal
  GroupHeading heading = GroupHeading::goal;
  Placement placement;
  Goals goals;
  std::optional<avo::TeamTask> task = {};  ///< of all of them together
  double jitter = 0.0;  ///< m: the largest random offset of starts and goals, along x and along y
};

/// `number` robots from the first rows of a MovingAI scenario.
struct RobotsFrom {
  std::string scen;  ///< file, relative to the scene's file
  int number = 0;
  avo::RobotSetup robot;  ///< all values except position and goal
  GroupHeading heading = GroupHeading::goal;
};

// `layers` of each kind: see avo::StaticObstacle.

struct PolylineObstacle {
  std::vector<avo::Vec2> points;  ///< at least two
  avo::LayerSet layers = avo::kAllLayers;
};
struct PolygonObstacle {
  std::vector<avo::Vec2> points;  ///< at least three
  bool solid = false;
  avo::LayerSet layers = avo::kAllLayers;
};
struct DiscObstacle {
  avo::Disc disc;
  avo::LayerSet layers = avo::kAllLayers;
};
struct WktObstacle {
  std::string text;
  avo::Fill as = avo::Fill::solid;
  avo::LayerSet layers = avo::kAllLayers;
};
struct WktFileObstacle {
  std::string file;
  avo::Fill as = avo::Fill::solid;
  avo::LayerSet layers = avo::kAllLayers;
};
struct GeojsonObstacle {
  std::string file;
  avo::Fill as = avo::Fill::solid;
  avo::LayerSet layers = avo::kAllLayers;
};
struct MapObstacle {
  std::string file;
  double cell = 1.0;
  avo::Vec2 origin;
  avo::LayerSet layers = avo::kAllLayers;
};
struct RosMapObstacle {
  std::string file;
  avo::LayerSet layers = avo::kAllLayers;
};
/// An entry of `obstacles`; the first field of each kind is the key that identifies it.
using ObstacleEntry = std::variant<PolylineObstacle, PolygonObstacle, DiscObstacle, WktObstacle,
                                   WktFileObstacle, GeojsonObstacle, MapObstacle, RosMapObstacle>;

enum class RosMode : std::uint8_t { trinary, scale, raw };

/// The facts that a map.yaml of ROS gives about its image.
struct RosMap {
  std::string image;  ///< file, relative to map.yaml
  double resolution = 0.05;
  double occupied_thresh = 0.65, free_thresh = 0.25;
  bool negate = false;
  RosMode mode = RosMode::trinary;
};

}  // namespace avo_io
