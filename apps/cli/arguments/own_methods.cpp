// SPDX-License-Identifier: Apache-2.0
#include "arguments/own_methods.h"

#include <CLI/CLI.hpp>
#include <cstdint>
#include <filesystem>
#include <fmt/format.h>
#include <fstream>
#include <iterator>
#include <string_view>
#if __has_include(<dlfcn.h>)
#include <dlfcn.h>
#endif

#include "arguments/option_parts.h"
#include "avo_io/printable.h"
#include "bindings/c/external.h"
#include "exit_codes.h"
#include "system/terminal.h"

namespace avo_cli {
namespace {

constexpr const char* kFunction = "avo_choose";  // unless the option names another one

/// "NAME=LIBRARY[:FUNCTION][,certified][,unclamped]" in its parts.
struct Given {
  std::string name, library, function = kFunction;
  bool certified = false, clamped = true;
};

[[noreturn]] void refuse(const std::string& word, const char* allowed) {
  throw UsageError(fmt::format("--method: found {}, must be {}",
                               avo_io::printable(word, kLongestWord), allowed));
}

Given parts_of(const std::string& word) {
  constexpr const char* kForm = "NAME=LIBRARY[:FUNCTION][,certified][,unclamped]";
  Given given;
  const std::size_t equals = word.find('=');
  if (equals == std::string::npos || equals == 0) refuse(word, kForm);
  given.name = word.substr(0, equals);
  std::string rest = word.substr(equals + 1);
  for (std::size_t comma = rest.rfind(','); comma != std::string::npos; comma = rest.rfind(',')) {
    const std::string option = rest.substr(comma + 1);
    if (option != "certified" && option != "unclamped") refuse(word, kForm);
    (option == "certified" ? given.certified : given.clamped) = option == "certified";
    rest.resize(comma);
  }
  if (given.certified && !given.clamped) refuse(word, "certified or unclamped, not both");
  if (const std::size_t colon = rest.rfind(':'); colon != std::string::npos && colon > 1) {
    given.function = rest.substr(colon + 1);
    rest.resize(colon);
  }
  if (rest.empty() || given.function.empty()) refuse(word, kForm);
  given.library = rest;
  return given;
}

/// A number for the bytes of a library, so that runs of another one are not taken for its runs.
std::string version_of(const std::string& library) {
  std::ifstream file(library, std::ios::binary);
  std::uint64_t hash = 0xcbf29ce484222325;  // FNV-1a
  for (std::istreambuf_iterator<char> byte(file); byte != std::istreambuf_iterator<char>(); ++byte)
    hash = (hash ^ static_cast<unsigned char>(*byte)) * 0x100000001b3;
  return fmt::format("{:#018x}", hash);
}

#if __has_include(<dlfcn.h>)
avo_external_method* loaded(const Given& given) {
  const std::string path = std::filesystem::absolute(given.library).string();
  void* library = dlopen(path.c_str(), RTLD_NOW | RTLD_LOCAL);
  if (library == nullptr)
    throw UsageError(fmt::format("--method: found {}, must be a library that can be loaded: {}",
                                 given.library, dlerror()));
  void* function = dlsym(library, given.function.c_str());
  if (function == nullptr)
    throw UsageError(
        fmt::format("--method: found no function {} in {}, must have one with C's "
                    "name",
                    given.function, given.library));
  return reinterpret_cast<avo_external_method*>(function);
}
#else
avo_external_method* loaded(const Given& given) {
  refuse(given.library, "left out: this system loads no libraries");
}
#endif

}  // namespace

void add_own_methods(CLI::App& verb, std::vector<std::string>& given, bool several) {
  CLI::Option* option =
      verb.add_option("--method", given,
                      several ? "a method of your own, that the file may name; may be repeated"
                              : "a method of your own, for robots that name none")
          ->type_name("NAME=LIBRARY[:FUNCTION][,certified][,unclamped]")
          ->allow_extra_args(false);
  if (!several) option->expected(1);
}

std::vector<avo_io::OwnMethod> own_methods_of(const std::vector<std::string>& given) {
  std::vector<avo_io::OwnMethod> methods;
  for (const std::string& word : given) {
    const Given own = parts_of(word);
    for (const avo_io::OwnMethod& other : methods)
      if (other.name == own.name)
        throw UsageError(fmt::format("--method: found {} twice, must have another name",
                                     avo_io::printable(own.name, kLongestWord)));
    methods.push_back({own.name, avo_c::external_of(loaded(own), nullptr), own.clamped,
                       own.certified, version_of(own.library)});
  }
  return methods;
}

namespace {

// What is told about the method besides its library, and is not so in the recording.
const char* what_differs(const avo_io::OwnMethod& own, const avo::Scenario& recorded) {
  for (const avo::RobotSetup& robot : recorded.robots) {
    const avo::Method method = method_of(recorded, robot);
    if (is_parked(robot) || !is_external(method)) continue;
    if (!own.clamped && method == avo::Method::external_clamped) return "unclamped";
    if (own.certified && certificate_of(recorded, robot) == avo::Certificate::none)
      return "certified";
  }
  return nullptr;
}

}  // namespace

avo::ExternalMethod method_behind(const std::vector<std::string>& given,
                                  const avo::Scenario& recorded) {
  const std::vector<avo_io::OwnMethod> own = own_methods_of(given);
  if (own.empty()) return {};
  const avo_io::OwnMethod& method = own.front();
  if (!has_external(recorded))
    refuse(method.name, "left out: no robot of the recording has a method of its maker's own");
  if (method.name != recorded.external_method)
    refuse(method.name, (avo_io::printable(recorded.external_method, kLongestWord) +
                         ", the method of the recording")
                            .c_str());
  if (const char* differs = what_differs(method, recorded))
    refuse(differs, "left out: the robots of the recording were otherwise");
  return method.function;
}

}  // namespace avo_cli
