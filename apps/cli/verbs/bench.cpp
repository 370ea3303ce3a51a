// SPDX-License-Identifier: Apache-2.0
// avo bench: the cost of a step of a scene. It runs the same steps several times, with nothing else
// between them. It runs them once more to count pairs and to separate the stages.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <utility>
#include <vector>
#ifdef __GLIBC__
#include <malloc.h>
#if __GLIBC_PREREQ(2, 33)
#define AVO_COUNTS_ALLOCATED
#endif
#endif

#include "avo/simulation.h"
#include "avo/space/simulation.h"
#include "exit_codes.h"
#include "reports/bench_report.h"
#include "reports/settings_report.h"
#include "system/terminal.h"
#include "verbs/space_verbs.h"
#include "verbs/verbs.h"

namespace avo_cli {
namespace {

constexpr int kRuns = 3;

/// The steps that are measured.
struct Course {
  std::int64_t warm_up = 0;  ///< number of steps before them
  std::int64_t steps = 0;
  bool until_arrival = false;  ///< fewer steps if all robots have arrived
};

std::int64_t last_step_of(const avo::Scenario& scenario) {
  return avo::last_step(scenario, scenario.duration);
}
std::int64_t last_step_of(const avo::space::Scenario& scenario) {
  return std::llround(scenario.duration / scenario.time_step);
}

template <class Scenario>
Course course_of(const Scenario& scenario, const BenchArguments& arguments) {
  constexpr std::int64_t kWarmUp = 10, kFewest = 20, kInMotion = 100, kRobotSteps = 20'000'000;
  if (arguments.steps) return {kWarmUp, *arguments.steps, false};
  const auto robots = static_cast<std::int64_t>(scenario.robots.size());
  const std::int64_t most = std::max(kFewest, kRobotSteps / robots);
  // its robots arrive one by one: the scene is representative only while nearly all are moving
  if (scenario.name.starts_with("uniform-")) return {kWarmUp, std::min(kInMotion, most), false};
  return {0, std::min(last_step_of(scenario), most), true};
}

/// Steps of a fleet. With free clocks, a step comprises all instants within one time step, so that
/// each robot decides about once in it.
class PlaneFleet {
 public:
  PlaneFleet(const avo::Scenario& scenario, int threads)
      : simulation_(scenario, threads),
        time_step_(scenario.time_step),
        free_(scenario.clock == avo::Clock::free) {}

  void take() {
    if (!free_) return simulation_.step();
    const double end = static_cast<double>(++taken_) * time_step_;
    while (simulation_.can_step_by(end)) simulation_.step();
  }
  void measure() {
    tell_machine(simulation_);
    simulation_.measure(true);
  }
  [[nodiscard]] bool all_at_goal() const { return simulation_.all_at_goal(); }
  [[nodiscard]] int threads() const { return simulation_.threads(); }
  [[nodiscard]] avo::StepProfile profile() const { return simulation_.profile(); }

 private:
  avo::Simulation simulation_;
  double time_step_;
  bool free_;
  std::int64_t taken_ = 0;
};

/// The same of a fleet in space. Its stages are not separated.
class SpaceFleet {
 public:
  SpaceFleet(const avo::space::Scenario& scenario, int threads) : simulation_(scenario, threads) {}

  void take() {
    simulation_.step();
    if (!measures_) return;
    for (const avo::space::Plan& plan : simulation_.plans()) {
      ++profile_.robot_steps;
      if (plan.violation > 0.0) ++profile_.infeasible;
    }
  }
  void measure() { measures_ = true; }
  [[nodiscard]] bool all_at_goal() const { return simulation_.all_at_goal(); }
  [[nodiscard]] int threads() const { return simulation_.threads(); }
  [[nodiscard]] avo::StepProfile profile() const { return profile_; }

