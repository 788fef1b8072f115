// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/document/measured_list.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace drillwave {

void MeasuredList::add(MeasuredSignal signal) {
    assert(!isFull());
    const std::string name = signal.name;
    const auto isTaken = [this](const std::string& wanted) {
        return std::ranges::find(m_signals, wanted, &MeasuredSignal::name) != m_signals.end();
    };
    for (int i = 2; isTaken(signal.name); ++i) signal.name = name + " (" + std::to_string(i) + ")";
    m_signals.push_back(std::move(signal));
    emit changed();
}

void MeasuredList::remove(std::size_t index) {
    if (index >= m_signals.size()) return;
    m_signals.erase(m_signals.begin() + static_cast<std::ptrdiff_t>(index));
    emit changed();
}

void MeasuredList::setTimeShift(std::size_t index, double seconds) {
    if (index >= m_signals.size() || !std::isfinite(seconds)) return;
    if (m_signals[index].timeShift == seconds) return;
    m_signals[index].timeShift = seconds;
    emit changed();
}

}  // namespace drillwave
