// SPDX-License-Identifier: Apache-2.0
// The state of a simulation in columns, one entry for each robot.
#pragma once
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "avo/simulation.h"
#include "core/executor.h"
#include "guidance/traits.h"
#include "planner/stages/relevance.h"
#include "robots/model.h"
#include "robots/motion.h"
#include "sim/bases/bases.h"
#include "sim/columns/mover_columns.h"

namespace avo::inline sim {

/// The constant part of a RobotSetup.
RobotTraits traits_of(const RobotSetup& setup);

/// How a robot and the others avoid each other. Nearly all robots have the same.
struct Conduct {
  double priority = 1.0;
  Method method = Method::avo;
  bool certified = true;  // it keeps the certificate
  LayerSet layers = RobotSetup{}.layers, avoids = RobotSetup{}.avoids;
  Behavior behavior = RobotSetup{}.behavior;
  friend bool operator==(const Conduct&, const Conduct&) = default;
};
/// Returns whether others count on the robot to do what its setup says: to brake, or to stay.
constexpr bool promises(Behavior behavior) {
  return behavior == Behavior::decides || behavior == Behavior::parked;
}
/// The method of robots that have none of their own, and whether these keep a certificate.
struct UsualMethod {
  Method method = Method::avo;
  bool certified = true;
};
UsualMethod usual_method(const Scenario& scenario);
Conduct conduct_of(const RobotSetup& setup, const UsualMethod& usual);
/// What A counts on from another robot that it avoids.
enum class Expectation : std::uint8_t {
  decides,           ///< it does its share, and keeps the certificate of A, if A has one
  cooperates,        ///< it should do its share, and promises nothing
  moves_on,          ///< A knows its velocity alone: it has failed, or only A keeps a certificate
  does_as_it_likes,  ///< it does not avoid A, and keeps its limits
};
/// None where A does not avoid B.
inline std::optional<Expectation> expected_of(const Conduct& b, const Conduct& a) {
  if ((a.avoids.bits & b.layers.bits) == 0) return std::nullopt;
  const bool is_like =
      b.method == a.method || (a.certified ? b.certified : !method_traits(a.method).has_rules);
  if ((b.avoids.bits & a.layers.bits) == 0)
    return is_like ? Expectation::does_as_it_likes : Expectation::moves_on;
  if (b.behavior == Behavior::moves_on) return Expectation::moves_on;
  if (b.behavior == Behavior::cooperates) return Expectation::cooperates;
  return is_like ? Expectation::decides : Expectation::moves_on;
}
/// A robot in the view of others with that expectation.
Neighbor sensed(const RobotTraits& traits, const Conduct& conduct, Expectation expected,
                Vec2 position, Vec2 velocity);
/// Adds the footprint of a robot of that model to what others sense of it.
void cover(const MotionModel& model, const BrakingPose& pose, Neighbor& neighbor);
/// A parked robot as others know it, by the center of its disc: all discs of its footprint, and
/// what is between them.
Wall parked_wall(const MotionModel& model, Vec2 center, double radius, double heading);
inline Wall parked_wall(const RobotSetup& setup) {
  return parked_wall(setup.model, disc_center(setup), disc_radius(setup), setup.heading);
}
/// m/s; for a robot with a heading it points along the heading, or against it.
Vec2 start_velocity(const RobotSetup& setup);

/// The memory of a robot that flies.
struct Flight {
  LoiterCircle circle;       // the circle that it falls back on
  bool has_arrived = false;  // it has passed its goal
};

/// A robot that moves as the host tells it, and does not decide. Meanwhile it avoids nobody, so
/// others keep clear of it as of a robot that does as it likes within its limits.
struct HostMotion {
  Vec2 velocity;         // m/s, after each step
  LayerSet avoids = {};  // those that it avoids once it decides again
  bool ends = false;     // it brakes, and decides again once it rests
};

/// Nanoseconds since the start of a run. Whole numbers decide exactly whether two robots decide at
/// the same time.
using Instant = std::int64_t;

/// The clock of one robot, and its present step.
struct OwnClock {
  double time_step = 0.0;      // s, from decision to decision
  Instant begin = 0, end = 0;  // of the step
  MotionState from, to;        // states at both times
  bool has_decided = false;    // false: it brakes until its first decision

