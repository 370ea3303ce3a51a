// SPDX-License-Identifier: Apache-2.0
// Which discs of robots overlap those of movers at the instants that are observed. Movers are
// moving obstacles, and robots that the host moves.
#pragma once
#include <compare>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "avo/simulation.h"
#include "spatial/point_grid.h"

namespace avo::inline metrics {

struct MoverContact {
  std::uint64_t robot = 0;     // its id
  bool is_with_robot = false;  // the mover is a robot that the host moves
  std::uint64_t mover = 0;     // its id
  std::size_t row = 0;         // of the robot, at present
};

class MoverContacts {
 public:
  /// Takes the discs of the robots; call it where the roster has changed.
  void take(const Simulation& simulation, const FleetView& fleet);
  /// Finds the contacts of the present instant; positions: the column of the fleet.
  void observe(const Simulation& simulation, std::span<const Vec2> positions);
  /// Present contacts that the observation before did not find, by robot, kind and id of movers.
  [[nodiscard]] std::span<const MoverContact> begun() const { return begun_; }

 private:
  struct RowDisc {
    std::uint64_t robot = 0;
    bool parked = false;
    double radius = 0.0;      // m
    double offset = 0.0;      // m, from the robot's place to the disc's center
    bool is_covered = false;  // it has a footprint, which the disc covers at any heading
    LayerSet layers = {}, avoids = {};
  };
  struct MoverDisc {
    std::uint64_t id = 0;
    bool is_robot = false;
    double radius = 0.0;           // m
    LayerSet layers = kAllLayers;  // that robots avoid it in
  };
  void take_movers(const Simulation& simulation, std::span<const Vec2> positions);
  void meet(const Simulation& simulation, Vec2 position, std::size_t row, double reach);

  std::vector<RowDisc> discs_;
  std::vector<std::size_t> moved_;   // rows of robots that the host moves
  std::vector<MoverDisc> movers_;    // obstacles, then robots
  std::vector<Vec2> centers_;        // m, of the movers
  PointGrid grid_;                   // of the centers
  std::vector<std::uint32_t> near_;  // places in the grid
  std::vector<MoverContact> now_, before_, begun_;
};

}  // namespace avo::inline metrics
