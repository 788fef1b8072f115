// SPDX-License-Identifier: GPL-3.0-or-later
// The events of a blow as a table that follows the time cursor and can move it.
#pragma once

#include <QAbstractTableModel>
#include <QTableView>
#include <optional>

#include "ui/job/solved_blow.h"

namespace drillwave {

// The table of events: the time, and what happened at the bit.

/// Table model of the events of a blow, such as the start and end of each contact at the bit. It reads them
/// from the shared result without copying, because a blow can have thousands of contacts.
class EventModel : public QAbstractTableModel {
    Q_OBJECT

  public:
    using QAbstractTableModel::QAbstractTableModel;

    void present(const SolvedBlowPtr& blow);
    /// Returns the time of the event in a row, counted from the start of the blow. It is in units of t0, the
    /// duration of the hammer force.
    double timeAt(int row) const;
    /// Returns the row of the first event at a time after the start of the blow, in units of t0 (duration of
    /// the hammer force). Nothing if no event is at this time.
    std::optional<int> rowAt(double time) const;

    int rowCount(const QModelIndex& parent = {}) const override;
    int columnCount(const QModelIndex& parent = {}) const override;
    QVariant data(const QModelIndex& index, int role = Qt::DisplayRole) const override;
    QVariant headerData(int section, Qt::Orientation orientation, int role = Qt::DisplayRole) const override;

  private:
    SolvedBlowPtr m_blow;
    ShownUnit m_unit;  // unit of the times shown
};

/// Table of the events of a blow at the bit, each with its time. It follows the time cursor: the event at its
/// time is selected.
class EventTable : public QTableView {
    Q_OBJECT

  public:
    explicit EventTable(QWidget* parent = nullptr);

    void present(const SolvedBlowPtr& blow);
    /// Marks the event at the time cursor. `time` is in units of t0 (duration of the hammer force) from the
    /// start of the blow. Marks no event if there is none at this time, or if `time` is empty.
    void setTime(std::optional<double> time);

  signals:
    /// Reports that the user has chosen an event in the table. `time` is in units of t0 (duration of the
    /// hammer force) from the start of the blow.
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
