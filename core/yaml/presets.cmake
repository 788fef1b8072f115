# SPDX-License-Identifier: GPL-3.0-or-later
# Embeds resources/presets/presets.yaml into core/yaml/preset_text.h of the build directory.
set(file ${PROJECT_SOURCE_DIR}/resources/presets/presets.yaml)
file(READ ${file} DRILLWAVE_PRESET_TEXT)
set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${file})
configure_file(preset_text.h.in preset_text.h @ONLY)
