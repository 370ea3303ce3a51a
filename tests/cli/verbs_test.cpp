// SPDX-License-Identifier: Apache-2.0
// The other verbs, help and versions.
#include <gtest/gtest.h>
#include <string>
#include <vector>

#include "avo/version.h"
#include "avo_io/scene.h"
#include "run_avo.h"
#include "support/json.h"

namespace avo_test {
namespace {

using Strings = std::vector<std::string>;

TEST(Verbs, version) {
  for (const char* option : {"--version", "-V"}) {
    const ProcessResult result = run_avo({option});
    EXPECT_EQ(result.exit_code, 0);
    EXPECT_EQ(result.out, std::string("avo ") + avo::kVersion + "\n");
  }
}

TEST(Verbs, help_alone_is_that_of_the_program) {
  EXPECT_EQ(run_avo({"help"}).out, run_avo({"--help"}).out);
}

TEST(Verbs, help_of_every_verb_has_an_example_that_works) {
  EXPECT_NE(run_avo({"--help"}).out.find("Example: avo run"), std::string::npos);
  for (const std::string verb :
       {"run", "explain", "check", "bench", "scenes", "validate", "schema", "help"}) {
    const ProcessResult result = run_avo({verb, "--help"});
    EXPECT_EQ(result.exit_code, 0);
    EXPECT_NE(result.out.find("Usage: avo " + verb), std::string::npos) << result.out;
    EXPECT_NE(result.out.find("Example: avo " + verb), std::string::npos) << result.out;
    EXPECT_EQ(run_avo({"help", verb}).out, result.out);
  }
}

TEST(Verbs, scenes_are_listed_and_printed) {
  const ProcessResult list = run_avo({"scenes"});
  EXPECT_EQ(list.exit_code, 0);
  const std::vector<std::string> lines = lines_of(list.out);
  ASSERT_EQ(lines.size(), avo_io::builtin_scenes().size());
  const auto json = nlohmann::ordered_json::parse(run_avo({"scenes", "--json"}).out);
  const std::vector<std::string> names{"arena",           "bottleneck",
                                       "cars-100",        "circle-N",
                                       "corridor",        "corridor-one-lane",
                                       "crossed-crowd",   "crossing-streams",
                                       "crowdnav-circle", "crowdnav-square",
                                       "doorway",         "doorway-narrow",
                                       "drives-100",      "maze",
                                       "mixed-fleet",     "mixed-yard",
                                       "moving-obstacle", "office",
                                       "permutation-100", "person",
                                       "planes-12",       "positions-exchange",
                                       "reversing-cars",  "swap-blocks",
                                       "uniform-N",       "warehouse"};
  for (const std::string file : {"arena.map", "arena.scen"})
    write_file(path_of(file), run_avo({"scenes", file}).out);
  for (std::size_t i = 0; i < names.size(); ++i) {
    EXPECT_TRUE(lines[i].starts_with(names[i] + " ")) << lines[i];
    EXPECT_EQ(json[i]["name"], names[i]);
    EXPECT_NE(json[i]["description"], "");
    const std::string path = path_of("scene.yaml");
    write_file(path, run_avo({"scenes", names[i]}).out);
    EXPECT_EQ(run_avo({"validate", path}).exit_code, 0) << names[i];
  }
  EXPECT_EQ(run_avo({"scenes", "nonsense"}).exit_code, 2);
}

TEST(Verbs, a_scene_by_path_is_the_scene_by_name) {
  const std::string path = path_of("circle.yaml");
  write_file(path, run_avo({"scenes", "circle-N"}).out);
  const auto run = [](const std::string& scene) {
    return run_avo({"run", scene, "--set", "duration=2", "--record", "-"}).out;
  };
  EXPECT_EQ(run(path), run("circle-100"));
}

TEST(Verbs, validate_says_what_there_is_and_warns) {
  const ProcessResult good = run_avo({"validate", "circle-12"});
  EXPECT_EQ(good.exit_code, 0);
  EXPECT_EQ(good.out, "circle-12: valid: 12 robots, 0 moving obstacles, 1000 steps of 0.1 s\n");
  EXPECT_EQ(good.err, "");
  const ProcessResult odd =
      run_avo({"validate", "circle-12", "--set", "sensing_radius=2", "--set", "method=avo_paper"});
  EXPECT_EQ(odd.exit_code, 0);
  EXPECT_TRUE(odd.err.starts_with("warning: sensing_radius 2 m is less than"));
}

TEST(Verbs, schema_is_json) {
  const ProcessResult result = run_avo({"schema"});
  EXPECT_EQ(result.exit_code, 0);
  EXPECT_EQ(result.out, avo_io::scenario_schema());
  EXPECT_EQ(nlohmann::ordered_json::parse(result.out)["type"], "object");
}

TEST(Verbs, what_is_left_out_is_told_with_what_it_may_be) {
  const std::string scene =
      " (name of a built-in scene, see avo scenes, or a YAML file; - is stdin)";
  for (const std::string verb : {"run", "explain", "bench", "validate"})
    EXPECT_EQ(run_avo({verb}).err,
              "avo: " + verb + ": found no SCENE" + scene + "; see avo " + verb + " --help\n");
  EXPECT_EQ(run_avo({"explain", "circle-10"}).err,
            "avo: explain: found no --robot (its number); see avo explain --help\n");
  EXPECT_EQ(run_avo({"run", "circle-10", "circle-20"}).err.find("see avo --help"),
            std::string::npos);
}

TEST(Verbs, a_name_that_is_none_is_told_the_scene_with_its_number) {
  const auto meant = [](const std::string& name) {
    std::vector<std::string> told;
    for (const std::string verb : {"run", "scenes"}) {
      const std::string error = run_avo({verb, name}).err;
      const std::size_t at = error.find("did you mean ");
      told.push_back(at == error.npos ? "" : error.substr(at + 13, error.find('?', at) - at - 13));
    }
    EXPECT_EQ(told[0], told[1]);
    return told[0];
  };
  EXPECT_EQ(meant("circle10"), "\"circle-10\"");
  EXPECT_EQ(meant("circel-250"), "\"circle-250\"");
  EXPECT_EQ(meant("uniform_1000"), "\"uniform-1000\"");
  EXPECT_EQ(meant("planes12"), "\"planes-12\"");
  EXPECT_EQ(meant("circle"), "\"circle-N\"");
  EXPECT_EQ(meant("circle1"), "\"circle-N\"") << "there is none of one robot";
  EXPECT_EQ(meant("circle99999999999"), "");
}

TEST(Verbs, usage_errors_take_one_line_and_exit_with_2) {
  for (const Strings& arguments :
       {Strings{}, Strings{"nonsense"}, Strings{"run"}, Strings{"--nonsense"}, Strings{"validate"},
        Strings{"run", "circle-2", "circle-3"}}) {
    const ProcessResult result = run_avo(arguments);
    EXPECT_EQ(result.exit_code, 2);
    EXPECT_EQ(result.out, "");
    EXPECT_EQ(lines_of(result.err).size(), 1U) << result.err;
  }
  EXPECT_EQ(run_avo({"rnu", "circle-2"}).err,
            "avo: rnu: found no such verb, did you mean \"run\"? Verbs are run, explain, check, "
            "replay, recover, convert, video, lab, bench, sweep, compare, report, scenes, "
            "validate, schema, help\n");
  EXPECT_EQ(run_avo({"help", "rnu"}).err, run_avo({"rnu"}).err);
  EXPECT_EQ(run_avo({"--vesrion"}).err,
            "avo: --vesrion: found no such option, did you mean --version?\n");
  EXPECT_EQ(run_avo({"run", "circle-2", "--recrod", "x.csv"}).err,
            "avo: --recrod: found no such option, did you mean --record?\n");
}

}  // namespace
}  // namespace avo_test
