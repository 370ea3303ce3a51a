// SPDX-License-Identifier: Apache-2.0
// When a run ends, which scenes it reads, and how much it says.
#include <cstdlib>
#include <fcntl.h>
#include <filesystem>
#include <gtest/gtest.h>
#include <string>
#include <unistd.h>

#include "verdicts.h"

namespace avo_test {
namespace {

Json summary_of(Strings arguments) {
  arguments.insert(arguments.begin(), "run");
  arguments.push_back("--json");
  const ProcessResult result = run_avo(arguments);
  EXPECT_EQ(result.exit_code, 0) << result.err;
  return Json::parse(result.out);
}

/// avo with that text as its standard input, in the folder of the test.
ProcessResult fed(const std::string& text, const Strings& arguments) {
  const std::string file = recording(text, "stdin.txt");
  return run_avo(arguments, {.before = [file, here = folder()] {
                   if (chdir(here.c_str()) != 0) _exit(97);
                   const int input = open(file.c_str(), O_RDONLY);
                   if (input < 0 || dup2(input, STDIN_FILENO) < 0) _exit(97);
                 }});
}

TEST(Ends, until_arrived_is_the_step_at_which_the_last_one_has) {
  const Json all = summary_of({"circle-10"}), some = summary_of({"circle-10", "--until-arrived"});
  EXPECT_EQ(all["steps"], 1000);
  EXPECT_EQ(some["arrived"], 10);
  EXPECT_EQ(some["last_arrival"], all["last_arrival"]);
  EXPECT_NEAR(some["steps"].get<double>() * 0.1, some["last_arrival"], 1e-9);
}

// One is at its goal at the start only, and is pushed off; the other one comes later.
TEST(Ends, each_robot_arrives_at_its_own_time) {
  const std::string scene = recording(
      "version: 1\nduration: 60\nrobots:\n"
      "  - {position: [0, 0], velocity: [1.5, 0], goal: [0, 0], preferred_speed: 0.1}\n"
      "  - {position: [30, 30], goal: [30, 20]}\n",
      "apart.yaml");
  const Json summary = summary_of({scene, "--until-arrived"});
  EXPECT_EQ(summary["arrived"], 2);
  EXPECT_LT(summary["steps"], 100);
}

TEST(Ends, at_least_one_step_is_taken) {
  const std::string scene =
      recording("version: 1\nrobots:\n  - {position: [0, 0], goal: [0, 0]}\n", "there.yaml");
  EXPECT_EQ(summary_of({scene, "--until-arrived"})["steps"], 1);
}

TEST(Ends, at_the_latest_with_the_duration_where_robots_cannot_arrive) {
  const std::string scene = recording(
      "version: 1\nduration: 5\nrobots:\n"
      "  - {position: [0, 0], goal: [9, 0]}\nobstacles:\n"
      "  - {polyline: [[7, -2], [11, -2], [11, 2], [7, 2], [7, -2]]}\n",
      "walled.yaml");
  const ProcessResult result = run_avo({"run", scene, "--until-arrived", "--summary", "-"});
  EXPECT_EQ(result.exit_code, 0);
  EXPECT_EQ(Json::parse(result.out)["steps"], 50);
  EXPECT_NE(result.err.find("warning: no route between the obstacles leads to the goal of robot 0"),
            std::string::npos);
  const Json slow = summary_of({"circle-10", "--until-arrived", "--duration", "5"});
  EXPECT_EQ(slow["steps"], 50);
  EXPECT_EQ(slow["arrived"], 0);
}

TEST(Ends, duration_replaces_that_of_the_scene) {
  EXPECT_EQ(summary_of({"circle-5", "--duration", "7"})["steps"], 70);
  EXPECT_EQ(summary_of({"circle-5", "--duration=120"})["steps"], 1200);
  for (const char* word : {"0", "-1", "nan", "inf", "x", "0.01"}) {
    const ProcessResult bad = run_avo(
        {"run", "circle-5", std::string("--duration=") + word, "--record", path_of("x.csv")});
    EXPECT_EQ(bad.exit_code, 2) << word << bad.err;
    EXPECT_TRUE(bad.err.starts_with("--duration: found ")) << bad.err;
    EXPECT_EQ(lines_of(bad.err).size(), 1U);
  }
  EXPECT_FALSE(exists(path_of("x.csv")));
}

TEST(StandardInput, a_member_of_a_family_is_what_its_name_runs) {
  for (const std::string name : {"circle-10", "circle-100", "uniform-50", "uniform-1000"}) {
    const ProcessResult text = run_avo({"scenes", name});
    ASSERT_EQ(text.exit_code, 0);
    EXPECT_NE(text.out.find("\nname: " + name + "\n"), std::string::npos) << text.out;
    const Strings options{"--duration", "3", "--record", "-", "-q"};
    Strings by_name{"run", name}, by_text{"run", "-"};
    by_name.insert(by_name.end(), options.begin(), options.end());
    by_text.insert(by_text.end(), options.begin(), options.end());
    EXPECT_EQ(fed(text.out, by_text).out, run_avo(by_name).out) << name;
    const auto untimed = [](const ProcessResult& result) {
      Json summary = Json::parse(result.out);
      summary.erase("step_milliseconds_median");
      for (const char* key : {"step_ms_p50", "step_ms_p99"}) summary["metrics"].erase(key);
      return summary;
    };
    EXPECT_EQ(untimed(fed(text.out, {"run", "-", "--duration=3", "--json"})),
              untimed(run_avo({"run", name, "--duration=3", "--json"})));
  }
  EXPECT_EQ(run_avo({"scenes", "circle-1"}).exit_code, 2);
  EXPECT_EQ(run_avo({"scenes", "circle-010"}).exit_code, 2);
}

TEST(StandardInput, is_a_scene_for_every_verb) {
  const std::string scene =
      "version: 1\nrobots:\n  - {position: [0, 0], goal: [5, 0]}\n"
      "  - {position: [0, 9], goal: [5, 9]}\n";
  EXPECT_TRUE(fed(scene, {"run", "-"}).out.starts_with("standard input: 2 robots, "));
  EXPECT_EQ(fed(scene, {"validate", "-"}).exit_code, 0);
  EXPECT_EQ(fed(scene, {"explain", "-", "--robot", "1"}).exit_code, 0);
  EXPECT_EQ(fed(scene, {"bench", "-", "--steps", "2"}).exit_code, 0);
  fed(scene, {"run", "-", "--record", path_of("x.csv")});
  EXPECT_EQ(fed(scene, {"check", path_of("x.csv"), "--scene", "-"}).exit_code, 0);
  EXPECT_EQ(fed(scene, {"run", "-", "--set", "robots.0.radius=-1"}).exit_code, 2);
}

TEST(StandardInput, has_the_built_in_maps_that_the_folder_has_not) {
  const std::string scene = run_avo({"scenes", "arena"}).out;
  const Strings by_text{"run", "-", "--duration=3", "--record", "-", "-q"};
  const ProcessResult run = fed(scene, by_text);
  ASSERT_EQ(run.exit_code, 0) << run.err;
  EXPECT_EQ(run.out, run_avo({"run", "arena", "--duration=3", "--record", "-", "-q"}).out);
  EXPECT_NE(fed(scene, {"validate", "-", "--set", "robots_from.scen=arna.scen"}).exit_code, 0);

  write_file(path_of("arena.map"), "type octile\nheight none\n");  // its own
  const ProcessResult own = fed(scene, by_text);
  EXPECT_EQ(own.exit_code, 3);
  EXPECT_TRUE(own.err.starts_with("arena.map:2:8: found \"none\"")) << own.err;

  std::filesystem::create_directory(path_of("elsewhere"));  // a file has its folder
  write_file(path_of("elsewhere/arena.yaml"), scene);
  EXPECT_EQ(run_avo({"validate", path_of("elsewhere/arena.yaml")}).exit_code, 4);
}

TEST(StandardInput, errors_say_where) {
  const ProcessResult bad = fed("version: 1\nrobots: 3\n", {"run", "-"});
  EXPECT_EQ(bad.exit_code, 3);
  EXPECT_TRUE(bad.err.starts_with("standard input:2:9: robots: found 3, must be")) << bad.err;
  EXPECT_TRUE(fed("", {"run", "-"}).err.starts_with("standard input:1:1: found nothing"));
  const ProcessResult twice = fed("", {"check", "-", "--scene", "-"});
  EXPECT_EQ(twice.exit_code, 2);
  EXPECT_EQ(twice.err,
            "avo: the recording and --scene: found - twice, must be one standard input only\n");
  const ProcessResult closed = run_avo({"run", "-"}, {.before = [] { close(STDIN_FILENO); }});
  EXPECT_EQ(closed.exit_code, 4);
  EXPECT_EQ(closed.err, "standard input: Bad file descriptor\n");
}

TEST(Volume, quiet_leaves_errors_and_what_options_ask_for) {
  const Strings warned{"circle-12",  "--set", "sensing_radius=2", "--set", "method=avo_paper",
                       "--duration", "1"};
  Strings run{"run", "-q", "--summary", path_of("x.json")};
  run.insert(run.end(), warned.begin(), warned.end());
  const ProcessResult quiet = run_avo(run);
  EXPECT_EQ(quiet.exit_code, 0);
  EXPECT_EQ(quiet.out + quiet.err, "");
  EXPECT_EQ(Json::parse(read_file(path_of("x.json")))["steps"], 10);
  run[1] = "-v";
  EXPECT_NE(run_avo(run).err.find("warning: "), std::string::npos);
  const ProcessResult bad = run_avo({"run", "-q", "circle-2", "--set", "duration=-1"});
  EXPECT_EQ(bad.exit_code, 2);
  EXPECT_NE(bad.err, "");
  EXPECT_NE(run_avo({"run", "circle-2", "-q", "--json", "--duration=1"}).out, "");
  for (const Strings& command :
       {Strings{"validate", "circle-2", "-q"}, Strings{"bench", "circle-2", "-q", "--steps=2"},
        Strings{"explain", "circle-2", "--robot=0", "--quiet"}}) {
    const ProcessResult result = run_avo(command);
    EXPECT_EQ(result.exit_code, 0);
    EXPECT_EQ(result.out + result.err, "") << command[0];
  }
  Strings limits{"-q"};
  limits.insert(limits.end(), kLimits.begin(), kLimits.end());
  EXPECT_EQ(check(kGoodRun, limits).out, "");
  EXPECT_EQ(check(kHeader + "0,3,0,0,3,0\n1,3,3,0,3,0\n", limits).exit_code, 1);
}

TEST(Volume, verbose_tells_settings_and_changes_no_results) {
  const ProcessResult loud = run_avo({"run", "circle-6", "--duration=2", "--threads=1", "-v",
                                      "--record", "-", "--set", "method=avo_paper"});
  const ProcessResult plain =
      run_avo({"run", "circle-6", "--duration=2", "--record", "-", "--set", "method=avo_paper"});
  EXPECT_EQ(loud.out, plain.out);
  for (const char* line :
       {"scene             circle-6, built in\n", "set               method=avo_paper\n",
        "set               duration=2\n", "robots            6, 0 of them parked\n",
        "method            avo_paper\n", "certificate       none\n",
        "control_time      4 s (delta)\n", "time_horizon      10 s (tau)\n",
        "response_time     0: at once\n", "duration          2 s\n", "threads           1\n",
        "instructions      "})
    EXPECT_NE(loud.err.find(line), std::string::npos) << line << loud.err;
  EXPECT_EQ(plain.err.find("instructions"), std::string::npos);
  EXPECT_EQ(run_avo({"run", "circle-2", "-v", "-q"}).exit_code, 2);
}

TEST(Volume, verbose_tells_the_response_times_that_take_effect) {
  const auto told = [](const Strings& settings) {
    Strings run{"run", "circle-3", "--duration=1", "-v"};
    for (const std::string& setting : settings) run.push_back("--set=" + setting);
    const std::string err = run_avo(run).err;
    const std::size_t begin = err.find("response_time     ");
    if (begin == std::string::npos) return err;
    return err.substr(begin + 18, err.find('\n', begin) - begin - 18);
  };
  EXPECT_EQ(told({}), "0.2 s");
  EXPECT_EQ(told({"response_time=0"}), "0: at once");
  EXPECT_EQ(told({"response_time=0.15"}), "0.3 s");
  EXPECT_EQ(told({"robots.1.max_acceleration=0.25"}), "0.2 s to 0.8 s");
}

TEST(Volume, json_is_the_summary_on_the_standard_output) {
  const ProcessResult both = run_avo({"run", "circle-2", "--json", "--summary", path_of("x.json")});
  EXPECT_EQ(both.exit_code, 2);
  EXPECT_EQ(lines_of(both.err).size(), 1U);
  EXPECT_EQ(run_avo({"run", "circle-2", "--json", "--record", "-"}).exit_code, 2);
}

}  // namespace
}  // namespace avo_test
