// SPDX-License-Identifier: Apache-2.0
#include "errors.h"

#include <array>
#include <exception>
#include <new>

#include "avo/error.h"
#include "avo/version.h"

namespace avo_c {
namespace {

thread_local std::string message_text;
thread_local const char* message = "";

void remember(const char* text) noexcept {
  try {
    message_text = text;
    message = message_text.c_str();
  } catch (...) {
    message = "out of memory";
  }
}

}  // namespace

void fail(avo_result result, std::string text) {
  throw Failure{result, std::move(text)};
}

avo_result handle_exception() noexcept {
  try {
    throw;
  } catch (const Failure& failure) {
    remember(failure.message.c_str());
    return failure.result;
  } catch (const avo::Error& error) {
    remember(error.what());
    return AVO_ERROR_INVALID_VALUE;
  } catch (const std::bad_alloc&) {
    message = "out of memory";
    return AVO_ERROR_OUT_OF_MEMORY;
  } catch (const std::exception& error) {
    remember(error.what());
    return AVO_ERROR_INTERNAL;
  } catch (...) {
    message = "a fault that has no name";
    return AVO_ERROR_INTERNAL;
  }
}

}  // namespace avo_c

const char* avo_last_error(void) {
  return avo_c::message;
}

const char* avo_result_text(avo_result result) {
  constexpr std::array kTexts{"ok",
                              "invalid id",
                              "invalid argument",
                              "invalid definition",
                              "invalid value",
                              "invalid scene",
                              "file that cannot be read",
                              "buffer too small",
                              "out of memory",
                              "unsupported",
                              "internal error"};
  if (result < 0 || static_cast<std::size_t>(result) >= kTexts.size()) return "unknown result";
  return kTexts[static_cast<std::size_t>(result)];
}

const char* avo_version(void) {
  return avo::kVersion;
}
