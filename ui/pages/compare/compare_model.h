// SPDX-License-Identifier: GPL-3.0-or-later
// Table model of the comparison of runs.
#pragma once

#include <QAbstractTableModel>
#include <QIcon>

#include "ui/pages/compare/compare_table.h"

namespace drillwave {

/// Table model of the comparison. Each result shows below its number the difference from the reference
/// column, absolute and in percent.
class CompareModel : public QAbstractTableModel {
    Q_OBJECT

  public:
    using QAbstractTableModel::QAbstractTableModel;

    /// Shows a table. `icons` are placed before the titles of the columns.
    void present(CompareTable table, QList<QIcon> icons);
    const CompareTable& table() const { return m_table; }
    /// Returns whether a row is a heading without numbers.
    bool isHeading(int row) const;

    int rowCount(const QModelIndex& parent = {}) const override;
    int columnCount(const QModelIndex& parent = {}) const override;
    QVariant data(const QModelIndex& index, int role = Qt::DisplayRole) const override;
    QVariant headerData(int section, Qt::Orientation orientation, int role = Qt::DisplayRole) const override;

  private:
    QString text(const CompareRow& row, std::size_t column) const;

    CompareTable m_table;
    QList<QIcon> m_icons;
};

}  // namespace drillwave
