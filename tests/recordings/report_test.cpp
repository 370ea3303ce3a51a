// SPDX-License-Identifier: Apache-2.0
// avo report: one page that needs nothing else and does nothing that a scene asks for.
#include <filesystem>
#include <gtest/gtest.h>
#include <regex>
#include <signal.h>
#include <sstream>
#include <string>
#include <unistd.h>

#include "edit_hdf5.h"
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

TEST(Report, tells_the_flow_across_a_line) {
  const std::string h5 = path_of("run.h5"), html = path_of("out.html");
  ASSERT_EQ(run_avo({"run", "doorway", "--duration=60", "--record", h5, "-q"}).exit_code, 0);
  ASSERT_EQ(run_avo({"report", h5, html, "--line", "0,-0.8,0,0.8"}).exit_code, 0);
  const std::string page = read_file(html);
  const auto value_of = [&](const std::string& name) {
    const std::string row = "<tr><td>metrics." + name + "</td><td>";
    const std::size_t at = page.find(row);
    return at == std::string::npos ? -1.0 : std::stod(page.substr(at + row.size(), 20));
  };
  EXPECT_GE(value_of("crossings"), 2.0);
  EXPECT_GT(value_of("flow"), 0.0);
  EXPECT_NEAR(value_of("specific_flow"), value_of("flow") / 1.6, 1e-5);
  ASSERT_EQ(run_avo({"report", h5, html}).exit_code, 0);
  EXPECT_EQ(read_file(html).find("metrics.crossings"), std::string::npos);
}

TEST(Report, refuses_what_is_no_line_and_leaves_the_page_as_it_was) {
  const std::string h5 = path_of("run.h5"), html = path_of("out.html");
  ASSERT_EQ(run_avo({"run", "person", "--duration=1", "--record", h5, "-q"}).exit_code, 0);
  for (const char* line : {"0,0,1", "0,0,1,1,1", "0,0,0,0", "0,0,a,1", "0,0,nan,1", "0,0,1,inf",
                           "0,0,1,", "0,,1,1", "0,0,1,1e13"}) {
    const ProcessResult result = run_avo({"report", h5, html, "--line", line});
    EXPECT_EQ(result.exit_code, 2) << line;
    EXPECT_EQ(result.err,
              std::string("avo: --line: found ") + line + ", must be X,Y,X,Y, two points in m\n");
    EXPECT_FALSE(std::filesystem::exists(html));
  }
  EXPECT_EQ(run_avo({"report", h5, html, "--line", "-5,-1,-5,1"}).exit_code, 0);
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

/// The command that a page shows, without its name.
Strings command_in(const std::string& page) {
  const std::size_t from = page.find("avo run "), to = page.find('<', from);
  std::istringstream words(page.substr(from, to - from));
  Strings command;
  for (std::string word; words >> word;) command.push_back(word);
  command.erase(command.begin());
  return command;
}

std::string report_on(const std::string& h5) {
  const ProcessResult result = run_avo({"report", h5, path_of("out.html")});
  EXPECT_EQ(result.exit_code, 0) << result.err;
  return read_file(path_of("out.html"));
}

/// The command of `page`, the report on `h5`, makes the same rows.
void expect_exact(const std::string& h5, const std::string& page) {
  const std::string a = path_of("a.csv"), b = path_of("b.csv"), again = path_of("again.h5");
  Strings command = command_in(page);
  ASSERT_EQ(command.back(), h5);
  command.back() = again;
  command.push_back("-q");
  const ProcessResult result = run_avo(command);
  ASSERT_EQ(result.exit_code, 0) << result.err;
  ASSERT_EQ(run_avo({"convert", h5, a, "-q"}).exit_code, 0);
  ASSERT_EQ(run_avo({"convert", again, b, "-q"}).exit_code, 0);
  EXPECT_TRUE(read_file(a) == read_file(b)) << h5;
}

TEST(Report, has_the_command_of_a_run_until_all_have_arrived) {
  const std::string page = page_of({"circle-4", "--until-arrived", "--every", "3"});
  EXPECT_NE(page.find("avo run circle-4 --every 3 --until-arrived --record"), std::string::npos);
  expect_exact(path_of("run.h5"), page);
  // some robots have not arrived by the end of the scene
  const std::string late = page_of({"circle-4", "--until-arrived", "--duration", "2"});
  EXPECT_NE(late.find("avo run circle-4 --set duration=2 --until-arrived --record"),
            std::string::npos);
}

TEST(Report, has_the_command_of_a_run_that_a_signal_has_ended) {
  const std::string h5 = path_of("run.h5");
  for (const Strings& scene :
       {Strings{"circle-1000"}, Strings{"circle-1000", "--until-arrived"},
        Strings{"circle-200", "--set", "clock=free", "--set", "duration=500"}}) {
    Strings command{"run", "--threads", "1", "--every", "50", "--record", h5, "-q"};
    command.insert(command.end(), scene.begin(), scene.end());
    const ProcessResult run = run_avo_to_its_own_end(command, {.meanwhile = [](int pid) {
                                                       wait_until_caught(pid, SIGINT);
                                                       wait_until_worked(pid, 0.5);
                                                       kill(pid, SIGINT);
                                                     }});
    ASSERT_EQ(run.exit_code, 130) << run.err;
    const std::string page = report_on(h5);
    EXPECT_NE(page.find(" --duration "), std::string::npos);
    expect_exact(h5, page);
  }
}

TEST(Report, of_a_run_that_differs_leaves_out_its_results) {
  page_of({"circle-6", "--duration", "9"});
  const std::string h5 = path_of("run.h5");
  ASSERT_NE(report_on(h5).find("<td>arrived</td>"), std::string::npos);
  change(h5, "state", {80, 1, 3}, H5T_NATIVE_DOUBLE, 0.7);
  const std::string page = report_on(h5);
  EXPECT_EQ(page.find("<td>arrived</td>"), std::string::npos);
  EXPECT_NE(page.find("Simulated again, the run is another one than the recording"),
            std::string::npos);
  EXPECT_NE(page.find("at 8 s, robot 1, vy: recorded 0.7, simulated"), std::string::npos);
  EXPECT_NE(page.find("avo run circle-6 --set duration=9 --record"), std::string::npos);
}

TEST(Report, of_another_version_leaves_out_its_results) {
  page_of({"circle-6", "--duration", "9"});
  const std::string h5 = path_of("run.h5");
  set_attribute(h5, "version", "9.8.7");
  const std::string page = report_on(h5);
  EXPECT_EQ(page.find("<td>arrived</td>"), std::string::npos);
  EXPECT_NE(page.find("Another version of avo has made the recording"), std::string::npos);
  EXPECT_NE(page.find("avo run circle-6 --set duration=9 --record"), std::string::npos);
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
  EXPECT_EQ(result.err, csv +
                            ": found no table of avo sweep, whose first columns must be sweep, "
                            "run, scene, method, parameters, seed, state_hash; a recording must be "
                            "HDF5\n");
  EXPECT_FALSE(exists(path_of("out.html")));
  EXPECT_EQ(run_avo({"report", csv, path_of("out.txt")}).exit_code, 2);
}

}  // namespace
}  // namespace avo_test
