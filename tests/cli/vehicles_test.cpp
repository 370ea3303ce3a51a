// SPDX-License-Identifier: Apache-2.0
// The scenes of forklifts and trucks in examples/vehicles: all arrive, and nothing touches. The
// judge of recordings knows their footprints.
#include <gtest/gtest.h>
#include <string>

#include "recordings.h"
#include "support/json.h"

namespace avo_test {
namespace {

struct Vehicles {
  std::string scene;
  int robots, parked;
  double last;  // s, the last arrival at the latest
};

TEST(Vehicles, arrive_without_contact) {
  for (const Vehicles& of :
       {Vehicles{"forklift-door", 6, 0, 50.0}, Vehicles{"forklift-aisle", 6, 0, 60.0},
        Vehicles{"truck-gate", 4, 0, 50.0}, Vehicles{"truck-yard", 5, 1, 40.0}}) {
    SCOPED_TRACE(of.scene);
    const std::string scene = std::string(AVO_SOURCE) + "/examples/vehicles/" + of.scene + ".yaml";
    const std::string record = path_of(of.scene + ".csv"), summary = path_of(of.scene + ".json");
    const ProcessResult run =
        run_avo({"run", scene, "--until-arrived", "--record", record, "--summary", summary, "-q"});
    ASSERT_EQ(run.exit_code, 0) << run.err;
    const auto json = nlohmann::json::parse(read_file(summary));
    EXPECT_EQ(json["robots"], of.robots);
    EXPECT_EQ(json["arrived"], of.robots);
    EXPECT_EQ(json["parked"], of.parked);
    EXPECT_LT(json["last_arrival"], of.last);
    EXPECT_EQ(json["collision_pairs"], 0);
    EXPECT_EQ(json["static_collisions"], 0);
    const ProcessResult check = run_avo({"check", record, "--scene", scene});
    EXPECT_EQ(check.exit_code, 0) << check.out;
  }
}

}  // namespace
}  // namespace avo_test
