// SPDX-License-Identifier: GPL-3.0-or-later
// Page that compares the figures and numbers of the paper with those computed by the program.
#pragma once

#include <string>
#include <vector>

#include "core/study/paper/discrepancies.h"
#include "core/study/paper/figure_data.h"

namespace drillwave {

/// Returns an HTML page with the recomputed figures of the paper, and a table that compares every number
/// printed in the paper with its computed value. The page refers to picture files in its own folder, such as
/// fig3.svg. It uses SVG if `formats` contains it, else PNG, else links to PDF.
std::string figuresPage(const std::vector<Figure>& figures, const std::vector<Discrepancy>& numbers,
                        const std::vector<std::string>& formats);

}  // namespace drillwave
