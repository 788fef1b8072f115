// SPDX-License-Identifier: GPL-3.0-or-later
// The events of a blow as a table that follows the time cursor and moves it.
#pragma once

#include <QTableView>
#include <optional>

#include "ui/job/solved_blow.h"

namespace drillwave {

class EventModel;

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
