// SPDX-License-Identifier: Apache-2.0
// avo compare: its table, its figures, and what it refuses.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <string>

#include "avo_io/recorded_run.h"
#include "reports/curves.h"
#include "support/json.h"
#include "sweeps.h"

namespace avo_test {
namespace {

using Json = nlohmann::ordered_json;
using testing::HasSubstr;

const std::string kColumns =
    "sweep,run,scene,method,time_horizon,seed,state_hash,robots,collided,arrival_50,arrival_100,"
    "step_milliseconds_median\n";

/// Two methods x two horizons x two seeds, by hand. Of orca both runs are one and the same.
std::string by_hand(const std::string& name) {
  write_file(path_of(name), kColumns +
                                "s,0,a,avo,5,1,0x1,10,0,4,9,1\ns,1,a,avo,5,2,0x2,10,1,6,11,3\n"
                                "s,2,a,avo,8,1,0x1,10,0,4,9,1\ns,3,a,avo,8,2,0x2,10,0,6,,1\n"
                                "s,4,a,orca,5,1,0x,10,1,5,12,2\ns,5,a,orca,5,2,0x,10,1,5,12,2\n"
                                "s,6,a,orca,8,1,0x,10,1,5,12,2\ns,7,a,orca,8,2,0x,10,1,5,12,2\n");
  return path_of(name);
}

TEST(Compare, has_a_row_for_each_method_and_a_block_for_all_else) {
  const ProcessResult result =
      run_avo({"compare", by_hand("a.csv"), "--columns", "collided,arrival_100"});
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_EQ(result.out,
            "time_horizon 5\n"
            "  method  runs               collided         arrival_100\n"
            "  avo        2  0.5 [0.09453, 0.9055]  10 [-2.706, 22.71]\n"
            "  orca       2                      1                  12\n"
            "time_horizon 8\n"
            "  method  runs       collided  arrival_100\n"
            "  avo        2  0 [0, 0.6576]       9 of 1\n"
            "  orca       2              1           12\n");
}

TEST(Compare, has_a_row_for_each_value_of_another_key) {
  const ProcessResult result =
      run_avo({"compare", by_hand("a.csv"), "--by=time_horizon", "--columns=arrival_50"});
  EXPECT_EQ(result.out,
            "method avo\n"
            "  time_horizon  runs         arrival_50\n"
            "  5                2  5 [-7.706, 17.71]\n"
            "  8                2  5 [-7.706, 17.71]\n"
            "method orca\n"
            "  time_horizon  runs  arrival_50\n"
            "  5                2           5\n"
            "  8                2           5\n");
}

TEST(Compare, tells_tables_apart_where_nothing_else_differs) {
  const std::string one = by_hand("a.csv"), other = by_hand("b.csv");
  const ProcessResult result =
      run_avo({"compare", one, other, "--by=table", "--columns=arrival_50"});
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_THAT(result.out, HasSubstr("method avo, time_horizon 5\n  table"));
  EXPECT_THAT(result.out, HasSubstr("  " + other + "     2  "));
}

TEST(Compare, draws_tables) {
  const std::string table = by_hand("a.csv");
  const std::string arrival = path_of("arrival.svg"), scaling = path_of("scaling.svg");
  const ProcessResult result =
      run_avo({"compare", table, "--arrival", arrival, "--scaling", scaling, "-q"});
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_EQ(result.out, "");
  for (const std::string& figure : {arrival, scaling})
    EXPECT_THAT(read_file(figure), HasSubstr("<svg"));
  const ProcessResult again = run_avo({"compare", table, "--arrival", path_of("again.svg"), "-q"});
  EXPECT_EQ(again.exit_code, 0);
  EXPECT_EQ(read_file(path_of("again.svg")), read_file(arrival));
}

std::size_t count_of(const std::string& part, const std::string& text) {
  std::size_t count = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1))
    ++count;
  return count;
}

