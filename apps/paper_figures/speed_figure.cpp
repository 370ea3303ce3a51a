// SPDX-License-Identifier: Apache-2.0
// The paper's Fig. 10: milliseconds a step against the number of robots on the circle.
#include <algorithm>
#include <ctime>
#include <fstream>

#include "avo/simulation.h"
#include "avo_io/scene.h"
#include "figures/chart.h"
#include "figures_of_the_paper.h"

namespace avo::paper {
namespace {

struct StepTime {
  double median = 0.0, high = 0.0;  // ms; `high` bounds 95 % of the steps
};

// Processor time, which does not count what else the machine does, of all steps on one thread until
// everybody could be on the other side, with a reserve of 30 %.
StepTime measure(int robots) {
  const Scenario scenario =
      avo_io::load_scenario("circle-" + std::to_string(robots), {"method=avo_paper"});
  const RobotSetup& one = scenario.robots.front();
  const double crossing = 1.3 * norm(one.goal - one.position) / one.preferred_speed;
  Simulation simulation(scenario, 1);
  std::vector<double> milliseconds;
  while (!simulation.all_at_goal() && simulation.time() < crossing) {
    const std::clock_t start = std::clock();
    simulation.step();
    milliseconds.push_back(1e3 * static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC);
  }
  std::sort(milliseconds.begin(), milliseconds.end());
  return {milliseconds[milliseconds.size() / 2], milliseconds[milliseconds.size() * 19 / 20]};
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
  figures::Series median{"median", {}, {0.00, 0.36, 0.66, 1.0}};
  figures::Series high{"95 % of the steps", {}, {0.80, 0.30, 0.00, 1.0}, true, 3.0};
  for (const int robots : {10, 50, 100, 200, 300, 400, 500, 600, 700, 800, 900, 1000}) {
    const StepTime time = measure(robots);
    median.points.push_back({1.0 * robots, time.median});
    high.points.push_back({1.0 * robots, time.high});
  }
  const std::string path = folder + "/fig-10.png";
  save(path, figures::draw_chart({"number of robots", "time of a step (ms)", {median, high}}, path,
                                 {.width = 360.0}));
  const double thousand = median.points.back().y;
  const double hundred = median.points[2].y;
  return {"10",
          "fig-10.png",
          "Time of a step",
          "Processor time of a whole step (neighbors, decisions, motion) of Circle-n during its "
          "crossing, on "
          "one thread of " +
              processor() + ". 1000 robots: median " + format("%.2f ms", thousand) +
              ", 95 % of the steps below " + format("%.2f ms", high.points.back().y) + ".",
          "the median for 1000 robots is " + format("%.1f", thousand / hundred) +
              " times that for 100; the paper calls its growth about linear.",
          "the paper shows less than 30 ms for 1000 robots, for the new velocities alone, on 8 "
          "threads of a Core i7 at 3.2 GHz. Times depend on the machine."};
}

}  // namespace avo::paper
