// SPDX-License-Identifier: Apache-2.0
// Recordings of earlier builds have scenes with keys and values that were removed since.
#include <gtest/gtest.h>
#include <string>
#include <utility>

#include "avo_io/recording.h"
#include "edit_hdf5.h"
#include "recorded.h"

namespace avo_test {
namespace {

/// Gives the recording's scene another line, as an earlier build may have written it.
void add_line(const std::string& h5, const std::string& line) {
  const std::string yaml = avo_io::read_recording_header(h5)->scene.yaml;
  set_attribute(h5, "scene", yaml + line + "\n");
}

TEST(RemovedSettings, a_removed_key_with_its_usual_value_changes_nothing) {
  const std::string h5 = recorded_circle();
  add_line(h5, "precision: double\nsamples: 0");
  EXPECT_EQ(run_avo({"check", h5}).exit_code, 0);
  const ProcessResult again = run_avo({"replay", h5});
  EXPECT_EQ(again.exit_code, 0) << again.err;
}

TEST(RemovedSettings, are_read_too_where_set_had_them) {
  const std::string h5 = recorded_circle({"--set", "seed=7"});
  set_attribute(h5, "override.0", "precision=double");
  const ProcessResult again = run_avo({"replay", h5});
  EXPECT_EQ(again.exit_code, 0) << again.err;
}

TEST(RemovedSettings, that_changed_the_motion_are_read_and_not_simulated_again) {
  for (const auto& [key, value] : {std::pair{"right_of_way", "told"}, std::pair{"samples", "25"},
                                   std::pair{"certificate", "stopping_capsules"}}) {
    const std::string h5 = recorded_circle();
    add_line(h5, std::string(key) + ": " + value);
    EXPECT_EQ(run_avo({"check", h5}).exit_code, 0) << key;
    const ProcessResult again = run_avo({"replay", h5});
    EXPECT_EQ(again.exit_code, 3) << key;
    const std::string beginning = h5 + ": its scene: found " + key + ": ";
    EXPECT_TRUE(again.err.starts_with(beginning)) << again.err;
    EXPECT_TRUE(again.err.ends_with(", which was removed: its run cannot be simulated again\n"))
        << again.err;
    const std::string page = path_of("run.html");
    EXPECT_EQ(run_avo({"report", h5, page}).exit_code, 0) << key;
    EXPECT_NE(read_file(page).find("was removed from avo"), std::string::npos) << key;
  }
}

TEST(RemovedSettings, are_refused_where_a_user_sets_them) {
  const std::string h5 = recorded_circle();
  const ProcessResult result = run_avo({"check", h5, "--set", "precision=double"});
  EXPECT_EQ(result.exit_code, 2);
  EXPECT_TRUE(result.err.starts_with("--set precision=double: found the removed key \"precision\""))
      << result.err;
}

}  // namespace
}  // namespace avo_test
