// SPDX-License-Identifier: GPL-3.0-or-later
// Numbers and tables of numbers as reports for people show them.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/model/scenario.h"
#include "core/text/handy_text.h"

namespace drillwave {

/// Title of a scenario in one line, nothing where it has none; and its groups in another.
std::string titleLine(const Scenario& scenario);
std::string groupsLine(const Scenario& scenario, const ReadingStyle& style = plainStyle());
/// The law of bit and rock in a line where it is not bilinear; nothing where it is.
std::string lawLine(const Scenario& scenario, const ReadingStyle& style = plainStyle());

/// All of them, as reports begin.
std::string headingOf(const Scenario& scenario, const ReadingStyle& style = plainStyle());

/// Broken into lines of at most 100 characters, two blanks before each.
std::string paragraph(std::string_view words);

/// Joins sentences with blanks, in the language of the reader.
std::string inOneParagraph(const std::vector<Message>& sentences, const ReadingStyle& style = plainStyle());

/// Alignment of all cells of a line except the first, which is aligned to the left.
enum class CellAlignment { left, right };

/// Lines of cells in columns. The last cell of a line of one or two is a remark, which widens no column.
class TextGrid {
  public:
    explicit TextGrid(CellAlignment alignment = CellAlignment::right) : m_alignment(alignment) {}

    void add(std::vector<std::string> cells) { m_rows.push_back(std::move(cells)); }
    /// Each a text of the program, or a symbol.
    void addTitles(const std::vector<const char*>& titles, const ReadingStyle& style);
    const std::vector<std::vector<std::string>>& rows() const { return m_rows; }
    std::string text() const;

  private:
    /// Widths of the columns; the last of a line of two is as wide as its text.
    std::vector<std::size_t> widths() const;

    CellAlignment m_alignment;
    std::vector<std::vector<std::string>> m_rows;
};

}  // namespace drillwave
