// SPDX-License-Identifier: GPL-3.0-or-later
// Tables of numbers and words as data, and their CSV form.
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

/// Contents of one cell: empty, a number or words. A number that is not finite gives an empty cell.
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

    /// Appends the cell to CSV text: the shortest text that reads back as the same number, or the words,
    /// quoted if CSV requires it.
    void appendTo(std::string& csv) const;

  private:
    std::variant<std::monostate, double, std::string> m_content;
};

using Cells = std::vector<Cell>;

/// Table of headers and rows, for output as CSV. The cells of each row are created only when it is written,
/// so a long table needs little memory. The data that `cellsOf` uses must outlive the table.
struct ReportTable {
    std::vector<std::string> headers;  ///< headers of the columns, with units
    std::size_t rows = 0;
    /// Function that returns the cells of a row (index from 0); missing cells at the end are empty.
    std::function<Cells(std::size_t row)> cellsOf;
};

/// Returns header and rows as CSV (RFC 4180).
std::string csvText(const ReportTable& table);

/// Appends the elements of `parts` to `whole`.
template <class Value>
void append(std::vector<Value>& whole, std::vector<Value> parts) {
    whole.insert(whole.end(), std::make_move_iterator(parts.begin()), std::make_move_iterator(parts.end()));
}

}  // namespace drillwave
