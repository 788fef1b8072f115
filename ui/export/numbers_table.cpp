// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/export/numbers_table.h"

#include <sstream>
#include <utility>

#include "core/text/csv.h"
#include "ui/text/typed_text.h"

namespace drillwave {

NumbersTable::NumbersTable(QByteArray csv, const QLocale& locale, QObject* parent)
    : QAbstractTableModel(parent), m_csv(std::move(csv)), m_locale(locale) {
    for (qsizetype begin = 0; begin < m_csv.size();) {
        const bool isComment = m_csv.at(begin) == '#' && m_header.isEmpty();
        if (!isComment && m_header.isEmpty())
            m_header = cells(begin);
        else if (!isComment)
            m_rows.push_back(begin);
        const qsizetype end = m_csv.indexOf('\n', begin);
        if (end < 0) break;
        begin = end + 1;
    }
}

QStringList NumbersTable::cells(qsizetype begin) const {
    const qsizetype end = m_csv.indexOf('\n', begin);
    std::istringstream line(m_csv.mid(begin, end < 0 ? -1 : end - begin).toStdString());
    CsvReader reader(line);
    CsvRecord record;
    QStringList texts;
    if (reader.next(record))
        for (const std::string& cell : record.cells) texts.append(QString::fromStdString(cell));
    return texts;
}

const QStringList& NumbersTable::row(int index) const {
    if (std::exchange(m_lastRow, index) != index)
        m_lastCells = cells(m_rows[static_cast<std::size_t>(index)]);
    return m_lastCells;
}

int NumbersTable::rowCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : static_cast<int>(m_rows.size());
}

int NumbersTable::columnCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : static_cast<int>(m_header.size());
}

QVariant NumbersTable::data(const QModelIndex& index, int role) const {
    if (!index.isValid() || (role != Qt::DisplayRole && role != Qt::TextAlignmentRole)) return {};
    const QString text = row(index.row()).value(index.column());
    bool isNumber = false;
    text.toDouble(&isNumber);
    if (role == Qt::TextAlignmentRole) {
        const auto side = isNumber ? Qt::AlignRight : Qt::AlignLeft;
        return QVariant::fromValue(side | Qt::AlignVCenter);
    }
    return isNumber ? localText(text, m_locale) : text;
}

QVariant NumbersTable::headerData(int section, Qt::Orientation orientation, int role) const {
    if (role != Qt::DisplayRole) return {};
    return orientation == Qt::Horizontal ? QVariant(m_header.value(section)) : QVariant(section + 1);
}

}  // namespace drillwave
