// SPDX-License-Identifier: Apache-2.0
// What is said of bad values in scene files, word by word: file, line, column, what, found,
// allowed.
#include <gtest/gtest.h>
#include <string>
#include <vector>

#include "bad_scenes.h"

namespace avo_test {
namespace {

class BadSceneTest : public testing::TestWithParam<BadScene> {};

TEST_P(BadSceneTest, is_refused_in_one_line) {
  expect_refused(GetParam());
}

INSTANTIATE_TEST_SUITE_P(Scenes, BadSceneTest, testing::ValuesIn(bad_scenes()),
                         [](const auto& test) { return std::string(test.param.name); });

}  // namespace
}  // namespace avo_test
