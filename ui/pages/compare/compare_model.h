// SPDX-License-Identifier: GPL-3.0-or-later
// The comparison as a table to look at.
#pragma once

#include <QAbstractTableModel>
#include <QIcon>

#include "ui/pages/compare/compare_table.h"

namespace drillwave {

/// Below each result its difference from that of the reference, absolute and in percent.
class CompareModel : public QAbstractTableModel {
    Q_OBJECT

  public:
    using QAbstractTableModel::QAbstractTableModel;

    /// `icons` stand before the titles of the columns.
    void present(CompareTable table, QList<QIcon> icons);
    const CompareTable& table() const { return m_table; }
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
