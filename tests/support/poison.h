// SPDX-License-Identifier: Apache-2.0
// Scratch memory as another decision could have left it, in the worst case.
#pragma once
#include <array>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "planner/scratch.h"

namespace avo::test {

/// Overwrites all contents of a planner's scratch memory by a number. Sizes of vectors stay,
/// because they determine the room. The bindings list all members: a new member must be added here.
class Poison {
 public:
  explicit Poison(double number) : number_(number) {}

  void operator()(PlanWorkspace& workspace) const {
    auto& [soft, decisions, programs, rows, demands, hard_and_soft, obstacles, order, ordered,
           alone, listed, movers, indices, passive, certified, flight, evasion, steering] =
        PlanWorkspace::Scratch::of(workspace);
    each(soft, decisions, rows, demands, hard_and_soft, order, alone, certified, flight, evasion,
         steering);
    // one robot has no programs; the others are lists, which are cleared before they are read
    static_cast<void>(programs), static_cast<void>(obstacles), static_cast<void>(ordered);
    static_cast<void>(listed), static_cast<void>(movers), static_cast<void>(indices);
    static_cast<void>(passive);
  }

 private:
  template <typename... Members>
  void each(Members&... members) const {
    (spoil(members), ...);
  }

  void spoil(double& x) const { x = number_; }
  void spoil(bool& x) const { x = true; }
  void spoil(std::uint8_t& x) const { x = 1; }
  void spoil(int& x) const { x = std::numeric_limits<int>::min() / 2; }
  void spoil(std::uint32_t& x) const { x = 0x7ffffff0; }
  void spoil(std::size_t& x) const { x = 0x7ffffff0; }
  void spoil(ProgramState& x) const { x = ProgramState::discs_disjoint; }
  void spoil(PairState& x) const { x = PairState::coincident; }
  void spoil(Vec2& x) const { each(x.x, x.y); }
  void spoil(HalfPlane& x) const { each(x.normal, x.offset); }
  void spoil(Segment& x) const { each(x.a, x.b); }
  template <typename T>
  void spoil(std::vector<T>& column) const {
    for (T& entry : column) spoil(entry);
  }
  template <typename T, std::size_t kCount>
  void spoil(std::array<T, kCount>& entries) const {
    for (T& entry : entries) spoil(entry);
  }
  template <std::size_t kCount>
  void spoil(double (&lanes)[kCount]) const {
    for (double& lane : lanes) spoil(lane);
  }
  // the targets of its pointers no longer exist
  void spoil(std::vector<const NearPair*>& waiting) const {
    for (auto& pair : waiting) pair = nullptr;
  }

  void spoil(ProgramRow<1>& row) const { each(row.n_x, row.n_y, row.offset, row.relative); }
  void spoil(LoiterCircle& circle) const { each(circle.center, circle.radius); }
  void spoil(MoverMotion& motion) const {
    auto& [acceleration, max_deviation, max_speed, likely_deviation, trajectory, trajectory_time] =
        motion;
    each(acceleration, max_deviation, max_speed, likely_deviation, trajectory_time);
    trajectory = nullptr;
  }
  void spoil(TrajectorySteps& steps) const { each(steps.x, steps.y, steps.bend); }

  void spoil(SharedPlanes& shared) const {
    auto& [offset, kept, kept_end, exceeding] = shared;
    each(offset, kept, kept_end, exceeding);
  }
  void spoil(PairColumns& pairs) const {
    auto& [count, p_x, p_y, v_x, v_y, radius, reach] = pairs;
    each(count, p_x, p_y, v_x, v_y, radius, reach);
  }
  void spoil(PlaneColumns& planes) const {
    auto& [n_x, n_y, h, excess, state] = planes;
    each(n_x, n_y, h, excess, state);
  }
  void spoil(HalfPlaneQueue& queue) const {
    auto& [count, index] = queue;
    each(count, index);
  }
  void spoil(HalfPlaneWorkspace& workspace) const {
    auto& [convex, horn, rest, cases] = workspace;
    each(convex, horn, rest);
    auto& [contact, tip, convexes, horns, follow, others] = cases;
    each(contact, tip, convexes, horns, follow, others);
  }
  void spoil(TilePairs& pairs) const {
    auto& [columns, end, share, raise] = pairs;
    each(columns, end, share, raise);
  }
  void spoil(SoftPlanes& soft) const {
    auto& [planes, excess, exceeding, first, overlapping, coinciding, shared, pairs, workspace,
           relative] = soft;
    each(planes, excess, exceeding, first, overlapping, coinciding, shared, pairs, workspace,
         relative);
  }
  void spoil(DecisionColumns& decisions) const {
    auto& [range, ahead, is_beside, push_x, push_y, push_at_rest_x, push_at_rest_y, wish_x, wish_y,
           aim_x, aim_y, last_x, last_y, target_x, target_y, violation, state, next_x, next_y,
           new_x, new_y, a_x, a_y, is_free] = decisions;
    each(range, ahead, is_beside, push_x, push_y, push_at_rest_x, push_at_rest_y, wish_x, wish_y,
         aim_x, aim_y, last_x, last_y, target_x, target_y, violation, state, next_x, next_y, new_x,
         new_y, a_x, a_y, is_free);
  }
  void spoil(Demands& demands) const {
    auto& [planes, excess, wall, overlapping, out] = demands;
    each(planes, excess, wall, overlapping, out);
  }
  void spoil(FlightConstraints& flight) const {
    auto& [lines, walls, slack, broken, broken_wall] = flight;
    for (auto& [neighbor, normal, part] : lines) each(neighbor, normal, part);
    for (auto& [a, b, radius] : walls) each(a, b, radius);
    each(slack, broken, broken_wall);
  }

