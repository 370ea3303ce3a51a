# SPDX-License-Identifier: Apache-2.0
# find_package(avo) and pkg-config.
include(CMakePackageConfigHelpers)
