# SPDX-License-Identifier: Apache-2.0
# scenarios/ becomes part of the library, so that it needs no path: scenes, and the maps they name.

set(avo_embedded_template ${CMAKE_CURRENT_LIST_DIR}/embedded.cpp.in)
set(avo_scenarios ${CMAKE_CURRENT_LIST_DIR}/../scenarios)

# Writes the source SOURCE of embedded_files() (builtin.h).
function(avo_embed_scenes source)
  file(GLOB scenes CONFIGURE_DEPENDS ${avo_scenarios}/*)
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${scenes})
  list(TRANSFORM scenes REPLACE "\\.yaml$" "")
  list(SORT scenes)
  set(avo_embedded "")
  foreach(scene IN LISTS scenes)
    get_filename_component(scene_name ${scene} NAME)
    set(is_scene false)
    if(EXISTS ${scene}.yaml)
      set(is_scene true)
      string(APPEND scene .yaml)
    endif()
    file(READ ${scene} scene_text)
    string(APPEND avo_embedded "      {\"${scene_name}\", R\"file(${scene_text})file\", ${is_scene}},\n")
  endforeach()
  configure_file(${avo_embedded_template} ${source} @ONLY)
endfunction()
