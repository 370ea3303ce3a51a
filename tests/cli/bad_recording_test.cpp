// SPDX-License-Identifier: Apache-2.0
// avo check: recordings and command lines that cannot be used, by exit code and message.
#include <gtest/gtest.h>
#include <string>

#include "recordings.h"

namespace avo_test {
namespace {

TEST(BadRecording, bad_recordings_take_one_line_and_exit_with_3) {
  const auto expect = [](const std::string& text, const std::string& message) {
    const ProcessResult result = check(text);
    EXPECT_EQ(result.exit_code, 3) << text;
    EXPECT_EQ(result.err, path_of("in.csv") + ":" + message + "\n");
    EXPECT_EQ(result.out, "");
  };
  const std::string names = "the first line must name time, robot, x, y, vx, vy";
  expect("", "1: found nothing, " + names);
  expect("time,robot,x,y,vx\n", "1: found no column \"vy\", " + names);
  expect("time,robot,x,y,v_x,vy\n", "1: found no column \"vx\", " + names + "; is \"v_x\" meant?");
  expect("time,robt,x,y,vx,vy\n",
         "1: found no column \"robot\", " + names + "; is \"robt\" meant?");
  expect("time,robot,x,y,vx,vy,x\n", "1: found column \"x\" more than once, " + names);
  expect("0,0,0,0,0,0\n", "1: found no column \"time\", " + names);
  expect(kHeader, "1: found rows of no time, must be of two or more");
  expect(kHeader + "0,0,0,0,0,0\n0,1,5,0,0,0\n",
         "3: found rows of one time only, must be of two or more");
  expect(kHeader + "0,0,0,0,0,0\n1,1,5,0,0,0\n",
         "3: found no robot at two successive times, must be one or more");
  expect(kHeader + "0,0,0,0,0\n", "2: found 5 columns, must be 6 as in the first line");
  expect(kHeader + "0,0,0,0,0,0,0\n", "2: found 7 columns, must be 6 as in the first line");
  expect(kHeader + "0,0,0,0,0,fast\n", "2: vy: found \"fast\", must be a finite number");
  expect(kHeader + "0,0,0,0,,0\n", "2: vx: found \"\", must be a finite number");
  expect(kHeader + "0,0,0x1p3,0,0,0\n", "2: x: found \"0x1p3\", must be a finite number");
  expect(kHeader + "0,0,0,1 2,0,0\n", "2: y: found \"1 2\", must be a finite number");
  expect(kHeader + "nan,0,0,0,0,0\n", "2: time: found \"nan\", must be a finite number");
  expect(kHeader + "0,0,-inf,0,0,0\n", "2: x: found \"-inf\", must be a finite number");
  expect(kHeader + "0,0,0,1e999,0,0\n", "2: y: found \"1e999\", must be from -1e+12 to 1e+12");
  expect(kHeader + "0,0,0,-2e12,0,0\n", "2: y: found \"-2e12\", must be from -1e+12 to 1e+12");
  for (const char* name : {"-1", "1.5", "one", "", "nan", "1e30"})
    expect(kHeader + "0," + name + ",0,0,0,0\n",
           std::string("2: robot: found \"") + name + "\", must be an integer >= 0");
  expect(kHeader + "0,0,0,0,0,0\n0.2,0,0,0,0,0\n\n0.1,0,0,0,0,0\n",
         "5: time: found 0.1 s, must be >= 0.2 s, the time before");
  expect(kHeader + "0,3,0,0,0,0\n0,1,5,0,0,0\n0,3,0,0,0,0\n",
         "4: robot: found 3 again at 0 s, must be once a time (line 2)");
  const std::string headings = "time,robot,x,y,vx,vy,speed,heading\n";
  expect(headings + "0,0,0,0,0,0,0,north\n",
         "2: heading: found \"north\", must be a finite number");
  expect(headings + "0,0,0,0,0,0,,1\n", "2: speed: found \"\", must be a finite number");
  expect("time,robot,x,y,vx,vy,speed,heading,speed\n",
         "1: found column \"speed\" more than once, " + names);
  expect(kHeader + std::string(70'000, '1'),
         "2: found more than 65536 characters, a line must be shorter");
  expect(kHeader + "0,0,0,0,0," + std::string("\0\n", 2),
         "2: vy: found \"\\x00\", must be a finite number");
}

TEST(BadRecording, numbers_in_space_are_read_as_in_the_plane) {
  const std::string scene = path_of("drone.yaml");
  write_file(scene, "version: 1\nspace: 3\nrobots:\n  - {position: [0, 0, 5], goal: [0, 0, 5]}\n");
  const auto checked = [&](const std::string& row) {
    return check("time,robot,x,y,z,vx,vy,vz,every\n" + row + "\n0.1,0,0,0,5,0,0,0,1\n",
                 {"--scene", scene});
  };
  const auto expect = [&](const std::string& row, const std::string& message) {
    const ProcessResult result = checked(row);
    EXPECT_EQ(result.exit_code, 3) << row;
    EXPECT_EQ(result.err, path_of("in.csv") + ":2: " + message + "\n");
  };
  expect("0,0,0,0,fast,0,0,0,1", "z: found \"fast\", must be a finite number");
  expect("nan,0,0,0,5,0,0,0,1", "time: found \"nan\", must be a finite number");
  expect("0,0,0,0,5,2e12,0,0,1", "vx: found \"2e12\", must be from -1e+12 to 1e+12");
  expect("0,1.5,0,0,5,0,0,0,1", "robot: found \"1.5\", must be an integer >= 0");
  expect("0,-1,0,0,5,0,0,0,1", "robot: found \"-1\", must be an integer >= 0");
  expect("0,0,0,0,5,0,0,0,0", "every: found \"0\", must be an integer >= 1");
  EXPECT_EQ(checked("0,0.0,+0,1e-999,5,0,0,0,1").exit_code, 0) << "numbers as other programs write";
}

TEST(BadRecording, robots_have_to_be_in_the_scene) {
  const ProcessResult result =
      check(kHeader + "0,0,0,0,0,0\n0,2,9,0,0,0\n", {"--scene", "circle-2"});
  EXPECT_EQ(result.exit_code, 3);
  EXPECT_EQ(result.err,
            path_of("in.csv") + ":3: robot: found 2, must be 0 to 1, the robots of the scene\n");
}

TEST(BadRecording, ends_where_more_pairs_overlap_than_it_can_hold) {
  std::string text = kHeader;
  for (int i = 0; i < 4'600; ++i) text += "0," + std::to_string(i) + ",0,0,0,0\n";
  const ProcessResult result = check(text + "1,0,0,0,0,0\n");
  EXPECT_EQ(result.exit_code, 3);
  EXPECT_EQ(result.err, path_of("in.csv") + ":4601: found more than 10000000 overlapping pairs\n");
}

TEST(BadRecording, files_that_cannot_be_read_exit_with_4) {
  const auto expect = [](const std::string& path, const std::string& message) {
    Strings arguments{"check", path};
    arguments.insert(arguments.end(), kLimits.begin(), kLimits.end());
    const ProcessResult result = run_avo(arguments);
    EXPECT_EQ(result.exit_code, 4);
    EXPECT_EQ(result.err, message + "\n");
  };
  expect("no-such.csv", "no-such.csv: No such file or directory");
  expect(folder(), folder() + ": found a directory, must be a file");
  for (const Strings& verb : {Strings{"check"}, Strings{"compare"}, Strings{"replay"}}) {
    const ProcessResult result = run_avo({verb[0], folder()});
    EXPECT_EQ(result.exit_code, 4) << verb[0];
    EXPECT_EQ(result.err, folder() + ": found a directory, must be a file\n") << verb[0];
  }
  EXPECT_EQ(run_avo({"check", "no.h5.part"}).err, "no.h5.part: No such file or directory\n");
  const ProcessResult scene =
      run_avo({"check", recording(kGoodRun), "--scene", path_of("no-such.yaml")});
  EXPECT_EQ(scene.exit_code, 4);
  EXPECT_EQ(run_avo({"check", "/dev/zero", "--scene", "circle-2"}).err,
            "/dev/zero:1: found more than 65536 characters, a line must be shorter\n");
}

TEST(BadRecording, impossible_command_lines_exit_with_2) {
  const auto expect = [](const Strings& more, const std::string& message) {
    Strings arguments{"check", "in.csv"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    const ProcessResult result = run_avo(arguments);
    EXPECT_EQ(result.exit_code, 2);
    EXPECT_EQ(result.err, "avo: " + message + "\n");
  };
  expect({},
         "--radius: found neither it nor robots in --scene, must be one of the two; "
         "--max-acceleration and --max-speed may be with it");
  expect({"--max-acceleration", "1", "--max-speed", "1"},
         "--radius: found neither it nor robots in --scene, must be one of the two; "
         "--max-acceleration and --max-speed may be with it");
  expect({"--radius", "1", "--max-braking", "1"},
         "--max-braking: found without --max-acceleration, must be with it");
  expect({"--scene", "circle-2", "--max-speed", "1"},
         "--max-speed: found besides the robots of --scene, must be one or the other");
  expect({"--scene", "circle-2", "--max-braking", "3"},
         "--max-braking: found besides the robots of --scene, must be one or the other");
  expect({"--radius", "1", "--max-acceleration", "1", "--max-speed", "1", "--max-braking", "0"},
         "--max-braking: found 0, must be > 0");
  expect({"--radius", "0", "--max-acceleration", "1", "--max-speed", "1"},
         "--radius: found 0, must be > 0");
  expect({"--radius", "1", "--max-acceleration", "nan", "--max-speed", "1"},
         "--max-acceleration: found nan, must be > 0");
  Strings more = kLimits;
  more.push_back("--require-arrival");
  expect(more,
         "--require-arrival: found without robots of --scene, must be with them: they have goals");
  more = kLimits;
  more.insert(more.end(), {"--seed", "3"});
  expect(more, "--set: found without --scene, must be with it");
  more = kLimits;
  more.insert(more.end(), {"--tolerance", "1"});
  expect(more, "--tolerance: found 1, must be >= 0 and < 1");
  EXPECT_EQ(run_avo({"check", "in.csv", "--scene", "circle-2", "--set", "robot=1"}).exit_code, 2);
  EXPECT_EQ(run_avo({"check", "--scene", "circle-2"}).exit_code, 2) << "no recording";
}

}  // namespace
}  // namespace avo_test
