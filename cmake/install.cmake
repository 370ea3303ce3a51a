# SPDX-License-Identifier: Apache-2.0
# find_package(avo) and pkg-config. An installed tree can be moved: all places in it are relative.
# Components: library (what programs need to run), dev (what they need to be built), c_core and c_core_dev (the same for
# avo_c_core, with the header of C), and the rest, tools (CMAKE_INSTALL_DEFAULT_COMPONENT_NAME in settings.cmake).
# cmake/debian.cmake makes a package of each.
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

# The library and its file for pkg-config, which is made of PC.pc.in; LIBRARY and DEV are the components.
function(avo_install_files name pc library dev)
  install(TARGETS ${name} EXPORT ${name}-targets
    ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT ${dev}
    RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR} COMPONENT ${library}
    LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT ${library} NAMELINK_COMPONENT ${dev})
  configure_file(cmake/${pc}.pc.in ${PROJECT_BINARY_DIR}/${name}.pc @ONLY)
  install(FILES ${PROJECT_BINARY_DIR}/${name}.pc DESTINATION ${avo_pc_folder} COMPONENT ${dev})
endfunction()
# HEADERS: the folder that has the library's own.
function(avo_install_library library headers)
  avo_install_files(${library} ${library} library dev)
  install(EXPORT ${library}-targets NAMESPACE avo:: DESTINATION ${avo_cmake_folder} COMPONENT dev)
  if(headers)
    install(DIRECTORY ${headers}/${library} DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} COMPONENT dev)
  endif()
endfunction()

avo_install_library(avo include)
install(FILES ${PROJECT_BINARY_DIR}/include/avo/version.h
  DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/avo COMPONENT dev)
if(TARGET avo_io)
  avo_install_library(avo_io include)
endif()
if(TARGET avo_c)
  set(avo_c_library avo_c)
  avo_install_library(avo_c "")
  # What needs nothing else of the installation, the header too, is found as a package of its own.
  set(avo_c_library avo_c_core)
  avo_install_files(avo_c_core avo_c c_core c_core_dev)
  install(EXPORT avo_c_core-targets NAMESPACE avo:: FILE avo_c_core-config.cmake
    DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/avo_c_core COMPONENT c_core_dev)
  install(DIRECTORY bindings/c/include/avo_c DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} COMPONENT c_core_dev)
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
