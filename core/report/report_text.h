// SPDX-License-Identifier: GPL-3.0-or-later
// Numbers and tables of numbers as reports for people show them.
#pragma once

#include <string>
#include <vector>

#include "core/model/scenario.h"
#include "core/text/handy_text.h"

namespace drillwave {

/// Title and groups of a scenario, as reports begin.
std::string headingOf(const Scenario& scenario);

/// Lines of cells, the first aligned to the left and the others to the right. Lines of one or two cells are
/// remarks: they do not widen the columns.
class TextGrid {
  public:
    void add(std::vector<std::string> cells) { m_rows.push_back(std::move(cells)); }
    std::string text() const;

  private:
    std::size_t width(std::size_t column) const;

    std::vector<std::vector<std::string>> m_rows;
};

}  // namespace drillwave
