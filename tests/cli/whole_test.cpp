// SPDX-License-Identifier: Apache-2.0
// Recordings that lack a robot of the scene, which avo check never calls safe, or its start or its
// end, which it tells.
#include <gtest/gtest.h>
#include <string>

#include "verdicts.h"

namespace avo_test {
namespace {

/// Returns the rows of the robots and times that `keep` selects.
template <class Keep>
std::string rows_of(const Recorded& run, const Keep& keep) {
  const Strings lines = lines_of(read_file(run.csv));
  std::string text = lines[0] + "\n";
  for (std::size_t i = 1; i < lines.size(); ++i) {
    const std::size_t comma = lines[i].find(',');
    if (keep(std::stod(lines[i]), std::stoi(lines[i].substr(comma + 1)))) text += lines[i] + "\n";
  }
  return text;
}

struct Verdict {
  int exit_code;
  std::string missing, part;  ///< what the lines of that name say; empty: there is none
  Json json;
};

Verdict judged(const std::string& text, Strings more) {
  const ProcessResult words = check(text, more);
  more.push_back("--json");
  Verdict result{words.exit_code, {}, {}, Json::parse(check(text, more).out)};
  for (const std::string& line : lines_of(words.out)) {
    if (line.starts_with("  missing")) result.missing = line.substr(21);
    if (line.starts_with("  a part")) result.part = line.substr(21);
  }
  return result;
}

void expect_incomplete(const std::string& text, const Strings& scene, const std::string& missing) {
  const Verdict verdict = judged(text, scene);
  EXPECT_EQ(verdict.exit_code, 7) << missing;
  EXPECT_EQ(verdict.missing, missing);
  EXPECT_EQ(verdict.json["verdict"], "incomplete");
  EXPECT_EQ(verdict.json["safe"], false);
  EXPECT_EQ(verdict.json["passed"], false);
}

void expect_safe(const std::string& text, const Strings& scene) {
  const Verdict verdict = judged(text, scene);
  EXPECT_EQ(verdict.exit_code, 0) << verdict.missing;
  EXPECT_EQ(verdict.missing + verdict.part, "");
  EXPECT_EQ(verdict.json["whole"], true);
  EXPECT_EQ(verdict.json["lacking"], Json::array());
}

/// Where the recording covers a part of the scene, the verdict is on that part.
void expect_part(const std::string& text, const Strings& scene, const std::string& part) {
  const Verdict verdict = judged(text, scene);
  EXPECT_EQ(verdict.exit_code, 0) << part;
  EXPECT_EQ(verdict.missing, "");
  EXPECT_EQ(verdict.part, part);
  EXPECT_EQ(verdict.json["safe"], true);
  EXPECT_EQ(verdict.json["whole"], false);
}

const Strings kScene{"--scene", "circle-4", "--set", "duration=6"};

TEST(Whole, a_recording_has_rows_of_every_robot_from_the_first_time_to_the_last) {
  const Recorded run = record({"circle-4", "--duration", "6"});
  expect_safe(read_file(run.csv), kScene);
  const std::string where = " at the first time or at the last one";
  const auto without = [&](int robot, double from, double to) {
    return rows_of(run, [=](double t, int k) { return k != robot || t < from || t > to; });
  };
  expect_incomplete(without(2, 0.0, 9.0), kScene, "rows of robot 2" + where);
  expect_incomplete(without(3, 0.0, 0.05), kScene, "rows of robot 3" + where);
  expect_incomplete(without(0, 5.95, 9.0), kScene, "rows of robot 0" + where);
  const std::string two = rows_of(run, [](double, int k) { return k != 0 && k != 3; });
  expect_incomplete(two, kScene, "rows of robots 0, 3" + where);
  EXPECT_EQ(judged(two, kScene).json["lacking"], Json::array({0, 3}));
  EXPECT_EQ(judged(two, kScene).json["whole"], true);
}

TEST(Whole, a_recording_goes_from_the_start_to_the_end_of_the_scene) {
  const Recorded run = record({"circle-4", "--duration", "6"});
  const std::string end = " s of the scene, which ends at 6 s or when all have arrived";
  const auto between = [&](double from, double to) {
    return rows_of(run, [=](double t, int) { return from <= t && t <= to; });
  };
  expect_part(between(0.0, 5.95), kScene, "0 to 5.9" + end);
  expect_part(between(0.05, 9.0), kScene, "0.1 to 6" + end);
  // the rows are the whole of a shorter scene, and of a scene with a shorter last step
  expect_safe(between(0.0, 5.0), {"--scene", "circle-4", "--set", "duration=5"});
  expect_safe(between(0.0, 5.0), {"--scene", "circle-4", "--set", "duration=5.09"});
  // a rule that is broken is broken
  EXPECT_EQ(check(between(0.0, 5.0), {"--scene", "circle-4", "--set", "max_speed=0.1"}).exit_code,
            2);
  EXPECT_EQ(check(between(0.0, 5.0), {"--scene", "circle-4", "--set", "groups.0.max_speed=0.1"})
                .exit_code,
            1);
  // without a scene, nothing tells whether the recording is whole
  EXPECT_EQ(check(between(1.0, 2.0)).exit_code, 0);
}

TEST(Whole, it_may_end_when_all_have_arrived) {
  const Recorded run = record({"circle-4", "--until-arrived"});
  const double end = run.summary["last_arrival"];
  expect_safe(read_file(run.csv), {"--scene", "circle-4"});
  const std::string before = rows_of(run, [=](double t, int) { return t < end - 0.05; });
  EXPECT_EQ(judged(before, {"--scene", "circle-4"}).json["whole"], false);
  EXPECT_EQ(check(before, {"--scene", "circle-4", "--require-arrival"}).exit_code, 1);
}

TEST(Whole, airplanes_may_leave_where_they_arrive) {
  const std::string scene = path_of("leaving.yaml");
  const std::string more =
      ", heading: 0, radius: 3, max_speed: 15, max_acceleration: 2, airplane: {min_speed: 15, "
      "lateral_acceleration: 5, after_goal: leave}}\n";
  write_file(scene,
             "version: 1\nname: leaving\nduration: 30\nsensing_radius: 200\nrobots:\n"
             "  - {position: [0, 0], goal: [60, 0]" +
                 more + "  - {position: [0, 160], goal: [150, 160]" + more);
  const Recorded run = record({scene});
  ASSERT_EQ(run.summary["arrived"], 2);
  expect_safe(read_file(run.csv), {"--scene", scene});
  const std::string gone = rows_of(run, [](double t, int k) { return k == 1 || t < 2.0; });
  expect_incomplete(gone, {"--scene", scene, "--set", "duration=10"},
                    "rows of robot 0 at the first time or at the last one");  // before it arrived
}

TEST(Whole, with_free_clocks_the_last_decisions_are_before_the_end) {
  const Strings free{"circle-4", "--set", "clock=free", "--set", "duration=6"};
  const Recorded run = record(free);
  Strings scene{"--scene"};
  scene.insert(scene.end(), free.begin(), free.end());
  expect_safe(read_file(run.csv), scene);
  const std::string before = rows_of(run, [](double t, int) { return t < 5.85; });
  EXPECT_EQ(judged(before, scene).json["whole"], false);
}

}  // namespace
}  // namespace avo_test
