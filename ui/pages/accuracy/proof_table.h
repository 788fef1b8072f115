// SPDX-License-Identifier: GPL-3.0-or-later
// Table model for a study with too many rows for a table of widgets.
#pragma once

#include <QAbstractTableModel>

#include "core/report/study.h"

namespace drillwave {

/// Table model for the table of an accuracy or stability study. Its first column holds the titles of the
/// rows.
class ProofTable : public QAbstractTableModel {
    Q_OBJECT

  public:
    using QAbstractTableModel::QAbstractTableModel;

    /// Shows a table; `first` is the title of the first column.
    void present(const QString& first, StudyTable table);
    void clear() { present({}, {}); }

    int rowCount(const QModelIndex& parent = {}) const override;
    int columnCount(const QModelIndex& parent = {}) const override;
    QVariant data(const QModelIndex& index, int role = Qt::DisplayRole) const override;
    QVariant headerData(int section, Qt::Orientation orientation, int role = Qt::DisplayRole) const override;

  private:
    QString m_first;
    StudyTable m_table;
};

}  // namespace drillwave
