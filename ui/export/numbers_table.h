// SPDX-License-Identifier: GPL-3.0-or-later
// The numbers that a page exports, as a table on the screen.
#pragma once

#include <QAbstractTableModel>
#include <QLocale>
#include <vector>

namespace drillwave {

/// Rows of CSV as in the file, with the decimal sign of the locale. Only visible rows are split into cells:
/// there may be a million.
class NumbersTable : public QAbstractTableModel {
    Q_OBJECT

  public:
    /// `csv` is a header and rows, with comments before the header or without. No cell has a line end.
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
    std::vector<qsizetype> m_rows;  // where they begin
    mutable int m_lastRow = -1;     // row of m_lastCells: the cells of a row are read one by one
    mutable QStringList m_lastCells;
};

}  // namespace drillwave
