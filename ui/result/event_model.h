// SPDX-License-Identifier: GPL-3.0-or-later
// The events of a blow as a table: when, and what happened at the bit.
#pragma once

#include <QAbstractTableModel>
#include <optional>

#include "ui/job/solved_blow.h"

namespace drillwave {

/// Reads from the shared answer: a blow with many contacts costs nothing to list.
class EventModel : public QAbstractTableModel {
    Q_OBJECT

  public:
    using QAbstractTableModel::QAbstractTableModel;

    void present(const SolvedBlowPtr& blow);
    /// Global time t/t0 of the event in a row.
    double timeAt(int row) const;
    /// The first event at a global time t/t0, if there is one.
    std::optional<int> rowAt(double time) const;

    int rowCount(const QModelIndex& parent = {}) const override;
    int columnCount(const QModelIndex& parent = {}) const override;
    QVariant data(const QModelIndex& index, int role = Qt::DisplayRole) const override;
    QVariant headerData(int section, Qt::Orientation orientation, int role = Qt::DisplayRole) const override;

  private:
    SolvedBlowPtr m_blow;
    ShownUnit m_unit;  // of times
};

}  // namespace drillwave
