// SPDX-License-Identifier: GPL-3.0-or-later
// Page that compares the figures and numbers of the paper with those computed by the program.
#pragma once

#include <string>
#include <vector>

#include "core/study/paper/discrepancies.h"
#include "core/study/paper/figure_data.h"

namespace drillwave {

/// Returns an HTML page with the recomputed figures of the paper, and a table of every printed number beside
/// its computed value. The picture files, such as fig3.svg, must be in the folder of the page, in the
/// `formats` given.
std::string figuresPage(const std::vector<Figure>& figures, const std::vector<Discrepancy>& numbers,
                        const std::vector<std::string>& formats);

}  // namespace drillwave
