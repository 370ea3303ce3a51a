// SPDX-License-Identifier: Apache-2.0
// avo lab: what it puts into the page, where it writes it, and what it refuses.
#include <fcntl.h>
#include <gtest/gtest.h>
#include <string>
#include <sys/stat.h>
#include <unistd.h>
#include <vector>

#include "avo_io/recording.h"
#include "avo_io/scene.h"
#include "pseudo_terminal.h"
#include "run_avo.h"
#include "support/json.h"

namespace avo_test {
namespace {

using Json = nlohmann::ordered_json;
using Strings = std::vector<std::string>;

const std::string kMark = "<script id=\"avo-input\" type=\"application/json\">";

/// In the test's folder.
ProcessResult lab(Strings words, const ProcessOptions& options = {}) {
  words.insert(words.begin(), "lab");
  ProcessOptions here = options;
  here.binary = AVO_WITH_LAB;
  here.before = [before = options.before] {
    if (chdir(folder().c_str()) != 0) _exit(97);
    if (before) before();
  };
  return run_avo(words, here);
}

/// What a page opens; all else of it must be as it was built.
Json input_in(const std::string& page) {
  const std::string built = read_file(AVO_SMALL_LAB);
  const std::size_t from = built.find(kMark) + kMark.size();
  const std::string tail = built.substr(from + 4);
  EXPECT_EQ(page.substr(0, from), built.substr(0, from));
  EXPECT_EQ(page.substr(page.size() - tail.size()), tail);
  const std::string input = page.substr(from, page.size() - tail.size() - from);
  EXPECT_EQ(input.find('<'), std::string::npos);
  return Json::parse(input);
}

avo_io::SceneSource source_in(const Json& input) {
  avo_io::SceneSource source{input["name"], input["yaml"], input["overrides"], {}};
  for (const Json& file : input["files"])
    source.files.push_back({file["path"], file["text"], file["builtin"]});
  source.start_at_rest = input["start_at_rest"];
  source.limit_speed = input["limit_speed"];
  return source;
}

std::string bytes_of(const std::string& base64) {
  const std::string digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string bytes;
  unsigned group = 0, bits = 0;
  for (const char c : base64) {
    if (c == '=') break;
    group = group << 6U | static_cast<unsigned>(digits.find(c));
    bits += 6;
    if (bits < 8) continue;
    bits -= 8;
    bytes += static_cast<char>(group >> bits & 255U);
  }
  return bytes;
}

TEST(Lab, without_an_argument_is_the_page_as_it_was_built) {
  const ProcessResult result = lab({});
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_EQ(result.out, "lab.html\n");
  EXPECT_EQ(read_file(path_of("lab.html")), read_file(AVO_SMALL_LAB));
}

TEST(Lab, has_the_scene_that_was_asked_for) {
  const ProcessResult result =
      lab({"circle-6", "--set", "groups.0.radius=0.6", "--seed", "7", "--start-at-rest"});
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_EQ(result.out, "circle-6.html\n");
  const Json input = input_in(read_file(path_of("circle-6.html")));
  EXPECT_EQ(input["kind"], "scene");
  EXPECT_EQ(input["name"], "circle-6");
  EXPECT_EQ(input["overrides"], Json::parse(R"(["groups.0.radius=0.6", "seed=7"])"));
  EXPECT_FALSE(input.contains("embedded"));
  const avo_io::SceneSource source = source_in(input);
  EXPECT_TRUE(source.start_at_rest);
  const avo::Scenario scenario = avo_io::parse_scenario(source);
  ASSERT_EQ(scenario.robots.size(), 6U);
  EXPECT_EQ(scenario.robots[3].radius, 0.6);
  EXPECT_EQ(scenario.seed, 7U);
}

TEST(Lab, has_the_files_that_a_scene_names) {
  ASSERT_EQ(lab({"arena"}).exit_code, 0);
  const avo_io::SceneSource source = source_in(input_in(read_file(path_of("arena.html"))));
  ASSERT_FALSE(source.files.empty());
  EXPECT_TRUE(source.files[0].builtin);
  EXPECT_EQ(walls_of(avo_io::parse_scenario(source).obstacles).size(),
            walls_of(avo_io::load_scenario("arena").obstacles).size());
}

TEST(Lab, has_raw_images_byte_by_byte) {
  std::string map = "P5\n200 100\n255\n";
  for (int k = 0; k < 200 * 100; ++k) map += k % 7 == 0 ? '\0' : '\xfe';
  write_file(path_of("map.pgm"), map);
  write_file(path_of("map.yaml"),
             "image: map.pgm\nresolution: 0.1\norigin: [50, 50, 0]\nnegate: 0\n"
             "occupied_thresh: 0.65\nfree_thresh: 0.196\n");
  write_file(path_of("scene.yaml"),
             "version: 1\nduration: 3\nrobots:\n  - {position: [0, 0], goal: [2, 0]}\n"
             "obstacles:\n  - {ros_map: map.yaml}\n");
  const ProcessResult result = lab({"scene.yaml"});
  ASSERT_EQ(result.exit_code, 0) << result.err;
  const Json files = input_in(read_file(path_of("scene.html")))["files"];
  ASSERT_EQ(files.size(), 2U);
  EXPECT_EQ(bytes_of(files[1]["base64"]), map);
}

TEST(Lab, shows_what_scenes_and_names_say_as_text) {
  const std::string evil =
      "version: 1\nname: '</script><script>alert(1)</script><!-- é \u2028'\n"
      "duration: 3\nrobots:\n  - {position: [0, 0], goal: [2, 0]}\n";
  const std::string name = "<img src=x>&\"'`@\xff.yaml";
  write_file(path_of(name), evil);
  const ProcessResult result = lab({name, "--out", "out.html"});
  ASSERT_EQ(result.exit_code, 0) << result.err;
  const std::string page = read_file(path_of("out.html"));
  const Json input = input_in(page);
  EXPECT_EQ(input["yaml"], evil);
  EXPECT_EQ(input["name"], "<img src=x>&\"'`@\ufffd.yaml");
  EXPECT_EQ(page.find("alert(1)</"), std::string::npos);
}

TEST(Lab, reads_and_writes_streams) {
  write_file(path_of("in.yaml"), avo_io::builtin_text("circle-3").value());
  const ProcessResult result = lab({"-", "--out", "-"}, {.before = [] {
                                     if (dup2(open("in.yaml", O_RDONLY), STDIN_FILENO) < 0)
                                       _exit(96);
                                   }});
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_EQ(input_in(result.out)["name"], "standard input");
  EXPECT_EQ(files_in(folder()), Strings{"in.yaml"});
}

TEST(Lab, has_recordings_as_their_bytes) {
  const std::string h5 = path_of("run.h5"), csv = path_of("run.csv");
  ASSERT_EQ(run_avo({"run", "circle-5", "--duration=20", "--record", h5, "-q"}).exit_code, 0);
  ASSERT_EQ(lab({"run.h5"}).exit_code, 0);
  const Json input = input_in(read_file(path_of("run.html")));
  EXPECT_EQ(input["kind"], "recording");
  EXPECT_EQ(input["name"], "run.h5");
  EXPECT_TRUE(bytes_of(input["base64"]) == read_file(h5));
  ASSERT_EQ(run_avo({"run", "circle-5", "--duration=2", "--record", csv, "-q"}).exit_code, 0);
  ASSERT_EQ(lab({"run.csv", "--scene", "circle-5", "--seed=3"}).exit_code, 0);
  const Json rows = input_in(read_file(path_of("run.html")));
  EXPECT_TRUE(bytes_of(rows["base64"]) == read_file(csv));
  EXPECT_EQ(rows["scene"]["name"], "circle-5");
  EXPECT_EQ(rows["scene"]["overrides"], Json::parse(R"(["seed=3"])"));
}

TEST(Lab, takes_scenes_and_recordings_of_space) {
  write_file(
      path_of("drones.yaml"),
      "version: 1\nspace: 3\ngroups:\n  - {count: 5, sphere: {radius: 5}, goal: antipodal}\n");
  const std::string csv = path_of("run.csv"), h5 = path_of("run.h5");
  for (const std::string& record : {csv, h5})
    ASSERT_EQ(run_avo({"run", path_of("drones.yaml"), "--duration=1", "--record", record, "-q"})
                  .exit_code,
              0);
  ASSERT_EQ(lab({"drones.yaml", "--seed=3"}).exit_code, 0);
  const Json scene = input_in(read_file(path_of("drones.html")));
  EXPECT_EQ(scene["kind"], "scene");
  EXPECT_EQ(scene["overrides"], Json::array({"seed=3"}));
  EXPECT_EQ(scene["yaml"], read_file(path_of("drones.yaml")));
  ASSERT_EQ(lab({"run.csv", "--scene", "drones.yaml"}).exit_code, 0);
  const Json rows = input_in(read_file(path_of("run.html")));
  EXPECT_TRUE(bytes_of(rows["base64"]) == read_file(csv));
  EXPECT_EQ(rows["scene"]["yaml"], scene["yaml"]);
  ASSERT_EQ(lab({"run.h5", "--out", "again.html"}).exit_code, 0);
  EXPECT_TRUE(bytes_of(input_in(read_file(path_of("again.html")))["base64"]) == read_file(h5));
  const std::string whole = read_file(csv);
  write_file(path_of("damaged.csv"), whole.substr(0, whole.size() - 3) + ",,\n");
  const ProcessResult damaged = lab({"damaged.csv", "--scene", "drones.yaml"});
  EXPECT_EQ(damaged.exit_code, 3);
  EXPECT_NE(damaged.err.find("damaged.csv:"), std::string::npos) << damaged.err;
}

TEST(Lab, takes_a_spool_as_far_as_it_is_whole) {
  const std::string h5 = path_of("run.h5"), spool = path_of("run.h5.part");
  const ProcessResult run = run_avo({"run", "circle-5", "--duration=1e6", "--record", h5, "-q"},
                                    {.meanwhile = [](int pid) {
                                      wait_until_larger(pid, path_of("run.h5.part"), 9000);
                                      kill(pid, SIGKILL);
                                    }});
  ASSERT_EQ(run.exit_code, 128 + SIGKILL);
  const ProcessResult result = lab({"run.h5.part"});
  ASSERT_EQ(result.exit_code, 0) << result.err;
  EXPECT_EQ(result.out, "run.html\n");
  ASSERT_EQ(run_avo({"recover", spool, "-q"}).exit_code, 7);
  const Json input = input_in(read_file(path_of("run.html")));
  EXPECT_TRUE(bytes_of(input["base64"]) == read_file(h5));
}

TEST(Lab, refuses_what_no_page_can_show) {
  const std::string h5 = path_of("run.h5"), csv = path_of("run.csv");
  ASSERT_EQ(run_avo({"run", "circle-3", "--duration=2", "--record", h5, "-q"}).exit_code, 0);
  ASSERT_EQ(run_avo({"run", "circle-3", "--duration=2", "--record", csv, "-q"}).exit_code, 0);
  const std::string damaged = read_file(csv);
  write_file(path_of("damaged.csv"), damaged.substr(0, damaged.size() - 3) + ",,\n");
  write_file(path_of("large.csv"), "time,robot,x,y,vx,vy\n");
  ASSERT_EQ(truncate(path_of("large.csv").c_str(), 100'000'001), 0);
  const struct {
    Strings words;
    int code;
    std::string message;
  } cases[] = {
      {{"run.csv"}, 2, "run.csv: found no scene in it, must be a recording as HDF5, or --scene"},
      {{"run.h5", "--scene", "circle-3"}, 2, "--scene: found with a recording that has its scene"},
      {{"run.h5", "--set", "seed=2"}, 2, "--set and the like: found with a recording that has"},
      {{"--set", "seed=2"}, 2, "--set and the like: found without a scene, must be with one"},
      {{"--scene", "circle-3"}, 2, "--scene: found without a recording"},
      {{"circle-5", "--scene", "circle-3"}, 2, "circle-5: found a built-in scene with --scene"},
      {{"-", "--scene", "circle-3"}, 2, "the recording: found -, must be a file"},
      {{"circle-3", "--out", "out.txt"}, 2, "--out out.txt: found the ending .txt"},
      {{"circle-3", "--set", "robots=1"}, 2, "--set robots=1"},
      {{"nowhere.yaml"}, 4, "nowhere.yaml"},
      {{"nowhere.h5"}, 4, "nowhere.h5"},
      {{"damaged.csv", "--scene", "circle-3"}, 3, "damaged.csv:"},
      {{"large.csv", "--scene", "circle-3"},
       3,
       "large.csv: found 100 MB, must be 100 MB at most for a page; avo run --every K records "
       "every "
       "K-th step only"},
  };
  const Strings before = files_in(folder());
  for (const auto& [words, code, message] : cases) {
    const ProcessResult result = lab(words);
    EXPECT_EQ(result.exit_code, code) << message;
    EXPECT_NE(result.err.find(message), std::string::npos) << result.err;
    EXPECT_EQ(lines_of(result.err).size(), 1U) << result.err;
    EXPECT_EQ(files_in(folder()), before) << message;
  }
}

TEST(Lab, warns_of_a_scene_that_breaks_assumptions_and_opens_it) {
  const ProcessResult result = lab({"circle-10", "--set", "sensing_radius=2"});
  EXPECT_EQ(result.exit_code, 0);
  EXPECT_NE(result.err.find("warning: circle-10: sensing_radius: found 2 m"), std::string::npos)
      << result.err;
  EXPECT_TRUE(exists(path_of("circle-10.html")));
}

TEST(Lab, replaces_no_file_but_such_a_page_unless_asked_to) {
  write_file(path_of("circle-3.html"), "notes");
  const ProcessResult refused = lab({"circle-3"});
  EXPECT_EQ(refused.exit_code, 2);
  EXPECT_EQ(refused.err,
            "avo: circle-3.html: found another file of this name, must be a page of avo lab; --out "
            "circle-3.html writes over it\n");
  EXPECT_EQ(read_file(path_of("circle-3.html")), "notes");
  EXPECT_EQ(lab({"circle-3", "--out", "circle-3.html"}).exit_code, 0);
  EXPECT_EQ(lab({"circle-3", "--seed=4"}).exit_code, 0);
  EXPECT_EQ(input_in(read_file(path_of("circle-3.html")))["overrides"][0], "seed=4");
}

TEST(Lab, in_a_build_without_it_says_how_to_get_it) {
  const ProcessResult result = run_avo({"lab", "circle-3"}, {.binary = AVO_WITHOUT_LAB});
  EXPECT_EQ(result.exit_code, 2);
  EXPECT_EQ(lines_of(result.err).size(), 1U);
  EXPECT_NE(result.err.find("run ./scripts/install --lab"), std::string::npos);
  EXPECT_FALSE(exists("circle-3.html"));
}

/// Runs at a terminal, with a program xdg-open that notes its argument. If xdg-open is not to
/// start, the function waits at most a second for the note.
std::string opened(const std::string& words, bool is_to_start) {
  const std::string note = path_of("note");
  write_file(path_of("xdg-open"), "#!/bin/sh\nprintf %s \"$1\" > '" + note + ".part'\nmv '" + note +
                                      ".part' '" + note + "'\n");
  chmod(path_of("xdg-open").c_str(), 0755);
  PseudoTerminal terminal(
      {"sh", "-c",
       "PATH=\"" + folder() + ":$PATH\" " + words + " '" AVO_WITH_LAB "' lab circle-3 $MORE"},
      {.folder = folder()});
  EXPECT_EQ(terminal.wait(), 0) << terminal.shown();
  if (is_to_start)
    wait_until([&] { return exists(note); });
  else
    usleep(1'000'000);
  return read_file(note);
}

TEST(Lab, opens_the_page_at_a_terminal_with_a_display) {
  EXPECT_EQ(opened("DISPLAY=:7", true), path_of("circle-3.html"));
}

TEST(Lab, opens_nothing_without_a_display_or_where_it_shall_not) {
  EXPECT_EQ(opened("DISPLAY= WAYLAND_DISPLAY=", false), "");
  EXPECT_EQ(opened("MORE=--no-open; export DISPLAY=:7;", false), "");
}

/// The page that a report frames, and what it opens.
Json framed_in(const std::string& report) {
  const std::string begin = "srcdoc=\"";
  const std::size_t from = report.find(begin) + begin.size();
  std::string page = report.substr(from, report.find('"', from) - from);
  const auto put_back = [&page](const std::string& name, char c) {
    for (std::size_t at = 0; (at = page.find(name, at)) != std::string::npos; ++at)
      page.replace(at, name.size(), 1, c);
  };
  put_back("&quot;", '"');
  put_back("&amp;", '&');
  return input_in(page);
}

TEST(Lab, plays_the_recording_in_its_report) {
  const std::string h5 = path_of("run.h5"), html = path_of("out.html");
  ASSERT_EQ(run_avo({"run", "circle-5", "--duration=100", "--record", h5, "-q"}).exit_code, 0);
  const ProcessResult result = run_avo({"report", h5, html}, {.binary = AVO_WITH_LAB});
  ASSERT_EQ(result.exit_code, 0) << result.err;
  const std::string report = read_file(html);
  EXPECT_EQ(report.find("id=\"replay\""), std::string::npos);
  const Json input = framed_in(report);
  EXPECT_EQ(input["kind"], "recording");
  EXPECT_EQ(input["name"], "run.h5");
  EXPECT_EQ(input["embedded"], true);
  write_file(path_of("again.h5"), bytes_of(input["base64"]));
  EXPECT_EQ(avo_io::read_recording_header(path_of("again.h5"))->every, 2);
  EXPECT_EQ(run_avo({"replay", path_of("again.h5")}).exit_code, 0);
}

TEST(Lab, plays_a_recording_of_space_in_its_report) {
  const std::string html = path_of("out.html"),
                    robots = "robots: [{position: [0, 0, 0], goal: [2, 0, 1]}]\n";
  for (const std::string& more :
       {std::string(), std::string("moving_obstacles: [{position: [9, 9, 9]}]\n")}) {
    write_file(path_of("drones.yaml"), "version: 1\nspace: 3\n" + robots + more);
    const std::string h5 = path_of("run.h5");
    ASSERT_EQ(
        run_avo({"run", path_of("drones.yaml"), "--duration=2", "--record", h5, "-q"}).exit_code,
        0);
    const ProcessResult result = run_avo({"report", h5, html}, {.binary = AVO_WITH_LAB});
    ASSERT_EQ(result.exit_code, 0) << result.err;
    const std::string report = read_file(html);
    EXPECT_EQ(report.find("id=\"replay\""), std::string::npos);
    const Json input = framed_in(report);
    EXPECT_EQ(input["name"], "run.h5");
    EXPECT_TRUE(bytes_of(input["base64"]) == read_file(h5));
  }
}

TEST(Lab, runs_the_run_of_a_sweep_in_its_report) {
  const std::string spec = path_of("sweep.yaml"), table = path_of("runs.csv");
  const std::string html = path_of("out.html");
  write_file(spec, "version: 1\nscenes: [circle-5]\nmethods: [avo, orca]\nseeds: [4]\n");
  ASSERT_EQ(run_avo({"sweep", spec, "--out", table, "-q"}).exit_code, 0);
  const ProcessResult result =
      run_avo({"report", table, html, "--spec", spec, "--run", "1"}, {.binary = AVO_WITH_LAB});
  ASSERT_EQ(result.exit_code, 0) << result.err;
  const Json input = framed_in(read_file(html));
  EXPECT_EQ(input["kind"], "scene");
  EXPECT_EQ(input["name"], "circle-5");
  EXPECT_EQ(input["overrides"], Json::parse(R"(["method=orca", "seed=4"])"));
  EXPECT_EQ(input["embedded"], true);
}

TEST(RecordingBytes, has_every_so_many_times_and_the_last) {
  const std::string h5 = path_of("run.h5"), thinned = path_of("thinned.h5");
  ASSERT_EQ(run_avo({"run", "circle-5", "--duration=30", "--record", h5, "-q"}).exit_code, 0);
  const auto times_of = [](const std::string& path) {
    avo_io::RecordingReader reader(path);
    avo_io::RecordedTime moment;
    std::vector<double> times;
    while (reader.next(moment)) times.push_back(moment.time);
    return times;
  };
  const std::vector<double> all = times_of(h5);
  ASSERT_EQ(all.size(), 301U);
  const struct {
    std::size_t most, every;
  } cases[] = {{1000, 1}, {301, 1}, {300, 2}, {151, 2}, {150, 3}, {100, 4}, {3, 150}, {2, 300}};
  for (const auto& [most, every] : cases) {
    write_file(thinned, avo_io::recording_bytes(h5, most));
    std::vector<double> kept;
    for (std::size_t k = 0; k < all.size(); ++k)
      if (k % every == 0 || k + 1 == all.size()) kept.push_back(all[k]);
    EXPECT_LE(kept.size(), most);
    EXPECT_EQ(times_of(thinned), kept) << most;
    const ProcessResult replay = run_avo({"replay", thinned});
    EXPECT_EQ(replay.exit_code, 0) << replay.out;
  }
}

}  // namespace
}  // namespace avo_test
