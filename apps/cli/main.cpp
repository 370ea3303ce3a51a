// SPDX-License-Identifier: Apache-2.0
// avo: the command line. It reads arguments, calls one verb, and turns errors into exit codes.
#include <CLI/CLI.hpp>
#include <algorithm>
#include <exception>
#include <new>
#include <string>
#include <system_error>
#include <vector>

#include "arguments/options.h"
#include "arguments/words.h"
#include "avo/simd.h"
#include "avo/version.h"
#include "avo_io/errors.h"
#include "avo_io/output_file.h"
#include "exit_codes.h"
#include "system/terminal.h"

namespace avo_cli {
namespace {

void check_environment() {
  try {
    avo::check_simd_target();
  } catch (const avo::Error& error) {
    throw UsageError(error.what());
  }
}

int parse_and_act(int argc, char** argv) {
  CLI::App app("Multi-robot collision avoidance that respects acceleration limits");
  Action action;
  add_options(app, action);
  check_words(app, std::vector<std::string>(argv + std::min(argc, 1), argv + argc));
  try {
    app.parse(argc, argv);
  } catch (const CLI::CallForHelp&) {
    print(app.help());
    return kDone;
  } catch (const CLI::CallForVersion&) {
    print(std::string("avo ") + avo::kVersion + "\n");
    return kDone;
  } catch (const CLI::ParseError& error) {
    throw UsageError(what_is_wrong(app, error));
  }
  check_environment();
  // all verbs write to it: report a closed output before a long run, not after it
  (void)avo_io::OutputFile("-");
  return action();
}

int fail(int code, const std::string& message) {
  say(message);
  return code;
}

}  // namespace
}  // namespace avo_cli

int main(int argc, char** argv) {
  using namespace avo_cli;
  try {
    prepare_streams();
    return parse_and_act(argc, argv);
  } catch (const UsageError& error) {
    return fail(kUsage, std::string("avo: ") + error.what());
  } catch (const avo_io::OverrideError& error) {
    return fail(kUsage, error.what());
  } catch (const avo_io::FileError& error) {
    return error.broken_pipe() ? kClosedPipe : fail(kFile, error.what());
  } catch (const BrokenScene& error) {
    say(error.lines);
    return kBadScene;
  } catch (const avo::Error& error) {
    return fail(kBadScene, error.what());
  } catch (const std::bad_alloc&) {
    return fail(kResources, "avo: found too little memory");
  } catch (const std::system_error& error) {
    return fail(kResources, std::string("avo: ") + error.what());
  } catch (const std::exception& error) {
    return fail(kOurFault,
                std::string("avo: a fault of this program, please report it: ") + error.what());
  }
}
