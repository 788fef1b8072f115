# SPDX-License-Identifier: GPL-3.0-or-later
# Embeds resources/manual/*.md into core/manual/manual_texts.h of the build directory, in the order of the list of chapters.
set(DRILLWAVE_MANUAL_TEXTS "")
foreach(name tutorial window keys files commands glossary theory strings drilling evidence)
  set(file ${PROJECT_SOURCE_DIR}/resources/manual/${name}.md)
  file(READ ${file} text)
  string(APPEND DRILLWAVE_MANUAL_TEXTS "    {\"${name}\", R\"page(${text})page\"},\n")
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${file})
endforeach()
configure_file(manual_texts.h.in manual_texts.h @ONLY)
