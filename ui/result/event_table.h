// SPDX-License-Identifier: GPL-3.0-or-later
// The events of a blow as a table that follows the time cursor and can move it.
#pragma once

#include <QAbstractTableModel>
#include <QTableView>
#include <optional>

#include "ui/job/solved_blow.h"

namespace drillwave {

// The table of events: the time, and what happened at the bit.

/// Table model of the events of a blow. It reads them from the shared result, so that many contacts cost
/// nothing.
class EventModel : public QAbstractTableModel {
    Q_OBJECT

  public:
    using QAbstractTableModel::QAbstractTableModel;

    void present(const SolvedBlowPtr& blow);
    /// Returns the global time of the event in a row [t0].
    double timeAt(int row) const;
    /// Returns the row of the first event at a global time [t0]; nothing if there is none.
    std::optional<int> rowAt(double time) const;

    int rowCount(const QModelIndex& parent = {}) const override;
    int columnCount(const QModelIndex& parent = {}) const override;
    QVariant data(const QModelIndex& index, int role = Qt::DisplayRole) const override;
    QVariant headerData(int section, Qt::Orientation orientation, int role = Qt::DisplayRole) const override;

  private:
    SolvedBlowPtr m_blow;
    ShownUnit m_unit;  // unit of the times shown
};

/// Table of the events of a blow.
class EventTable : public QTableView {
    Q_OBJECT

  public:
    explicit EventTable(QWidget* parent = nullptr);

    void present(const SolvedBlowPtr& blow);
    /// Marks the event at the time cursor [t0]; none if there is no event or `time` is empty.
    void setTime(std::optional<double> time);

  signals:
    /// Reports that the user has chosen an event; `time` is its global time [t0].
    void timeChosen(std::optional<double> time);

  protected:
    void focusInEvent(QFocusEvent* event) override;

  private:
    void choose(const QModelIndex& index);
    void markEvent();

    EventModel* m_model;
    std::optional<double> m_time;
    bool m_following = false;  // whether the selection changes because of the time cursor, not the user
};

}  // namespace drillwave
