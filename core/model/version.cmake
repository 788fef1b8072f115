# SPDX-License-Identifier: GPL-3.0-or-later
# The version of this build, DRILLWAVE_VERSION: that of the project, and behind it the commits since it was given: "0.2.0+203.ga059c129".
# Without git, as in an archive of the sources, it is only that of the project.

# drillwave_git(VARIABLE ARGUMENT…): what git prints; empty where it fails.
function(drillwave_git variable)
  execute_process(COMMAND ${DRILLWAVE_GIT} -c safe.directory=* -C ${PROJECT_SOURCE_DIR} ${ARGN}
                  OUTPUT_VARIABLE printed OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET RESULT_VARIABLE failed)
  if(failed)
    set(printed "")
  endif()
  set(${variable} "${printed}" PARENT_SCOPE)
endfunction()

set(DRILLWAVE_VERSION ${PROJECT_VERSION})
find_program(DRILLWAVE_GIT git)
# Sources that lie in the checkout of another project have no .git of their own.
if(DRILLWAVE_GIT AND EXISTS ${PROJECT_SOURCE_DIR}/.git)
  string(REPLACE "." "[.]" pattern "VERSION ${PROJECT_VERSION} ")
  drillwave_git(released log --format=%H -G${pattern} -- CMakeLists.txt)
  string(REGEX REPLACE ".*\n" "" released "${released}")
  drillwave_git(since rev-list --count ${released}..HEAD)
  drillwave_git(commit rev-parse --short=8 HEAD)
  if(released AND commit AND since GREATER 0)
    string(APPEND DRILLWAVE_VERSION "+${since}.g${commit}")
  endif()
  # Every commit and every checkout is written there.
  drillwave_git(log rev-parse --git-path logs/HEAD)
  cmake_path(ABSOLUTE_PATH log BASE_DIRECTORY ${PROJECT_SOURCE_DIR})
  if(EXISTS ${log})
    set_property(DIRECTORY ${PROJECT_SOURCE_DIR} APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${log})
  endif()
endif()
