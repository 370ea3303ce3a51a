// SPDX-License-Identifier: Apache-2.0
// JSON for tests, whose code is made once, in json.cpp.
#pragma once
#include <nlohmann/json.hpp>

extern template class nlohmann::basic_json<>;
extern template class nlohmann::basic_json<nlohmann::ordered_map>;
