// SPDX-License-Identifier: Apache-2.0
// avo convert: formats and their names, CSV, and what is refused. What the other formats hold is
// looked at by tests/exports.
#include <csignal>
#include <cstdlib>
#include <gtest/gtest.h>
#include <string>
#include <unistd.h>

#include "recordings.h"

namespace avo_test {
namespace {

std::string record(const Strings& scene, const std::string& name) {
  Strings command{"run", "-q", "--record", path_of(name)};
  command.insert(command.end(), scene.begin(), scene.end());
  EXPECT_EQ(run_avo(command).exit_code, 0);
  return path_of(name);
}

ProcessResult convert(const Strings& words) {
  Strings command{"convert"};
  command.insert(command.end(), words.begin(), words.end());
  return run_avo(command);
}

TEST(Convert, csv_has_the_bytes_of_the_run_s_own) {
  for (const Strings& scene :
       {Strings{"circle-10", "--duration", "3"}, Strings{"mixed-yard", "--duration", "1"},
        Strings{"circle-3", "--duration", "3.5", "--every", "10"},
        Strings{"circle-3", "--duration", "2", "--set", "clock=free"},
        Strings{"planes-12", "--until-arrived", "--every", "20"}}) {
    const std::string own = record(scene, "own.csv"), recording = record(scene, "run.h5");
    const ProcessResult result = convert({recording, path_of("out.csv")});
    EXPECT_EQ(result.exit_code, 0);
    EXPECT_EQ(read_file(path_of("out.csv")), read_file(own));
    EXPECT_EQ(convert({own, path_of("again.csv")}).exit_code, 0);
    EXPECT_EQ(read_file(path_of("again.csv")), read_file(own));
    EXPECT_EQ(convert({recording, "-", "--to", "csv"}).out, read_file(own));
  }
}

TEST(Convert, says_what_it_has_written) {
  const std::string recording = record({"circle-3", "--duration", "1"}, "run.h5");
  const std::string out = path_of("out.sqlite");
  const ProcessResult result = convert({recording, out});
  EXPECT_EQ(result.out, out + ": 11 times, 33 rows, 10 frames a second\n");
  EXPECT_EQ(result.err, "");
  EXPECT_EQ(convert({recording, path_of("out.mcap")}).out,
            path_of("out.mcap") + ": 11 times, 33 rows\n");
  EXPECT_EQ(convert({recording, out, "-q"}).out, "");
  EXPECT_EQ(convert({recording, path_of("anything"), "--to", "sqlite", "-q"}).exit_code, 0);
  EXPECT_EQ(read_file(path_of("anything")), read_file(out));
}

TEST(Convert, reads_spools_and_the_standard_input) {
  const std::string recording = record({"circle-3", "--duration", "20"}, "run.h5");
  // the run cannot write its end, and leaves the spool
  const ProcessResult killed =
      run_avo({"run", "circle-3", "--duration", "100000", "--record", path_of("killed.h5")},
              {.meanwhile = [](int pid) {
                wait_until_larger(pid, path_of("killed.h5.part"), 9000);
                kill(pid, SIGKILL);
              }});
  EXPECT_EQ(killed.exit_code, 128 + SIGKILL);
  EXPECT_EQ(convert({path_of("killed.h5.part"), path_of("killed.csv")}).exit_code, 0);
  EXPECT_EQ(convert({recording, path_of("run.csv")}).exit_code, 0);
  const std::string whole = read_file(path_of("run.csv"));
  EXPECT_EQ(read_file(path_of("killed.csv")).substr(0, 2000), whole.substr(0, 2000));
  const std::string out = path_of("out.mcap");
  const std::string command = std::string(AVO_BINARY) + " convert - " + out +
                              " --scene circle-3 -q < " + path_of("run.csv");
  EXPECT_EQ(WEXITSTATUS(std::system(command.c_str())), 0);
  EXPECT_TRUE(read_file(out).starts_with("\x89MCAP0\r\n"));
}

void expect_refused(const Strings& words, int exit_code, const std::string& message) {
  const ProcessResult result = convert(words);
  EXPECT_EQ(result.exit_code, exit_code) << result.err;
  EXPECT_EQ(result.err, message + "\n");
  EXPECT_EQ(result.out, "");
}

TEST(Convert, wrong_command_lines_take_one_line) {
  const std::string csv = recording(kGoodRun);
  const auto refused = [&](Strings words, const std::string& message) {
    words.insert(words.begin(), csv);
    expect_refused(words, 2, "avo: " + message);
  };
  const std::string must = ", must be .csv, .sqlite, .mcap or .glb, or with --to FORMAT";
  refused({"out.parquet"}, "the output out.parquet: found the ending \".parquet\"" + must);
  refused({"out"}, "the output out: found the ending \"\"" + must);
  refused({"-"}, "the output -: found the ending \"\"" + must);
  refused({"out.h5"},
          "the output out.h5: found the ending .h5 without --to, must be with --to recording or "
          "pedestrian-hdf5");
  refused({"out.txt"},
          "the output out.txt: found the ending .txt without --to, must be with --to "
          "pedestrian-text or obsmat");
  refused({"out.csv", "--to", "mcab"},
          "--to: found mcab, did you mean \"mcap\"? Must be one of csv, sqlite, pedestrian-hdf5, "
          "mcap, pedestrian-text, obsmat, recording, gltf, set-points");
  refused({"out.csv", "--to", "sqlite"},
          "the output out.csv: found the ending .csv, must be .sqlite or none");
  refused({"out.mcap"},
          "--scene: found none, must be given: MCAP shows radii and walls, and CSV has neither");
  refused({"out.csv", "--set", "seed=2"}, "--set: found without --scene, must be with it");
  refused({csv, "--to", "csv"}, "the recording " + csv + " and the output " + csv +
                                    ": found to be one file, must differ");
  EXPECT_FALSE(exists("out.csv"));
}

TEST(Convert, what_has_no_frames_is_refused_and_nothing_is_written) {
  const auto refused = [](const std::string& rows, const std::string& message) {
    const std::string csv = recording(kHeader + rows);
    expect_refused({csv, path_of("out.sqlite")}, 3, csv + message);
    expect_refused({csv, path_of("out.h5"), "--to", "pedestrian-hdf5"}, 3, csv + message);
    EXPECT_EQ(files_in(folder()), Strings{"in.csv"});
  };
  refused("0,0,0,0,0,0\n1,0,0,0,0,0\n1.5,0,0,0,0,0\n2,0,0,0,0,0\n",
          ":5: found rows at 1.5 s, must be at times 1 s apart from the first: the format has "
          "frames; csv and mcap have times");
  refused("0,0,0,0,0,0\n", ":2: found rows of one time only, must be of two or more");
  const std::string free =
      record({"circle-3", "--duration", "1", "--set", "clock=free"}, "free.h5");
  expect_refused({free, path_of("out.sqlite")}, 3,
                 free +
                     ": found free clocks, must have a common one: the format has frames at "
                     "equal times; csv and mcap have times");
  EXPECT_EQ(convert({free, path_of("out.mcap")}).exit_code, 0);
}

TEST(Convert, files_that_cannot_be_read_or_written_take_one_line) {
  const std::string none = path_of("none.h5"), csv = recording(kGoodRun);
  for (const std::string name : {"out.sqlite", "out.mcap", "out.csv"})
    expect_refused({none, path_of(name)}, 4, none + ": No such file or directory");
  const std::string nowhere = path_of("no/out.sqlite");
  expect_refused({csv, nowhere}, 4, nowhere + ": No such file or directory");
  const std::string device = "/dev/null: found no regular file, this format must be written to one";
  expect_refused({csv, "/dev/null", "--to", "sqlite"}, 4, device);
  expect_refused({csv, "/dev/null", "--to", "pedestrian-hdf5"}, 4, device);
  EXPECT_EQ(convert({csv, "/dev/null", "--to", "csv"}).exit_code, 0);
  expect_refused({csv, path_of("out.mcap"), "--scene", "circle-3"}, 3,
                 csv + ":3: robot: found 7, must be 0 to 2, the robots of the scene");
  EXPECT_EQ(files_in(folder()), Strings{"in.csv"});
}

TEST(Convert, old_files_stay_where_it_fails) {
  const std::string out = path_of("out.sqlite");
  write_file(out, "old");
  const std::string csv = recording(kHeader + "0,0,0,0,0,0\n1,0,nan,0,0,0\n");
  EXPECT_EQ(convert({csv, out}).exit_code, 3);
  EXPECT_EQ(read_file(out), "old");
  EXPECT_EQ(convert({recording(kGoodRun.substr(0, kGoodRun.find("1.5"))), out}).exit_code, 0);
  EXPECT_TRUE(read_file(out).starts_with("SQLite format 3"));
}

}  // namespace
}  // namespace avo_test
