// SPDX-License-Identifier: Apache-2.0
// avo check: robots that are run over, in motion and at rest.
#include <gtest/gtest.h>
#include <string>

#include "verdicts.h"

namespace avo_test {
namespace {

// The first robot rests at its goal; the walker comes by at 2.2 s. The second one drives on, into a
// disc that stands.
const std::string kSceneWithMover =
    "version: 1\nduration: 4\nrobots:\n"
    "  - {position: [0, 0], goal: [0, 0]}\n"
    "  - {position: [20, 0], velocity: [1, 0], goal: [60, 0], max_speed: 1}\n"
    "moving_obstacles:\n"
    "  - {position: [-3, 0], velocity: [1, 0], radius: 0.3}\n";
const std::string kDisc = "  - {position: [22, 0.2], radius: 0.5}\n";

std::string rows() {
  std::string text = "time,robot,x,y,vx,vy\n";
  for (int k = 0; k <= 40; ++k) {
    const std::string time = std::to_string(0.1 * k);
    text += time + ",0,0,0,0,0\n" + time + ",1," + std::to_string(20.0 + 0.1 * k) + ",0,1,0\n";
  }
  return text;
}

Strings judging(const std::string& scene, Strings more = {}) {
  write_file(path_of("run_over.yaml"), scene);
  Strings arguments{"check", recording(rows()), "--scene", path_of("run_over.yaml")};
  arguments.insert(arguments.end(), more.begin(), more.end());
  return arguments;
}

TEST(CheckMovers, who_is_run_over_at_rest_is_not_safe) {
  const ProcessResult words = run_avo(judging(kSceneWithMover));
  EXPECT_EQ(words.exit_code, 1) << words.out << words.err;
  EXPECT_NE(words.out.find(": unsafe\n"), std::string::npos) << words.out;
  EXPECT_NE(
      words.out.find("  moving obstacles   0 hit by a robot in motion; 1 hit a robot at rest\n"
                     "    at rest          robot 0 at 2.2 s, by moving obstacle 0, 0.8 m "
                     "deep\n"),
      std::string::npos)
      << words.out;
  const ProcessResult result = run_avo(judging(kSceneWithMover, {"--json"}));
  EXPECT_EQ(result.exit_code, 1);
  const Json json = Json::parse(result.out);
  EXPECT_EQ(json["safe"], false);
  EXPECT_EQ(json["passed"], false);
  EXPECT_EQ(json["verdict"], "unsafe");
  EXPECT_EQ(json["movers_at_rest"], "collision");
  EXPECT_EQ(json["mover_contacts_moving"]["count"], 0);
  EXPECT_EQ(json["mover_contacts_at_rest"], 1);
  ASSERT_EQ(json["mover_hits"].size(), 1U);
  const Json& hit = json["mover_hits"][0];
  EXPECT_EQ(hit["robot"], 0);
  EXPECT_EQ(hit["moving_obstacle"], 0);
  EXPECT_EQ(hit["moved"], false);
  EXPECT_NEAR(hit["time"], 2.2, 1e-6);
  EXPECT_NEAR(hit["depth"], 0.8, 1e-6);
}

TEST(CheckMovers, at_rest_ok_says_that_it_may_be) {
  const ProcessResult words = run_avo(judging(kSceneWithMover, {"--movers-at-rest", "ok"}));
  EXPECT_EQ(words.exit_code, 0) << words.out << words.err;
  EXPECT_NE(words.out.find("1 hit a robot at rest, which is allowed\n"), std::string::npos)
      << words.out;
  const Json json =
      Json::parse(run_avo(judging(kSceneWithMover, {"--movers-at-rest", "ok", "--json"})).out);
  EXPECT_EQ(json["safe"], true);
  EXPECT_EQ(json["movers_at_rest"], "ok");
  EXPECT_EQ(json["mover_hits"].size(), 1U);
  EXPECT_EQ(run_avo(judging(kSceneWithMover, {"--movers-at-rest", "collision"})).exit_code, 1);
}

TEST(CheckMovers, at_rest_ok_is_not_ok_in_motion) {
  const ProcessResult result =
      run_avo(judging(kSceneWithMover + kDisc, {"--movers-at-rest=ok", "--json"}));
  EXPECT_EQ(result.exit_code, 1);
  const Json hits = Json::parse(result.out)["mover_hits"];
  ASSERT_EQ(hits.size(), 2U);
  EXPECT_EQ(hits[0]["robot"], 1);
  EXPECT_EQ(hits[0]["moving_obstacle"], 1);
  EXPECT_EQ(hits[0]["moved"], true);
  EXPECT_EQ(hits[1]["moved"], false);
}

TEST(CheckMovers, each_hit_has_a_line) {
  const std::string out = run_avo(judging(kSceneWithMover + kDisc)).out;
  const std::size_t first = out.find("    in motion        robot 1 at 1.0");
  EXPECT_NE(first, std::string::npos) << out;
  EXPECT_NE(out.find(" s, by moving obstacle 1, 0.8 m deep\n    at rest          robot 0 at 2.2 s",
                     first),
            std::string::npos)
      << out;
  std::string many = kSceneWithMover;  // eleven more run over it, all at once
  for (int k = 0; k < 11; ++k) many += "  - {position: [-4, 0], velocity: [2, 0], radius: 0.3}\n";
  EXPECT_NE(run_avo(judging(many)).out.find("    ...              2 more, see --json\n"),
            std::string::npos);
}

TEST(CheckMovers, other_words_are_refused) {
  const ProcessResult result = run_avo(judging(kSceneWithMover, {"--movers-at-rest", "fine"}));
  EXPECT_EQ(result.exit_code, 2);
  EXPECT_EQ(result.out, "");
  EXPECT_NE(result.err.find("--movers-at-rest: found fine, must be ok or collision"),
            std::string::npos)
      << result.err;
}

}  // namespace
}  // namespace avo_test