  // m/s², on average.
  Vec2 acceleration() const {
    if (!(end > begin)) return {};
    return (to.velocity - from.velocity) / (static_cast<double>(end - begin) / 1e9);
  }
};

/// Columns by slot. Robots that are near each other are near in memory once the fleet has been put
/// in order. Ids ascend by rank.
struct Fleet {
  std::vector<RobotId> id;
  std::vector<int> rank;
  std::vector<RobotTraits> traits;
  std::vector<Conduct> conduct;
  std::vector<RelevantRange> range;
  std::vector<float> nearest;  // m, the radius with its nearest neighbors in the last step
  std::vector<Vec2> goal;
  std::vector<Vec2> position;  // of its disc
  std::vector<Vec2> velocity;
  std::vector<double> heading;  // rad; read where there is a model
  std::vector<Detour> detour;
  std::vector<Plan> plan;
  std::vector<double> applied_acceleration;
  std::vector<std::uint8_t> has_stood;  // whether it has stood near its goal, which others share
  std::vector<std::uint32_t> cell;      // key of its cell, see Cells

  std::vector<std::uint32_t> slot_of;  // by rank
  std::vector<OwnClock> clock;         // by rank; empty where the clock is common
  bool has_clocks = false;
  bool has_footprints = false;
  UsualMethod usual;                // of robots that have none of their own
  std::vector<std::uint32_t> pace;  // of World::paces, by rank; empty where all use the first one
  // what setups say and no other column has, by rank; empty where all have the default values
  std::vector<RobotSetup> rare;
  std::vector<MotionModel> models;  // by rank; empty where all are holonomic
  std::vector<double> own_radius;   // m, from their setups, by rank; empty where all are holonomic
  std::vector<Flight> flights;      // by rank; empty where no robot flies
  // m/s, preferred velocities that the host gave, by rank; empty where it gave none
  std::vector<std::optional<Vec2>> told;
  std::vector<std::optional<HostMotion>> host_motion;  // by rank; empty where the host moved none
  // the bodies, where their bases do not execute exactly; the fleet is that of the references then
  Bases bases;

