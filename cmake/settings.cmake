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

# Contraction to fused multiply-add would make the bits depend on the compiler and the machine. Where flags such as
# -march=native allow these instructions, g++ 12 makes them of vectors of two numbers in spite of -ffp-contract=off,
# unless it is told not to look for such vectors. Elsewhere that would cost 1 % of the instructions for nothing.
include(CheckCXXSourceCompiles)
function(avo_look_for_fused_instructions)
  get_directory_property(options COMPILE_OPTIONS)  # of a project that adds this one
  list(FILTER options INCLUDE REGEX "^-m")
  list(JOIN options " " CMAKE_REQUIRED_FLAGS)
  set(CMAKE_REQUIRED_QUIET ON)
  unset(AVO_FUSED_INSTRUCTIONS CACHE)  # flags may have changed
  check_cxx_source_compiles("
    #if !defined(__FMA__) && !defined(__FMA4__)
    #error no fused multiply-add
    #endif
    int main() {}" AVO_FUSED_INSTRUCTIONS)
  mark_as_advanced(AVO_FUSED_INSTRUCTIONS)
endfunction()
avo_look_for_fused_instructions()
add_library(avo_settings INTERFACE)
target_compile_features(avo_settings INTERFACE cxx_std_20)
target_compile_options(avo_settings INTERFACE
  $<$<NOT:$<CXX_COMPILER_ID:MSVC>>:-Wall;-Wextra;-Wpedantic;-Wconversion;-Wshadow;-ffp-contract=off>
  $<$<AND:$<CXX_COMPILER_ID:GNU>,$<BOOL:${AVO_FUSED_INSTRUCTIONS}>>:-fno-tree-slp-vectorize>
  $<$<CXX_COMPILER_ID:GNU>:-Wno-restrict>)  # false alarms of g++ 12 in std::string's operator+
if(AVO_FUSED_INSTRUCTIONS)
  target_compile_definitions(avo_settings INTERFACE AVO_FUSED_INSTRUCTIONS)
endif()

# Most of the time of a build goes into headers: COUNT files of TARGET at a time are one unit, 0: all of them.
# CMAKE_UNITY_BUILD=OFF compiles each file alone.
function(avo_compile_in_units target count)
  if(CMAKE_UNITY_BUILD OR NOT DEFINED CMAKE_UNITY_BUILD)
    set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_BATCH_SIZE ${count})
  endif()
endfunction()
# Those of them whose own names other files have as well are units by themselves.
function(avo_compile_alone)
  set_source_files_properties(${ARGN} PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
endfunction()
