// SPDX-License-Identifier: GPL-3.0-or-later
// The waves on their way back through a section.
#pragma once

#include <algorithm>
#include <cstddef>
#include <span>
#include <vector>

namespace drillwave {

/// Cells, or means of cells, that leave as many cells later as the section is long: a window that moves over
/// a buffer.
template <class Cell>
class DelayLine {
  public:
    /// Restarts in the same memory: as long as `delay`, to be filled by content(); at most `mostBlock` cells
    /// are added before advance().
    void restart(std::size_t delay, std::size_t mostBlock) {
        m_mostBlock = mostBlock;
        m_delay = delay;
        m_at = 0;
        m_last = room() - m_delay - m_mostBlock;
        if (m_cells.size() < room()) grow();
    }

    /// Returns the next cells to leave.
    const Cell* arriving() const { return m_cells.data() + m_at; }
    /// Returns the place of the next cells to enter.
    Cell* leaving() { return m_cells.data() + m_at + m_delay; }
    const Cell* leaving() const { return m_cells.data() + m_at + m_delay; }
    std::size_t delay() const { return m_delay; }
    /// Returns everything on its way, the oldest first.
    std::span<const Cell> content() const { return {arriving(), m_delay}; }
    std::span<Cell> content() { return {m_cells.data() + m_at, m_delay}; }

    void advance(std::size_t block) {
        m_at += block;
        if (m_at <= m_last) return;
        std::copy_n(m_cells.begin() + static_cast<std::ptrdiff_t>(m_at), m_delay, m_cells.begin());
        m_at = 0;
    }

  private:
    /// The more room, the less often all that is on its way is moved back to the beginning.
    std::size_t room() const { return 3 * m_delay + 2 * m_mostBlock; }

    /// To more than is needed: it becomes longer with every cut of the cells.
    void grow() {
        if (m_cells.capacity() < room()) {
            const std::size_t more = std::max(room(), 2 * m_cells.capacity());
            m_cells.clear();  // nothing in it is wanted, nor to be copied
            m_cells.reserve(more);
        }
        m_cells.resize(room());
    }

    std::size_t m_delay = 0;
    std::size_t m_mostBlock = 0;
    std::size_t m_at = 0;
    std::size_t m_last = 0;  ///< of m_at, before what is on its way is moved back
    std::vector<Cell> m_cells;
};

}  // namespace drillwave
