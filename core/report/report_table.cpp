// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/report/report_table.h"

#include <cassert>

#include "core/text/csv.h"
#include "core/text/handy_text.h"

namespace drillwave {

void Cell::appendTo(std::string& csv) const {
    if (const auto* number = std::get_if<double>(&m_content)) appendNumber(csv, *number);
    if (const auto* words = std::get_if<std::string>(&m_content)) csv += csvCell(*words);
}

std::string csvText(const ReportTable& table) {
    std::string csv;
    const auto addRow = [&](const auto& cells, const auto& addCell) {
        for (std::size_t c = 0; c < table.headers.size(); ++c) {
            if (c > 0) csv += ',';
            if (c < cells.size()) addCell(cells[c]);
        }
        csv += '\n';
    };
    addRow(table.headers, [&](const std::string& header) { csv += csvCell(header); });
    for (std::size_t row = 0; row < table.rows; ++row) {
        const Cells cells = table.cellsOf(row);
        assert(cells.size() <= table.headers.size());
        addRow(cells, [&](const Cell& cell) { cell.appendTo(csv); });
    }
    return csv;
}

}  // namespace drillwave