 private:
  avo::space::Simulation simulation_;
  bool measures_ = false;
  avo::StepProfile profile_;
};

/// Calls around(take) for each step of the course, where take() takes the step.
template <class Fleet, class Around>
void follow(Fleet& fleet, const Course& course, const Around& around) {
  for (std::int64_t k = 0; k < course.steps; ++k) {
    if (course.until_arrival && k > 0 && fleet.all_at_goal()) return;
    around([&fleet] { fleet.take(); });
  }
}

template <class Fleet, class Scenario>
std::vector<double> time_steps(const Scenario& scenario, int threads, const Course& course) {
  using Clock = std::chrono::steady_clock;
  Fleet fleet(scenario, threads);
  for (std::int64_t k = 0; k < course.warm_up; ++k) fleet.take();
  std::vector<double> milliseconds;
  follow(fleet, course, [&](const auto& take) {
    const Clock::time_point start = Clock::now();
    take();
    milliseconds.push_back(std::chrono::duration<double, std::milli>(Clock::now() - start).count());
  });
  return milliseconds;
}

/// Returns the bytes that this process has allocated and not freed; 0 if unknown.
std::size_t allocated_bytes() {
#ifdef AVO_COUNTS_ALLOCATED
  const struct mallinfo2 info = mallinfo2();
  return info.uordblks + info.hblkhd;
#else
  return 0;
#endif
}

/// Measures stages, pairs and memory; it also returns the number of threads.
template <class Fleet, class Scenario>
BenchResults profile_steps(const Scenario& scenario, int threads, const Course& course) {
  const std::size_t before = allocated_bytes();
  Fleet fleet(scenario, threads);
  for (std::int64_t k = 0; k < course.warm_up; ++k) fleet.take();
  fleet.measure();
  follow(fleet, course, [](const auto& take) { take(); });
  BenchResults results;
  results.threads = fleet.threads();
  results.profile = fleet.profile();
  results.bytes = allocated_bytes() - before;
  return results;
}

/// Takes the median step by step: the runs are the same bit for bit, so they have the same number
/// of steps.
std::vector<double> median_run(const std::vector<std::vector<double>>& runs) {
  std::vector<double> result;
  for (std::size_t k = 0; k < runs[0].size(); ++k) {
    std::vector<double> same(runs.size());
    std::transform(runs.begin(), runs.end(), same.begin(), [k](const auto& run) { return run[k]; });
    result.push_back(median(std::move(same)));
  }
  return result;
}

/// Measures the steps; it reports progress between the runs, never within the timed part.
template <class Fleet, class Scenario>
BenchResults measure(const Scenario& scenario, int threads, const Course& course) {
  Progress progress = Progress::of_parts(1 + kRuns);
  BenchResults results = profile_steps<Fleet>(scenario, threads, course);  // this run also warms up
  results.runs = kRuns;
  std::vector<std::vector<double>> runs;
  while (runs.size() < kRuns) {
    progress.show(1.0 + static_cast<double>(runs.size()));
    runs.push_back(time_steps<Fleet>(scenario, threads, course));
  }
  results.milliseconds = median_run(runs);
  return results;
}

template <class Fleet, class Scenario>
int tell_bench(const Scenario& scenario, const BenchArguments& arguments) {
  const Course course = course_of(scenario, arguments);
  const BenchResults results = measure<Fleet>(scenario, arguments.threads, course);
  const avo::PlannerOptions options = planner_options(scenario);
  const BenchScene scene{scenario.name, scenario.robots.size(), scenario.time_step,
                         to_string(options.method), to_string(options.certificate)};
  if (arguments.json)
    print(to_json(scene, results));
  else
    print_results(readable(scene, results));
  return kDone;
}

}  // namespace

int bench(const BenchArguments& arguments) {
  if (const auto in_space = load_in_space(arguments.scene, {}))
    return tell_bench<SpaceFleet>(*in_space, arguments);
  return tell_bench<PlaneFleet>(load(arguments.scene), arguments);
}

}  // namespace avo_cli
