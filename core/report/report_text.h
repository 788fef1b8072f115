// SPDX-License-Identifier: GPL-3.0-or-later
// Numbers and tables in text reports for people.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/model/scenario.h"
#include "core/text/handy_text.h"

namespace drillwave {

/// Returns the title of a scenario as one line, empty without a title; groupsLine() returns its dimensionless
/// groups as one line.
std::string titleLine(const Scenario& scenario);
std::string groupsLine(const Scenario& scenario, const ReadingStyle& style = plainStyle());
/// Returns the law of bit and rock as one line; empty if it is bilinear.
std::string lawLine(const Scenario& scenario, const ReadingStyle& style = plainStyle());

/// Returns the first lines of a report: title, dimensionless groups and rock law.
std::string headingOf(const Scenario& scenario, const ReadingStyle& style = plainStyle());

/// Returns words broken into lines of at most 100 characters, each indented by two spaces.
std::string paragraph(std::string_view words);

/// Returns sentences joined by spaces, in the language of the reader.
std::string inOneParagraph(const std::vector<Message>& sentences, const ReadingStyle& style = plainStyle());

/// Alignment of the cells in a line. The first cell of a line is always left-aligned.
enum class CellAlignment { left, right };

/// Table of text cells in aligned columns. In a line with one or two cells, the last cell is a note, which
/// may be wider than its column.
class TextGrid {
  public:
    explicit TextGrid(CellAlignment alignment = CellAlignment::right) : m_alignment(alignment) {}

    void add(std::vector<std::string> cells) { m_rows.push_back(std::move(cells)); }
    /// Adds a line of headings; each must be a translatable text of the program or a symbol.
    void addTitles(const std::vector<const char*>& titles, const ReadingStyle& style);
    const std::vector<std::vector<std::string>>& rows() const { return m_rows; }
    std::string text() const;

  private:
    /// Returns the widths of the columns, in characters. The last cell of a line with one or two cells is a
    /// note, which has no influence on the widths.
    std::vector<std::size_t> widths() const;

    CellAlignment m_alignment;
    std::vector<std::vector<std::string>> m_rows;
};

}  // namespace drillwave
