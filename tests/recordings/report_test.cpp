// SPDX-License-Identifier: Apache-2.0
// avo report: one page that needs nothing else and does nothing that a scene asks for.
#include <gtest/gtest.h>
#include <regex>
#include <string>

#include "verdicts.h"

namespace avo_test {
namespace {

std::string page_of(const Strings& scene) {
  const std::string h5 = path_of("run.h5"), html = path_of("out.html");
  Strings command{"run", "--record", h5, "-q"};
  command.insert(command.end(), scene.begin(), scene.end());
  EXPECT_EQ(run_avo(command).exit_code, 0);
  const ProcessResult result = run_avo({"report", h5, html});
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_EQ(result.out, html + "\n");
  return read_file(html);
}

std::size_t count(const std::string& text, const std::string& part) {
  std::size_t found = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1))
    ++found;
  return found;
}

/// The script's data.
Json data_in(const std::string& page) {
  const std::size_t from = page.find("const data = ") + 13, to = page.find(";\n", from);
  return Json::parse(page.substr(from, to - from));
}

TEST(Report, has_verdict_results_command_scene_and_replay) {
  const std::string page =
      page_of({"circle-6", "--set", "duration=30", "--set", "groups.0.radius=0.6"});
  EXPECT_NE(page.find("<span class=\"verdict safe\">safe</span>"), std::string::npos);
  EXPECT_NE(page.find("avo run circle-6 --set duration=30 --set groups.0.radius=0.6 --record "),
            std::string::npos);
  EXPECT_NE(page.find("<tr><td>arrived</td><td>6</td></tr>"), std::string::npos);
  EXPECT_NE(page.find("overlaps           0 pairs of robots"), std::string::npos);
  EXPECT_NE(page.find("# N robots on a circle"), std::string::npos);
  EXPECT_EQ(count(page, "<circle r=\"0.6\""), 6U);
  EXPECT_EQ(count(page, "data:image/svg+xml;base64,"), 4U);
  const Json data = data_in(page);
  const std::size_t times = data["times"].size();
  EXPECT_EQ(times, 301U);
  const std::string positions = data["positions"];
  EXPECT_EQ(positions.size(), (times * 6 * 2 * 2 + 2) / 3 * 4);
}

TEST(Report, leaves_no_mark_and_loads_nothing) {
  const std::string page = page_of({"person", "--set", "duration=5"});
  EXPECT_FALSE(std::regex_search(page, std::regex("@[a-z]+@")));
  EXPECT_EQ(page.find("http://"), std::string::npos);
  EXPECT_EQ(page.find("https://"), std::string::npos);
  EXPECT_NE(page.find("default-src 'none'"), std::string::npos);
  EXPECT_NE(page.find("<title>moving obstacle 0</title>"), std::string::npos);
}

TEST(Report, shows_what_scenes_say_as_text) {
  const std::string scene = path_of("evil.yaml");
  write_file(
      scene,
      "version: 1\nname: '<img src=x onerror=alert(1)>@scene@'\nduration: 3\n"
      "# </script><script>alert(2)</script>\nrobots:\n  - {position: [0, 0], goal: [2, 0]}\n");
  const std::string page = page_of({scene});
  EXPECT_EQ(page.find("<img src=x"), std::string::npos);
  EXPECT_EQ(count(page, "<script>"), 1U);
  EXPECT_EQ(count(page, "</script>"), 1U);
  EXPECT_NE(page.find("&lt;img src=x onerror=alert(1)&gt;@scene@</h1>"), std::string::npos);
}

TEST(Report, of_many_frames_stays_small) {
  const std::string page = page_of({"uniform-1000", "--set", "duration=60"});
  EXPECT_LE(data_in(page)["times"].size() * 1000, 400'000U);
  EXPECT_GT(data_in(page)["times"].size(), 300U);
}

TEST(Report, refuses_what_has_no_scene_in_it) {
  const std::string csv = path_of("run.csv");
  ASSERT_EQ(run_avo({"run", "circle-4", "--duration=2", "--record", csv, "-q"}).exit_code, 0);
  const ProcessResult result = run_avo({"report", csv, path_of("out.html")});
  EXPECT_EQ(result.exit_code, 3);
  EXPECT_EQ(result.err, csv + ": found no scene in it, must be a recording as HDF5\n");
  EXPECT_FALSE(exists(path_of("out.html")));
  EXPECT_EQ(run_avo({"report", csv, path_of("out.txt")}).exit_code, 2);
}

}  // namespace
}  // namespace avo_test
