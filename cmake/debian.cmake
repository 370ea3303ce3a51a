# SPDX-License-Identifier: Apache-2.0
# Debian packages, one of each component of the installation: cpack -G DEB, by scripts/package.
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME avo)
set(CPACK_PACKAGE_VERSION ${PROJECT_VERSION})
set(CPACK_PACKAGE_CONTACT "avo maintainers <maintainers@avo.invalid>")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "")  # each component has its own
set(CPACK_STRIP_FILES ON)
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS
  OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)
set(CPACK_PRE_BUILD_SCRIPTS ${PROJECT_SOURCE_DIR}/cmake/debian/documents.cmake)

set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_RELEASE 1)
set(CPACK_DEBIAN_COMPRESSION_TYPE xz)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS_PRIVATE_DIRS)
set(avo_shlibs "")
foreach(library avo avo_io avo_c)
  if(TARGET ${library})
    get_target_property(avo_folder ${library} BINARY_DIR)
    list(APPEND CPACK_DEBIAN_PACKAGE_SHLIBDEPS_PRIVATE_DIRS ${avo_folder})
    string(APPEND avo_shlibs "lib${library} 0 libavo0 (>= ${PROJECT_VERSION})\n")
  endif()
endforeach()
set(avo_deb_version "${PROJECT_VERSION}-${CPACK_DEBIAN_PACKAGE_RELEASE}")
set(avo_deb_about "Each robot decides alone and without communication, 10 to 100 times a
second. No two robots touch, however dense the crowd is, and every step
keeps the limits of acceleration and speed.")

# COMPONENT becomes the package NAME of SECTION. ABOUT is the second paragraph of its description.
macro(avo_deb component name section summary about)
  list(APPEND CPACK_COMPONENTS_ALL ${component})
  string(TOUPPER ${component} upper)
  set(CPACK_DEBIAN_${upper}_PACKAGE_NAME ${name})
  set(CPACK_DEBIAN_${upper}_PACKAGE_SECTION ${section})
  set(CPACK_COMPONENT_${upper}_DESCRIPTION "${summary}\n${avo_deb_about}\n\n${about}")
endmacro()

set(CPACK_COMPONENTS_ALL)
avo_deb(library libavo0 libs "multi-robot collision avoidance: shared libraries"
  "This package holds what programs need to run.")
file(WRITE ${PROJECT_BINARY_DIR}/debian/shlibs "${avo_shlibs}")
file(WRITE ${PROJECT_BINARY_DIR}/debian/triggers "activate-noawait ldconfig\n")
set(CPACK_DEBIAN_LIBRARY_PACKAGE_CONTROL_EXTRA
  ${PROJECT_BINARY_DIR}/debian/shlibs ${PROJECT_BINARY_DIR}/debian/triggers)
avo_deb(dev libavo-dev libdevel "multi-robot collision avoidance: headers"
  "This package holds headers, and what CMake and pkg-config need.")
set(CPACK_DEBIAN_DEV_PACKAGE_DEPENDS "libavo0 (= ${avo_deb_version})")
set(CPACK_DEBIAN_DEV_PACKAGE_SHLIBDEPS OFF)
if(TARGET avo_c_core)
  avo_deb(c_core libavo-c-core0 libs "multi-robot collision avoidance: C library for games"
    "This package holds the C interface without scene files.")
  file(WRITE ${PROJECT_BINARY_DIR}/debian/c_core/shlibs "libavo_c_core 0 libavo-c-core0 (>= ${PROJECT_VERSION})\n")
  set(CPACK_DEBIAN_C_CORE_PACKAGE_CONTROL_EXTRA
    ${PROJECT_BINARY_DIR}/debian/c_core/shlibs ${PROJECT_BINARY_DIR}/debian/triggers)
  avo_deb(c_core_dev libavo-c-core-dev libdevel "multi-robot collision avoidance: C header"
    "This package holds the header of C, and what CMake and pkg-config need\nfor libavo-c-core0.")
  set(CPACK_DEBIAN_C_CORE_DEV_PACKAGE_DEPENDS "libavo-c-core0 (= ${avo_deb_version})")
  set(CPACK_DEBIAN_C_CORE_DEV_PACKAGE_SHLIBDEPS OFF)
  string(APPEND CPACK_DEBIAN_DEV_PACKAGE_DEPENDS ", libavo-c-core-dev (= ${avo_deb_version})")
endif()
if(TARGET avo_cli)
  avo_deb(tools avo-tools science "multi-robot collision avoidance: command line"
    "This package holds the program avo: it runs scenes, draws them, and
judges recordings.")
  set(CPACK_DEBIAN_TOOLS_PACKAGE_DEPENDS "libavo0 (= ${avo_deb_version}), fonts-dejavu-core")
endif()
if(TARGET avo_python)
  avo_deb(python python3-avo python "multi-robot collision avoidance: Python module"
    "This package holds the module avo for Python 3.")
  find_package(Python3 REQUIRED COMPONENTS Interpreter)
  math(EXPR avo_next_python "${Python3_VERSION_MINOR} + 1")
  set(CPACK_DEBIAN_PYTHON_PACKAGE_DEPENDS "libavo0 (= ${avo_deb_version}), python3-numpy, \
python3 (>= 3.${Python3_VERSION_MINOR}), python3 (<< 3.${avo_next_python})")
  set(CPACK_DEBIAN_PYTHON_PACKAGE_CONTROL_EXTRA
    ${PROJECT_SOURCE_DIR}/cmake/debian/postinst ${PROJECT_SOURCE_DIR}/cmake/debian/prerm)
  set(CPACK_DEBIAN_PYTHON_PACKAGE_CONTROL_STRICT_PERMISSION ON)
endif()
include(CPack)
