// SPDX-License-Identifier: Apache-2.0
// The robots of these scenes have clocks of their own. The tests run the scenes from the command
// line.
#include <gtest/gtest.h>
#include <string>

#include "avo/simulation.h"
#include "avo_io/scene.h"
#include "recordings.h"
#include "support/json.h"

namespace avo_test {
namespace {

using Json = nlohmann::ordered_json;

const Strings kFree{"circle-10", "--set", "clock=free", "--set", "robots.2.time_step=0.05"};

Strings with(Strings first, const Strings& more) {
  first.insert(first.end(), more.begin(), more.end());
  return first;
}

TEST(FreeClocks, a_recording_has_rows_at_all_instants_and_is_judged_safe) {
  const std::string csv = path_of("free.csv");
  const ProcessResult run =
      run_avo(with({"run"}, with(kFree, {"--record", csv, "--summary", path_of("free.json")})));
  ASSERT_EQ(run.exit_code, 0) << run.err;
  EXPECT_NE(run.out.find("11000 steps by clocks of their own"), std::string::npos) << run.out;
  const Json summary = Json::parse(read_file(path_of("free.json")));
  EXPECT_EQ(summary["arrived"], 10);
  EXPECT_EQ(summary["collision_pairs"], 0);

  Strings judge = with({"check", csv, "--require-arrival", "--scene"}, kFree);
  const ProcessResult words = run_avo(judge);
  EXPECT_EQ(words.exit_code, 0) << words.out << words.err;
  EXPECT_EQ(words.err, "");
  EXPECT_NE(words.out.find("  held               0 changes between two decisions\n"),
            std::string::npos);
  judge.push_back("--json");
  const Json json = Json::parse(run_avo(judge).out);
  EXPECT_EQ(json["changes"], (Json{{"count", 0}, {"worst", 0.0}, {"first", nullptr}}));
  EXPECT_EQ(json["uneven_steps"], 0);
  EXPECT_EQ(json["rows"], 10 * (json["steps"].get<int>() + 1));
}

// Robot 2 decides every 0.05 s, which it may not by a scene that says 0.1 s.
TEST(FreeClocks, who_decides_at_other_times_breaks_a_rule) {
  const std::string csv = path_of("early.csv");
  ASSERT_EQ(run_avo(with({"run"}, with(kFree, {"--record", csv}))).exit_code, 0);
  const ProcessResult result =
      run_avo({"check", csv, "--json", "--scene", "circle-10", "--set", "clock=free"});
  EXPECT_EQ(result.exit_code, 1);
  const Json json = Json::parse(result.out);
  EXPECT_EQ(json["safe"], false);
  EXPECT_GT(json["changes"]["count"], 0);
  EXPECT_EQ(json["changes"]["first"]["robot"], 2);
  for (const char* rule : {"overlaps", "accelerations", "speeds", "jumps"})
    EXPECT_EQ(json[rule]["count"], 0) << rule;
}

// A person that follows a path takes the steps that lead from one decision to the next.
TEST(FreeClocks, a_person_on_a_path_is_walked_by_the_times_of_the_recording) {
  // this person runs, because the robots evade a person that only walks
  const Strings person{"person", "--set", "clock=free", "--set",
                       "moving_obstacles.0.max_speed=2.2"};
  const std::string csv = path_of("person.csv");
  ASSERT_EQ(run_avo(with({"run"}, with(person, {"--record", csv, "--summary", path_of("s.json")})))
                .exit_code,
            0);
  const Json summary = Json::parse(read_file(path_of("s.json")));
  const auto judged = [&](const std::string& recording) {
    return run_avo(with({"check", recording, "--json", "--scene"}, person));
  };
  const ProcessResult result = judged(csv);
  EXPECT_EQ(result.exit_code, 1) << result.out;
  const Json json = Json::parse(result.out);
  EXPECT_EQ(json["mover_contacts_moving"]["count"], summary["mover_collisions_in_motion"]);
  EXPECT_EQ(json["mover_contacts_at_rest"], summary["mover_collisions"]);
  EXPECT_GT(json["mover_contacts_at_rest"], 0);
  // where the rows begin later, the place on the path is unknown
  const std::string text = read_file(csv);
  std::size_t end = 0;
  for (int k = 0; k < 25; ++k) end = text.find('\n', end) + 1;
  const std::size_t first = text.find('\n') + 1;
  const ProcessResult late = judged(recording(text.substr(0, first) + text.substr(end)));
  EXPECT_EQ(late.exit_code, 3);
  EXPECT_NE(late.err.find("s, must be 0 s in the first row: with free clocks nobody knows how far "
                          "moving_obstacles.0 is on its path by then\n"),
            std::string::npos)
      << late.err;
}

TEST(FreeClocks, explain_tells_the_robots_own_last_decision) {
  const Json json =
      Json::parse(run_avo(with({"explain", "--json", "--robot", "2", "--time", "7"}, kFree)).out);
  const double time = json["time"];
  EXPECT_LE(time, 7.0);
  EXPECT_GT(time, 6.95);
  avo::Simulation simulation(
      avo_io::load_scenario("circle-10", {"clock=free", "robots.2.time_step=0.05"}), 1);
  while (simulation.time() < time) simulation.step();
  EXPECT_EQ(simulation.time(), time);
  EXPECT_EQ(simulation.next_decision({2}), time);
  simulation.step();
  EXPECT_TRUE(simulation.decided({2}));
  const avo::Vec2 chosen = simulation.fleet().plan[2].new_velocity;
  EXPECT_EQ(json["new_velocity"], (Json::array({chosen.x, chosen.y})));
  const ProcessResult early = run_avo(with({"explain", "--robot", "2", "--time", "0"}, kFree));
  EXPECT_EQ(early.exit_code, 2);
  EXPECT_NE(early.err.find("--time: found 0 s, must be >= 0.0"), std::string::npos) << early.err;
}

TEST(FreeClocks, what_has_no_common_steps_is_said_in_a_line) {
  EXPECT_EQ(run_avo(with({"validate"}, kFree)).out,
            "circle-10: valid: 10 robots, 0 moving obstacles, 100 s by clocks of their own\n");
  const ProcessResult common = run_avo({"run", "circle-10", "--set", "robots.2.time_step=0.05"});
  EXPECT_EQ(common.exit_code, 2);
  EXPECT_NE(
      common.err.find("robots.2.time_step: found 0.05, must be left out where clock is common"),
      std::string::npos)
      << common.err;
}

}  // namespace
}  // namespace avo_test