TEST(Compare, draws_a_chart_for_each_block_and_names_each_method_once) {
  const std::string table = by_hand("a.csv");
  ASSERT_EQ(run_avo({"compare", table, "--arrival", path_of("a.svg"), "-q"}).exit_code, 0);
  const std::string by_method = read_file(path_of("a.svg"));
  for (const char* text : {">time_horizon 5<", ">time_horizon 8<", ">method avo<", ">method orca<"})
    EXPECT_EQ(count_of(text, by_method), 1U) << text;
  EXPECT_EQ(count_of(">arrived (%)<", by_method), 2U);
  const ProcessResult other =
      run_avo({"compare", table, "--by=time_horizon", "--arrival", path_of("b.svg"), "-q"});
  ASSERT_EQ(other.exit_code, 0) << other.err;
  EXPECT_NE(read_file(path_of("b.svg")), by_method);
  EXPECT_EQ(count_of(">method avo<", read_file(path_of("b.svg"))), 1U) << "a title";
}

TEST(Compare, draws_recordings) {
  const std::string a = path_of("a.h5"), b = path_of("b.h5");
  ASSERT_EQ(run_avo({"run", "circle-6", "--duration=30", "--record", a, "-q"}).exit_code, 0);
  ASSERT_EQ(run_avo({"run", "cars-100", "--duration=7", "--record", b, "-q"}).exit_code, 0);
  const ProcessResult result =
      run_avo({"compare", a, b, "--arrival", path_of("1.png"), "--clearance", path_of("2.png"),
               "--traces", path_of("3.pdf")});
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_THAT(result.out, HasSubstr("6 of 6   30 s"));
  for (const char* file : {"1.png", "2.png", "3.pdf"}) EXPECT_TRUE(exists(path_of(file))) << file;
}

TEST(Compare, charts_end_with_the_motion) {
  const std::string a = path_of("a.h5");
  ASSERT_EQ(run_avo({"run", "circle-2", "--duration=600", "--record", a, "-q"}).exit_code, 0);
  const std::vector<avo::Vec2> arrivals = avo_cli::arrivals_of(avo_io::read_run(a));
  EXPECT_LT(arrivals.back().x, 30.0);
  EXPECT_EQ(arrivals.back().y, 100.0);
}

TEST(Compare, finds_in_a_recording_what_its_run_has_found) {
  for (const char* scene : {"circle-6", "planes-12", "doorway"}) {
    const std::string path = path_of(std::string(scene) + ".h5");
    const Json json =
        Json::parse(run_avo({"run", scene, "--duration=40", "--record", path, "--json"}).out);
    const avo_io::RecordedRun run = avo_io::read_run(path, 50);
    EXPECT_EQ(run.moments.back().arrived, json["arrived"].get<int>()) << scene;
    EXPECT_EQ(run.travelers, json["robots"].get<int>()) << scene;
    double least = 1e9;
    for (const auto& moment : run.moments) least = std::min(least, moment.clearance.value_or(1e9));
    EXPECT_GE(least, json["min_clearance"].get<double>() - 1e-6) << scene;
    EXPECT_LT(least, json["min_clearance"].get<double>() + 0.2) << scene;
    EXPECT_LE(run.frames.size(), 51U);
    EXPECT_GE(run.frames.size(), 25U);
    EXPECT_EQ(run.frames.back().time, run.moments.back().time);
  }
}

TEST(Compare, takes_nobody_for_arrived_behind_a_wall) {
  write_file(path_of("wall.yaml"),
             "version: 1\nduration: 5\narrival_distance: 1\n"
             "robots:\n"
             "  - {position: [0, 0], goal: [0.9, 0], radius: 0.2}\n"
             "  - {position: [-3, 0], goal: [-2.5, 0], radius: 0.2}\n"
             "  - {position: [-3, 9], goal: [-3, 9], radius: 0.2, parked: true}\n"
             "obstacles:\n  - {polyline: [[0.5, -50], [0.5, 50]]}\n");
  const std::string path = path_of("wall.h5");
  const ProcessResult result =
      run_avo({"run", path_of("wall.yaml"), "--record", path, "--json", "--duration=7"});
  ASSERT_EQ(result.exit_code, 0) << result.err;
  EXPECT_EQ(Json::parse(result.out)["arrived"], 2);
  const avo_io::RecordedRun run = avo_io::read_run(path);
  EXPECT_EQ(run.moments.back().arrived, 1);
  EXPECT_EQ(run.travelers, 2);
}