  void spoil(NeighborColumns& neighbors) const {
    auto& [count, has_movers, has_aged, has_priorities, has_max_braking, has_deviations,
           has_partings, x, y, v_x, v_y, radius, max_acceleration, decides, priority, max_braking,
           age, position_error, motion, has_loiterers, loiter, has_footprints, covers, parting] =
        neighbors;
    each(count, has_movers, has_aged, has_priorities, has_max_braking, has_deviations, has_partings,
         x, y, v_x, v_y, radius, max_acceleration, decides, priority, max_braking, age,
         position_error, motion, has_loiterers, loiter, has_footprints, parting);
    static_cast<void>(covers);
  }
  // model, neighbors, loiter and lookahead are lists
  void spoil(RobotColumns& robots) const {
    auto& [count, x, y, v_x, v_y, preferred_x, preferred_y, distance_to_goal, radius,
           max_acceleration, max_speed, max_braking, heading, priority, model, has_models,
           neighbors, loiter, lookahead] = robots;
    each(count, x, y, v_x, v_y, preferred_x, preferred_y, distance_to_goal, radius,
         max_acceleration, max_speed, max_braking, heading, priority, has_models);
    static_cast<void>(model), static_cast<void>(neighbors), static_cast<void>(loiter);
    static_cast<void>(lookahead);
  }
  void spoil(Tile& tile) const {
    auto& [robots, neighbors, detour, plan, walls, slot, maneuvers, remembers, trusted] = tile;
    each(robots, neighbors, slot, maneuvers);
    remembers = trusted = false;
    static_cast<void>(detour), static_cast<void>(plan), static_cast<void>(walls);
  }

