// SPDX-License-Identifier: GPL-3.0-or-later
// Measured signals drawn over the computed curves, in the order in which they were added.
#pragma once

#include <QObject>
#include <QUndoStack>
#include <vector>

#include "core/signal/alignment.h"

namespace drillwave {

/// List of measured signals, kept when another scenario is opened so that both can be compared with them.
/// Each change is a step of the document's undo history, but does not count as a change of the scenario file.
class MeasuredList : public QObject {
    Q_OBJECT

  public:
    /// Makes an empty list whose changes are steps of `history`, which must outlive the list.
    explicit MeasuredList(QUndoStack& history, QObject* parent = nullptr);

    /// Largest number of measured signals in the list; each one has its own line style.
    static constexpr std::size_t most = 8;

    const std::vector<MeasuredSignal>& signalList() const { return m_signals; }
    bool isFull() const { return m_signals.size() >= most; }
    /// Adds a signal under a unique name: "gauge", then "gauge (2)". Requires that the list is not full.
    void add(MeasuredSignal signal);
    /// Removes the signal at `index`; does nothing if there is none.
    void remove(std::size_t index);
    /// Sets the time shift of a signal [s]. Does nothing for an invalid index or a value that is not finite.
    /// Successive shifts with the same `gesture` are merged into one undo step, but with gesture 0 each shift
    /// is a step.
    void setTimeShift(std::size_t index, double seconds, int gesture = 0);

  signals:
    void changed();

  private:
    void push(std::vector<MeasuredSignal> after, const QString& step, int gesture = 0);

    QUndoStack& m_history;
    std::vector<MeasuredSignal> m_signals;
};

}  // namespace drillwave
