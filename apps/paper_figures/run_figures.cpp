// SPDX-License-Identifier: Apache-2.0
// The paper's Figs. 1, 7, 8 and 9: scenes run to their end, with what happened in them.
#include <algorithm>
#include <array>
#include <cmath>

#include "avo/metrics.h"
#include "avo/simulation.h"
#include "avo_io/scene.h"
#include "figures/trajectories.h"
#include "figures_of_the_paper.h"

namespace avo::paper {
namespace {

struct Run {
  Scenario scenario;
  std::vector<figures::TrajectoryFrame> frames;
  RunSummary summary;
};

Run run_scene(const std::string& name) {
  Run run{avo_io::load_scenario(name), {}, {}};
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
  return run;
}

std::string seconds(const std::optional<double>& time) {
  return time ? format("%.1f s", *time) : "never";
}

// What happened, in one sentence.
std::string numbers(const RunSummary& summary) {
  const double robot_steps = static_cast<double>(summary.robots * summary.steps);
  std::string text =
      std::to_string(summary.arrived) + " of " + std::to_string(summary.robots) + " arrive";
  if (summary.mean_arrival)
    text += ", after " + format("%.1f s", *summary.mean_arrival) + " on average";
  if (summary.last_arrival)
    text += " and " + format("%.1f s", *summary.last_arrival) + " at the latest";
  text += "; " + std::to_string(summary.collision_pairs) + " pairs of robots collide";
  if (summary.first_collision_time)
    text += " (first at " + seconds(summary.first_collision_time) + ")";
  if (summary.min_clearance) {
    text += "; smallest clearance " + format("%.3f m", *summary.min_clearance);
  }
  text += "; largest acceleration " + format("%.3f m/s²", summary.max_acceleration) + ", speed " +
          format("%.3f m/s", summary.max_speed) + "; CA empty in " +
          format("%.1f %%", 100.0 * static_cast<double>(summary.infeasible_steps) / robot_steps) +
          " of the decisions.";
  return text;
}

std::string parameters(const Scenario& scenario) {
  return "δ = " + format("%g s", scenario.control_time) +
         ", τ = " + format("%g s", scenario.time_horizon) +
         ", Δt = " + format("%g s", scenario.time_step);
}

// The paper says of all its scenes that they are free of collisions.
std::string collisions_agree(const RunSummary& summary) {
  return summary.collision_pairs + summary.obstacle_collisions == 0 ? "no collision. "
                                                                    : std::string();
}
std::string collisions_differ(const RunSummary& summary) {
  if (summary.collision_pairs + summary.obstacle_collisions == 0) return {};
  return "the paper calls the motion collision-free; here " +
         std::to_string(summary.collision_pairs) +
         " pairs overlap at some time, because the linear program has no solution and the least "
         "unsafe velocity is taken. ";
}

// When the robots have come to `part` of their first mean distance from the middle, to the least
// one, and out again to `part`.
std::array<double, 3> crossing_times(const Run& run, double part) {
  std::vector<double> distance;
  for (const auto& frame : run.frames) {
    double sum = 0.0;
    for (const Vec2 at : frame.position) sum += norm(at);
    distance.push_back(sum / static_cast<double>(frame.position.size()));
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
  figures::draw_trajectories(run.scenario, run.frames, folder + "/fig-01.png");
  return {
      "1",
      "fig-01.png",
      "Positions exchange",
      "Two robots exchange positions, " + parameters(run.scenario) +
          ". Newer discs are on top and darker. " + numbers(run.summary),
      collisions_agree(run.summary) +
          "Both give way to the same side, and the spacing of the discs grows as they speed up.",
      collisions_differ(run.summary) +
          "The paper prints no positions, and its robots pass their targets at high speed; "
          "here they come to rest at them."};
}

Caption draw_moving_obstacle(const std::string& folder) {
  const Run run = run_scene("moving-obstacle");
  figures::draw_trajectories(run.scenario, run.frames, folder + "/fig-07.png");
  return {"7",
          "fig-07.png",
          "Moving obstacle",
          "One robot and an oncoming obstacle (gray) that does not react, " +
              parameters(run.scenario) + ". " + numbers(run.summary) +
              " Collisions with the obstacle: " + std::to_string(run.summary.obstacle_collisions) +
              ".",
          collisions_agree(run.summary) + "The robot goes around the obstacle to its goal.",
          collisions_differ(run.summary) + "The paper prints no positions."};
}

Caption draw_circle(const std::string& folder) {
  const Run run = run_scene("circle-100");
  const auto times = crossing_times(run, 0.65);
  figures::draw_instants(run.scenario, run.frames, times, 4.0, folder + "/fig-08.png",
                         {.width = 500.0});
  return {"8",
          "fig-08.png",
          "Circle-100",
          "100 robots move to the opposite side of a circle, " + parameters(run.scenario) +
              "; three instants, each with the trace of the last 4 s. " + numbers(run.summary),
          collisions_agree(run.summary) +
              "All robots meet in the middle, keep turning to one side, and leave the crowd "
              "again; the limits of acceleration and speed hold on every step.",
          collisions_differ(run.summary)};
}

Caption draw_cars(const std::string& folder) {
  const Run run = run_scene("cars-100");
  figures::draw_trajectories(run.scenario, run.frames, folder + "/fig-09.png", {.width = 400.0});
  return {"9",
          "fig-09.png",
          "Car-like robots",
          "100 cars with random poses and goals, " + parameters(run.scenario) +
              "; the newest frame shows the disc that is kept clear, centered at the rear axle. " +
              numbers(run.summary),
          collisions_agree(run.summary) +
              "All accelerations are turned into controls of the car by Eqs. (24), (25).",
          collisions_differ(run.summary) + "The paper prints neither the poses nor the size."};
}

}  // namespace avo::paper