  std::size_t size() const { return id.size(); }
  void reserve(std::size_t count);
  void add(RobotId robot, const RobotSetup& setup, std::uint32_t own_pace = 0);
  void remove(std::size_t slot);
  /// Takes all of the setup but its state, goal, model and clock. It may throw bad_alloc before any
  /// change.
  void change(std::size_t slot, const RobotSetup& setup, std::uint32_t own_pace);
  /// The walls of parked robots, in the order of their ids, as if one robot had this wall, or none.
  std::vector<Wall> parked_walls(std::optional<std::size_t> changed = {},
                                 const std::optional<Wall>& own = {}) const;
  /// Slot of the robot.
  std::optional<std::size_t> slot(RobotId robot) const;
  std::size_t search(RobotId robot) const;  // find(), slower
  /// Throws Error if there is no such robot.
  std::size_t find(RobotId robot) const {
    if (robot.value < slot_of.size()) {  // its rank, if no robot before it has gone
      const std::uint32_t own = slot_of[static_cast<std::size_t>(robot.value)];
      if (id[own] == robot) return own;
    }
    return search(robot);
  }
  OwnClock& clock_of(std::size_t slot) { return clock[static_cast<std::size_t>(rank[slot])]; }
  const OwnClock& clock_of(std::size_t slot) const {
    return clock[static_cast<std::size_t>(rank[slot])];
  }
  std::uint32_t pace_of(std::size_t slot) const {
    return pace.empty() ? 0 : pace[static_cast<std::size_t>(rank[slot])];
  }
  /// m; none: the scene's.
  std::optional<double> own_arrival_distance(std::size_t slot) const {
    if (rare.empty()) return std::nullopt;
    return rare[static_cast<std::size_t>(rank[slot])].arrival_distance;
  }
  MotionModel model(std::size_t slot) const {
    return models.empty() ? MotionModel{} : models[static_cast<std::size_t>(rank[slot])];
  }
  /// None for a holonomic robot.
  const MotionModel* own_model(std::size_t slot) const {
    return traits[slot].has_model ? &models[static_cast<std::size_t>(rank[slot])] : nullptr;
  }
  /// m: the offset of its disc from the reported place of the robot, and that place.
  Vec2 offset(std::size_t slot) const { return offset(slot, heading[slot]); }
  Vec2 offset(std::size_t slot, double heading_of_it) const;
  Vec2 place(std::size_t slot) const {
    return traits[slot].has_model ? position[slot] - offset(slot) : position[slot];
  }
  Vec2 place(std::size_t slot, const MotionState& state) const {
    return state.position - offset(slot, state.heading);
  }
  /// m: the reported place, of the body.
  Vec2 body_place(std::size_t slot) const {
    return bases.are_exact() ? place(slot) : base(slot).place();
  }
  const Base& base(std::size_t slot) const {
    return bases.all[static_cast<std::size_t>(rank[slot])];
  }
  /// The setup with its goal, position, velocity and heading.
  RobotSetup setup(std::size_t slot) const { return setup(slot, state(slot)); }
  RobotSetup setup(std::size_t slot, const MotionState& state) const;
  /// None for a robot that can rest.
  const Flight* flight(std::size_t slot) const {
    if (flights.empty() || !traits[slot].has_model || can_rest(*own_model(slot))) return nullptr;
    return &flights[static_cast<std::size_t>(rank[slot])];
  }
  Flight* flight(std::size_t slot) {
    return const_cast<Flight*>(static_cast<const Fleet*>(this)->flight(slot));
  }
  std::optional<LoiterCircle> circle(std::size_t slot) const {
    const Flight* own = flight(slot);
    return own != nullptr ? std::optional(own->circle) : std::nullopt;
  }
  MotionState state(std::size_t slot) const {
    return {position[slot], velocity[slot], heading[slot], circle(slot).value_or(LoiterCircle{})};
  }
  bool is_parked(std::size_t slot) const { return conduct[slot].behavior == Behavior::parked; }
  /// What robot a counts on from robot b; none where it does not avoid b as a neighbor.
  std::optional<Expectation> expected(std::size_t b, std::size_t a) const {
    if (is_parked(a) || is_parked(b)) return std::nullopt;
    return expected_of(conduct[b], conduct[a]);
  }
  /// m/s, the preferred velocity that the host gave to the robot.
  std::optional<Vec2> told_velocity(std::size_t slot) const {
    return told.empty() ? std::nullopt : told[static_cast<std::size_t>(rank[slot])];
  }
  /// None for a robot that decides.
  const HostMotion* moved_by_host(std::size_t slot) const {
    if (host_motion.empty()) return nullptr;
    const auto& own = host_motion[static_cast<std::size_t>(rank[slot])];
    return own ? &*own : nullptr;
  }
  bool decides(std::size_t slot) const {
    return !is_parked(slot) && moved_by_host(slot) == nullptr;
  }
  /// Returns whether the robot goes to its goal, and the host says no velocity.
  bool heads_for_goal(std::size_t slot) const {
    return moved_by_host(slot) == nullptr && !told_velocity(slot);
  }
  /// The robot in the view of others with that expectation.
  Neighbor sensed(std::size_t slot, Expectation expected = Expectation::decides) const;
  /// Moves the robot in slot order[k] to slot k. If the executor fails during that, the fleet is
  /// unusable, and torn stays true.
  void reorder(std::span<const std::uint32_t> order, Executor& executor, bool& torn);

 private:
  template <typename Action>
  void for_each_column(const Action& action);
  std::vector<std::byte> scratch_;  // for reorder()
};

/// The robot with its limits and its model, in no particular state.
Robot limits_of(const Fleet& fleet, std::size_t slot);

/// m: the target of its disc that brings its place to the end of its route; other aims are for the
/// disc.
inline Vec2 disc_goal(const Fleet& fleet, std::size_t slot, Vec2 aim, Vec2 end) {
  return aim == end ? aim + fleet.offset(slot) : aim;
}

/// m/s: the preferred velocity of a robot that flies.
inline Vec2 course_of(const Flight& flight, Vec2 position, Vec2 goal, double preferred_speed) {
  const Vec2 to_goal = goal - position;
  const double distance = norm(to_goal);
  if (flight.has_arrived || !(distance > 0.0)) return {};
  return (preferred_speed / distance) * to_goal;
}

/// Order-dependent 64-bit hash of the bits of all positions, velocities and headings.
std::uint64_t hash_of(const Fleet& fleet, const MoverColumns& movers, std::int64_t steps);

}  // namespace avo::inline sim
