// SPDX-License-Identifier: Apache-2.0
// avo sweep: the same table in any order, on any machines, and after whatever ends it.
#include <algorithm>
#include <fmt/format.h>
#include <functional>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <numeric>
#include <signal.h>
#include <string>
#include <sys/resource.h>
#include <unistd.h>

#include "support/json.h"
#include "sweeps.h"

namespace avo_test {
namespace {

using Json = nlohmann::ordered_json;
using testing::HasSubstr;

/// The sweep lasts long enough to be ended while it runs.
const std::string kLongSweep =
    "version: 1\nscenes: [circle-40, circle-20]\nseeds: {count: 40}\nparameters: {duration: "
    "[90]}\n";

TEST(Sweep, is_the_same_table_with_any_jobs_and_shards) {
  const std::string one = swept(kSmallSweep, "one.csv", {"--jobs", "1"});
  const std::string three = swept(kSmallSweep, "three.csv", {"--jobs", "3"});
  EXPECT_EQ(lines_of(read_file(one)).size(), 1U + 2 * 2 * 2 * 3);
  EXPECT_EQ(untimed(one), untimed(three));
  const std::string first = swept(kSmallSweep, "first.csv", {"--shard", "1/2"});
  const std::string second = swept(kSmallSweep, "second.h5", {"--shard=2/2", "--jobs=2"});
  EXPECT_EQ(lines_of(read_file(first)).size(), 1U + 12);
  const std::string all = swept(kSmallSweep, "all.csv", {"--merge", second, first});
  EXPECT_EQ(untimed(all), untimed(one));
  EXPECT_EQ(files_in(folder()),
            (Strings{"all.csv", "first.csv", "one.csv", "second.h5", "sweep.yaml", "three.csv"}));
}

TEST(Sweep, numbers_its_runs_with_seeds_fastest_and_scenes_slowest) {
  const avo_io::SweepTable table = avo_io::read_sweep(swept(kSmallSweep, "runs.csv"));
  const Strings run = column(table, "run"), scene = column(table, "scene"),
                method = column(table, "method"), seed = column(table, "seed"),
                radius = column(table, "sensing_radius");
  const auto key = [&](std::size_t k) {
    return run[k] + " " + scene[k] + " " + method[k] + " " + radius[k] + " " + seed[k];
  };
  EXPECT_EQ(key(0), "0 circle-5 avo 12 4");
  EXPECT_EQ(key(1), "1 circle-5 avo 12 5");
  EXPECT_EQ(key(3), "3 circle-5 avo 20 4");
  EXPECT_EQ(key(6), "6 circle-5 orca 12 4");
  EXPECT_EQ(key(23), "23 uniform-8 orca 20 6");
}

TEST(Sweep, has_the_numbers_of_avo_run) {
  const avo_io::SweepTable table = avo_io::read_sweep(swept(kSmallSweep, "runs.csv"));
  constexpr std::size_t kRun = 20;  // uniform-8 orca 12 6
  const Json json = Json::parse(run_avo({"run", "uniform-8", "--set=method=orca", "--seed=6",
                                         "--set=sensing_radius=12", "--json"})
                                    .out);
  // all numbers of the summary but one that follows from two others, and times
  const auto compare = [&](const Json& numbers) {
    int compared = 0;
    for (const auto& [name, value] : numbers.items()) {
      if (name == "not_arrived_count" || avo_io::is_sweep_timing(name)) continue;
      if (!value.is_number()) continue;  // what the run has no number of
      const Strings found = column(table, name);
      ASSERT_GT(found.size(), kRun) << name;
      EXPECT_EQ(found[kRun], fmt::format("{}", value.get<double>())) << name;
      ++compared;
    }
    EXPECT_GT(compared, 15);
  };
  compare(json);
  compare(json["metrics"]);
  EXPECT_EQ(column(table, "optimal")[kRun],
            fmt::format("{}", json["decisions"]["optimal"].get<int>()));
  EXPECT_EQ(column(table, "arrival_100")[kRun], column(table, "last_arrival")[kRun]);
}

// Robot 0 avoids no robot, and it runs into robot 1, which rests.
TEST(Sweep, tells_one_sided_collisions_at_rest_from_those_in_motion) {
  write_file(path_of("ram.yaml"),
             "version: 1\nduration: 10\nmethod: avo_paper\nsensing_radius: 0.001\n"
             "allow_broken_assumptions: true\nrobots:\n"
             "  - {position: [0, 0], goal: [9, 0], avoids: []}\n"
             "  - {position: [5, 0.2], goal: [5, 0.2]}\n");
  const avo_io::SweepTable table =
      avo_io::read_sweep(swept("version: 1\nscenes: [ram.yaml]\n", "runs.csv"));
  EXPECT_EQ(column(table, "one_sided_collisions"), Strings{"1"});
  EXPECT_EQ(column(table, "one_sided_collisions_in_motion"), Strings{"0"});
  EXPECT_EQ(column(table, "collision_pairs"), Strings{"0"});
}

TEST(Sweep, tells_when_so_many_have_arrived_and_ends_then_if_it_is_to) {
  const std::string yaml =
      "version: 1\nscenes: [circle-10]\nuntil_arrived: true\nmethods: [avo_paper]\n";
  const avo_io::SweepTable table = avo_io::read_sweep(swept(yaml, "runs.csv"));
  const Json json = Json::parse(
      run_avo({"run", "circle-10", "--set=method=avo_paper", "--until-arrived", "--json"}).out);
  EXPECT_EQ(column(table, "steps")[0], fmt::format("{}", json["steps"].get<int>()));
  EXPECT_EQ(column(table, "first_arrival"), column(table, "arrival_10"));
  double mean = 0.0, before = 0.0;
  for (int k = 10; k <= 100; k += 10) {
    const auto time = avo_io::number_in(column(table, fmt::format("arrival_{}", k))[0]);
    ASSERT_TRUE(time.has_value());
    EXPECT_GE(*time, before);
    before = *time;
    mean += *time / 10.0;  // one robot each
  }
  EXPECT_NEAR(mean, json["mean_arrival"].get<double>(), 1e-9);
}

TEST(Sweep, tells_the_first_arrival_of_robots_that_are_not_parked) {
  write_file(path_of("a.yaml"),
             "version: 1\nduration: 9\nrobots:\n"
             "  - {position: [0, -20], goal: [0, -20], parked: true}\n"
             "  - {position: [0, 0], goal: [1, 0]}\n"
             "  - {position: [0, 9], goal: [4, 9]}\n");
  write_file(path_of("b.yaml"),
             "version: 1\nduration: 1\nrobots:\n  - {position: [0, 0], goal: [90, 0]}\n");
  const avo_io::SweepTable table =
      avo_io::read_sweep(swept("version: 1\nscenes: [a.yaml, b.yaml]\n", "runs.csv"));
  const Strings first = column(table, "first_arrival");
  ASSERT_EQ(first.size(), 2U);
  EXPECT_EQ(first[0], column(table, "arrival_10")[0]);
  EXPECT_EQ(first[0], column(table, "arrival_50")[0]);
  EXPECT_GT(avo_io::number_in(first[0]).value(), 0.0);
  EXPECT_LT(avo_io::number_in(first[0]).value(),
            avo_io::number_in(column(table, "last_arrival")[0]).value());
  EXPECT_EQ(first[1], "");
}

TEST(Sweep, judges_some_robots_among_others) {
  const std::string head = "version: 1\nscenes: [circle-5]\nuntil_arrived: true\n";
  const avo_io::SweepTable all = avo_io::read_sweep(swept(head, "all.csv"));
  const avo_io::SweepTable one = avo_io::read_sweep(swept(head + "judged: [3]\n", "one.csv"));
  const auto field = [](const avo_io::SweepTable& table, const std::string& column) {
    const auto place = std::find(table.columns.begin(), table.columns.end(), column);
    return table.rows.at(0).at(static_cast<std::size_t>(place - table.columns.begin()));
  };
  EXPECT_EQ(field(all, "trips"), "5");
  EXPECT_EQ(field(one, "trips"), "1");
  EXPECT_EQ(field(one, "success"), "1");
  EXPECT_NE(field(one, "sweep"), field(all, "sweep"));
  const ProcessResult result = sweep(head + "judged: [5]\n", {"--out", path_of("none.csv")});
  EXPECT_EQ(result.exit_code, 3);
  EXPECT_NE(result.err.find("found robot 5 judged, must be 0 to 4"), std::string::npos)
      << result.err;
}

TEST(Sweep, measures_the_flow_across_a_line) {
  // one after the other with 1 m/s, 3 m apart, and one beside the line
  std::string scene = "version: 1\nduration: 30\nrobots:\n";
  for (int k = 0; k < 4; ++k)
    scene += fmt::format(
        "  - {{position: [{}, 0], goal: [{}, 0], velocity: [1, 0], preferred_speed: 1}}\n",
        -3 * k - 3, 20 - 3 * k);
  scene += "  - {position: [-9, 9], goal: [9, 9], velocity: [1, 0], preferred_speed: 1}\n";
  write_file(path_of("row.yaml"), scene);
  const std::string head = "version: 1\nscenes: [row.yaml]\n";
  const avo_io::SweepTable table =
      avo_io::read_sweep(swept(head + "line: [[0, -2], [0, 2]]\n", "runs.csv"));
  EXPECT_EQ(column(table, "crossings"), (Strings{"4"})) << "not who passes beside the line";
  const double flow = avo_io::number_in(column(table, "flow").at(0)).value();
  EXPECT_NEAR(flow, 1.0 / 3.0, 1e-3) << "three gaps of 3 s, and not four";
  EXPECT_EQ(avo_io::number_in(column(table, "specific_flow").at(0)).value(), flow / 4.0);
  EXPECT_EQ(table.columns.back(), "seconds");
  const avo_io::SweepTable nobody =
      avo_io::read_sweep(swept(head + "line: [[99, -2], [99, 2]]\n", "none.csv"));
  EXPECT_EQ(column(nobody, "crossings"), (Strings{"0"}));
  EXPECT_EQ(column(nobody, "flow"), (Strings{""}));
  EXPECT_NE(column(nobody, "sweep"), column(table, "sweep")) << "other lines, another sweep";
  EXPECT_EQ(column(avo_io::read_sweep(swept(head, "without.csv")), "flow"), Strings{});
}

/// A summary of a sweep.
avo_io::SweepTable table_in(const std::string& path) {
  avo_io::SweepTable table;
  for (const std::string& line : lines_of(read_file(path))) {
    Strings row;
    for (std::size_t at = 0; at <= line.size();) {
      const std::size_t end = std::min(line.find(',', at), line.size());
      row.push_back(line.substr(at, end - at));
      at = end + 1;
    }
    if (table.columns.empty())
      table.columns = row;
    else
      table.rows.push_back(row);
  }
  return table;
}

TEST(Sweep, has_no_interval_of_runs_that_are_one_and_the_same) {
  const std::string summary = path_of("summary.csv");
  swept("version: 1\nscenes: [circle-5, uniform-8]\nseeds: {count: 3}\n", "runs.csv",
        {"--summary", summary});
  const avo_io::SweepTable table = table_in(summary);
  ASSERT_EQ(table.rows.size(), 2U);
  for (const char* name : {"mean_arrival", "collided", "step_milliseconds_median"}) {
    const Strings low = column(table, std::string(name) + ".low");
    const Strings high = column(table, std::string(name) + ".high");
    EXPECT_EQ(column(table, std::string(name) + ".count")[0], "3") << name;
    EXPECT_EQ(low[0] + high[0], "") << name << ": the seed changes nothing of a circle";
    EXPECT_NE(low[1], "") << name;
    EXPECT_NE(high[1], "") << name;
  }
}

TEST(Sweep, tells_the_median_and_the_mean_over_its_seeds) {
  const std::string summary = path_of("summary.csv");
  const avo_io::SweepTable runs =
      avo_io::read_sweep(swept("version: 1\nscenes: [uniform-12]\nmethods: "
                               "[orca_clamped]\nparameters: {duration: [20]}\nseeds: {count: 5}\n",
                               "runs.csv", {"--summary", summary}));
  const avo_io::SweepTable table = table_in(summary);
  for (const std::string name : {"jerk", "acceleration_rms", "turned_back"}) {
    std::vector<double> values;
    for (const std::string& field : column(runs, name)) values.push_back(std::stod(field));
    std::sort(values.begin(), values.end());
    ASSERT_EQ(values.size(), 5U) << name;
    EXPECT_LT(values[0], values[4]) << name;
    EXPECT_EQ(std::stod(column(table, name + ".median").at(0)), values[2]) << name;
    const double mean = std::accumulate(values.begin(), values.end(), 0.0) / 5.0;
    EXPECT_NEAR(std::stod(column(table, name + ".mean").at(0)), mean, 1e-12) << name;
  }
}

TEST(Sweep, prepares_no_run_again_that_is_done) {
  const avo_io::SweepSpec spec = avo_io::parse_sweep(kSmallSweep, path_of("s"));
  std::vector<std::pair<std::int64_t, std::int64_t>> told;
  const avo_io::SweepOptions options{
      .jobs = 2,
      .journal = path_of("runs.part"),
      .preparing = [&](std::int64_t done, std::int64_t all) { told.emplace_back(done, all); }};
  EXPECT_EQ(run_sweep(spec, options).resumed, 0);
  ASSERT_FALSE(told.empty());
  for (const auto& [done, all] : told) EXPECT_EQ(all, 8 + 24) << "kinds of runs, and runs";
  EXPECT_EQ(told.back().first, 8 + 24);
  told.clear();
  EXPECT_EQ(run_sweep(spec, options).resumed, 24);
  ASSERT_FALSE(told.empty());
  EXPECT_EQ(told.back().first, 8) << "only to tell that it is the same sweep";
}

/// Ends the long sweep once some of its runs are done.
ProcessResult ended_by(int signal) {
  const std::string journal = path_of("runs.csv.part");
  return sweep(
      kLongSweep, {"--out", path_of("runs.csv"), "--jobs=2"}, {.meanwhile = [&](int pid) {
        wait_until(pid, [&] { return exists(journal) && lines_of(read_file(journal)).size() > 4; });
        kill(pid, signal);
      }});
}

/// The rows of the journal without their hashes.
Strings kept_rows() {
  Strings rows = lines_of(read_file(path_of("runs.csv.part")));
  rows.erase(rows.begin());
  for (std::string& row : rows) row.resize(row.rfind(','));
  return rows;
}

/// Goes on, and has done no run again that is among `kept`: even its times are those.
void expect_goes_on(const Strings& kept) {
  const ProcessResult result = sweep(kLongSweep, {"--out", path_of("runs.csv"), "--jobs=2"});
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_THAT(result.out, HasSubstr(fmt::format("80 runs, {} of them before, in", kept.size())));
  const Strings rows = lines_of(read_file(path_of("runs.csv")));
  EXPECT_EQ(rows.size(), 81U);
  for (const std::string& row : kept)
    EXPECT_EQ(std::count(rows.begin(), rows.end(), row), 1) << row;
  EXPECT_EQ(untimed(path_of("runs.csv")), untimed(swept(kLongSweep, "whole.csv")));
  EXPECT_FALSE(exists(path_of("runs.csv.part")));
}

TEST(Sweep, goes_on_after_it_was_killed_and_notices_a_torn_line) {
  EXPECT_EQ(ended_by(SIGKILL).exit_code, 128 + SIGKILL);
  EXPECT_FALSE(exists(path_of("runs.csv")));
  Strings kept = kept_rows();
  ASSERT_GE(kept.size(), 4U);
  ASSERT_LT(kept.size(), 80U);
  // the last line loses its end, as where the power fails
  const std::string journal = read_file(path_of("runs.csv.part"));
  write_file(path_of("runs.csv.part"), journal.substr(0, journal.size() - 9));
  kept.pop_back();
  expect_goes_on(kept);
}

TEST(Sweep, runs_again_what_has_a_changed_digit_and_all_behind_it) {
  EXPECT_EQ(ended_by(SIGKILL).exit_code, 128 + SIGKILL);
  Strings kept = kept_rows();
  ASSERT_GE(kept.size(), 4U);
  std::string journal = read_file(path_of("runs.csv.part"));
  const std::size_t at = journal.find(",circle", journal.find(kept[2]));
  ASSERT_NE(at, std::string::npos);
  journal[at - 1] = journal[at - 1] == '7' ? '8' : '7';  // the number of the run
  write_file(path_of("runs.csv.part"), journal);
  kept.resize(2);
  expect_goes_on(kept);
}

TEST(Sweep, ends_with_the_runs_under_way_on_a_signal) {
  const ProcessResult result = ended_by(SIGINT);
  EXPECT_EQ(result.exit_code, 130);
  EXPECT_THAT(result.err, HasSubstr("of 80 runs; the same command goes on from there\n"));
  EXPECT_FALSE(exists(path_of("runs.csv")));
  expect_goes_on(kept_rows());
}

TEST(Sweep, says_that_the_disk_is_full_and_leaves_no_table) {
  write_file(path_of("sweep.yaml"), kSmallSweep);
  const std::string h5 = path_of("full.h5");
  int refused = 0;
  for (unsigned kibibytes = 1; kibibytes < 400; kibibytes += 7) {
    const ProcessResult result =
        run_avo({"sweep", path_of("sweep.yaml"), "--out", h5, "-q"}, {.before = [kibibytes] {
                  signal(SIGXFSZ, SIG_IGN);
                  const rlimit limit{1024 * kibibytes, 1024 * kibibytes};
                  setrlimit(RLIMIT_FSIZE, &limit);
                }});
    if (result.exit_code == 0) break;
    EXPECT_EQ(result.exit_code, 4) << kibibytes << " KiB: " << result.err;
    EXPECT_THAT(result.err, HasSubstr("full.h5"));
    EXPECT_EQ(lines_of(result.err).size(), 1U) << result.err;
    EXPECT_FALSE(exists(h5));
    ++refused;
  }
  EXPECT_GT(refused, 3);
  EXPECT_TRUE(exists(h5)) << "it went on from its journal once there was room";
}

TEST(Sweep, does_not_go_on_with_the_runs_of_another_one) {
  ended_by(SIGKILL);
  const std::string out = path_of("runs.csv");
  const std::string refused =
      out +
      ".part: found the runs of another sweep, shard or version, must be of this one; "
      "remove it to begin anew\n";
  for (const auto& [yaml, more] : {std::pair{kSmallSweep, Strings{}},
                                   {kLongSweep, {"--shard=1/2"}},
                                   {kLongSweep + "until_arrived: true\n", {}},
                                   {kLongSweep + "methods: [orca]\n", {}}}) {
    Strings words = more;
    words.insert(words.end(), {"--out", out});
    const ProcessResult result = sweep(yaml, words);
    EXPECT_EQ(result.exit_code, 3);
    EXPECT_EQ(result.err, refused);
  }
}

TEST(Sweep, knows_a_scene_by_its_text_and_not_by_its_name) {
  const std::string scene = path_of("a.yaml");
  const std::string yaml = "version: 1\nscenes: [a.yaml]\n";
  write_file(scene, "version: 1\nduration: 3\nrobots:\n  - {position: [0, 0], goal: [1, 0]}\n");
  const avo_io::SweepTable before = avo_io::read_sweep(swept(yaml, "runs.csv"));
  EXPECT_EQ(column(before, "steps"), (Strings{"30"}));
  EXPECT_EQ(column(before, "scene"), (Strings{"a.yaml"}));
  EXPECT_EQ(column(before, "seed"), (Strings{"1"}));
  EXPECT_EQ(column(before, "method"), (Strings{"avo"}));
  write_file(scene, "version: 1\nduration: 4\nrobots:\n  - {position: [0, 0], goal: [1, 0]}\n");
  const ProcessResult result =
      sweep(yaml, {"--merge", path_of("runs.csv"), "--out", path_of("all.csv")});
  EXPECT_EQ(result.exit_code, 3);
  EXPECT_THAT(result.err, HasSubstr("runs.csv: found a table of another sweep"));
}

}  // namespace
}  // namespace avo_test
