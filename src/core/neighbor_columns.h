// SPDX-License-Identifier: Apache-2.0
// What robots sense of others, in columns.
#pragma once
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "avo/robot.h"

namespace avo::inline core {

/// Columns have room for so many extra entries, which are read but do not count.
inline constexpr std::size_t kSpareNeighbors = 16;

/// What a robot counts on from a neighbor. Kernels read the numbers: prompt neighbors are above 0,
/// a neighbor of 0 takes no share.
enum class NeighborKind : std::int8_t {
  prompt = 1,       // it decides, and has the declared errors
  mover = 0,        // it moves on
  aged = -1,        // it decides, and has errors of its own
  loiterer = -2,    // it decides, and does not brake
  cooperator = -3,  // it should decide, and promises nothing
  covered = -4,     // it decides, has the declared errors, and a footprint
};

/// The footprint of a neighbor, as others know it: see Neighbor.
struct SensedFootprint {
  Footprint footprint;
  Vec2 ahead;           // unit
  double spread = 0.0;  // rad
};

/// The known motion of a neighbor that does not decide.
struct MoverMotion {
  Vec2 acceleration;              // m/s²
  double max_deviation = 0.0;     // m/s²
  double max_speed = 0.0;         // m/s; not kept for a neighbor that decides
  double likely_deviation = 0.0;  // m/s²
  const Trajectory* trajectory = nullptr;
  double trajectory_time = 0.0;  // s
};

/// Neighbors of one robot or of several; allocates only while it grows.
struct NeighborColumns {
  std::size_t count = 0;
  bool has_movers = false;                       // some do not decide: they move on or cooperate
  bool has_aged = false;                         // some have errors of their own
  bool has_priorities = false;                   // some have a priority other than 1
  bool has_max_braking = false;                  // some have a max_braking
  bool has_deviations = false;                   // some have a max_deviation
  bool has_partings = false;                     // some have a parting
  std::vector<double> x, y, v_x, v_y;            // m, m/s
  std::vector<double> radius, max_acceleration;  // m, m/s²
  std::vector<double> kinds;           // NeighborKind; prompt unless add() was told otherwise
  std::vector<double> priority;        // 1 unless add() was told otherwise
  std::vector<double> max_braking;     // m/s², read where has_max_braking
  std::vector<int> age;                // steps, of all neighbors that are not prompt
  std::vector<double> position_error;  // m, of all neighbors that are not prompt
  // of neighbors that do not decide; of others only its max_deviation
  std::vector<MoverMotion> motion;
  bool has_loiterers = false;
  std::vector<LoiterCircle> loiter;  // of loiterers
  bool has_footprints = false;
  std::vector<SensedFootprint> covers;  // without discs unless add() was told otherwise
  std::vector<Vec2> parting;            // 0 unless add() was told otherwise

  NeighborKind kind(std::size_t k) const {
    return static_cast<NeighborKind>(static_cast<int>(kinds[k]));
  }
  bool is_predicted(std::size_t k) const {
    return kind(k) == NeighborKind::mover || kind(k) == NeighborKind::cooperator;
  }

