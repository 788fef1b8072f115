// SPDX-License-Identifier: GPL-3.0-or-later
// The events of a blow as a table that follows the time cursor and moves it.
#pragma once

#include <QAbstractTableModel>
#include <QTableView>
#include <optional>

#include "ui/job/solved_blow.h"

namespace drillwave {

// The events of a blow as a table: when, and what happened at the bit.

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

class EventTable : public QTableView {
    Q_OBJECT

  public:
    explicit EventTable(QWidget* parent = nullptr);

    void present(const SolvedBlowPtr& blow);
    /// Marks the event at the time cursor t/t0, if there is one.
    void setTime(std::optional<double> time);

  signals:
    /// The user chose an event: its global time t/t0.
    void timeChosen(std::optional<double> time);

  protected:
    void focusInEvent(QFocusEvent* event) override;

  private:
    void choose(const QModelIndex& index);
    void markEvent();

    EventModel* m_model;
    std::optional<double> m_time;
    bool m_following = false;  // the table follows the time cursor, not the user
};

}  // namespace drillwave
