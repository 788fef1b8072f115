# SPDX-License-Identifier: GPL-3.0-or-later
# Embeds resources/manual/*.md into core/manual/manual_texts.h of the build directory, in the order of the list of chapters.
drillwave_embed_texts(DRILLWAVE_MANUAL_TEXTS manual md
    tutorial window keys files commands glossary theory strings drilling evidence)
configure_file(manual_texts.h.in manual_texts.h @ONLY)
