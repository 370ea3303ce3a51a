# SPDX-License-Identifier: Apache-2.0
# find_package(avo) and pkg-config: the library alone, what it needs is the compiler and threads.
include(CMakePackageConfigHelpers)
install(TARGETS avo EXPORT avo-targets
  ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR} LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR})
install(DIRECTORY include/avo ${PROJECT_BINARY_DIR}/include/avo
  DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
install(EXPORT avo-targets NAMESPACE avo:: DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/avo)
configure_package_config_file(cmake/avo-config.cmake.in ${PROJECT_BINARY_DIR}/avo-config.cmake
  INSTALL_DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/avo)
write_basic_package_version_file(${PROJECT_BINARY_DIR}/avo-config-version.cmake
  COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/avo-config.cmake ${PROJECT_BINARY_DIR}/avo-config-version.cmake
  DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/avo)

set(avo_pc_private "${CMAKE_THREAD_LIBS_INIT}")
configure_file(cmake/avo.pc.in ${PROJECT_BINARY_DIR}/avo.pc @ONLY)
install(FILES ${PROJECT_BINARY_DIR}/avo.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig)
if(AVO_CLI)
  install(TARGETS avo_cli RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
endif()