  /// Reserves room for so many.
  void reserve(std::size_t neighbors) {
    // this column grows last: where memory runs out, some others may have grown already
    if (motion.size() < neighbors + kSpareNeighbors) grow(neighbors + kSpareNeighbors);
  }
  /// Adds a neighbor that decides, with the declared errors and the priority 1, and brakes with its
  /// max_acceleration.
  void add_usual(Vec2 position, Vec2 velocity, double own_radius, double own_acceleration) {
    x[count] = position.x, y[count] = position.y;
    v_x[count] = velocity.x, v_y[count] = velocity.y;
    radius[count] = own_radius;
    max_acceleration[count] = max_braking[count] = own_acceleration;
    motion[count].max_deviation = 0.0;
    ++count;
  }
  void add(const Neighbor& neighbor) {
    x[count] = neighbor.position.x, y[count] = neighbor.position.y;
    v_x[count] = neighbor.velocity.x, v_y[count] = neighbor.velocity.y;
    radius[count] = neighbor.radius, max_acceleration[count] = neighbor.max_acceleration;
    const bool moves_on = !shares(neighbor);
    const bool predicted = avo::is_predicted(neighbor);
    const bool aged = has_errors_of_its_own(neighbor);
    const bool loiters = !predicted && neighbor.loiter.has_value();
    const NeighborKind own = moves_on             ? NeighborKind::mover
                             : predicted          ? NeighborKind::cooperator
                             : loiters            ? NeighborKind::loiterer
                             : aged               ? NeighborKind::aged
                             : neighbor.footprint ? NeighborKind::covered
                                                  : NeighborKind::prompt;
    kinds[count] = static_cast<double>(own);
    if (loiters) loiter[count] = *neighbor.loiter;
    has_loiterers = has_loiterers || loiters;
    age[count] = neighbor.age, position_error[count] = neighbor.position_error;
    priority[count] = neighbor.priority;
    max_braking[count] = braking_limit(neighbor);
    if (neighbor.parting != Vec2{}) part(count, neighbor.parting);
    if (neighbor.footprint) cover(count, {neighbor.footprint, neighbor.ahead, neighbor.spread});
    motion[count].max_deviation = neighbor.max_deviation;
    if (predicted) {
      motion[count].acceleration = moves_on ? neighbor.acceleration : Vec2{};
      motion[count].max_speed = neighbor.max_speed;
      motion[count].likely_deviation = neighbor.likely_deviation;
      motion[count].trajectory = moves_on ? neighbor.trajectory : nullptr;
      motion[count].trajectory_time = neighbor.trajectory_time;
    }
    ++count;
    has_movers = has_movers || predicted;
    has_deviations = has_deviations || neighbor.max_deviation > 0.0;
    has_aged = has_aged || aged;
    has_priorities = has_priorities || neighbor.priority != 1.0;
    has_max_braking = has_max_braking || neighbor.max_braking;
  }
  /// See Neighbor::parting.
  void part(std::size_t place, Vec2 direction) {
    parting[place] = direction;
    has_partings = true;
  }
  void cover(std::size_t place, const SensedFootprint& footprint) {
    covers[place] = footprint;
    has_footprints = true;
  }
  /// Replaces the neighbor at `place` by the one at `other`, which stays.
  void replace(std::size_t place, std::size_t other) {
    x[place] = x[other], y[place] = y[other];
    v_x[place] = v_x[other], v_y[place] = v_y[other];
    radius[place] = radius[other], max_acceleration[place] = max_acceleration[other];
    kinds[place] = kinds[other], age[place] = age[other];
    position_error[place] = position_error[other];
    motion[place] = motion[other], loiter[place] = loiter[other];
    priority[place] = priority[other], max_braking[place] = max_braking[other];
    parting[place] = parting[other], covers[place] = covers[other];
  }
  void clear() {
    if (has_movers || has_aged || has_loiterers || has_footprints)
      std::fill(kinds.begin(), kinds.end(), static_cast<double>(NeighborKind::prompt));
    if (has_priorities) std::fill(priority.begin(), priority.end(), 1.0);
    if (has_partings) std::fill(parting.begin(), parting.end(), Vec2{});
    if (has_footprints) std::fill(covers.begin(), covers.end(), SensedFootprint{});
    count = 0;
    has_movers = has_aged = has_priorities = has_max_braking = has_loiterers = false;
    has_deviations = has_partings = has_footprints = false;
  }
  Neighbor operator[](std::size_t i) const {
    Neighbor neighbor{.position = {x[i], y[i]},
                      .velocity = {v_x[i], v_y[i]},
                      .radius = radius[i],
                      .max_acceleration = max_acceleration[i],
                      .age = kind(i) == NeighborKind::prompt ? 0 : age[i],
                      .priority = priority[i]};
    if (kind(i) != NeighborKind::prompt) neighbor.position_error = position_error[i];
    if (has_max_braking) neighbor.max_braking = max_braking[i];
    if (kind(i) == NeighborKind::loiterer) neighbor.loiter = loiter[i];
    if (has_deviations) neighbor.max_deviation = motion[i].max_deviation;
    if (has_partings) neighbor.parting = parting[i];
    if (has_footprints && covers[i].footprint) {
      neighbor.footprint = covers[i].footprint;
      neighbor.ahead = covers[i].ahead, neighbor.spread = covers[i].spread;
    }
    if (!is_predicted(i)) return neighbor;
    neighbor.behavior = kind(i) == NeighborKind::mover ? Behavior::moves_on : Behavior::cooperates;
    neighbor.acceleration = motion[i].acceleration;
    neighbor.max_speed = motion[i].max_speed;
    neighbor.likely_deviation = motion[i].likely_deviation;
    neighbor.trajectory = motion[i].trajectory;
    neighbor.trajectory_time = motion[i].trajectory_time;
    return neighbor;
  }

 private:
  void grow(std::size_t size);
};

/// The neighbors of one robot: neighbors [first, first + count) of the columns. If the range is not
/// infinite they have the order of their distances. Beyond the range all of them decide and matter
/// to half-planes only.
struct Neighbors {
  const NeighborColumns* columns = nullptr;
  std::size_t first = 0, count = 0;
  double range = std::numeric_limits<double>::infinity();  // m
  // number of nearest neighbors that would get a half-plane, but were removed because they are
  // behind walls
  std::size_t hidden = 0;

  std::size_t size() const { return count; }
  Neighbor operator[](std::size_t k) const { return (*columns)[first + k]; }
};

/// Lists them in order.
void list(const Neighbors& neighbors, std::vector<Neighbor>& listed);

/// Sets the given neighbors as the columns' only ones.
Neighbors in_columns(std::span<const Neighbor> neighbors, NeighborColumns& columns);

}  // namespace avo::inline core
