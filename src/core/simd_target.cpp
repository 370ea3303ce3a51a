// SPDX-License-Identifier: Apache-2.0
// AVO_SIMD, and what Highway finds on this machine.
#include "core/simd_target.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>

#include "avo/error.h"
#ifdef AVO_HIGHWAY
#include <hwy/highway.h>
#endif

namespace avo {
namespace {

struct Target {
  const char* name;
  std::int64_t bit;  // Highway's; 0: scalar
};

#ifdef AVO_HIGHWAY
constexpr std::array<Target, 5> kTargets{{{"avx512", HWY_AVX3},
                                          {"avx2", HWY_AVX2},
                                          {"sse4", HWY_SSE4},
                                          {"neon", HWY_NEON},
                                          {"scalar", 0}}};
bool is_here(const Target& target) {
  static const std::int64_t supported = hwy::SupportedTargets() & HWY_TARGETS;
  return target.bit == 0 || (supported & target.bit) != 0;
}
void select(const Target& target) {
  hwy::SetSupportedTargetsForTest(target.bit);  // 0: all, which nobody then asks for
  hwy::GetChosenTarget().Update(hwy::SupportedTargets());
}
#else
constexpr std::array<Target, 5> kTargets{
    {{"avx512", 1}, {"avx2", 1}, {"sse4", 1}, {"neon", 1}, {"scalar", 0}}};
bool is_here(const Target& target) {
  return target.bit == 0;
}
void select(const Target&) {}
#endif

const Target* find(std::string_view name) {
  for (const Target& target : kTargets) {
    if (name == target.name) return &target;
  }
  return nullptr;
}

const Target& best() {
  for (const Target& target : kTargets) {
    if (is_here(target)) return target;
  }
  return kTargets.back();
}

std::string_view asked_for() {
  const char* value = std::getenv("AVO_SIMD");
  return value == nullptr || std::string_view(value).empty() ? "auto" : value;
}

const Target* initial() {
  const Target* target = find(asked_for());
  if (target == nullptr || !is_here(*target)) target = &best();
  select(*target);
  return target;
}

const Target*& current() {
  static const Target* target = initial();
  return target;
}

}  // namespace

const char* simd_target() {
  return current()->name;
}

bool simd_is_scalar() {
  return current()->bit == 0;
}

std::span<const char* const> simd_targets() {
  static const auto list = [] {
    struct {
      std::array<const char*, kTargets.size()> names{};
      std::size_t count = 0;
    } found;
    for (const Target& target : kTargets) {
      if (is_here(target)) found.names[found.count++] = target.name;
    }
    return found;
  }();
  return {list.names.data(), list.count};
}

bool use_simd_target(std::string_view name) {
  const Target* target = find(name);
  if (target == nullptr || !is_here(*target)) return false;
  current() = target;
  select(*target);
  return true;
}

void check_simd_target() {
  const std::string_view name = asked_for();
  if (name == "auto") return;
  const Target* target = find(name);
  if (target != nullptr && is_here(*target)) return;
  std::string allowed = "auto";
  for (const char* each : simd_targets()) allowed += std::string(", ") + each;
  throw Error("AVO_SIMD: found " + std::string(name) + ", must be one of " + allowed +
              (target != nullptr ? " on this machine" : ""));
}

}  // namespace avo
