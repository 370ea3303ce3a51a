// SPDX-License-Identifier: Apache-2.0
// What a shared library shows: all that is public carries AVO_API, everything else is hidden.
#pragma once

#if defined(__GNUC__)
#define AVO_API __attribute__((visibility("default")))
/// A member that is hidden, of a class that is public.
#define AVO_LOCAL __attribute__((visibility("hidden")))
#else
#define AVO_API
#define AVO_LOCAL
#endif
