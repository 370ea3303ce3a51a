// SPDX-License-Identifier: Apache-2.0
// The symbols that a shared library shows: all public symbols carry AVO_API, everything else is
// hidden.
#pragma once

#if defined(__GNUC__)
#define AVO_API __attribute__((visibility("default")))
/// A hidden member of a public class.
#define AVO_LOCAL __attribute__((visibility("hidden")))
#else
#define AVO_API
#define AVO_LOCAL
#endif
