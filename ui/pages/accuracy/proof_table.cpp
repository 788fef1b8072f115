// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/pages/accuracy/proof_table.h"

#include "ui/text/shown_text.h"

namespace drillwave {

void ProofTable::present(const QString& first, StudyTable table) {
    beginResetModel();
    m_first = first;
    m_table = std::move(table);
    endResetModel();
}

int ProofTable::rowCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : static_cast<int>(m_table.rows.size());
}

int ProofTable::columnCount(const QModelIndex& parent) const {
    return parent.isValid() || m_table.columns.empty() ? 0 : static_cast<int>(m_table.columns.size()) + 1;
}

QVariant ProofTable::data(const QModelIndex& index, int role) const {
    if (!index.isValid()) return {};
    if (role == Qt::TextAlignmentRole && index.column() > 0) return int(Qt::AlignRight | Qt::AlignVCenter);
    if (role != Qt::DisplayRole && role != Qt::ToolTipRole) return {};
    const auto row = static_cast<std::size_t>(index.row()), column = static_cast<std::size_t>(index.column());
    if (column == 0) return translated(m_table.rows[row].text);
    const std::vector<StudyTable::Cell>& cells = m_table.cells[row];
    return column <= cells.size() ? QString::fromStdString(cells[column - 1].text) : QString();
}

QVariant ProofTable::headerData(int section, Qt::Orientation orientation, int role) const {
    if (role != Qt::DisplayRole || orientation != Qt::Horizontal) return {};
    return section == 0 ? m_first : translated(m_table.columns[static_cast<std::size_t>(section - 1)].text);
}

}  // namespace drillwave
