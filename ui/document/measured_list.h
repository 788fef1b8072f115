// SPDX-License-Identifier: GPL-3.0-or-later
// The measured signals that are laid over computed ones, in the order in which they came.
#pragma once

#include <QObject>
#include <vector>

#include "core/signal/measured_signal.h"

namespace drillwave {

/// Stays when the scenario changes or another one is opened: what was measured is compared with both.
class MeasuredList : public QObject {
    Q_OBJECT

  public:
    using QObject::QObject;

    /// More would have no line of their own.
    static constexpr std::size_t most = 8;

    const std::vector<MeasuredSignal>& signalList() const { return m_signals; }
    bool isFull() const { return m_signals.size() >= most; }
    /// Under a name of its own: "gauge", "gauge (2)". Requires that the list is not full.
    void add(MeasuredSignal signal);
    /// No effect where there is no such index.
    void remove(std::size_t index);
    /// [s]; no effect where there is no such index, or for infinities.
    void setTimeShift(std::size_t index, double seconds);

  signals:
    void changed();

  private:
    std::vector<MeasuredSignal> m_signals;
};

}  // namespace drillwave
