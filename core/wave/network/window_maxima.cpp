// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/wave/network/window_maxima.h"

namespace drillwave {

void WindowMaxima::begin(long window) {
    m_levels.clear();
    for (long size = smallest;; size *= growth) {
        m_levels.push_back({.size = size, .first = 0, .largest = {}});
        if (size >= window) return;  // a block of the largest size holds a window, or two do
    }
}

void WindowMaxima::push(long step, double value) {
    for (Level& level : m_levels) {
        const long block = blockOf(step, level.size);
        if (level.largest.empty()) level.first = block;
        if (level.first + static_cast<long>(level.largest.size()) <= block)
            level.largest.push_back(value);
        else
            level.largest.back() = std::max(level.largest.back(), value);
    }
}

void WindowMaxima::dropBefore(long oldest) {
    for (Level& level : m_levels)
        while (!level.largest.empty() && (level.first + 1) * level.size <= oldest) {
            level.largest.pop_front();
            ++level.first;
        }
}

}  // namespace drillwave
