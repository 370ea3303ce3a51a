// SPDX-License-Identifier: Apache-2.0
// The symbols that a shared library shows: all public symbols carry AVO_API, everything else is
// hidden. For Windows, CMake defines AVO_SHARED where the libraries are shared, and AVO_EXPORTING
// while they are compiled.
#pragma once

#if defined(_WIN32)
#if !defined(AVO_SHARED)
#define AVO_API
#elif defined(AVO_EXPORTING)
#define AVO_API __declspec(dllexport)
#else
#define AVO_API __declspec(dllimport)
#endif
#define AVO_LOCAL
#elif defined(__GNUC__)
#define AVO_API __attribute__((visibility("default")))
/// A hidden member of a public class.
#define AVO_LOCAL __attribute__((visibility("hidden")))
#else
#define AVO_API
#define AVO_LOCAL
#endif
