// SPDX-License-Identifier: GPL-3.0-or-later
// The page that compares the paper with what is computed here.
#pragma once

#include <string>
#include <vector>

#include "core/study/paper/discrepancies.h"
#include "core/study/paper/figure_data.h"

namespace drillwave {

/// HTML with the figures (fig3.svg and so on beside it, which are there in `formats`, of pictureFormats) and
/// a table of every printed number.
std::string figuresPage(const std::vector<Figure>& figures, const std::vector<Discrepancy>& numbers,
                        const std::vector<std::string>& formats);

}  // namespace drillwave
