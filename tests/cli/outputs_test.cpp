// SPDX-License-Identifier: Apache-2.0
// Files that avo writes: whole or not there, all or none, never an input, never each other.
#include <algorithm>
#include <filesystem>
#include <gtest/gtest.h>
#include <string>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>
#include <vector>

#include "run_avo.h"

namespace avo_test {
namespace {

namespace fs = std::filesystem;
using Strings = std::vector<std::string>;

const std::string kScene =
    "version: 1\nduration: 1\nrobots:\n"
    "  - {position: [0, 0], goal: [5, 0]}\n"
    "  - {position: [0, 9], goal: [5, 9]}\n";

/// In the folder of the test, so that names can be short.
ProcessResult run_here(const Strings& arguments, ProcessOptions options = {}) {
  const std::string here = folder();
  options.before = [here, before = options.before] {
    if (chdir(here.c_str()) != 0) _exit(97);
    if (before) before();
  };
  return run_avo(arguments, options);
}

void refused(const Strings& arguments, const std::string& message) {
  const ProcessResult result = run_here(arguments);
  EXPECT_EQ(result.exit_code, 2) << message;
  EXPECT_EQ(result.out, "");
  EXPECT_EQ(result.err, "avo: " + message + "\n");
}

bool is_link(const std::string& path) {
  return fs::is_symlink(fs::symlink_status(path));
}

bool has_begun() {
  const Strings names = files_in(folder());
  return std::any_of(names.begin(), names.end(), [](const std::string& name) {
    return name.find(".part") != std::string::npos;
  });
}

TEST(Outputs, are_no_inputs) {
  write_file(path_of("scene.csv"), kScene);
  fs::create_symlink("scene.csv", path_of("link.csv"));
  fs::create_hard_link(path_of("scene.csv"), path_of("hard.csv"));
  for (const std::string name : {"scene.csv", "./scene.csv", "link.csv", "hard.csv"})
    refused({"run", "scene.csv", "--record", name},
            "the scene scene.csv and --record " + name + ": found to be one file, must differ");
  refused({"run", "link.csv", "--summary", "hard", "--record", "scene.csv"},
          "the scene link.csv and --record scene.csv: found to be one file, must differ");
  fs::create_symlink("scene.csv", path_of("figure.svg"));
  refused({"explain", "scene.csv", "--robot", "0", "--figure", "figure.svg"},
          "the scene scene.csv and --figure figure.svg: found to be one file, must differ");
  EXPECT_EQ(read_file(path_of("scene.csv")), kScene);
}

TEST(Outputs, are_not_each_other) {
  const std::string one_file = ": found to be one file, must differ";
  write_file(path_of("old.csv"), "precious\n");
  fs::create_hard_link(path_of("old.csv"), path_of("hard"));
  fs::create_symlink("new", path_of("dangling.csv"));
  fs::create_directory(path_of("folder"));
  fs::create_symlink(folder(), path_of("here"));
  refused({"run", "circle-2", "--record", "old.csv", "--summary", "hard"},
          "--record old.csv and --summary hard" + one_file);
  refused({"run", "circle-2", "--record", "dangling.csv", "--summary", "folder/../new"},
          "--record dangling.csv and --summary folder/../new" + one_file);
  refused({"run", "circle-2", "--record", "new", "--summary", "here/new"},
          "--record new and --summary here/new" + one_file);
  refused({"run", "circle-2", "--record", "-", "--summary", "-"},
          "--record - and --summary -" + one_file);
  EXPECT_EQ(read_file(path_of("old.csv")), "precious\n");
  EXPECT_EQ(files_in(folder()), (Strings{"dangling.csv", "folder", "hard", "here", "old.csv"}));
}

TEST(Outputs, the_standard_output_is_one_of_them) {
  const auto into = [](const Strings& arguments, const std::string& file) {
    const ProcessResult result = run_here(arguments, {.out_path = path_of(file)});
    EXPECT_EQ(result.exit_code, 2) << result.err;
    return result.err;
  };
  const std::string one_file = ": found to be one file, must differ\n";
  EXPECT_EQ(into({"run", "circle-2", "--record", "x.csv", "--summary", "-"}, "x.csv"),
            "avo: --record x.csv and --summary -" + one_file);
  EXPECT_EQ(into({"run", "circle-2", "--record", "x.csv"}, "x.csv"),
            "avo: --record x.csv and the standard output" + one_file);
  EXPECT_EQ(into({"validate", "x.csv"}, "x.csv"),
            "avo: the scene x.csv and the standard output" + one_file);
  EXPECT_EQ(into({"check", "x.csv", "--scene", "circle-2"}, "x.csv"),
            "avo: the recording x.csv and the standard output" + one_file);
}

TEST(Outputs, devices_and_names_of_scenes_may_be_shared) {
  EXPECT_EQ(
      run_here({"run", "circle-2", "--record", "/dev/null", "--summary", "/dev/null"}).exit_code,
      0);
  const Strings builtin{"run", "circle-2", "--set", "duration=1", "--record", "circle-2"};
  for (int i = 0; i < 2; ++i) EXPECT_EQ(run_here(builtin).exit_code, 0) << "no file is read for it";
  EXPECT_TRUE(read_file(path_of("circle-2")).starts_with("time,robot"));
}

TEST(Outputs, names_of_another_format_are_refused) {
  for (const std::string name : {"x.parquet", "x.json", "x.hdf", "x.csv.gz", "x."})
    refused({"run", "circle-2", "--record", name}, "--record " + name + ": found the ending " +
                                                       fs::path(name).extension().string() +
                                                       ", must be .csv, .h5 or none");
  refused({"run", "circle-2", "--summary", "x.csv"},
          "--summary x.csv: found the ending .csv, must be .json or none");
  refused({"run", "circle-2", "--figure", ".svg"},
          "--figure .svg: found an extension without a name, must be such as figure.svg");
  EXPECT_EQ(files_in(folder()), Strings{});
  ASSERT_EQ(symlink("/dev/null", path_of("null.h5").c_str()), 0);
  const ProcessResult device = run_here({"run", "circle-2", "--record", "null.h5"});
  EXPECT_EQ(device.exit_code, 4);
  EXPECT_EQ(device.err, "null.h5: found no regular file, HDF5 must be written to one\n");
  for (const char* name : {"x.csv", "X.CSV", "none", ".csv", "x.h5", "/dev/null"})
    EXPECT_EQ(run_here({"run", "circle-2", "--set", "duration=1", "--record", name}).exit_code, 0)
        << name;
}

TEST(Outputs, empty_names_are_refused) {
  const auto refused_empty = [](const Strings& arguments, const std::string& option) {
    const std::string& verb = arguments.front();
    refused(arguments, verb + ": " + option + ": found an empty name, must have one; see avo " +
                           verb + " --help");
  };
  for (const std::string option : {"--record", "--summary", "--figure"})
    refused_empty({"run", "circle-2", option, ""}, option);
  refused_empty({"explain", "circle-2", "--robot", "0", "--figure", ""}, "--figure");
  refused_empty({"run", ""}, "SCENE");
  refused_empty({"check", ""}, "RECORDING");
  refused_empty({"check", "x.csv", "--scene", ""}, "--scene");
}

TEST(Outputs, figures_of_every_kind) {
  for (const char* name : {"a.svg", "a.png", "a.pdf"}) {
    ASSERT_EQ(run_here({"run", "moving-obstacle", "--figure", name}).exit_code, 0);
    const std::string bytes = read_file(path_of(name));
    EXPECT_GT(bytes.size(), 1000U) << name;
    EXPECT_TRUE(bytes.starts_with("<?xml") || bytes.starts_with("\x89PNG") ||
                bytes.starts_with("%PDF"))
        << name;
  }
  EXPECT_EQ(files_in(folder()), (Strings{"a.pdf", "a.png", "a.svg"})) << "nothing left behind";
}

TEST(Outputs, a_figure_has_a_size_a_part_of_the_run_and_robots) {
  const auto drawn = [](const Strings& options) {
    Strings words{"run", "circle-6", "--duration", "20", "--figure", "f.svg", "-q"};
    words.insert(words.end(), options.begin(), options.end());
    const ProcessResult result = run_here(words);
    EXPECT_EQ(result.exit_code, 0) << result.err;
    return read_file(path_of("f.svg"));
  };
  const std::string whole = drawn({});
  EXPECT_NE(whole.find("width=\"450pt\""), std::string::npos);
  const std::string sized = drawn({"--figure-size", "300x200"});
  EXPECT_NE(sized.find("width=\"300pt\" height=\"200pt\""), std::string::npos);
  EXPECT_LT(drawn({"--figure-robots", "0,2-3"}).size(), whole.size());
  EXPECT_LT(drawn({"--figure-time", "2:4"}).size(), whole.size());
  EXPECT_EQ(drawn({"--figure-time", "0:", "--figure-robots", "0-5"}), whole);
}

TEST(Outputs, options_of_a_figure_are_refused_in_one_line) {
  const auto refused = [](const Strings& options) {
    Strings words{"run", "circle-6", "--duration", "1", "-q"};
    words.insert(words.end(), options.begin(), options.end());
    const ProcessResult result = run_here(words);
    EXPECT_EQ(result.exit_code, 2);
    EXPECT_EQ(lines_of(result.err).size(), 1U) << result.err;
    return result.err;
  };
  const Strings figure{"--figure", "f.svg"};
  const auto of_figure = [&](const char* option, const char* word) {
    return refused({figure[0], figure[1], option, word});
  };
  for (const char* word : {"", "x", "50", "300x", "300x9000", "nan"})
    EXPECT_NE(of_figure("--figure-size", word).find("--figure-size"), std::string::npos) << word;
  for (const char* word : {":", "5", "4:4", "-1:2", "a:b", "2:9:"})
    EXPECT_NE(of_figure("--figure-time", word).find("--figure-time: found"), std::string::npos);
  for (const char* word : {"1,", "x", "3-1", "-1", "0-99999999"})
    EXPECT_NE(of_figure("--figure-robots", word).find("--figure-robots: found"), std::string::npos);
  EXPECT_EQ(of_figure("--figure-robots", "0,6"),
            "avo: --figure-robots: found 6, must be < 6, the number of robots\n");
  EXPECT_EQ(of_figure("--figure-time", "2:3"),
            "avo: --figure-time: found a begin at 2 s, must be <= 1 s, the duration\n");
  EXPECT_NE(refused({"--figure-size", "300"}).find("--figure"), std::string::npos);
}

TEST(Outputs, places_that_cannot_be_written_are_reported_before_it_simulates) {
  const auto forever = [](const Strings& more) {
    Strings arguments{"run", "positions-exchange", "--set", "duration=1e6"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    const ProcessResult result = run_here(arguments);
    EXPECT_EQ(result.exit_code, 4);
    EXPECT_EQ(files_in(folder()), Strings{}) << "neither the other output nor a part of it";
    return result.err;
  };
  const std::string missing = ": No such file or directory\n";
  EXPECT_EQ(forever({"--record", "no/a.csv"}), "no/a.csv" + missing);
  EXPECT_EQ(forever({"--record", "ok.csv", "--summary", "no/a.json"}), "no/a.json" + missing);
  EXPECT_EQ(forever({"--record", "ok.csv", "--figure", "no/a.svg"}), "no/a.svg" + missing);
  EXPECT_EQ(forever({"--record", std::string(300, 'a')}),
            std::string(300, 'a') + ": File name too long\n");
  EXPECT_EQ(forever({"--record", "."}), ".: found a directory, must be a file\n");
  ASSERT_EQ(symlink("loop", path_of("loop").c_str()), 0);
  EXPECT_EQ(run_here({"run", "circle-2", "--record", "loop"}).err,
            "loop: Too many levels of symbolic links\n");
}

TEST(Outputs, a_full_disk_is_reported) {
  const std::string full = ": No space left on device\n";
  ASSERT_EQ(symlink("/dev/full", path_of("full.svg").c_str()), 0);
  for (const Strings& output : {Strings{"--record", "/dev/full"}, Strings{"--summary", "/dev/full"},
                                Strings{"--figure", "full.svg"}}) {
    const ProcessResult result = run_here({"run", "circle-10", output[0], output[1]});
    EXPECT_EQ(result.exit_code, 4);
    EXPECT_EQ(result.err, output[1] + full);
  }
  const ProcessResult out = run_avo({"run", "circle-2"}, {.out_path = "/dev/full"});
  EXPECT_EQ(out.exit_code, 4);
  EXPECT_EQ(out.err, "standard output" + full);
  struct stat status = {};
  ASSERT_EQ(stat("/dev/full", &status), 0);
  EXPECT_TRUE(S_ISCHR(status.st_mode)) << "still a device";
}

TEST(Outputs, a_limit_of_file_size_is_reported) {
  const auto at_most_1000_bytes = [] {
    const rlimit limit{1000, 1000};
    if (setrlimit(RLIMIT_FSIZE, &limit) != 0) _exit(97);
  };
  for (const Strings& output : {Strings{"--record", "a.csv"}, Strings{"--figure", "a.svg"}}) {
    write_file(path_of(output[1]), "precious\n");
    const ProcessResult result =
        run_here({"run", "circle-10", output[0], output[1]}, {.before = at_most_1000_bytes});
    EXPECT_EQ(result.exit_code, 4);
    EXPECT_EQ(result.err, output[1] + ": File too large\n");
    EXPECT_EQ(read_file(path_of(output[1])), "precious\n");
    EXPECT_FALSE(has_begun()) << "nothing left behind";
  }
}

TEST(Outputs, a_file_is_replaced_only_by_a_whole_one) {
  const std::string path = path_of("out.csv");
  write_file(path, "precious\n");
  const auto exit_code = [](const Strings& more) {
    Strings arguments{"run", "circle-2", "--record", "out.csv"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return run_here(arguments).exit_code;
  };
  EXPECT_EQ(exit_code({"--summary", "/dev/full"}), 4);
  EXPECT_EQ(exit_code({"--set", "duration=-1"}), 2);
  EXPECT_EQ(exit_code({"--figure", "no/a.svg"}), 4);
  EXPECT_EQ(read_file(path), "precious\n");
  fs::permissions(path, fs::perms::owner_read | fs::perms::owner_write | fs::perms::group_write);
  EXPECT_EQ(exit_code({}), 0);
  EXPECT_TRUE(read_file(path).starts_with("time,robot"));
  EXPECT_EQ(fs::status(path).permissions(),
            fs::perms::owner_read | fs::perms::owner_write | fs::perms::group_write);
  EXPECT_EQ(files_in(folder()), Strings{"out.csv"});
}

/// The place of the summary becomes a folder while the simulation runs.
void obstruct(const std::string& old_recording) {
  if (!old_recording.empty()) write_file(path_of("out.csv"), old_recording);
  const ProcessResult result = run_here(
      {"run", "circle-2", "--set", "duration=1e6", "--record", "out.csv", "--summary", "out.json"},
      {.meanwhile = [](int pid) {
        wait_until(pid, has_begun);
        fs::create_directory(path_of("out.json"));
        kill(pid, SIGINT);
      }});
  EXPECT_EQ(result.exit_code, 4);
  EXPECT_EQ(result.err, "out.json: Is a directory\n");
}

TEST(Outputs, all_get_their_names_or_none) {
  obstruct("");
  EXPECT_EQ(files_in(folder()), Strings{"out.json"});
  fs::remove(path_of("out.json"));
  obstruct("precious\n");
  EXPECT_EQ(files_in(folder()), (Strings{"out.csv", "out.json"}));
  EXPECT_EQ(read_file(path_of("out.csv")), "precious\n");
}

TEST(Outputs, links_are_followed_not_replaced) {
  write_file(path_of("target.csv"), "");
  fs::create_directory(path_of("folder"));
  fs::create_symlink("target.csv", path_of("link.csv"));
  fs::create_symlink("../link2.csv", path_of("folder/dangling.csv"));
  fs::create_symlink("folder/new.csv", path_of("link2.csv"));
  for (const std::string link : {"link.csv", "folder/dangling.csv"}) {
    ASSERT_EQ(run_here({"run", "circle-2", "--set", "duration=1", "--record", link}).exit_code, 0);
    EXPECT_TRUE(is_link(path_of(link)));
  }
  EXPECT_TRUE(read_file(path_of("target.csv")).starts_with("time,robot"));
  EXPECT_TRUE(is_link(path_of("link2.csv")));
  EXPECT_TRUE(read_file(path_of("folder/new.csv")).starts_with("time,robot"));
}

TEST(Outputs, temporary_names_cannot_be_foreseen) {
  write_file(path_of("victim"), "precious\n");
  const auto set_traps = [] {
    const std::string pid = std::to_string(getpid());
    for (const std::string& name : {".out." + pid + ".part.csv", "out.csv." + pid + ".tmp"})
      if (symlink("victim", name.c_str()) != 0) _exit(97);
  };
  ASSERT_EQ(run_here({"run", "circle-2", "--set", "duration=1", "--record", "out.csv"},
                     {.before = set_traps})
                .exit_code,
            0);
  EXPECT_EQ(read_file(path_of("victim")), "precious\n");
  EXPECT_FALSE(is_link(path_of("out.csv")));
}

}  // namespace
}  // namespace avo_test
