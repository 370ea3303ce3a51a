// SPDX-License-Identifier: Apache-2.0
// Recordings that lack rows: avo run --every, and what avo check says of them.
#include <gtest/gtest.h>
#include <string>

#include "verdicts.h"

namespace avo_test {
namespace {

/// The recording with the rows of every so many times only, and of the last, as other tools thin.
std::string thinned(const std::string& csv, int every, int robots) {
  const Strings lines = lines_of(read_file(csv));
  std::string text = lines[0] + "\n";
  const auto last = (lines.size() - 2) / static_cast<std::size_t>(robots);
  for (std::size_t i = 1; i < lines.size(); ++i) {
    const std::size_t time = (i - 1) / static_cast<std::size_t>(robots);
    if (time % static_cast<std::size_t>(every) == 0 || time == last) text += lines[i] + "\n";
  }
  return text;
}

std::string without_last_column(const std::string& text) {
  std::string result;
  for (const std::string& line : lines_of(text)) result += line.substr(0, line.rfind(',')) + "\n";
  return result;
}

TEST(Thinned, has_every_so_many_steps_and_the_last_and_says_so) {
  const Recorded all = record({"circle-3", "--duration", "3.5"});
  const std::string few = path_of("few.csv");
  ASSERT_EQ(run_avo({"run", "circle-3", "--duration=3.5", "--every=10", "--record", few}).exit_code,
            0);
  const std::string text = read_file(few);
  EXPECT_TRUE(text.starts_with("time,robot,x,y,vx,vy,every\n0,0,20,0,0,0,10\n")) << text;
  EXPECT_EQ(lines_of(text).size(), 1U + 5 * 3) << "0, 1, 2, 3 and 3.5 s";
  EXPECT_EQ(without_last_column(text), thinned(all.csv, 10, 3));
  // every step, as without the option
  const std::string one = path_of("one.csv");
  run_avo({"run", "circle-3", "--duration=3.5", "--every=1", "--record", one});
  EXPECT_EQ(read_file(one), read_file(all.csv));
  // with headings
  const ProcessResult cars =
      run_avo({"run", "cars-100", "--duration=0.3", "--every=2", "--record=-", "-q"});
  EXPECT_TRUE(cars.out.starts_with("time,robot,x,y,vx,vy,heading,speed,every\n"));
  EXPECT_EQ(lines_of(cars.out).size(), 301U);
}

void expect_incomplete(const Strings& command, const std::string& why) {
  const ProcessResult words = run_avo(command);
  EXPECT_EQ(words.exit_code, 7) << words.out << words.err;
  EXPECT_NE(words.out.find(" s: incomplete\n  not judged         " + why), std::string::npos)
      << words.out;
  EXPECT_EQ(words.out.find("safe\n"), std::string::npos);
  Strings as_json = command;
  as_json.push_back("--json");
  const ProcessResult result = run_avo(as_json);
  EXPECT_EQ(result.exit_code, 7);
  const Json json = Json::parse(result.out);
  EXPECT_EQ(json["verdict"], "incomplete");
  EXPECT_EQ(json["safe"], false);
  EXPECT_EQ(json["passed"], false);
  EXPECT_GT(json["unjudged_steps"], 0);
}

TEST(Thinned, is_never_called_safe) {
  const Recorded all = record({"circle-10", "--until-arrived"});
  ASSERT_EQ(run_avo({"check", all.csv, "--scene", "circle-10"}).exit_code, 0);
  const std::string few = path_of("few.csv");
  run_avo({"run", "circle-10", "--until-arrived", "--every=10", "--record", few});
  const std::string why =
      "23 of 23 steps, whose rows in between are missing: every 10 steps have rows\n";
  expect_incomplete({"check", few, "--scene", "circle-10"}, why);
  expect_incomplete({"check", few, "--scene", "circle-10", "--require-arrival"}, why);
  Strings limits{"check", few};
  limits.insert(limits.end(), kLimits.begin(), kLimits.end());
  expect_incomplete(limits, why);
  // other programs thin the recording and do not say so, but the scene knows its time_step
  for (const int every : {2, 10}) {
    const std::string other = recording(thinned(all.csv, every, 10), "other.csv");
    expect_incomplete({"check", other, "--scene", "circle-10"}, "");
  }
  // a single time is missing
  std::string text;
  for (const std::string& line : lines_of(read_file(all.csv)))
    if (!line.starts_with("5.7")) text += line + "\n";
  expect_incomplete({"check", recording(text, "hole.csv"), "--scene", "circle-10"},
                    "1 of 221 steps");
}

TEST(Thinned, piped_is_judged_alike) {
  const std::string command = std::string(AVO_BINARY) + " run circle-5 -q --every 7 --record - | " +
                              AVO_BINARY + " check - --scene circle-5 -q";
  const int status = std::system(command.c_str());
  EXPECT_EQ(WEXITSTATUS(status), 7);
}

TEST(Thinned, is_unsafe_where_its_rows_are) {
  const Strings paper{"circle-100", "--set", "method=avo_paper", "--duration", "30"};
  const std::string few = path_of("few.csv");
  Strings run{"run", "--every=5", "--record", few};
  run.insert(run.end(), paper.begin(), paper.end());
  ASSERT_EQ(run_avo(run).exit_code, 0);
  const ProcessResult result =
      run_avo({"check", few, "--scene", "circle-100", "--set", "method=avo_paper", "--json"});
  EXPECT_EQ(result.exit_code, 1);
  const Json json = Json::parse(result.out);
  EXPECT_EQ(json["verdict"], "unsafe");
  EXPECT_GT(json["overlaps"]["count"], 0) << "in rows";
  EXPECT_EQ(json["unjudged_steps"], 60);
}

const std::string kThinned = "time,robot,x,y,vx,vy,every\n";

TEST(Thinned, rows_are_judged_and_the_way_between_is_not) {
  // on the cubic, the robots would meet halfway
  const std::string through = "0,0,-3,0,2,0,5\n0,1,3,0,-2,0,5\n3,0,3,0,2,0,5\n3,1,-3,0,-2,0,5\n";
  const Json unknown = Json::parse(
      check(kThinned + through, {"--radius=0.5", "--max-speed=2", "--max-acceleration=1", "--json"})
          .out);
  EXPECT_EQ(unknown["verdict"], "incomplete");
  EXPECT_EQ(unknown["overlaps"]["count"], 0);
  EXPECT_EQ(unknown["least_clearance"], 5.0);
  EXPECT_EQ(unknown["every"], 5);
  EXPECT_EQ(unknown["robot_steps"], 0);
  const std::string in_row = "0,0,0,0,0,0,5\n0,1,9,0,0,0,5\n9,0,0,0,0,0,5\n9,1,0.5,0,0,0,5\n";
  EXPECT_EQ(check(kThinned + in_row).exit_code, 1) << "they overlap there";
  const std::string fast = "0,0,0,0,0,0,5\n5,0,9,0,2.5,0,5\n";
  EXPECT_EQ(check(kThinned + fast).exit_code, 1) << "faster than max_speed";
  const std::string sudden = "0,0,0,0,0,0,5\n0.5,0,0.5,0,2,0,5\n";
  EXPECT_EQ(check(kThinned + sudden).exit_code, 1) << "4 m/s^2, whatever lies between";
  const std::string far = "0,0,0,0,0,0,5\n1,0,50,0,0,0,5\n";
  EXPECT_EQ(check(kThinned + far).exit_code, 1) << "nobody gets there";
  EXPECT_EQ(check(kThinned + "0,0,0,0,0,0,1\n1,0,0,0,0,0,1\n").exit_code, 0) << "every step";
}

TEST(Thinned, says_by_how_much_in_whole_numbers) {
  for (const char* every : {"0", "-1", "x", "", "2.5", "nan"}) {
    const ProcessResult result = check(kThinned + "0,0,0,0,0,0," + every + "\n1,0,0,0,0,0,5\n");
    EXPECT_EQ(result.exit_code, 3) << every;
    EXPECT_EQ(result.err,
              path_of("in.csv") + ":2: every: found \"" + every + "\", must be an integer >= 1\n");
  }
}

TEST(Thinned, with_free_clocks_longer_steps_than_any_lack_rows) {
  const Recorded all = record({"circle-2", "--set", "clock=free", "--duration", "10"});
  const Strings scene{"--scene", "circle-2", "--set", "clock=free"};
  Strings command{"check", all.csv};
  command.insert(command.end(), scene.begin(), scene.end());
  ASSERT_EQ(run_avo(command).exit_code, 0);
  command[1] = recording(thinned(all.csv, 4, 2), "few.csv");
  expect_incomplete(command, "");
}

TEST(Thinned, wants_a_recording_and_a_positive_number) {
  const ProcessResult alone = run_avo({"run", "circle-2", "--every", "3"});
  EXPECT_EQ(alone.exit_code, 2);
  EXPECT_EQ(alone.err,
            "avo: --every: found without --record, must be with it: it thins the recording\n");
  for (const std::string word :
       {"0", "-3", "x", "1.5", "nan", "100000001", "99999999999999999999"}) {
    const ProcessResult bad =
        run_avo({"run", "circle-2", "--every=" + word, "--record", path_of("x.csv")});
    EXPECT_EQ(bad.exit_code, 2);
    EXPECT_EQ(bad.err,
              "avo: --every: found " + word + ", must be a whole number from 1 to 100000000\n");
  }
  EXPECT_FALSE(exists(path_of("x.csv")));
}

}  // namespace
}  // namespace avo_test
