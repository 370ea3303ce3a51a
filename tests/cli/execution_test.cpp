// SPDX-License-Identifier: Apache-2.0
// Scenes with bases that do not execute exactly: avo run records the bodies, and avo check judges
// them.
#include <cmath>
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <numbers>
#include <string>

#include "recordings.h"

namespace avo_test {
namespace {

// Twenty robots that press towards one point.
std::string crush() {
  std::string scene =
      "version: 1\nname: crush\nduration: 15\n"
      "execution: {time_constant: 0.2, dead_time: 0.13, deadband: 0.04, quantum: 0.02}\nrobots:\n";
  for (int k = 0; k < 20; ++k) {
    const double angle = 2.0 * std::numbers::pi * k / 20.0;
    const double x = std::cos(angle), y = std::sin(angle), goal = 0.1 + 0.03 * k;
    scene += fmt::format("  - {{position: [{}, {}], goal: [{}, {}], radius: 0.4}}\n", 8.0 * x,
                         8.0 * y, goal * x, goal * y);
  }
  return scene;
}

// The same of drives with slow wheels, two thirds of all.
std::string crush_of_drives() {
  std::string scene =
      "version: 1\nname: crush of drives\nduration: 40\n"
      "execution: {dead_time: 0.05, deadband: 0.05, quantum: 0.02, heading_age: 0.02}\nrobots:\n";
  for (int k = 0; k < 20; ++k) {
    const double angle = 2.0 * std::numbers::pi * k / 20.0;
    const double x = std::cos(angle), y = std::sin(angle), goal = 0.1 + 0.03 * k;
    const std::string drive =
        k % 3 == 0 ? ""
                   : ", drive: {track: 0.4, offset: 0.2, wheel_speed: 1.5, wheel_acceleration: 3}";
    scene += fmt::format(
        "  - {{position: [{}, {}], goal: [{}, {}], radius: 0.3, max_speed: 0.4, max_acceleration: "
        "0.5{}}}\n",
        6.0 * x, 6.0 * y, goal * x, goal * y, drive);
  }
  return scene;
}

ProcessResult judged(const std::string& name, Strings overrides,
                     const std::string& text = crush()) {
  const std::string scene = path_of("crush.yaml"), record = path_of(name);
  write_file(scene, text);
  Strings run{"run", scene, "--record", record, "-q"};
  run.insert(run.end(), overrides.begin(), overrides.end());
  const ProcessResult done = run_avo(run);
  EXPECT_EQ(done.exit_code, 0) << done.err;
  return run_avo({"check", record, "--scene", scene});
}

TEST(Execution, is_run_recorded_and_judged) {
  for (const char* name : {"bodies.csv", "bodies.h5"}) {
    const ProcessResult words = judged(name, {});
    EXPECT_EQ(words.exit_code, 0) << words.out << words.err;
    EXPECT_NE(words.out.find("paths known to"), std::string::npos) << words.out;
  }
}

TEST(Execution, that_is_not_declared_is_found) {
  const ProcessResult words = judged("undeclared.csv", {"--set", "execution_error=0"});
  EXPECT_EQ(words.exit_code, 1) << words.out;
  EXPECT_NE(words.out.find(": unsafe\n"), std::string::npos) << words.out;
}

TEST(Execution, of_drives_is_run_recorded_and_judged) {
  for (const char* name : {"drives.csv", "drives.h5"}) {
    const ProcessResult words = judged(name, {}, crush_of_drives());
    EXPECT_EQ(words.exit_code, 0) << words.out << words.err;
    EXPECT_NE(words.out.find("paths known to"), std::string::npos) << words.out;
  }
  const ProcessResult sensed =
      judged("sensed.csv", {"--set", "sensing.noise={position: 0.005, velocity: 0.01}"},
             crush_of_drives());
  EXPECT_EQ(sensed.exit_code, 0) << sensed.out << sensed.err;
  const ProcessResult undeclared =
      judged("undeclared.csv", {"--set", "execution_error=0"}, crush_of_drives());
  EXPECT_EQ(undeclared.exit_code, 1) << undeclared.out;
}

TEST(Execution, is_refused_by_name) {
  write_file(path_of("crush.yaml"), crush());
  const auto refusal = [&](const std::string& override) {
    return run_avo({"validate", path_of("crush.yaml"), "--set", override}).err;
  };
  EXPECT_NE(refusal("execution.dead_time=-1").find("execution.dead_time"), std::string::npos);
  EXPECT_NE(refusal("execution.lag=1").find("execution.lag"), std::string::npos);
  EXPECT_NE(refusal("clock=free").find("common in a scene with execution"), std::string::npos);
}

}  // namespace
}  // namespace avo_test
