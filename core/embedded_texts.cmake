# SPDX-License-Identifier: GPL-3.0-or-later
# drillwave_embed_texts(VARIABLE FOLDER ENDING NAME…): the initializers {"NAME", R"…"}, of the files resources/FOLDER/NAME.ENDING,
# which a template of a header then takes in; editing one of them makes the header again.
function(drillwave_embed_texts variable folder ending)
  set(initializers "")
  foreach(name ${ARGN})
    set(file ${PROJECT_SOURCE_DIR}/resources/${folder}/${name}.${ending})
    file(READ ${file} text)
    string(APPEND initializers "    {\"${name}\", R\"${ending}(${text})${ending}\"},\n")
    set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${file})
  endforeach()
  set(${variable} "${initializers}" PARENT_SCOPE)
endfunction()
