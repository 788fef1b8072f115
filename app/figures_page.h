// The page that compares the paper with what is computed here.
#pragma once

#include <string>
#include <vector>

#include "core/study/discrepancies.h"
#include "core/study/figure_data.h"

namespace drillwave {

/// HTML with the figures (fig3.svg and so on beside it) and a table of every printed number.
std::string figuresPage(const std::vector<Figure>& figures, const std::vector<Discrepancy>& numbers);

}  // namespace drillwave
