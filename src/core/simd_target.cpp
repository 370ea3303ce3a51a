// SPDX-License-Identifier: Apache-2.0
// AVO_SIMD, and the instruction sets of this machine and build.
#include "core/simd_target.h"

#include <array>
#include <cstdlib>
#include <string>
#include <vector>

#include "avo/error.h"
#include "core/kernel_table.h"
#if AVO_TARGETS != 0 && (defined(__x86_64__) || defined(__i386__))
#include <cpuid.h>
#endif

#if defined(__FMA__) && defined(__GNUC__) && !defined(__clang__) && !defined(AVO_FUSED_INSTRUCTIONS)
#error "put -march into CMAKE_CXX_FLAGS: cmake/settings.cmake has to know of it to keep the bits"
#endif

namespace avo::inline core {
namespace {

constexpr std::array<const char*, kSimdTargets> kNames{"avx512", "avx2",    "sse4",
                                                       "neon",   "simd128", "scalar"};

// The instructions of the kernels' instruction sets, see HWY_TARGET_STR. The compiler's own test
// also asks the operating system.
#if AVO_TARGETS != 0 && (defined(__x86_64__) || defined(__i386__))
bool has_sse4() {
  return __builtin_cpu_supports("ssse3") && __builtin_cpu_supports("sse4.1") &&
         __builtin_cpu_supports("sse4.2") && __builtin_cpu_supports("pclmul") &&
         __builtin_cpu_supports("aes");
}
bool has_f16c() {
  unsigned a = 0, b = 0, c = 0, d = 0;
  return __get_cpuid(1, &a, &b, &c, &d) != 0 && (c & bit_F16C) != 0;
}
bool has_avx2() {
  return has_sse4() && __builtin_cpu_supports("avx2") && __builtin_cpu_supports("bmi") &&
         __builtin_cpu_supports("bmi2") && __builtin_cpu_supports("fma") && has_f16c();
}
bool has_avx512() {
  return has_avx2() && __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512vl") &&
         __builtin_cpu_supports("avx512dq") && __builtin_cpu_supports("avx512bw");
}
std::array<bool, kSimdTargets> find_targets() {
  return {(AVO_TARGETS & HWY_AVX3) != 0 && has_avx512(),
          (AVO_TARGETS & HWY_AVX2) != 0 && has_avx2(),
          (AVO_TARGETS & HWY_SSE4) != 0 && has_sse4(),
          false,
          false,
          true};
}
#elif AVO_TARGETS != 0
std::array<bool, kSimdTargets> find_targets() {  // compiled for it, so the machine has it
  return {false, false, false, (AVO_TARGETS & HWY_NEON) != 0, false, true};
}
#else
std::array<bool, kSimdTargets> find_targets() {
#ifdef AVO_SIMD128
  constexpr bool simd128 = true;
#else
  constexpr bool simd128 = false;
#endif
  return {false, false, false, false, simd128, true};
}
#endif

bool is_here(std::size_t target) {
  static const std::array<bool, kSimdTargets> here = find_targets();
  return here[target];
}

// kSimdTargets if there is none of that name.
std::size_t find(std::string_view name) {
  std::size_t target = 0;
  while (target < kSimdTargets && name != kNames[target]) ++target;
  return target;
}

std::string_view asked_for() {
  const char* value = std::getenv("AVO_SIMD");
  return value == nullptr || std::string_view(value).empty() ? "auto" : value;
}

std::size_t initial() {
  std::size_t target = find(asked_for());
  if (target < kSimdTargets && is_here(target)) return target;
  target = 0;
  while (!is_here(target)) ++target;
  return target;
}

std::size_t& current() {
  static std::size_t target = initial();
  return target;
}

}  // namespace

SimdTarget current_simd_target() {
  return static_cast<SimdTarget>(current());
}

std::vector<const char*> simd_targets() {
  std::vector<const char*> names;
  for (std::size_t target = 0; target < kSimdTargets; ++target) {
    if (is_here(target)) names.push_back(kNames[target]);
  }
  return names;
}

bool use_simd_target(std::string_view name) {
  const std::size_t target = find(name);
  if (target == kSimdTargets || !is_here(target)) return false;
  current() = target;
  return true;
}

}  // namespace avo::inline core

namespace avo {

const char* simd_target() {
  return kNames[current()];
}

void check_simd_target() {
  const std::string_view name = asked_for();
  if (name == "auto") return;
  const std::size_t target = find(name);
  if (target < kSimdTargets && is_here(target)) return;
  std::string allowed = "auto";
  for (const char* here : simd_targets()) allowed += std::string(", ") + here;
  throw Error("AVO_SIMD: found " + std::string(name) + ", must be one of " + allowed +
              (target < kSimdTargets ? " on this machine" : ""));
}

}  // namespace avo
