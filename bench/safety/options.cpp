// SPDX-License-Identifier: Apache-2.0
// Parses the options of the harness, with one line for each mistake.
#include "options.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <system_error>
#include <thread>
#include <utility>

#include "scenes.h"

namespace avo::safety {
namespace {

constexpr std::array kMethods{Method::avo,
                              Method::avo_paper,
                              Method::velocity_obstacle,
                              Method::orca,
                              Method::orca_clamped,
                              Method::reciprocal_velocity_obstacle,
                              Method::buffered_voronoi};
constexpr std::array kCertificates{Certificate::none, Certificate::braking_trajectories};
constexpr std::array kMotions{Motion::held, Motion::exponential};

[[noreturn]] void refuse(const std::string& option, const std::string& found,
                         const std::string& allowed) {
  throw UsageError(option + ": found \"" + found + "\", must be " + allowed);
}

template <class T, std::size_t N>
T value_of(const std::string& option, const std::string& text, const std::array<T, N>& values) {
  std::string allowed;
  for (const T value : values) {
    if (to_string(value) == text) return value;
    allowed += (allowed.empty() ? "" : ", ") + std::string(to_string(value));
  }
  refuse(option, text, "one of " + allowed);
}

double number(const std::string& option, const std::string& text, double min, double max,
              const std::string& allowed) {
  double value = 0.0;
  const char* const end = text.data() + text.size();
  const auto result = std::from_chars(text.data(), end, value);
  const bool is_number = result.ec == std::errc() && result.ptr == end && std::isfinite(value);
  if (!is_number || value < min || value > max) refuse(option, text, allowed);
  return value;
}

std::int64_t whole(const std::string& option, const std::string& text, std::int64_t min,
                   std::int64_t max) {
  std::int64_t value = 0;
  const char* const end = text.data() + text.size();
  const auto result = std::from_chars(text.data(), end, value);
  const bool is_number = result.ec == std::errc() && result.ptr == end;
  if (!is_number || value < min || value > max) {
    refuse(option, text,
           "a whole number from " + std::to_string(min) + " to " + std::to_string(max));
  }
  return value;
}

double seconds(const std::string& option, const std::string& text) {
  return number(option, text, 1e-6, 1e6, "a number of seconds from 1e-6 to 1e6");
}

constexpr std::int64_t kMost = 1000000000;

// Returns true if there is such an option and it accepted the value.
bool take(Options& o, const std::string& option, const std::string& text) {
  if (option == "--row") {
    o.rows.push_back(text);
  } else if (option == "--scenes") {
    o.scenes = static_cast<int>(whole(option, text, 1, 1000000));
  } else if (option == "--first-seed") {
    o.first_seed = static_cast<std::uint64_t>(whole(option, text, 0, kMost));
  } else if (option == "--robot-steps") {
    o.soak_steps = number(option, text, 1.0, 1e12, "a number from 1 to 1e12");
  } else if (option == "--threads") {
    o.threads = static_cast<int>(whole(option, text, 1, 1024));
  } else if (option == "--json") {
    o.json = text;
  } else if (option == "--record") {
    o.record = text;
  } else {
    return false;
  }
  return true;
}

// Does the same for options that change the scenes; it remembers them in their original text.
bool take_setting(Options& o, const std::string& option, const std::string& text) {
  if (option == "--method") {
    o.method = value_of(option, text, kMethods);
  } else if (option == "--certificate") {
    o.certificate = value_of(option, text, kCertificates);
  } else if (option == "--motion") {
    o.motion = value_of(option, text, kMotions);
  } else if (option == "--control-time") {
    o.control_time = seconds(option, text);
  } else if (option == "--time-horizon") {
    o.time_horizon = seconds(option, text);
  } else {
    return false;
  }
  o.settings.push_back(option + " " + text);
  return true;
}

}  // namespace

const char* usage() {
  return R"(avo_bench_safety: safety and arrival over families of scenes.

  --row NAME          only this row, or those whose names begin so; may be repeated
  --list              names the rows and ends
  --scenes N          scenes of each row whose scenes differ
  --first-seed S      seed of the first scene of each row, default 1
  --robot-steps X     robot-steps of each crush and each row of walls- but
                      walls-movers, in all its scenes, default 1e7; a tenth of it for
                      mixed-crush
  --method NAME       avo, avo_paper, velocity_obstacle, orca, orca_clamped,
                      reciprocal_velocity_obstacle, buffered_voronoi
  --certificate NAME  none, braking_trajectories
  --motion NAME       held, exponential
  --control-time S    delta, where the row does not name its own
  --time-horizon S    tau, likewise
  --threads N         scenes at a time, default: as many as the machine has; times alone depend on it
  --json FILE         one JSON object a row
  --record FILE       of a single scene: CSV as avo run --record writes it

Columns, over all scenes of a row:
  robots, steps       robots; robot-steps
  pairs               of robots that ever overlapped, in continuous time
  a or v              robot-steps above a_max, or whose positions do not follow their velocities;
                      states above v_max
  clear mm            least distance of two robots, less their radii
  unsafe              scenes with any of it, with a wall touched, or with an obstacle touched by a
                      robot in motion; where there are none, the rate that 95 % confidence leaves
                      (three by the scenes)
  arrive%, at end%    robots that were ever within 0.5 m of their goal; that were at the end
  last s, 99% s       until all, until 99 % had arrived
  ratio, 99%          the same by the row's own time: the target of circles (aim 1), 60 s of random
                      squares and movers (aim 1), 600 s of passages, 300 s of touching goals, of
                      the others the longest straight way's time (aim 3, at most 4.5, 8 or 20)
  late                scenes where too few arrived in time: all by the target or 60 s, 98 % by 600 s,
                      all by 300 s or 8 straight ways, or 99 % by 4.5 or 20
  us, worst           CPU microseconds of Simulation::step a robot-step: mean, and mean of the worst
                      second; includes about 0.3 us a step for reading the clock
Lines below a row: in how many scenes all arrive, the fewest that do in one, the median of the scenes'
last arrivals (who never arrives counts as the scene's duration); walls; decisions.

Exit status: 0; 1 where anything happened that a certificate rules out; 2 usage; 3 scene; 4 output.
)";
}

Options parse_options(int count, const char* const* arguments) {
  Options options;
  options.threads = std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
  for (int i = 1; i < count; ++i) {
    const std::string option = arguments[i];
    if (option == "--help" || option == "-h") {
      options.help = true;
      continue;
    }
    if (option == "--list") {
      options.list = true;
      continue;
    }
    const std::string text = i + 1 < count ? arguments[++i] : "";
    if (text.empty()) throw UsageError(option + ": found no value, or no such option; see --help");
    if (!take(options, option, text) && !take_setting(options, option, text)) {
      throw UsageError(option + ": found no such option; see --help");
    }
  }
  return options;
}

bool is_asked_for(const Options& options, const std::string& row,
                  const std::vector<std::string>& all_rows) {
  if (options.rows.empty()) return true;
  return std::any_of(options.rows.begin(), options.rows.end(), [&](const std::string& asked) {
    if (asked == row) return true;
    const bool is_name = std::find(all_rows.begin(), all_rows.end(), asked) != all_rows.end();
    return !is_name && row.starts_with(asked);
  });
}

void apply(const Options& options, Scenario& scenario) {
  if (options.method) scenario.method = *options.method;
  if (options.certificate) scenario.certificate = *options.certificate;
  if (options.motion) scenario.motion = *options.motion;
  if (options.control_time && !scenario.control_time) scenario.control_time = options.control_time;
  if (options.time_horizon && !scenario.time_horizon) scenario.time_horizon = options.time_horizon;
  see_far_enough(scenario);
}

}  // namespace avo::safety
