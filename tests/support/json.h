// SPDX-License-Identifier: Apache-2.0
// JSON for tests, with keys in the order of the text; json.cpp alone instantiates its code.
#pragma once
#include <nlohmann/json.hpp>

extern template class nlohmann::basic_json<nlohmann::ordered_map>;
