# SPDX-License-Identifier: GPL-3.0-or-later
# Embeds resources/examples/*.yaml into core/yaml/example_texts.h of the build directory.
drillwave_embed_texts(DRILLWAVE_EXAMPLE_TEXTS examples yaml
    paper_fig4a
    paper_fig4b
    paper_fig8_minimum
    reference_case
    r32_hard_rock
    t38_medium_rock
    t51_soft_rock
    rock_that_yields
    piston_for_unknown_rock
    r32_string
    t38_string
    t51_string)
configure_file(example_texts.h.in example_texts.h @ONLY)
