# SPDX-License-Identifier: GPL-3.0-or-later
# Installed files, in two components, and the packages for Debian that CPack makes of them:
# drillwave-cli, the commands for machines without a desktop, and drillwave, the window. In build/release: cpack -G DEB
set(DRILLWAVE_DEBIAN_REVISION 1 CACHE STRING "Revision of the packages for Debian")
if(DEFINED ENV{DEBFULLNAME} AND DEFINED ENV{DEBEMAIL})
  set(maintainer "$ENV{DEBFULLNAME} <$ENV{DEBEMAIL}>")
else()
  set(maintainer "The Drillwave developers <drillwave@drillwave.invalid>")
endif()
set(DRILLWAVE_MAINTAINER "${maintainer}" CACHE STRING "Whom the packages name as their maintainer; DEBFULLNAME and DEBEMAIL if not given")
set(DRILLWAVE_DEBIAN_VERSION ${DRILLWAVE_VERSION}-${DRILLWAVE_DEBIAN_REVISION})

set(packaging ${PROJECT_SOURCE_DIR}/packaging)
set(resources ${PROJECT_SOURCE_DIR}/resources)
set(described ${PROJECT_BINARY_DIR}/app/describe)
set(made ${PROJECT_BINARY_DIR}/packaging)
set(share ${CMAKE_INSTALL_DATADIR})
set(cli_docs ${CMAKE_INSTALL_DATAROOTDIR}/doc/drillwave-cli)
set(window_docs ${CMAKE_INSTALL_DATAROOTDIR}/doc/drillwave)

string(TIMESTAMP DRILLWAVE_DEBIAN_DATE "%a, %d %b %Y 00:00:00 +0000" UTC)
configure_file(${packaging}/debian/changelog.in ${made}/changelog.Debian @ONLY)
configure_file(${packaging}/desktop/drillwave.metainfo.xml.in ${made}/local.drillwave.Drillwave.metainfo.xml @ONLY)

# The packages, and so what is installed, have pages and lists of changes packed, without the time at which that was done.
find_program(DRILLWAVE_GZIP gzip REQUIRED)
# install_packed(FILE NAME FOLDER COMPONENT): FILE as FOLDER/NAME.gz
set(packed)
macro(install_packed file name folder component)
  set(gz ${made}/${component}/${name}.gz)
  file(MAKE_DIRECTORY ${made}/${component})
  add_custom_command(OUTPUT ${gz} COMMAND ${DRILLWAVE_GZIP} -9nc ${file} > ${gz}
                     DEPENDS ${file} drillwave_descriptions VERBATIM)
  list(APPEND packed ${gz})
  install(FILES ${gz} DESTINATION ${folder} COMPONENT ${component})
endmacro()

# Description of both packages.
macro(install_papers folder component)
  install_packed(${PROJECT_SOURCE_DIR}/CHANGELOG.md changelog ${folder} ${component})
  install_packed(${made}/changelog.Debian changelog.Debian ${folder} ${component})
  install(FILES ${packaging}/debian/copyright DESTINATION ${folder} COMPONENT ${component})
endmacro()

install_papers(${cli_docs} cli)
install_packed(${described}/drillwave.1 drillwave.1 ${CMAKE_INSTALL_MANDIR}/man1 cli)
install(FILES ${described}/drillwave.bash DESTINATION ${share}/bash-completion/completions RENAME drillwave COMPONENT cli)
install(FILES ${described}/_drillwave DESTINATION ${share}/zsh/vendor-completions COMPONENT cli)
install(FILES ${described}/drillwave.fish DESTINATION ${share}/fish/vendor_completions.d COMPONENT cli)
install(DIRECTORY ${resources}/examples ${resources}/manual ${resources}/screenshots DESTINATION ${cli_docs} COMPONENT cli)
install(FILES ${packaging}/slurm/parts.sbatch DESTINATION ${cli_docs}/examples/slurm COMPONENT cli)

if(DRILLWAVE_GUI)
  install_papers(${window_docs} window)
  install_packed(${described}/drillwave-window.1 drillwave-window.1 ${CMAKE_INSTALL_MANDIR}/man1 window)
  install(FILES ${packaging}/desktop/drillwave.desktop DESTINATION ${share}/applications COMPONENT window)
  install(FILES ${made}/local.drillwave.Drillwave.metainfo.xml DESTINATION ${share}/metainfo COMPONENT window)
  install(FILES ${packaging}/desktop/mime.xml DESTINATION ${share}/mime/packages RENAME drillwave.xml COMPONENT window)
  set(icons ${share}/icons/hicolor)
  install(FILES ${resources}/icons/drillwave.svg DESTINATION ${icons}/scalable/apps COMPONENT window)
  install(DIRECTORY ${described}/hicolor/ DESTINATION ${icons} COMPONENT window)
endif()

# All that is installed, without the tests.
add_custom_target(drillwave_installed ALL DEPENDS ${packed})
add_dependencies(drillwave_installed drillwave)

set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_CONTACT "${DRILLWAVE_MAINTAINER}")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ
    WORLD_EXECUTE)
set(CPACK_COMPONENTS_GROUPING IGNORE)
set(CPACK_COMPONENTS_ALL cli)
if(DRILLWAVE_GUI)
  list(APPEND CPACK_COMPONENTS_ALL window)
endif()
set(what "A hammer blow sends a stress wave through the drill rod, the bit meets the
rock, and the rod rebounds. Drillwave says how fast it rebounds, how far the
bit penetrates, where the energy of the blow goes, and what feed force the
blows need: for uniform rods with a bound on the numerical error, and for
whole drill strings.
.
")
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_PACKAGE_VERSION ${DRILLWAVE_VERSION})
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_RELEASE ${DRILLWAVE_DEBIAN_REVISION})
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_CLI_PACKAGE_NAME drillwave-cli)
set(CPACK_DEBIAN_CLI_PACKAGE_SECTION science)
set(CPACK_DEBIAN_CLI_PACKAGE_SUGGESTS drillwave)
set(CPACK_DEBIAN_CLI_DESCRIPTION "${what}This package has the commands, which need no desktop: single blows, sweeps,
maps, designs and many more, in parallel and in parts for clusters; and
examples, the manual and completions for shells.")
set(CPACK_DEBIAN_WINDOW_PACKAGE_NAME drillwave)
set(CPACK_DEBIAN_WINDOW_PACKAGE_SECTION science)
set(CPACK_DEBIAN_WINDOW_PACKAGE_DEPENDS "drillwave-cli (= ${DRILLWAVE_DEBIAN_VERSION})")
set(CPACK_DEBIAN_WINDOW_PACKAGE_RECOMMENDS "hicolor-icon-theme, shared-mime-info, qt6-translations-l10n")
set(CPACK_DEBIAN_WINDOW_DESCRIPTION "${what}This package has the window, in which every change of a parameter is solved
and drawn at once, and with which the commands draw pictures.")
include(CPack)
