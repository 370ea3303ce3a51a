# SPDX-License-Identifier: Apache-2.0
# What Debian asks of every package beyond the installed files: run by CPack before it packs them.
string(TIMESTAMP date "%a, %d %b %Y %H:%M:%S +0000" UTC)  # of SOURCE_DATE_EPOCH where that is set
foreach(component IN LISTS CPACK_COMPONENTS_ALL)
  set(root ${CPACK_TEMPORARY_INSTALL_DIRECTORY}/${component}/usr)
  string(TOUPPER ${component} upper)
  set(package ${CPACK_DEBIAN_${upper}_PACKAGE_NAME})
  set(documents ${root}/share/doc/${package})

  file(COPY ${CMAKE_CURRENT_LIST_DIR}/copyright DESTINATION ${documents})
  file(WRITE ${documents}/changelog.Debian
    "avo (${CPACK_PACKAGE_VERSION}-${CPACK_DEBIAN_PACKAGE_RELEASE}) unstable; urgency=medium\n\n"
    "  * Version ${CPACK_PACKAGE_VERSION}; CHANGELOG.md of the sources says what has changed.\n\n"
    " -- ${CPACK_PACKAGE_CONTACT}  ${date}\n")
  set(overrides "# Made from the sources of the project, not for Debian's archive: no bug asks for it."
    "${package}: initial-upload-closes-no-bugs *")
  if(component MATCHES "^(library|c_core)$")
    list(APPEND overrides "# CPack adds these scripts, which do nothing that the trigger does not do."
      "${package}: maintscript-calls-ldconfig *")
  endif()
  list(JOIN overrides "\n" overrides)
  file(WRITE ${root}/share/lintian/overrides/${package} "${overrides}\n")

  file(GLOB pages ${root}/share/man/man?/*.[1-9])
  execute_process(COMMAND gzip -9n ${documents}/changelog.Debian ${pages} COMMAND_ERROR_IS_FATAL ANY)
  file(GLOB_RECURSE files LIST_DIRECTORIES false ${documents}/* ${root}/share/lintian/* ${root}/share/man/*)
  file(CHMOD ${files} PERMISSIONS OWNER_READ OWNER_WRITE GROUP_READ WORLD_READ)
endforeach()
