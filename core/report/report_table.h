// SPDX-License-Identifier: GPL-3.0-or-later
// Tables of numbers and words as data, and how they are written as CSV.
#pragma once

#include <concepts>
#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

namespace drillwave {

/// Content of one cell: nothing, a number or words. A number that is not finite is nothing.
class Cell {
  public:
    Cell() = default;
    Cell(double number) : m_content(number) {}
    Cell(std::integral auto number) : m_content(static_cast<double>(number)) {}
    Cell(bool holds) : m_content(std::string(holds ? "true" : "false")) {}
    template <class Content>
    Cell(const std::optional<Content>& content) {
        if (content) *this = Cell(*content);
    }
    Cell(std::string words) : m_content(std::move(words)) {}
    Cell(std::string_view words) : m_content(std::string(words)) {}
    Cell(const char* words) : m_content(std::string(words)) {}

    /// Appends the shortest text that reads back as the same number, or the words, quoted where CSV needs it.
    void appendTo(std::string& csv) const;

  private:
    std::variant<std::monostate, double, std::string> m_content;
};

using Cells = std::vector<Cell>;

/// Headers and rows. The cells of a row are made when the table is written: a table of many rows takes no
/// memory of its own, and what it shows must outlive it.
struct ReportTable {
    std::vector<std::string> headers;  ///< of the columns, with their units
    std::size_t rows = 0;
    std::function<Cells(std::size_t row)> cellsOf;  ///< of a row, from 0; missing cells at its end are empty
};

/// Returns header and rows as CSV, RFC 4180.
std::string csvText(const ReportTable& table);

/// Appends the parts to the whole.
template <class Value>
void append(std::vector<Value>& whole, std::vector<Value> parts) {
    whole.insert(whole.end(), std::make_move_iterator(parts.begin()), std::make_move_iterator(parts.end()));
}

}  // namespace drillwave
