# SPDX-License-Identifier: GPL-3.0-or-later
# Writes what moc makes of headers as one source: cmake -D MOC=PROGRAM -D ROOT=FOLDER -D HEADERS=LIST.txt -D QT=FOLDERS
# -D OUT=FILE -P write_mocs.cmake. LIST.txt has a header in each line, as it is included.
# Moc reads every header that it finds behind an include, and takes thirty times as long where it finds Qt's, all for naming
# those again whose types cross a signal: all of Qt is included here. Only an interface must be one that it has seen declared.
file(STRINGS ${HEADERS} headers)
list(TRANSFORM QT PREPEND -I)
set(text "// Written by ui/write_mocs.cmake.\n#include <QtWidgets>\n")
foreach(header ${headers})
  file(STRINGS ${ROOT}/${header} macros REGEX "^ *Q_(OBJECT|GADGET|NAMESPACE|INTERFACES\\()")
  if(NOT macros)
    continue()
  endif()
  set(folders "")
  if(macros MATCHES Q_INTERFACES)
    set(folders ${QT})
  endif()
  execute_process(COMMAND ${MOC} ${folders} -f${header} ${ROOT}/${header} OUTPUT_VARIABLE made COMMAND_ERROR_IS_FATAL ANY)
  string(APPEND text "${made}")
endforeach()
file(WRITE ${OUT} "${text}")
