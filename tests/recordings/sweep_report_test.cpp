// SPDX-License-Identifier: Apache-2.0
// avo report of a sweep: its tables and figures, and one run that is simulated again.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <string>

#include "sweeps.h"
#include "verdicts.h"

namespace avo_test {
namespace {

using testing::HasSubstr;
using testing::Not;

/// Table and page of the small sweep.
std::string sweep_page(const Strings& more) {
  swept(kSmallSweep, "runs.csv");
  Strings command{"report", path_of("runs.csv"), path_of("out.html")};
  command.insert(command.end(), more.begin(), more.end());
  const ProcessResult result = run_avo(command);
  EXPECT_EQ(result.exit_code, 0) << result.err;
  return read_file(path_of("out.html"));
}

std::size_t times_in(const std::string& text, const std::string& part) {
  std::size_t found = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1))
    ++found;
  return found;
}

TEST(SweepReport, has_a_table_and_a_figure_for_each_block) {
  const std::string page = sweep_page({});
  EXPECT_THAT(page, HasSubstr("24 runs: 2 scenes, 2 methods, 2 values of sensing_radius, 3 seeds"));
  EXPECT_EQ(times_in(page, "<h3>scene "), 4U);
  EXPECT_EQ(times_in(page, "data:image/svg+xml;base64,"), 4U);
  EXPECT_EQ(times_in(page, "<tr><td>avo</td><td>3</td>"), 4U);
  EXPECT_EQ(times_in(page, "<tr><td>orca</td><td>3</td>"), 4U);
  EXPECT_EQ(times_in(page, "<script>"), 0U);
  EXPECT_THAT(page, HasSubstr("With --spec"));
}

TEST(SweepReport, shows_the_run_that_is_asked_for) {
  const std::string page = sweep_page({"--spec", path_of("sweep.yaml"), "--run", "22"});
  EXPECT_THAT(page, HasSubstr("<h2>Run 22: uniform-8 orca sensing_radius=20 seed=5</h2>"));
  EXPECT_THAT(page, HasSubstr("avo run uniform-8 --set method=orca --set sensing_radius=20 --set "
                              "seed=5</pre>"));
  EXPECT_THAT(page, HasSubstr("<pre>avo sweep " + path_of("sweep.yaml") + " --out " +
                              path_of("runs.csv") + "</pre>"));
  EXPECT_EQ(times_in(page, "<circle r=\"0.5\""), 8U);
  EXPECT_EQ(times_in(page, "<script>"), 1U);
  EXPECT_THAT(page, HasSubstr("scenes: [circle-5, uniform-8]"));
}

// The balls of two robots and of a moving obstacle, from above and from the side.
TEST(SweepReport, shows_a_run_in_space) {
  write_file(path_of("drones.yaml"),
             "version: 1\nspace: 3\nduration: 4\nrobots:\n"
             "  - {position: [0, 0, 0], goal: [6, 0, 1]}\n"
             "  - {position: [6, 1, 0], goal: [0, 1, 1]}\n"
             "moving_obstacles:\n  - {position: [3, 9, 0], velocity: [0, -1, 0], radius: 0.7}\n");
  const std::string spec = "version: 1\nscenes: [" + path_of("drones.yaml") +
                           "]\nmethods: [avo]\nparameters:\n  time_horizon: [2, 3]\n";
  swept(spec, "runs.csv");
  const ProcessResult result = run_avo({"report", path_of("runs.csv"), path_of("out.html"),
                                        "--spec", path_of("sweep.yaml"), "--run", "1"});
  ASSERT_EQ(result.exit_code, 0) << result.err;
  const std::string page = read_file(path_of("out.html"));
  EXPECT_THAT(page, HasSubstr("time_horizon=3, from above, and from the side</h2>"));
  EXPECT_THAT(page, HasSubstr("avo run " + path_of("drones.yaml") + " --set time_horizon=3</pre>"));
  EXPECT_EQ(times_in(page, "<circle r=\"0.5\""), 4U);
  EXPECT_EQ(times_in(page, "<circle r=\"0.7\""), 2U);
  EXPECT_EQ(times_in(page, "<script>"), 1U);
}

TEST(SweepReport, knows_a_shard_by_its_runs) {
  swept(kSmallSweep, "part.csv", {"--shard", "3/5"});
  const ProcessResult result = run_avo(
      {"report", path_of("part.csv"), path_of("out.html"), "--spec", path_of("sweep.yaml")});
  EXPECT_EQ(result.exit_code, 0) << result.err;
  const std::string page = read_file(path_of("out.html"));
  EXPECT_THAT(page, HasSubstr("<h2>Run 2: "));
  EXPECT_THAT(page, HasSubstr("sweep.yaml --shard 3/5 --out "));
  const ProcessResult other = run_avo({"report", path_of("part.csv"), path_of("other.html"),
                                       "--spec", path_of("sweep.yaml"), "--run", "3"});
  EXPECT_EQ(other.exit_code, 2);
  EXPECT_EQ(other.err,
            "avo: --run: found 3, must be one of the runs in " + path_of("part.csv") + "\n");
  EXPECT_FALSE(exists(path_of("other.html")));
}

TEST(SweepReport, refuses_another_spec_and_another_state) {
  const std::string table = swept(kSmallSweep, "runs.csv"), html = path_of("out.html");
  const std::string spec = path_of("sweep.yaml");
  std::string text = read_file(table);
  const std::size_t hash = text.find("0x", text.find('\n'));
  text[hash + 2] = text[hash + 2] == '0' ? '1' : '0';
  write_file(path_of("edited.csv"), text);
  const ProcessResult edited = run_avo({"report", path_of("edited.csv"), html, "--spec", spec});
  EXPECT_EQ(edited.exit_code, 3);
  EXPECT_THAT(edited.err, HasSubstr("edited.csv: run 0: state_hash: found 0x"));
  write_file(spec, kSmallSweep + "until_arrived: true\n");
  const ProcessResult other = run_avo({"report", table, html, "--spec", spec});
  EXPECT_EQ(other.exit_code, 3);
  EXPECT_THAT(other.err, HasSubstr("found a table of another sweep"));
  EXPECT_FALSE(exists(html));
}

TEST(SweepReport, refuses_options_that_do_not_belong_together) {
  const std::string table = swept(kSmallSweep, "runs.csv"), html = path_of("out.html");
  EXPECT_EQ(run_avo({"report", table, html, "--run", "1"}).err,
            "avo: --run: found without --spec, must be with it\n");
  const std::string h5 = path_of("run.h5");
  ASSERT_EQ(run_avo({"run", "circle-4", "--duration=2", "--record", h5, "-q"}).exit_code, 0);
  EXPECT_EQ(run_avo({"report", h5, html, "--spec", path_of("sweep.yaml")}).err,
            "avo: --spec: found with a recording, must be with a table of avo sweep\n");
  EXPECT_FALSE(exists(html));
}

TEST(SweepReport, reads_tables_as_hdf5) {
  const std::string table = swept(kSmallSweep, "runs.h5"), html = path_of("out.html");
  const ProcessResult result =
      run_avo({"report", table, html, "--spec", path_of("sweep.yaml"), "--run=5"});
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_THAT(read_file(html), HasSubstr("<h2>Run 5: circle-5 avo sensing_radius=20 seed=6</h2>"));
}

}  // namespace
}  // namespace avo_test
