// SPDX-License-Identifier: Apache-2.0
// The paper's Figs. 1, 7, 8 and 9: scenes are run to their end, and the text tells what happened.
#include <algorithm>
#include <array>
#include <cinttypes>
#include <cmath>
#include <cstdio>

#include "avo/metrics.h"
#include "avo/simulation.h"
#include "avo_io/scene.h"
#include "figures/trajectories.h"
#include "figures_of_the_paper.h"

namespace avo::paper {
namespace {

constexpr double kTail = 4.0;     // s, of the traces of Fig. 8
constexpr double kCarTail = 6.0;  // s, of the traces of Fig. 9

struct Run {
  Scenario scenario;
  std::vector<figures::TrajectoryFrame> frames;
  RunSummary summary;
  std::string name;  // with its settings and the hash of its last state
};

Run run_scene(const std::string& name, std::vector<std::string> overrides = {}) {
  overrides.emplace_back("method=avo_paper");
  Run run{avo_io::load_scenario(name, overrides), {}, {}, name};
  Simulation simulation(run.scenario);
  Metrics metrics(run.scenario);
  figures::TrajectoryRecorder recorder;
  metrics.observe(simulation);
  recorder.observe(simulation);
  const auto steps = std::llround(run.scenario.duration / run.scenario.time_step);
  for (long long k = 0; k < steps; ++k) {
    simulation.step();
    metrics.observe(simulation);
    recorder.observe(simulation);
  }
  run.frames = recorder.frames();
  run.summary = metrics.summary();
  for (const std::string& setting : overrides) run.name += " " + setting;
  char hash[24];
  std::snprintf(hash, sizeof hash, " 0x%016" PRIx64, simulation.state_hash());
  run.name += hash;
  return run;
}

std::string clearance_text(double clearance) {
  return format(std::fabs(clearance) < 0.01 ? "%.1e m" : "%.2f m", clearance);
}

// Returns one sentence about what happened.
std::string numbers(const RunSummary& summary) {
  std::string text =
      std::to_string(summary.arrived) + " of " + std::to_string(summary.robots) + " arrive";
  if (summary.mean_arrival && summary.robots > 1) {
    text += ", after " + format("%.1f s", *summary.mean_arrival) + " on average";
  }
  if (summary.last_arrival) text += ", the last after " + format("%.1f s", *summary.last_arrival);
  if (summary.robots > 1) {
    text += "; pairs of robots that collide: " + std::to_string(summary.collision_pairs);
  }
  if (summary.first_collision_time) {
    text += " (the first after " + format("%.1f s", *summary.first_collision_time) + ")";
  }
  if (summary.min_clearance)
    text += "; smallest clearance " + clearance_text(*summary.min_clearance);
  text += "; largest acceleration " + format("%.3f m/s²", summary.max_acceleration) +
          ", largest speed " + format("%.3f m/s", summary.max_speed) + ".";
  return text;
}

std::string parameters(const Scenario& scenario) {
  const PlannerOptions options = planner_options(scenario);
  return "δ = " + format("%g s", options.control_time) +
         ", τ = " + format("%g s", options.time_horizon) +
         ", Δt = " + format("%g s", scenario.time_step);
}

// The paper says that all its scenes are free of collisions, that the robots keep the
// limits, and that the robots reach their goals. True statements go to one side, the others to the
// other side.
struct Comparison {
  std::string agrees, differs;
};

void compare_collisions(const RunSummary& summary, Comparison& to) {
  const auto collisions = summary.collision_pairs + summary.mover_collisions;
  if (collisions == 0) {
    to.agrees += "No collision. ";
    return;
  }
  to.differs += "The paper calls the motion collision-free; here " + std::to_string(collisions) +
                " pairs overlap at some time. ";
  if (summary.infeasible_steps == 0) return;
  const double decisions = static_cast<double>(summary.robots * summary.steps);
  to.differs +=
      "CA_A was empty in " +
      format("%.1f %%", 100.0 * static_cast<double>(summary.infeasible_steps) / decisions) +
      " of the decisions; there the least unsafe velocity is taken, and the method "
      "promises nothing. ";
}

Comparison compare(const Run& run) {
  const RunSummary& summary = run.summary;
  Comparison comparison;
  compare_collisions(summary, comparison);
  double max_acceleration = 0.0, max_speed = 0.0;
  for (const RobotSetup& robot : run.scenario.robots) {
    max_acceleration = std::fmax(max_acceleration, robot.max_acceleration);
    max_speed = std::fmax(max_speed, robot.max_speed);
  }
  constexpr double kRounding = 1.0 + 1e-9;
  const bool limits = summary.max_acceleration <= kRounding * max_acceleration &&
                      summary.max_speed <= kRounding * max_speed;
  (limits ? comparison.agrees : comparison.differs) +=
      limits ? "The limits of acceleration and speed hold on every step. "
             : "A limit of acceleration or speed is exceeded. ";
  const bool all = summary.arrived == summary.robots;
  (all ? comparison.agrees : comparison.differs) +=
      all ? "Every robot reaches its goal. "
          : std::to_string(summary.robots - summary.arrived) + " robots do not reach their goals. ";
  return comparison;
}

// Returns the largest distance by which the robot passes to the left of the straight line to its
// goal; negative: right.
double largest_detour(const Run& run, std::size_t robot) {
  const RobotSetup& setup = run.scenario.robots[robot];
  const Vec2 direction = (setup.goal - setup.position) / norm(setup.goal - setup.position);
  double largest = 0.0;
  for (const auto& frame : run.frames) {
    const double left = cross(direction, frame.position[robot] - setup.position);
    if (std::fabs(left) > std::fabs(largest)) largest = left;
  }
  return largest;
}

// Returns the largest distance of any robot from the middle, at any time.
double farthest(std::span<const figures::TrajectoryFrame> frames) {
  double result = 0.0;
  for (const auto& frame : frames) {
    for (const Vec2 p : frame.position) result = std::fmax(result, norm(p));
  }
  return result;
}

// Returns the final speed of the fastest robot, from the last two frames.
double final_speed(const Run& run) {
  const auto& last = run.frames.back();
  const auto& before = run.frames[run.frames.size() - 2];
  double fastest = 0.0;
  for (std::size_t i = 0; i < last.position.size(); ++i) {
    const double length = norm(last.position[i] - before.position[i]);
    fastest = std::fmax(fastest, length / (last.time - before.time));
  }
  return fastest;
}

std::string detour_text(double left) {
  return format("%.2f m", std::fabs(left)) + (left > 0.0 ? " to the left" : " to the right");
}

// Returns the mean distance of the robots from the middle of the scene, at the last frame not later
// than `time`.
double mean_distance(const std::vector<figures::TrajectoryFrame>& frames, double time) {
  std::size_t index = 0;
  while (index + 1 < frames.size() && frames[index + 1].time <= time) ++index;
  double sum = 0.0;
  for (const Vec2 at : frames[index].position) sum += norm(at);
  return sum / static_cast<double>(frames[index].position.size());
}

// Returns the times at which the mean distance from the middle falls to `part` of its first value,
// is least, and grows again to `part`.
std::array<double, 3> crossing_times(const Run& run, double part) {
  std::vector<double> distance;
  for (const auto& frame : run.frames) {
    distance.push_back(mean_distance({frame}, frame.time));
  }
  const auto least = std::min_element(distance.begin(), distance.end());
  const double wanted = part * distance.front();
  const auto in = std::find_if(distance.begin(), least, [&](double d) { return d <= wanted; });
  auto out = std::find_if(least, distance.end(), [&](double d) { return d >= wanted; });
  if (out == distance.end()) --out;
  const auto time = [&](auto it) {
    return run.frames[static_cast<std::size_t>(it - distance.begin())].time;
  };
  return {time(in), time(least), time(out)};
}

}  // namespace

Caption draw_exchange(const std::string& folder) {
  const Run run = run_scene("positions-exchange");
  const std::string path = folder + "/fig-01.png";
  save(path, figures::draw_trajectories(run.scenario, run.frames, path));
  const Comparison comparison = compare(run);
  return {"1",
          "fig-01.png",
          "Positions exchange",
          "Two robots exchange positions, " + parameters(run.scenario) +
              ". Newer discs are on top and darker; crosses are goals. " + numbers(run.summary),
          comparison.agrees + "The robots give way by " + detour_text(largest_detour(run, 0)) +
              " and " + detour_text(largest_detour(run, 1)) +
              " of their straight lines. The spacing of the discs grows as the robots speed up.",
          comparison.differs +
              "The paper prints no positions, and its robots pass their targets at high speed. "
              "Our robots come to rest there: at the end none is faster than " +
              format("%.2g m/s", final_speed(run)) + ".",
          {run.name}};
}

Caption draw_moving_obstacle(const std::string& folder) {
  const Run run = run_scene("moving-obstacle");
  const std::string path = folder + "/fig-07.png";
  save(path, figures::draw_trajectories(run.scenario, run.frames, path));
  const Comparison comparison = compare(run);
  return {"7",
          "fig-07.png",
          "Moving obstacle",
          "One robot and an oncoming obstacle (gray) that does not react, " +
              parameters(run.scenario) + ". " + numbers(run.summary),
          comparison.agrees + "The robot passes the obstacle " +
              detour_text(largest_detour(run, 0)) + " of its straight line.",
          comparison.differs + "The paper prints no positions.",
          {run.name}};
}

Caption draw_circle(const std::string& folder) {
  const Run run = run_scene("circle-100");
  const auto times = crossing_times(run, 0.65);
  const std::string path = folder + "/fig-08.png";
  save(path,
       figures::draw_instants(run.scenario, run.frames, times, kTail, path, {.width = 500.0}));
  const Comparison comparison = compare(run);
  return {"8",
          "fig-08.png",
          "Circle-100",
          "100 robots move to the opposite side of a circle, " + parameters(run.scenario) +
              ". There are three instants, each with the trace of the last " +
              format("%g s", kTail) + ". " + numbers(run.summary),
          comparison.agrees + "All robots meet in the middle: after " + format("%.1f s", times[1]) +
              " they are " + format("%.1f m", mean_distance(run.frames, times[1])) +
              " from it on average, at the start " +
              format("%.1f m", mean_distance(run.frames, 0.0)) + ".",
          comparison.differs + "Before they rest, robots swing past their goals, out to " +
              format("%.1f m", farthest(run.frames)) +
              " from the middle: the half-planes of those that have arrived refuse the braking.",
          {run.name}};
}

Caption draw_cars(const std::string& folder) {
  const Run run = run_scene("cars-100");
  const double times[] = {0.5 * run.summary.mean_arrival.value_or(run.scenario.duration)};
  const std::string path = folder + "/fig-09.png";
  save(path,
       figures::draw_instants(run.scenario, run.frames, times, kCarTail, path, {.width = 360.0}));
  const Run exact = run_scene("cars-100", {"groups.0.car.acceleration_set=exact"});
  const bool same = numbers(exact.summary) == numbers(run.summary);
  const Comparison comparison = compare(run);
  return {
      "9",
      "fig-09.png",
      "Car-like robots",
      "100 cars with random poses and goals (crosses), " + parameters(run.scenario) +
          ", with the trace of the last " + format("%g s", kCarTail) +
          ". The circle is the disc that is kept clear, centered at the rear axle. " +
          numbers(run.summary),
      comparison.agrees +
          "The accelerations are turned into controls of the car by Eqs. (24), (25).",
      (same ? "With the exact set of Fig. 6(b) all is the same: as δ a_max = 2 v_max, no choice "
              "comes to the limit of acceleration. "
            : "With the exact set of Fig. 6(b): " + numbers(exact.summary) + " ") +
          comparison.differs + "The paper prints neither poses nor sizes.",
      {run.name, exact.name}};
}

}  // namespace avo::paper
