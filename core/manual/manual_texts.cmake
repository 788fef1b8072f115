# SPDX-License-Identifier: GPL-3.0-or-later
# Embeds resources/manual/*.md into core/manual/manual_texts.h of the build directory, in the order of the list of chapters, and
# those that are translated.
set(pages tutorial window keys files commands glossary theory strings drilling evidence upgrading)
set(translated "")
foreach(language de sv)
  foreach(page tutorial window keys glossary)
    list(APPEND translated ${language}/${page})
  endforeach()
endforeach()
drillwave_embed_texts(DRILLWAVE_MANUAL_TEXTS manual md ${pages})
drillwave_embed_texts(DRILLWAVE_TRANSLATED_TEXTS manual md ${translated})
configure_file(manual_texts.h.in manual_texts.h @ONLY)
