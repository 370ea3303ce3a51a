// SPDX-License-Identifier: Apache-2.0
// This file exists only for the precompiled headers.
#include "support/headers.h"
