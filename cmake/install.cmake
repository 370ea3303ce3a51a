# SPDX-License-Identifier: Apache-2.0
# find_package(avo) and pkg-config. An installed tree can be moved: all places in it are relative.
# Components: library (what programs need to run), dev (what they need to be built), and the rest, tools
# (CMAKE_INSTALL_DEFAULT_COMPONENT_NAME in settings.cmake). cmake/debian.cmake makes a package of each.
include(CMakePackageConfigHelpers)
set(avo_cmake_folder ${CMAKE_INSTALL_LIBDIR}/cmake/avo)
set(avo_pc_folder ${CMAKE_INSTALL_LIBDIR}/pkgconfig)
file(RELATIVE_PATH avo_pc_to_prefix
  ${CMAKE_INSTALL_FULL_LIBDIR}/pkgconfig ${CMAKE_INSTALL_PREFIX})
string(REGEX REPLACE "/$" "" avo_pc_to_prefix "${avo_pc_to_prefix}")
file(RELATIVE_PATH avo_pc_to_include
  ${CMAKE_INSTALL_FULL_LIBDIR}/pkgconfig ${CMAKE_INSTALL_FULL_INCLUDEDIR})
file(RELATIVE_PATH avo_bin_to_lib ${CMAKE_INSTALL_FULL_BINDIR} ${CMAKE_INSTALL_FULL_LIBDIR})

# A static library passes on what it needs; with a shared one it is nobody's business.
set(avo_pc_threads "")
set(avo_io_pc_needs "")
if(NOT BUILD_SHARED_LIBS)
  set(avo_pc_threads " -pthread")
  set(avo_io_pc_needs " yaml-cpp fmt hdf5 libdeflate sqlite3 libpng")
endif()

# headers: the folder that has the library's own.
function(avo_install_library library headers)
  install(TARGETS ${library} EXPORT ${library}-targets
    ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT dev
    LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT library NAMELINK_COMPONENT dev)
  install(EXPORT ${library}-targets NAMESPACE avo:: DESTINATION ${avo_cmake_folder} COMPONENT dev)
  install(DIRECTORY ${headers}/${library}
    DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} COMPONENT dev)
  configure_file(cmake/${library}.pc.in ${PROJECT_BINARY_DIR}/${library}.pc @ONLY)
  install(FILES ${PROJECT_BINARY_DIR}/${library}.pc DESTINATION ${avo_pc_folder} COMPONENT dev)
endfunction()

avo_install_library(avo include)
install(FILES ${PROJECT_BINARY_DIR}/include/avo/version.h
  DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/avo COMPONENT dev)
if(TARGET avo_io)
  avo_install_library(avo_io include)
endif()
if(TARGET avo_c)
  avo_install_library(avo_c bindings/c/include)
endif()
if(TARGET avo_cli)
  set_target_properties(avo_cli PROPERTIES INSTALL_RPATH "$ORIGIN/${avo_bin_to_lib}")
  install(TARGETS avo_cli RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR} COMPONENT tools)
endif()

configure_package_config_file(cmake/avo-config.cmake.in ${PROJECT_BINARY_DIR}/avo-config.cmake
  INSTALL_DESTINATION ${avo_cmake_folder} NO_SET_AND_CHECK_MACRO)
write_basic_package_version_file(${PROJECT_BINARY_DIR}/avo-config-version.cmake
  COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/avo-config.cmake ${PROJECT_BINARY_DIR}/avo-config-version.cmake
  DESTINATION ${avo_cmake_folder} COMPONENT dev)

if(avo_top_level)
  include(cmake/debian.cmake)
endif()
