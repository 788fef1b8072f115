// SPDX-License-Identifier: GPL-3.0-or-later
// Table on the screen of the numbers that a page exports.
#pragma once

#include <QAbstractTableModel>
#include <QLocale>
#include <vector>

namespace drillwave {

/// Table model of a CSV text, shown with the decimal sign of the locale. Only visible rows are split into
/// cells, because there may be a million rows.
class NumbersTable : public QAbstractTableModel {
    Q_OBJECT

  public:
    /// Takes a CSV text: a header and rows, with or without comment lines before the header. Cells must not
    /// contain line ends.
    NumbersTable(QByteArray csv, const QLocale& locale, QObject* parent);

    int rowCount(const QModelIndex& parent = {}) const override;
    int columnCount(const QModelIndex& parent = {}) const override;
    QVariant data(const QModelIndex& index, int role = Qt::DisplayRole) const override;
    QVariant headerData(int section, Qt::Orientation orientation, int role = Qt::DisplayRole) const override;

  private:
    QStringList cells(qsizetype begin) const;
    const QStringList& row(int index) const;

    QByteArray m_csv;
    QLocale m_locale;
    QStringList m_header;
    std::vector<qsizetype> m_rows;  // start of each row in m_csv [bytes]
    // Row of m_lastCells, which is stored because the cells of a row are requested one by one.
    mutable int m_lastRow = -1;
    mutable QStringList m_lastCells;
};

}  // namespace drillwave
