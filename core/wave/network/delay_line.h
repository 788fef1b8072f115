// SPDX-License-Identifier: GPL-3.0-or-later
// Waves on their way through a section towards the hammer.
#pragma once

#include <algorithm>
#include <cstddef>
#include <span>
#include <vector>

namespace drillwave {

/// Queue of fixed length for the waves that run through a section. A cell (time step of a wave), or the mean
/// of a cell, leaves the queue after one round trip of the section. The queue is a window that moves over a
/// buffer.
template <class Cell>
class DelayLine {
  public:
    /// Restarts the queue with a length of `delay` cells (time steps of a wave), in the same memory. The
    /// caller must then fill content(). At most `mostBlock` cells may be written before each advance().
    void restart(std::size_t delay, std::size_t mostBlock) {
        m_mostBlock = mostBlock;
        m_delay = delay;
        m_at = 0;
        m_last = room() - m_delay - m_mostBlock;
        if (m_cells.size() < room()) grow();
    }

    /// Returns a pointer to the cells (time steps of the wave) that leave the section next, the oldest first.
    const Cell* oldest() const { return m_cells.data() + m_at; }
    /// Returns a pointer to the memory into which the next cells (time steps of the wave) are written, as
    /// they enter the section.
    Cell* newest() { return m_cells.data() + m_at + m_delay; }
    /// Returns a pointer to the cells (time steps of the wave) that have entered the section last, since the
    /// last advance().
    const Cell* newest() const { return m_cells.data() + m_at + m_delay; }
    /// Returns the length of the queue in cells (time steps): the round trip of the section.
    std::size_t delay() const { return m_delay; }
    /// Returns all cells (time steps) of the wave in the section, the oldest first.
    std::span<const Cell> content() const { return {oldest(), m_delay}; }
    std::span<Cell> content() { return {m_cells.data() + m_at, m_delay}; }

    /// Advances the queue by `block` cells (time steps), after as many have been written at newest().
    void advance(std::size_t block) {
        m_at += block;
        if (m_at <= m_last) return;
        std::copy_n(m_cells.begin() + static_cast<std::ptrdiff_t>(m_at), m_delay, m_cells.begin());
        m_at = 0;
    }

  private:
    /// Returns the size of the buffer, in cells. The larger the buffer is, the less often its content is
    /// moved back to the start.
    std::size_t room() const { return 3 * m_delay + 2 * m_mostBlock; }

    /// Enlarges the buffer to more than is needed now, because the queue becomes longer whenever cells (time
    /// steps) are cut.
    void grow() {
        if (m_cells.capacity() < room()) {
            const std::size_t more = std::max(room(), 2 * m_cells.capacity());
            m_cells.clear();  // the old content need not be copied
            m_cells.reserve(more);
        }
        m_cells.resize(room());
    }

    std::size_t m_delay = 0;
    std::size_t m_mostBlock = 0;
    std::size_t m_at = 0;
    std::size_t m_last = 0;  ///< largest m_at before the content is moved back to the start
    std::vector<Cell> m_cells;
};

}  // namespace drillwave
