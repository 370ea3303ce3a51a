// SPDX-License-Identifier: Apache-2.0
// The paper's Fig. 10: milliseconds a step against the number of robots on the circle.
#include <algorithm>
#include <chrono>
#include <fstream>
#include <thread>

#include "avo/simulation.h"
#include "avo_io/scene.h"
#include "figures/chart.h"
#include "figures_of_the_paper.h"

namespace avo::paper {
namespace {

// Median time of a step over the crossing: until the robots are as far from the middle as at the
// start again, or the scene ends.
double median_milliseconds(int robots, int threads) {
  const Scenario scenario = avo_io::load_scenario("circle-" + std::to_string(robots));
  Simulation simulation(scenario, threads);
  std::vector<double> milliseconds;
  while (!simulation.all_at_goal() && simulation.time() < scenario.duration) {
    const auto start = std::chrono::steady_clock::now();
    simulation.step();
    const std::chrono::duration<double, std::milli> spent =
        std::chrono::steady_clock::now() - start;
    milliseconds.push_back(spent.count());
  }
  const auto middle = milliseconds.begin() + static_cast<std::ptrdiff_t>(milliseconds.size() / 2);
  std::nth_element(milliseconds.begin(), middle, milliseconds.end());
  return *middle;
}

std::string processor() {
  std::ifstream file("/proc/cpuinfo");
  for (std::string line; std::getline(file, line);) {
    if (line.rfind("model name", 0) == 0) return line.substr(line.find(':') + 2);
  }
  return "a processor without a name";
}

}  // namespace

Caption draw_speed(const std::string& folder) {
  const int all = static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
  std::vector<figures::Series> series{{"1 thread", {}, {0.00, 0.36, 0.66, 1.0}}};
  if (all > 1) series.push_back({std::to_string(all) + " threads", {}, {0.80, 0.30, 0.00, 1.0}});
  for (const int robots : {10, 100, 250, 500, 750, 1000}) {
    series[0].points.push_back({1.0 * robots, median_milliseconds(robots, 1)});
    if (all > 1) series[1].points.push_back({1.0 * robots, median_milliseconds(robots, all)});
  }
  figures::draw_chart({"number of robots", "time of a step (ms)", series}, folder + "/fig-10.png",
                      {.width = 360.0});
  const double one = series[0].points.back().y;
  const double per_robot = one / series[0].points[1].y / 10.0;
  return {"10",
          "fig-10.png",
          "Time of a step",
          "Median time of a whole step (neighbors, decisions, motion) of Circle-n over its "
          "crossing, on " +
              processor() + ". 1000 robots: " + format("%.1f ms", one) + " on one thread" +
              (all > 1 ? ", " + format("%.1f ms", series[1].points.back().y) + " on " +
                             std::to_string(all)
                       : "") +
              ".",
          "growth about linear: a robot of 1000 costs " + format("%.2f", per_robot) +
              " times one of 100.",
          "the paper: below 30 ms for 1000 robots on 8 threads of a Core i7 at 3.2 GHz, for the "
          "new velocities alone. Times depend on the machine and on what else it does."};
}

}  // namespace avo::paper
