# SPDX-License-Identifier: Apache-2.0
# What every target of this project is compiled with. A project that adds this one keeps its own
# build type.
if(avo_top_level)
  if(NOT CMAKE_BUILD_TYPE AND NOT CMAKE_CONFIGURATION_TYPES)
    set(CMAKE_BUILD_TYPE Release)
  endif()
  set(CMAKE_EXPORT_COMPILE_COMMANDS ON)
  set(CMAKE_INSTALL_DEFAULT_COMPONENT_NAME tools)
endif()
set(CMAKE_CXX_EXTENSIONS OFF)

# Contraction to fused multiply-add would make the bits depend on the compiler and the machine.
add_library(avo_settings INTERFACE)
target_compile_features(avo_settings INTERFACE cxx_std_20)
target_compile_options(avo_settings INTERFACE
  -Wall -Wextra -Wpedantic -Wconversion -Wshadow -ffp-contract=off
  $<$<CXX_COMPILER_ID:GNU>:-Wno-restrict>  # false alarms of g++ 12 in std::string's operator+
  $<$<BOOL:${AVO_WERROR}>:-Werror>)
