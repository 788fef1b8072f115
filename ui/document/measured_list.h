// SPDX-License-Identifier: GPL-3.0-or-later
// The measured signals that are laid over computed ones, in the order in which they came.
#pragma once

#include <QObject>
#include <QUndoStack>
#include <vector>

#include "core/signal/alignment.h"

namespace drillwave {

/// Stays when the scenario changes or another one is opened: signals are compared with both. Each change is a
/// step of the history of the document, with those of the scenario, as long as that lasts; it makes no
/// difference to the file.
class MeasuredList : public QObject {
    Q_OBJECT

  public:
    /// The history must outlive the list.
    explicit MeasuredList(QUndoStack& history, QObject* parent = nullptr);

    /// More would have no line of their own.
    static constexpr std::size_t most = 8;

    const std::vector<MeasuredSignal>& signalList() const { return m_signals; }
    bool isFull() const { return m_signals.size() >= most; }
    /// Under a name of its own: "gauge", "gauge (2)". Requires that the list is not full.
    void add(MeasuredSignal signal);
    /// No effect where there is no such index.
    void remove(std::size_t index);
    /// [s]; no effect where there is no such index, or for infinities. Shifts one after the other with the
    /// same `gesture` are one step; 0 is none.
    void setTimeShift(std::size_t index, double seconds, int gesture = 0);

  signals:
    void changed();

  private:
    void push(std::vector<MeasuredSignal> after, const QString& step, int gesture = 0);

    QUndoStack& m_history;
    std::vector<MeasuredSignal> m_signals;
};

}  // namespace drillwave
