// SPDX-License-Identifier: Apache-2.0
// avo replay finds the first bit that differs.
#include "avo_io/replay.h"

#include <cstdint>
#include <gtest/gtest.h>
#include <hdf5.h>
#include <string>

#include "avo/metrics.h"
#include "avo/version.h"
#include "avo_io/recorded_run.h"
#include "avo_io/recording.h"
#include "edit_hdf5.h"
#include "recorded.h"
#include "verdicts.h"

namespace avo_test {
namespace {

Json difference(const std::string& h5) {
  const ProcessResult result = run_avo({"replay", h5, "--json", "--threads", "2"});
  EXPECT_EQ(result.exit_code, 1) << result.err;
  const Json json = Json::parse(result.out);
  EXPECT_EQ(json["equal"], false);
  return json["difference"];
}

TEST(Replay, of_what_was_recorded_is_equal) {
  const std::string h5 = recorded_circle();
  const ProcessResult words = run_avo({"replay", h5});
  EXPECT_EQ(words.exit_code, 0) << words.err;
  EXPECT_TRUE(
      words.out.starts_with("circle-6: 91 times of 6 robots are equal, and the state hash 0x"))
      << words.out;
  const Json json = Json::parse(run_avo({"replay", h5, "--json"}).out);
  EXPECT_EQ(json["equal"], true);
  EXPECT_EQ(json["times"], 91);
  EXPECT_EQ(json["difference"], Json());
}

TEST(Replay, shows_what_metrics_of_the_run_have_seen) {
  for (const char* scene : {"circle-30", "planes-12", "mixed-yard"}) {
    const std::string h5 = path_of("run.h5");
    Json told = Json::parse(
        run_avo({"run", scene, "--duration", "30", "--record", h5, "--json"}).out)["metrics"];
    avo::Metrics metrics(avo_io::read_run(h5, 2).scenario);
    avo_io::replay(h5, 2, [&](const avo::Simulation& simulation) { metrics.observe(simulation); });
    const Json again = Json::parse(avo_io::to_json(metrics.summary()))["metrics"];
    EXPECT_GT(told["acceleration_rms"], 0.0) << scene;
    EXPECT_FALSE(told["turned_back"].is_null()) << scene;
    told["step_ms_p50"] = told["step_ms_p99"] = Json();  // the replay has no step times
    EXPECT_EQ(again, told) << scene;
  }
}

TEST(Replay, tells_the_first_value_that_differs) {
  const std::string h5 = recorded_circle();
  change(h5, "state", {80, 1, 3}, H5T_NATIVE_DOUBLE, 7.0);
  Json first = difference(h5);
  EXPECT_EQ(first["time"], 8.0);
  EXPECT_EQ(first["robot"], 1);
  EXPECT_EQ(first["column"], "vy");
  EXPECT_EQ(first["recorded"], "7");
  change(h5, "clearance", {70, 5}, H5T_NATIVE_FLOAT, 0.25f);
  first = difference(h5);
  EXPECT_EQ(first["time"], 7.0);
  EXPECT_EQ(first["column"], "clearance");
  change(h5, "status", {66, 0}, H5I_INVALID_HID, std::uint8_t{3});
  first = difference(h5);
  EXPECT_EQ(first["column"], "status");
  EXPECT_EQ(first["recorded"], "braking");
  EXPECT_EQ(first["simulated"], "optimal");
  const ProcessResult words = run_avo({"replay", h5});
  EXPECT_EQ(words.exit_code, 1);
  EXPECT_EQ(words.out,
            "circle-6: 66 times of 6 robots are equal\n  the first that differs: at "
            "6.6000000000000005 s, "
            "robot 0, status: recorded braking, simulated optimal\n");
}

TEST(Replay, sees_the_last_bit) {
  const std::string h5 = recorded_circle();
  const Json json = Json::parse(run_avo({"check", h5, "--json"}).out);
  const hid_t file = H5Fopen(h5.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT);
  const hid_t set = H5Dopen2(file, "state", H5P_DEFAULT);
  std::vector<double> state(91 * 6 * 4);
  ASSERT_GE(H5Dread(set, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, state.data()), 0);
  H5Dclose(set);
  H5Fclose(file);
  const double last = state[(90 * 6 + 2) * 4];
  change(h5, "state", {90, 2, 0}, H5T_NATIVE_DOUBLE, std::nextafter(last, 100.0));
  EXPECT_EQ(difference(h5)["robot"], 2);
}

TEST(Replay, sees_another_hash_and_refuses_another_version) {
  const std::string h5 = recorded_circle();
  set_attribute(h5, "state_hash", 1);
  const Json first = difference(h5);
  EXPECT_EQ(first["column"], "state_hash");
  EXPECT_EQ(first["robot"], Json());
  set_attribute(h5, "version", "9.8.7");
  const ProcessResult result = run_avo({"replay", h5});
  EXPECT_EQ(result.exit_code, 3);
  EXPECT_EQ(result.err, h5 + ": version: found 9.8.7, must be " + avo::kVersion +
                            ": another version of avo need not simulate the same bits\n");
  EXPECT_EQ(run_avo({"check", h5}).exit_code, 0) << "judged all the same";
}

TEST(Replay, finds_rows_that_are_missing) {
  const std::string h5 = recorded_circle();
  leave_out(h5, 20, 21);
  Json first = difference(h5);
  EXPECT_EQ(first["time"], 2.0);
  EXPECT_EQ(first["column"], "time");
  EXPECT_EQ(first["recorded"], "no row");
  EXPECT_EQ(first["simulated"], "2");
  EXPECT_EQ(run_avo({"replay", h5}).out,
            "circle-6: 20 times of 6 robots are equal\n  the first that differs: at 2 s, time: "
            "recorded no row, simulated 2\n");
  leave_out(h5, 0, 1);
  EXPECT_EQ(difference(h5)["time"], 0.0) << "the start";
  const std::string end = recorded_circle();
  leave_out(end, 90, 91);
  EXPECT_EQ(difference(end)["column"], "state_hash") << "nobody knows where the run ended";
}

TEST(Replay, finds_rows_that_are_missing_of_every_so_many_steps) {
  const std::string h5 = path_of("run.h5");
  const auto record = [&h5](const Strings& more) {
    Strings command{"run", "circle-6", "--duration", "9", "--record", h5, "-q"};
    command.insert(command.end(), more.begin(), more.end());
    ASSERT_EQ(run_avo(command).exit_code, 0);
  };
  record({"--every", "7"});  // 0, 7, ..., 84, 90
  EXPECT_EQ(run_avo({"replay", h5}).exit_code, 0);
  leave_out(h5, 2, 3);
  EXPECT_EQ(difference(h5)["simulated"], "1.4000000000000001");
  record({"--every", "7"});
  leave_out(h5, 12, 13);  // 77, 90
  EXPECT_EQ(difference(h5)["simulated"], "8.4");
  record({"--every", "9"});
  EXPECT_EQ(run_avo({"replay", h5}).exit_code, 0);
  record({"--every", "100"});
  EXPECT_EQ(run_avo({"replay", h5}).exit_code, 0) << "the start and the end";
  // that it has the rows of every 7 steps is not true
  record({});
  set_attribute(h5, "every", 7);
  EXPECT_EQ(difference(h5)["simulated"], "0.7000000000000001");
}

TEST(Replay, with_free_clocks_finds_rows_that_are_missing) {
  const std::string h5 = path_of("run.h5");
  ASSERT_EQ(run_avo({"run", "circle-5", "--set", "clock=free", "--set", "duration=4", "--record",
                     h5, "-q"})
                .exit_code,
            0);
  ASSERT_EQ(run_avo({"replay", h5}).exit_code, 0);
  leave_out(h5, 33, 35);
  const Json first = difference(h5);
  EXPECT_EQ(first["recorded"], "no row");
}

TEST(Replay, refuses_what_has_no_scene_in_it) {
  const std::string csv = path_of("run.csv");
  ASSERT_EQ(run_avo({"run", "circle-4", "--duration=2", "--record", csv, "-q"}).exit_code, 0);
  const ProcessResult result = run_avo({"replay", csv});
  EXPECT_EQ(result.exit_code, 3);
  EXPECT_EQ(result.err, csv + ": found no scene in it, must be a recording as HDF5\n");
  const ProcessResult none = run_avo({"replay", path_of("none.h5")});
  EXPECT_EQ(none.exit_code, 4);
  EXPECT_EQ(none.err, path_of("none.h5") + ": No such file or directory\n");
  write_file(path_of("none.h5.part"), "");
  EXPECT_EQ(run_avo({"check", path_of("none.h5")}).err,
            path_of("none.h5") + ": No such file or directory; a run has left " +
                path_of("none.h5.part") + ", which avo reads, and avo recover makes " +
                path_of("none.h5") + " of it\n");
}

}  // namespace
}  // namespace avo_test
