// SPDX-License-Identifier: Apache-2.0
// The routes of a fleet among boxes, and the passages there. They only say where a robot heads for:
// safety never depends on them.
#pragma once
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "core/memo.h"
#include "space/routes/free_cells.h"
#include "space/routes/right_of_way.h"
#include "space/routes/route.h"

namespace avo::space {

/// Memory of a worker; allocates only while it grows.
struct HeadingScratch {
  RouteScratch search;
  std::vector<Claimant> others;
};

/// What others do beside a robot, for the rules at passages.
struct PassageView {
  std::span<const Neighbor> neighbors;
  double detour = 0.0;          ///< rad, see Detour::angle
  double sensing_radius = 0.0;  ///< m
  double time_step = 0.0;       ///< s
};

class SpaceRoutes {
 public:
  SpaceRoutes() = default;
  /// places: m, of robots and goals, between which routes lead. routes: whether there are any.
  SpaceRoutes(std::span<const Box> boxes, std::span<const Robot> robots,
              std::span<const Vec3> goals, bool routes);

  /// Other boxes, from the next step on. Routes that are still clear and as short as others stay.
  void set_boxes(std::span<const Box> boxes, std::span<const Robot> robots,
                 std::span<const Vec3> goals);
  /// A goal that a robot has from now on.
  void include(Vec3 goal);

  /// Before the robots of a step decide: what each seems to claim.
  void begin_step(std::span<const Robot> robots);

  /// Finds the route of robot k before it decides, where it knows none for this goal and these
  /// boxes. Several threads may ask for different robots at once.
  void look(std::size_t k, const Robot& robot, Vec3 goal, HeadingScratch& scratch);
  /// Where robot k heads for, with what it remembers of its route. Several threads may ask for
  /// different robots at once.
  SpaceHeading heading(std::size_t k, const Robot& robot, Vec3 goal, double preferred_speed,
                       const PassageView& company, SpaceRoute& route,
                       HeadingScratch& scratch) const;
  /// The robot that robot k lets go first at a passage, where that guides robot k on that route.
  [[nodiscard]] std::optional<SpaceWait> wait(std::size_t k, const Robot& robot,
                                              const PassageView& company, const SpaceRoute& route,
                                              HeadingScratch& scratch) const;

  /// What robot k remembers of its route; none where it knows no route, nor needs any.
  [[nodiscard]] const SpaceRoute* route(std::size_t k) const {
    return routes_[k].is_searched ? &routes_[k] : nullptr;
  }
  [[nodiscard]] SpaceRoute& memory(std::size_t k) { return routes_[k]; }
  /// Returns whether a box is between robot k and a goal that it can reach.
  [[nodiscard]] bool is_behind_box(std::size_t k, Vec3 position, Vec3 goal) const;
  [[nodiscard]] const SpacePassages& passages() const { return passages_; }
  [[nodiscard]] bool has_boxes() const { return solids_.size() > 0; }

 private:
  FoundRoute find(Vec3 from, Vec3 goal, double radius, HeadingScratch& scratch) const;
  void follow(const Robot& robot, Vec3 goal, SpaceRoute& route, HeadingScratch& scratch) const;
  const FreeCells& cells(double radius) const;
  static SpaceClaimer claimer_of(std::size_t k, const Robot& robot, const PassageView& company,
                                 const SpaceRoute& route);

  bool has_routes_ = false;
  Solids solids_;
  SpacePassages passages_;
  SpaceClaims claims_;
  Bounds within_;              // where routes may lead
  std::vector<double> radii_;  // of robots, and their classes, ascending
  Memo<FreeCells> cells_;      // of each radius
  std::vector<SpaceRoute> routes_;
};

}  // namespace avo::space
