// SPDX-License-Identifier: Apache-2.0
// The paper's Fig. 10: milliseconds per step against the number of robots on the circle.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <ctime>
#include <fstream>
#include <random>
#include <string>
#include <vector>

#include "avo/simulation.h"
#include "avo_io/scene.h"
#include "figures/chart.h"
#include "figures/colors.h"
#include "figures_of_the_paper.h"

namespace avo::paper {
namespace {

constexpr std::size_t kRuns = 9;  // of each circle
constexpr double kJitter = 0.1;   // m, of each coordinate of starts and goals
constexpr std::array kCircles{10, 50, 100, 200, 300, 400, 500, 600, 700, 800, 900, 1000};

struct StepTime {
  double median = 0.0, high = 0.0;  // ms; `high` bounds 95 % of the steps
};

double median_of(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return values[values.size() / 2];
}

// Returns a circle with starts and goals slightly shifted; each seed shifts them differently.
Scenario circle(int robots, std::uint64_t seed) {
  Scenario scenario =
      avo_io::load_scenario("circle-" + std::to_string(robots), {"method=avo_paper"});
  std::mt19937_64 random(seed);
  const auto moved = [&random](Vec2 place) {
    const auto off = [&random] {
      return kJitter * (std::ldexp(static_cast<double>(random() >> 11), -52) - 1.0);
    };
    const double x = off();
    return place + Vec2{x, off()};
  };
  for (RobotSetup& robot : scenario.robots)
    robot.position = moved(robot.position), robot.goal = moved(robot.goal);
  return scenario;
}

// Measures processor time, which does not include other work of the machine. It covers all steps on
// one thread until every robot could be on the other side, with a reserve of 30 %.
StepTime measure(const Scenario& scenario) {
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

// Measures for each circle the medians over its runs. All circles are run in turns, so that an hour
// in which the machine is slower counts for all of them.
std::vector<StepTime> measure_all() {
  std::array<std::vector<double>, kCircles.size()> medians, highs;
  for (std::size_t run = 0; run < kRuns; ++run) {
    for (std::size_t k = 0; k < kCircles.size(); ++k) {
      const StepTime time = measure(circle(kCircles[k], run + 1));
      medians[k].push_back(time.median), highs[k].push_back(time.high);
    }
  }
  std::vector<StepTime> times;
  for (std::size_t k = 0; k < kCircles.size(); ++k)
    times.push_back({median_of(medians[k]), median_of(highs[k])});
  return times;
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
  figures::Series median{"median", {}, figures::kBlue};
  figures::Series high{"95 % of the steps", {}, figures::kVermilion, true, 3.0};
  const std::vector<StepTime> times = measure_all();
  for (std::size_t k = 0; k < times.size(); ++k) {
    median.points.push_back({1.0 * kCircles[k], times[k].median});
    high.points.push_back({1.0 * kCircles[k], times[k].high});
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
          "crossing, on one thread of " +
              processor() + ". Each circle was run " + std::to_string(kRuns) +
              " times, in turns with the others, with starts and goals up to 0.1 m off. The curves "
              "are medians over the runs. 1000 robots: median " +
              format("%.2f ms", thousand) + ", 95 % of the steps below " +
              format("%.2f ms", high.points.back().y) + ".",
          "the median for 1000 robots is " + format("%.1f", thousand / hundred) +
              " times that for 100; the paper calls its growth about linear.",
          "the paper shows less than 30 ms for 1000 robots, on 8 threads of a Core i7 at 3.2 GHz. "
          "This time is that of the new velocities alone. Times depend on the machine."};
}

}  // namespace avo::paper
