// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/report/row_csv.h"

#include <bit>
#include <cstdint>
#include <span>

#include "core/text/csv.h"

namespace drillwave {

namespace {

/// Appends the numbers of one row after another. Leading cells with the numbers of the row before, as the
/// outer axes of a sweep have them, are copied.
class NumberCells {
  public:
    /// Whether the numbers of a line come behind other cells.
    enum class Place { first, behindCells };

    NumberCells(const std::vector<RowColumn>& columns, Place place, std::string& text)
        : m_columns(columns), m_place(place), m_text(text), m_ends(columns.size()) {}

    void append(std::span<const double> numbers) {
        const std::size_t start = m_text.size();
        std::size_t same = 0;
        while (same < m_before.size() && isSame(numbers[same], m_before[same])) ++same;
        if (same > 0) m_text.append(m_text, m_start, m_ends[same - 1]);
        for (std::size_t c = same; c < numbers.size(); ++c) {
            if (c > 0 || m_place == Place::behindCells) m_text += ',';
            if (m_columns[c].kind == RowColumn::Kind::word)
                m_text += csvCell(m_columns[c].cell(numbers[c]));
            else
                m_columns[c].appendText(m_text, numbers[c]);
            m_ends[c] = m_text.size() - start;
        }
        m_start = start;
        m_before = numbers;
    }

  private:
    /// Also in its sign, which 0 has too.
    static bool isSame(double a, double b) {
        return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b);
    }

    const std::vector<RowColumn>& m_columns;
    Place m_place;
    std::string& m_text;
    std::span<const double> m_before;  // numbers of the row before
    std::size_t m_start = 0;           // where its cells begin
    std::vector<std::size_t> m_ends;   // and where each of them ends, from there
};

}  // namespace

bool RowCsv::begin(const RowHeader& header) {
    m_columns = header.columns;
    m_hasCopied = !header.copied.empty();
    if (!header.isFirstPart) return true;
    std::string line;
    for (const std::string& heading : header.copied) line += csvCell(heading) + ",";
    for (const RowColumn& column : header.columns) line += column.header + ",";
    line.back() = '\n';
    return m_write(line);
}

void RowCsv::prepare(const RowBlock& rows, std::string& prepared) const {
    using Place = NumberCells::Place;
    NumberCells numbers(m_columns, m_hasCopied ? Place::behindCells : Place::first, prepared);
    for (std::size_t i = 0; i < rows.size(); ++i) {
        const std::span<const std::string> copied = rows.copied(i);
        for (std::size_t c = 0; c < copied.size(); ++c) {
            if (c > 0) prepared += ',';
            prepared += csvCell(copied[c]);
        }
        numbers.append(rows[i]);
        prepared += '\n';
    }
}

bool RowCsv::take(const RowBlock&, std::string_view prepared) {
    return m_write(prepared);
}

}  // namespace drillwave
