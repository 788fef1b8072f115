// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/wave/network/window_maxima.h"

namespace drillwave {

namespace {

/// Sizes of blocks: a window of millions of steps is a dozen of the largest.
constexpr std::size_t levels = 6;

long blockOf(long step, long size) {
    return step >= 0 ? step / size : -((size - 1 - step) / size);
}

}  // namespace

void WindowMaxima::push(long step, double value) {
    if (m_levels.empty()) {
        m_levels.resize(levels);
        for (std::size_t i = 0; i < levels; ++i) {
            if (i > 0) m_levels[i].size = growth * m_levels[i - 1].size;
            m_levels[i].first = blockOf(step, m_levels[i].size);
        }
    }
    for (Level& level : m_levels) {
        const long block = blockOf(step, level.size);
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
