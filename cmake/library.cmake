# SPDX-License-Identifier: Apache-2.0
# What avo, avo_io and avo_c have in common, and how tests reach what they hide.

# Position independent also where it is static, for plug-ins and Python modules. Outside it is seen
# what carries AVO_API, nothing else: no instance of a standard template either.
function(avo_set_up_library library)
  set_target_properties(${library} PROPERTIES VERSION ${PROJECT_VERSION} SOVERSION 0
    POSITION_INDEPENDENT_CODE ON CXX_VISIBILITY_PRESET hidden VISIBILITY_INLINES_HIDDEN ON
    INSTALL_RPATH "$ORIGIN")
  if(WIN32 AND BUILD_SHARED_LIBS)  # avo/export.h
    target_compile_definitions(${library} PUBLIC AVO_SHARED PRIVATE AVO_EXPORTING)
  endif()
  # A call within the library is not a matter of what a program puts in its place; clang's default.
  target_compile_options(${library} PRIVATE $<$<CXX_COMPILER_ID:GNU>:-fno-semantic-interposition>)
  get_target_property(type ${library} TYPE)
  if(type STREQUAL "SHARED_LIBRARY" AND UNIX AND NOT APPLE)
    set(exports ${PROJECT_SOURCE_DIR}/cmake/exports.map)
    if(EXISTS ${CMAKE_CURRENT_SOURCE_DIR}/exports.map)
      set(exports ${CMAKE_CURRENT_SOURCE_DIR}/exports.map)
    endif()
    target_link_options(${library} PRIVATE LINKER:--version-script=${exports} LINKER:--no-undefined)
    set_target_properties(${library} PROPERTIES LINK_DEPENDS ${exports})
  endif()
endfunction()

# INTERNAL: the library with its inner functions, for tests and benchmarks, linked to what follows
# (as the library is). It is the library itself, or the same objects where that is shared.
function(avo_add_internal internal library)
  if(NOT BUILD_SHARED_LIBS)
    add_library(${internal} ALIAS ${library})
    return()
  endif()
  get_target_property(sources ${library} SOURCES)
  list(FILTER sources INCLUDE REGEX "TARGET_OBJECTS")
  add_library(${internal} STATIC EXCLUDE_FROM_ALL $<TARGET_OBJECTS:${library}> ${sources})
  target_include_directories(${internal} PUBLIC
    $<TARGET_PROPERTY:${library},INTERFACE_INCLUDE_DIRECTORIES>)
  target_compile_features(${internal} PUBLIC cxx_std_20)
  target_link_libraries(${internal} PUBLIC ${ARGN})
endfunction()
