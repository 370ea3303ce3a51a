// SPDX-License-Identifier: Apache-2.0
// Methods of the user's own on the command line: the potential field of examples/own_method.c.
#include <gtest/gtest.h>
#include <string>
#include <vector>

#include "run_avo.h"
#include "support/json.h"
#include "sweeps.h"

namespace avo_test {
namespace {

const std::string kField = std::string("field=") + AVO_OWN_METHOD;

ProcessResult run_by(const std::string& method, Strings more = {}) {
  more.insert(more.begin(), {"run", "circle-30", "--method", method, "--until-arrived"});
  return run_avo(more);
}

std::int64_t pairs_by(const std::string& method) {
  const ProcessResult result = run_by(method, {"--json"});
  EXPECT_EQ(result.exit_code, 0) << result.err;
  return nlohmann::ordered_json::parse(result.out)["collision_pairs"].get<std::int64_t>();
}

TEST(OwnMethod, touches_alone_and_not_behind_the_certificate) {
  EXPECT_GT(pairs_by(kField), 0);
  EXPECT_GT(pairs_by(kField + ":avo_choose,unclamped"), 0);
  EXPECT_EQ(pairs_by(kField + ",certified"), 0);
}

TEST(OwnMethod, is_recorded_judged_and_simulated_again) {
  const std::string h5 = path_of("run.h5"), page = path_of("run.html");
  ASSERT_EQ(run_by(kField + ",certified", {"--record", h5}).exit_code, 0);
  const ProcessResult judged = run_avo({"check", h5});
  EXPECT_EQ(judged.exit_code, 0) << judged.out;
  EXPECT_EQ(run_avo({"replay", h5, "--method", kField}).exit_code, 0);
  const ProcessResult without = run_avo({"replay", h5});
  EXPECT_NE(without.err.find("external_method field: found no function, must have one"),
            std::string::npos)
      << without.err;
  ASSERT_EQ(run_avo({"report", h5, page}).exit_code, 0);
  EXPECT_NE(read_file(page).find("Without --method the run is not simulated again: it is by field"),
            std::string::npos);
  ASSERT_EQ(run_avo({"report", h5, page, "--method", kField}).exit_code, 0);
  EXPECT_NE(read_file(page).find("30 robots, method field"), std::string::npos);
  EXPECT_NE(read_file(page).find("--method field="), std::string::npos);
}

TEST(OwnMethod, stands_in_sweeps_and_comparisons_beside_the_others) {
  const std::string yaml =
      "version: 1\nscenes: [circle-12]\nmethods: [avo, field, safe]\nuntil_arrived: true\n";
  const Strings own{"--method", kField, "--method",
                    std::string("safe=") + AVO_OWN_METHOD + ",certified"};
  const std::string table = swept(yaml, "runs.csv", own);
  const ProcessResult compared = run_avo({"compare", table, "--by", "method"});
  ASSERT_EQ(compared.exit_code, 0) << compared.err;
  for (const char* method : {"avo", "field", "safe"})
    EXPECT_NE(compared.out.find(method), std::string::npos) << compared.out;
  const ProcessResult without = sweep(yaml, {"--out", path_of("other.csv")});
  EXPECT_EQ(without.exit_code, 3);
  EXPECT_NE(without.err.find("methods.1: found \"field\", must be one of avo"), std::string::npos)
      << without.err;
}

TEST(ForeignMotion, is_a_recording_of_a_method_of_its_own) {
  const std::string csv = path_of("rvo.csv"), h5 = path_of("rvo.h5"), page = path_of("rvo.html");
  ASSERT_EQ(
      run_avo({"run", "circle-12", "--set", "method=orca", "--record", csv, "--until-arrived"})
          .exit_code,
      0);
  const ProcessResult made =
      run_avo({"convert", csv, h5, "--to", "recording", "--scene", "circle-12"});
  ASSERT_EQ(made.exit_code, 0) << made.err;
  const std::string avo = path_of("avo.h5");
  ASSERT_EQ(run_avo({"run", "circle-12", "--record", avo, "--until-arrived"}).exit_code, 0);
  const ProcessResult compared =
      run_avo({"compare", h5, avo, "--traces", path_of("t.svg"), "--arrival", path_of("a.svg")});
  ASSERT_EQ(compared.exit_code, 0) << compared.err;
  EXPECT_NE(compared.out.find("rvo.h5"), std::string::npos) << compared.out;
  ASSERT_EQ(run_avo({"report", h5, page}).exit_code, 0);
  EXPECT_NE(read_file(page).find("12 robots, method rvo"), std::string::npos);
  EXPECT_NE(read_file(page).find("it is by rvo"), std::string::npos);
  // the same rows, back again
  ASSERT_EQ(run_avo({"convert", h5, path_of("back.csv")}).exit_code, 0);
  EXPECT_EQ(read_file(path_of("back.csv")), read_file(csv));
}

TEST(ForeignMotion, is_refused_where_it_is_not_of_the_scene) {
  const std::string csv = path_of("orca.csv"), h5 = path_of("orca.h5");
  write_file(csv, "time,robot,x,y,vx,vy\n0,0,0,0,1,0\n70,0,1,0,1,0\n");
  const auto refused = [&](Strings more) {
    more.insert(more.begin(), {"convert", csv, h5, "--to", "recording"});
    const ProcessResult result = run_avo(more);
    EXPECT_NE(result.exit_code, 0);
    EXPECT_FALSE(exists(h5));
    return result.err;
  };
  EXPECT_NE(refused({}).find("time_step: found 70, must be <= time_horizon"), std::string::npos);
  EXPECT_NE(refused({"--scene", "circle-3"}).find("another name than avo's own"),
            std::string::npos);
  EXPECT_NE(refused({"--scene", "circle-3", "--name", "rvo", "--set", "duration=60"})
                .find("found 70 s, must be <= 60 s, the duration of the scene"),
            std::string::npos);
}

// There are two people with numbers of their own. One person comes later, and one person goes
// earlier.
std::string people(const std::string& name) {
  const std::string csv = path_of(name);
  write_file(csv,
             "time,robot,x,y,vx,vy\n"
             "10,7,0,0,1,0\n10.5,7,0.5,0,1,0\n10.5,40,9,5,0,0\n11,7,1,0.0625,1,0.25\n"
             "11,40,9,5,0,0\n11.5,7,1.5,0.1875,1,0.25\n11.5,40,9,5,0,0\n12,40,9,5,0,0\n");
  return csv;
}

TEST(ForeignMotion, makes_a_scene_of_its_own_where_there_is_none) {
  const std::string csv = people("people.csv"), h5 = path_of("people.h5");
  const ProcessResult made = run_avo({"convert", csv, h5, "--to", "recording"});
  ASSERT_EQ(made.exit_code, 0) << made.err;
  EXPECT_EQ(made.err,
            "warning: the robots are made of the motion: the first place, the last one as goal, "
            "the largest speed and acceleration; radius 0.3 m (--radius), robot 0 is 7 there, "
            "robot 1 is 40, 0 s is 10 s there; nobody knows of walls, --scene gives them\n");
  ASSERT_EQ(run_avo({"convert", h5, path_of("back.csv")}).exit_code, 0);
  EXPECT_EQ(read_file(path_of("back.csv")),
            "time,robot,x,y,vx,vy\n"
            "0,0,0,0,1,0\n0.5,0,0.5,0,1,0\n0.5,1,9,5,0,0\n1,0,1,0.0625,1,0.25\n1,1,9,5,0,0\n"
            "1.5,0,1.5,0.1875,1,0.25\n1.5,1,9,5,0,0\n2,1,9,5,0,0\n");
  const ProcessResult judged = run_avo({"check", h5});
  EXPECT_NE(judged.out.find("largest 0.5 m/s^2"), std::string::npos) << judged.out;
  EXPECT_NE(judged.out.find("0 robot-steps beyond the limit"), std::string::npos) << judged.out;
  EXPECT_NE(judged.out.find("2 of 2"), std::string::npos) << judged.out;
}

TEST(ForeignMotion, enters_reports_and_comparisons_without_a_scene) {
  const std::string csv = people("people.csv"), h5 = path_of("people.h5"), page = path_of("p.html");
  ASSERT_EQ(run_avo({"convert", csv, h5, "--to", "recording", "--radius", "0.2", "--set", "seed=7"})
                .exit_code,
            0);
  ASSERT_EQ(run_avo({"report", h5, page}).exit_code, 0);
  const std::string text = read_file(page);
  for (const char* part : {"2 robots, method people", "avo convert MOTION", "goal: [1.5, 0.1875]",
                           "radius: 0.2", "start_time: 0.5", "max_acceleration: 0.5",
                           "time_step: 0.5", "duration: 2", "--set seed=7"})
    EXPECT_NE(text.find(part), std::string::npos) << part;
  EXPECT_EQ(text.find("avo run people"), std::string::npos);
  const std::string other = path_of("avo.h5");
  ASSERT_EQ(run_avo({"run", "circle-3", "--duration", "2", "--record", other}).exit_code, 0);
  const ProcessResult compared = run_avo({"compare", h5, other, "--arrival", path_of("a.svg")});
  ASSERT_EQ(compared.exit_code, 0) << compared.err;
  EXPECT_NE(compared.out.find("2 of 2"), std::string::npos) << compared.out;
}

TEST(ForeignMotion, takes_walls_from_a_scene_without_robots) {
  const std::string csv = people("people.csv"), h5 = path_of("people.h5"),
                    walls = path_of("walls.yaml");
  write_file(walls, "version: 1\nobstacles:\n  - {polyline: [[-5, 6], [20, 6]]}\n");
  const Strings words{"convert", csv, h5, "--to", "recording", "--scene", walls};
  const ProcessResult made = run_avo(words);
  ASSERT_EQ(made.exit_code, 0) << made.err;
  EXPECT_EQ(made.err.find("walls, --scene"), std::string::npos) << made.err;
  const ProcessResult judged = run_avo({"check", h5});
  EXPECT_NE(judged.out.find("from obstacles   0.7 m"), std::string::npos) << judged.out;
  write_file(walls, "{version: 1, obstacles: [{polyline: [[-5, 6], [20, 6]]}]}");
  const ProcessResult refused = run_avo(words);
  EXPECT_EQ(refused.exit_code, 3);
  EXPECT_NE(refused.err.find("found a scene in braces"), std::string::npos) << refused.err;
}

TEST(ForeignMotion, without_a_scene_is_refused_where_none_can_be_made) {
  const std::string csv = people("people.csv"), h5 = path_of("people.h5"), out = path_of("o.h5");
  ASSERT_EQ(run_avo({"convert", csv, h5, "--to", "recording"}).exit_code, 0);
  const auto refused = [&](const std::string& input, Strings more) {
    more.insert(more.begin(), {"convert", input, out, "--to", "recording"});
    const ProcessResult result = run_avo(more);
    EXPECT_EQ(result.exit_code, 2);
    EXPECT_FALSE(exists(out));
    return result.err;
  };
  EXPECT_NE(refused(h5, {}).find("is a recording with a scene of its own"), std::string::npos);
  EXPECT_NE(refused("-", {}).find("found the standard input, must be a file"), std::string::npos);
  EXPECT_NE(refused(csv, {"--radius", "0"}).find("--radius: found 0, must be > 0 m and finite"),
            std::string::npos);
  EXPECT_NE(refused(csv, {"--scene", "circle-3", "--radius", "1"})
                .find("--radius: found with robots in --scene, must be without them"),
            std::string::npos);
  EXPECT_NE(run_avo({"convert", csv, path_of("o.csv"), "--radius", "1"})
                .err.find("--radius: found without --to recording, must be with it"),
            std::string::npos);
}

// A recording says itself by what method its robots moved, and how.
TEST(OwnMethod, of_a_recording_is_no_other_one) {
  const std::string h5 = path_of("own.h5"), plain = path_of("plain.h5");
  ASSERT_EQ(run_avo({"run", "circle-6", "--method", kField, "--record", h5}).exit_code, 0);
  ASSERT_EQ(run_avo({"run", "circle-6", "--record", plain}).exit_code, 0);
  const auto refused = [](const std::string& recording, const std::string& method) {
    const ProcessResult result = run_avo({"replay", recording, "--method", method});
    EXPECT_EQ(result.exit_code, 2) << method;
    return result.err;
  };
  EXPECT_NE(refused(plain, kField)
                .find("--method: found field, must be left out: no robot of the recording has a "
                      "method of its maker's own"),
            std::string::npos);
  EXPECT_NE(refused(h5, std::string("other=") + AVO_OWN_METHOD)
                .find("--method: found other, must be field, the method of the recording"),
            std::string::npos);
  EXPECT_NE(refused(h5, kField + ",unclamped").find("--method: found unclamped, must be left out"),
            std::string::npos);
  EXPECT_NE(refused(h5, kField + ",certified").find("--method: found certified, must be left out"),
            std::string::npos);
}

TEST(ForeignMotion, is_told_where_it_begins_elsewhere) {
  const std::string csv = path_of("elsewhere.csv"), h5 = path_of("elsewhere.h5");
  write_file(csv, "time,robot,x,y,vx,vy\n0,0,0,0,1,0\n0,1,1,0,1,0\n1,0,1,0,1,0\n1,1,2,0,1,0\n");
  const std::string scene = path_of("elsewhere.yaml");
  write_file(scene,
             "version: 1\nrobots:\n  - {position: [0, 0], goal: [9, 0]}\n"
             "  - {position: [3, 0], goal: [9, 2]}\n  - {position: [5, 0], goal: [9, 4]}\n");
  const ProcessResult made = run_avo({"convert", csv, h5, "--to", "recording", "--scene", scene});
  EXPECT_EQ(made.exit_code, 0) << made.err;
  EXPECT_NE(made.err.find("robot 1 is at [1, 0], and the scene has it start at [3, 0], and 1 more "
                          "are elsewhere: is it the scene of the recording?"),
            std::string::npos)
      << made.err;
}

TEST(OwnMethod, is_refused_where_it_cannot_be_had) {
  const auto refused = [](const std::string& method) {
    const ProcessResult result = run_by(method);
    EXPECT_EQ(result.exit_code, 2) << method;
    return result.err;
  };
  const std::string form = "must be NAME=LIBRARY[:FUNCTION][,certified][,unclamped]";
  for (const char* word : {"field", "=f.so", "field=", "field=f.so,fast", "field=f.so:"})
    EXPECT_NE(refused(word).find(form), std::string::npos) << word;
  EXPECT_NE(refused("field=f.so,certified,unclamped").find("not both"), std::string::npos);
  EXPECT_NE(refused("field=./none.so").find("must be a library that can be loaded"),
            std::string::npos);
  EXPECT_NE(refused(kField + ":other").find("found no function other in"), std::string::npos);
  EXPECT_NE(refused(std::string("avo=") + AVO_OWN_METHOD).find("another name than avo's own"),
            std::string::npos);
}

}  // namespace
}  // namespace avo_test
