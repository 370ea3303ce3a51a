// SPDX-License-Identifier: Apache-2.0
// A route of straight pieces with corners that are cut by arcs.
#pragma once
#include <cstddef>
#include <span>
#include <vector>

#include "avo/vec.h"
#include "navigator/dubins.h"

namespace avo::inline navigator {

/// How corners are cut.
struct Rounding {
  double tolerance = 0.0;     // m, > 0: an arc passes the corner within this distance
  double least_radius = 0.0;  // m, >= 0, of arcs, as far as the pieces leave room
};

/// How a robot follows a route, for its speed before and on arcs.
struct Cornering {
  double acceleration = 0.0;  // m/s², that it uses
  double braking = 0.0;       // m/s², that it plans with
  double lag = 0.0;           // s, with which its velocity follows its preferred velocity
};

/// A corner of a route, or its end.
struct RoutePoint {
  Vec2 place = {};     // m
  bool stops = false;  // the robot comes to rest there: the corner is not cut
};

class RoundedRoute {
 public:
  /// The points of a route, without repetitions; at least one.
  RoundedRoute(std::span<const RoutePoint> points, const Rounding& rounding);
  /// The route of those pieces from a pose on. Its points are the start, and the end of each piece.
  RoundedRoute(const Pose& from, std::span<const PathPiece> pieces);

  [[nodiscard]] double length() const { return length_; }  // m
  [[nodiscard]] Vec2 at(double along) const;               // m; along: m, from the start
  /// m from the start, of the point nearest to p between both; the first one of several.
  [[nodiscard]] double nearest(Vec2 p, double from, double to) const;
  /// m from the start: the nearest point to p of a stretch. The stretch is the first one up to `to`
  /// that is at most `farther` m farther from p than the route is.
  [[nodiscard]] double first_near(Vec2 p, double farther, double to) const;
  /// m/s: the largest speed at a place from which the robot can slow down before the arcs.
  /// most: m/s, at least as much as it wants.
  [[nodiscard]] double top_speed(double along, double most, const Cornering& cornering) const;
  /// m from the start, of each of the points; of a cut corner, the middle of its arc.
  [[nodiscard]] std::span<const double> points() const { return points_; }

 private:
  // A straight piece, or an arc.
  struct Element {
    Vec2 from, direction;
    double curvature = 0.0;            // 1/m, > 0: to the left
    double begin = 0.0, length = 0.0;  // m
    double radius = 0.0;               // m, on which it is driven; infinite where it is straight
  };
  void add_line(Vec2 from, Vec2 to);
  /// The arc, or the slow place, at a corner; returns where the next piece begins.
  Vec2 add_corner(Vec2 from, Vec2 corner, Vec2 before, Vec2 after, double room,
                  const Rounding& rounding);
  [[nodiscard]] std::size_t element_at(double along) const;
  static Vec2 point_on(const Element& element, double local);
  static double nearest_on(const Element& element, Vec2 p);

  Vec2 start_;                     // m
  std::vector<Element> elements_;  // none where there is one point
  std::vector<double> points_;
  double length_ = 0.0;
};

}  // namespace avo::inline navigator