TEST(Compare, refuses_what_it_cannot_compare_in_one_line) {
  const std::string table = by_hand("a.csv"), figure = path_of("f.svg");
  const auto refused = [](const Strings& words, int code) {
    Strings command{"compare"};
    command.insert(command.end(), words.begin(), words.end());
    const ProcessResult result = run_avo(command);
    EXPECT_EQ(result.exit_code, code) << result.err;
    EXPECT_EQ(lines_of(result.err).size(), 1U) << result.err;
    return result.err;
  };
  EXPECT_EQ(refused({table, "--by", "methd"}, 2),
            "avo: --by: found methd, did you mean \"method\"? Must be one of scene, method, "
            "time_horizon\n");
  EXPECT_THAT(refused({table, "--columns", "arrivel_50"}, 2),
              HasSubstr("did you mean \"arrival_50\"?"));
  EXPECT_THAT(refused({table, "--traces", figure}, 2),
              HasSubstr("--traces: found no recording, must be one or more"));
  EXPECT_THAT(refused({table, "--clearance", figure}, 2), HasSubstr("--clearance: found no"));
  EXPECT_THAT(refused({table, "--arrival", "f.txt"}, 2), HasSubstr("--arrival"));
  EXPECT_EQ(refused({table, "--columns", "state_hash"}, 2),
            "avo: --columns: found state_hash, which says what a run is, must be a result in "
            "numbers, e.g. robots\n");
  EXPECT_THAT(refused({table, "--columns", "scene"}, 2), HasSubstr("--columns: found scene, "));
  EXPECT_THAT(refused({table, "--columns", "seed"}, 2), HasSubstr("--columns: found seed, "));
  const std::string h5 = path_of("run.h5");
  ASSERT_EQ(run_avo({"run", "circle-2", "--duration", "1", "--record", h5, "-q"}).exit_code, 0);
  EXPECT_EQ(refused({h5, "--by", "method"}, 2),
            "avo: --by: found without a table of avo sweep, must be with one or more\n");
  EXPECT_THAT(refused({h5, "--columns", "x"}, 2), HasSubstr("--columns: found without a table"));
  const std::string bad = path_of("bad.csv"), text = read_file(table);
  write_file(bad, kColumns + "s,0,a,avo,5,1,0x,10,0,4,9,1\ns,1,a,avo,5,1,0x,10,0,4,9 s,1\n");
  EXPECT_EQ(refused({bad, "--columns", "arrival_100"}, 3),
            bad + ": run 1: arrival_100: found 9 s, must be a number or empty\n");
  write_file(bad, text.substr(0, text.size() - 1));
  EXPECT_EQ(refused({bad}, 3), bad + ":9: found no end of the line, the table was cut off\n");
  write_file(bad, kColumns.substr(0, kColumns.size() - 1));
  EXPECT_EQ(refused({bad}, 3), bad + ":1: found no end of the line, the table was cut off\n");
  write_file(bad, kColumns);
  EXPECT_EQ(refused({bad}, 3), bad + ": found a table without runs, must have one or more\n");
  EXPECT_THAT(refused({path_of("none.csv")}, 4), HasSubstr("none.csv"));
  EXPECT_THAT(refused({path_of("none.h5")}, 4), HasSubstr("none.h5"));
  write_file(path_of("text.csv"), "time,robot\n0,1\n");
  EXPECT_THAT(refused({path_of("text.csv")}, 3), HasSubstr("found no table of avo sweep"));
  std::string many = kColumns;
  for (char c = 'a'; c <= 'm'; ++c) many += std::string("s,0,") + c + ",avo,5,1,0x,10,0,4,9,1\n";
  write_file(path_of("many.csv"), many);
  EXPECT_THAT(refused({path_of("many.csv"), "--arrival", figure}, 2),
              HasSubstr("--arrival: found 13 curves, must be at most 12"));
  EXPECT_FALSE(exists(figure));
}

}  // namespace
}  // namespace avo_test
