// SPDX-License-Identifier: Apache-2.0
// What avo check says of contacts with static obstacles: by the numbers of the recording and scene.
#include <gtest/gtest.h>

#include "avo_io/judgement.h"
#include "support/json.h"

namespace avo_test {
namespace {

// Robot 7 of the recording, the judge's second one, touched its fourth wall: one of obstacle 2.
avo_io::Judgement touched() {
  avo_io::Judgement judgement;
  judgement.recording = "in.csv";
  judgement.numbers = {3, 7};
  judgement.obstacle_of_wall = {0, 0, 1, 2, 2};
  judgement.report.static_contacts = {2, avo::CheckViolation{1.5, 1, 3, 0.25}, 0.5};
  judgement.report.least_static_clearance = -0.5;
  return judgement;
}

TEST(CheckReport, json_names_the_obstacle_of_the_wall) {
  const auto json = nlohmann::ordered_json::parse(avo_io::to_json(touched()));
  EXPECT_EQ(json["static_contacts"].dump(),
            R"({"count":2,"worst":0.5,"first":{"time":1.5,"robot":7,"obstacle":2,"amount":0.25}})");
  EXPECT_EQ(json["least_static_clearance"], -0.5);
  EXPECT_EQ(json["safe"], false);
  EXPECT_EQ(json["passed"], false);
}

TEST(CheckReport, words_have_a_line_for_obstacles_where_there_are_any) {
  avo_io::Judgement judgement = touched();
  const std::string text = avo_io::readable(judgement);
  EXPECT_NE(text.find(": unsafe\n"), std::string::npos) << text;
  EXPECT_NE(text.find("  obstacles          2 robots touched one, the first at 1.5 s: robot 7 and "
                      "obstacle 2, by 0.25 m; at most by 0.5 m\n"),
            std::string::npos)
      << text;
  EXPECT_NE(text.find("    from obstacles   -0.5 m\n"), std::string::npos) << text;
  judgement.report = {};
  judgement.obstacle_of_wall.clear();
  EXPECT_EQ(avo_io::readable(judgement).find("obstacle"), std::string::npos);
}

}  // namespace
}  // namespace avo_test
