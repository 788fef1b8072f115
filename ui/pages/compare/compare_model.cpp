// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/pages/compare/compare_model.h"

#include <QFont>

#include "ui/runs/difference_text.h"
#include "ui/text/number_text.h"

namespace drillwave {
namespace {

bool hasDifferences(const CompareTable& table, const CompareRow& row) {
    return table.titles.size() > 1 && row.kind == CompareRow::Kind::result;
}

}  // namespace

void CompareModel::present(CompareTable table, QList<QIcon> icons) {
    const bool isSameShape = table.rows.size() == m_table.rows.size() && table.titles == m_table.titles;
    // While values are dragged what is selected stays so.
    if (!isSameShape) beginResetModel();
    m_table = std::move(table);
    m_icons = std::move(icons);
    if (!isSameShape) return endResetModel();
    emit dataChanged(index(0, 0), index(rowCount() - 1, columnCount() - 1));
    emit headerDataChanged(Qt::Vertical, 0, rowCount() - 1);
    emit headerDataChanged(Qt::Horizontal, 0, columnCount() - 1);
}

bool CompareModel::isHeading(int row) const {
    return m_table.rows[static_cast<std::size_t>(row)].kind == CompareRow::Kind::heading;
}

int CompareModel::rowCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : static_cast<int>(m_table.rows.size());
}

int CompareModel::columnCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : static_cast<int>(m_table.titles.size());
}

QString CompareModel::text(const CompareRow& row, std::size_t column) const {
    if (row.kind == CompareRow::Kind::heading) return {};
    const QString told = row.text(column, QLocale());
    if (!row.hasNumbers()) return told;
    const QString value = told.isEmpty() ? noNumber : told;
    if (!hasDifferences(m_table, row)) return value;
    if (column == m_table.reference) return value + QLatin1Char('\n') + tr("reference");
    const std::optional<double> difference = row.difference(column, m_table.reference);
    if (!difference) return value + QLatin1Char('\n');
    const QString share = relativeText(*row.numbers[column], *row.numbers[m_table.reference]);
    const bool isNone = row.relative(column, m_table.reference) == 0.0;  // less than rounding makes
    return value + QLatin1Char('\n') + signedText(isNone ? 0 : *difference) +
           (share.isEmpty() ? QString() : QStringLiteral("   ") + share);
}

QVariant CompareModel::data(const QModelIndex& index, int role) const {
    if (!index.isValid()) return {};
    const CompareRow& row = m_table.rows[static_cast<std::size_t>(index.row())];
    if (role == Qt::TextAlignmentRole) return int(Qt::AlignRight | Qt::AlignVCenter);
    if (role == Qt::DisplayRole) return text(row, static_cast<std::size_t>(index.column()));
    return {};
}

QVariant CompareModel::headerData(int section, Qt::Orientation orientation, int role) const {
    if (orientation == Qt::Horizontal) {
        if (role == Qt::DisplayRole || role == Qt::ToolTipRole) return m_table.titles.value(section);
        if (role == Qt::DecorationRole) return m_icons.value(section);
        return {};
    }
    const CompareRow& row = m_table.rows[static_cast<std::size_t>(section)];
    if (role == Qt::TextAlignmentRole) return int(Qt::AlignLeft | Qt::AlignVCenter);
    if (role == Qt::FontRole) {
        QFont font;
        font.setBold(row.kind == CompareRow::Kind::heading);
        return font;
    }
    if (role != Qt::DisplayRole) return {};
    return row.unit.isEmpty() ? row.name : QStringLiteral("%1 [%2]").arg(row.name, row.unit);
}

}  // namespace drillwave