  void spoil(BrakingProfile& profile) const {
    auto& [speed, decrement, full_steps] = profile;
    each(speed, decrement, full_steps);
  }
  void spoil(Braking& braking) const {
    auto& [profile, increment, direction, length, reach, intervals] = braking;
    each(profile, increment, direction, length, reach, intervals);
  }
  void spoil(Deviation::Line& line) const { each(line.start, line.per_distance); }
  void spoil(Deviation& deviation) const {
    auto& [ahead, across, anyhow, fast, slow, most_ahead, most_aside] = deviation;
    each(ahead, across, anyhow, fast, slow, most_ahead, most_aside);
  }
  void spoil(ConstraintColumns& columns) const {
    auto& [count, judged, normal, cone, bound, offset, interval, needs, coefficient, neighbor] =
        columns;
    each(count, judged, normal, cone, bound, offset, interval, needs, coefficient, neighbor);
  }
  void spoil(OwnColumns& own) const {
    auto& [count, filled, start, middle, ahead, across, anyhow, most] = own;
    each(count, filled, start, middle, ahead, across, anyhow, most);
  }
  void spoil(TrajectoryConstraints& constraints) const {
    auto& [columns, own, deviation, own_columns, trajectory, waiting, stays_at_rest, has_cones] =
        constraints;
    each(columns, own, deviation, own_columns, trajectory, waiting, stays_at_rest, has_cones);
  }
  void spoil(LoiterLine& line) const {
    auto& [neighbor, normal, offset, begin] = line;
    each(neighbor, normal, offset, begin);
  }
  void spoil(NearWall& wall) const {
    auto& [segment, distance, held, margin, normal, cone, index] = wall;
    each(segment, distance, held, margin, normal, cone, index);
  }
  void spoil(WallConstraints& walls) const {
    auto& [near, middle, stop, backup, first, broken, doubtful, must_brake] = walls;
    each(near, middle, stop, backup, first, broken, doubtful, must_brake);
  }
  void spoil(CandidatePath& path) const {
    auto& [first, next_velocity, direction, speed, way, moving, bend, swing, braking, begin, end,
           grown_within, grown, lever] = path;
    each(first, next_velocity, direction, speed, way, moving, bend, swing, braking, begin, end,
         grown_within, grown, lever);
  }
  void spoil(Deepest& deepest) const { each(deepest.index, deepest.depth); }
  void spoil(Invariant& invariant) const {
    auto& [slack, broken, touched, unknown, doubtful] = invariant;
    each(slack, broken, touched, unknown, doubtful);
  }
  void spoil(BrakingColumns& own) const {
    auto& o = own;
    each(o.speed, o.decrement, o.increment, o.full_steps, o.direction_x, o.direction_y, o.length,
         o.reach, o.intervals, o.stray_velocity, o.stray_distance, o.ahead_start, o.ahead_slope,
         o.across_start, o.across_slope, o.anyhow_start, o.anyhow_slope, o.fast_speed, o.fast_steps,
         o.slow_speed, o.slow_steps, o.most_ahead, o.most_aside, o.far_distance,
         o.far_speed_squared, o.clear_distance, o.per_decrement, o.next_ahead, o.next_aside,
         o.far_reach);
  }
  void spoil(NearQueue& queue) const { each(queue.robot, queue.place); }
  void spoil(NearPair& pair) const {
    auto& [robot, neighbor, p, contact, inflated, error, share, b, gap, against] = pair;
    each(robot, neighbor, p, contact, inflated, error, share, b, gap, against);
  }
  void spoil(NearPairs& near) const {
    auto& [own, queue, kept, end, has_others, admits] = near;
    each(own, queue, kept, end, has_others, admits);
  }
  void spoil(CertificateConstraints& constraints) const {
    auto& [invariant, trajectories, loiterers, walls, footprint, path, near, alone, seen] =
        constraints;
    for (DiscConstraints& disc : footprint.discs)
      each(disc.ahead, disc.trajectories, disc.walls, disc.path);
    each(invariant, trajectories, loiterers, walls, path, near, alone, seen);
  }
  void spoil(CertifiedWorkspace& certified) const {
    auto& [constraints, hard, rows] = certified;
    each(constraints, hard, rows);
  }

  void spoil(Predicted& other) const {
    each(other.position, other.velocity, other.acceleration, other.contact, other.drift,
         other.deviation, other.reaction, other.asks_to_stop, other.stop_contact, other.max_speed,
         other.fastest);
  }
  void spoil(KeptWall& wall) const { each(wall.segment, wall.kept, wall.clear_until); }
  void spoil(Surroundings& around) const {
    auto& [others, trajectories, walls, clear_now, clear_after, clear_until, after, last, brakes_at,
           intervals, brakings, discs, refused_by, work] = around;
    for (KnownInterval& known : intervals) spoil(known.path.end);
    static_cast<void>(brakings);  // no interval belongs to a path that is still to come
    for (Hull& disc : discs.moving) each(disc.start, disc.middle, disc.end, disc.bend);
    for (BrakingDisc& disc : discs.braking) each(disc.offset, disc.grown);
    each(refused_by, others, trajectories, walls, clear_now, clear_after, clear_until,
         after.position, after.velocity, after.time, after.heading, last.position, last.velocity,
         last.time, brakes_at, work);
  }
  void spoil(EvasionWorkspace& evasion) const {
    auto& [around, deciding, certified, chosen, put_aside] = evasion;
    each(around, certified, chosen.velocity, chosen.duration, put_aside);
    static_cast<void>(deciding);
  }

  void spoil(ManeuverMemory::ManeuverNode& node) const {
    auto& [pose, angle, cost, since, move, parent, moves, nearness, stops, is_first_gear] = node;
    each(pose.axle, pose.heading, angle, cost, since, move.gear, move.side, move.radius, parent,
         moves, stops, is_first_gear);
    nearness = Nearness::later;
  }
  void spoil(ManeuverMemory::Open& open) const { each(open.cost, open.node); }
  void spoil(ManeuverMemory::NodeCell& cell) const {
    cell.key = 0x7ffffff0;
    spoil(cell.node);
  }
  void spoil(SteerMemory::ManeuverObstacle& obstacle) const {
    each(obstacle.segment, obstacle.keep);
  }
  void spoil(SteerMemory& steering) const {
    auto& [obstacles, maneuvers] = steering;
    auto& [turns, nodes, open, cells] = maneuvers;
    turns.turns.fill(0.0), spoil(turns.directions);
    each(obstacles, nodes, open, cells);
  }

  double number_;
};

}  // namespace avo::test
