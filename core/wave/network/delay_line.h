// SPDX-License-Identifier: GPL-3.0-or-later
// The waves on their way back through a section.
#pragma once

#include <algorithm>
#include <cstddef>
#include <span>
#include <vector>

namespace drillwave {

/// Cells, or means of cells, that come out as many cells later as the section is long: a window that moves
/// over a buffer.
template <class Cell>
class DelayLine {
  public:
    /// Filled with `initial`; at most `mostBlock` cells are put in before advance().
    DelayLine(std::size_t delay, std::size_t mostBlock, const Cell& initial)
        : m_delay(delay), m_mostBlock(mostBlock), m_cells(3 * delay + 2 * mostBlock, initial) {}

    /// The next cells to come out.
    const Cell* arriving() const { return m_cells.data() + m_at; }
    /// Where the next cells go in.
    Cell* leaving() { return m_cells.data() + m_at + m_delay; }
    const Cell* leaving() const { return m_cells.data() + m_at + m_delay; }
    std::size_t delay() const { return m_delay; }
    /// All that is on its way, the oldest first.
    std::span<const Cell> content() const { return {arriving(), m_delay}; }

    void advance(std::size_t block) {
        m_at += block;
        if (m_at + m_delay + m_mostBlock <= m_cells.size()) return;
        std::copy_n(m_cells.begin() + static_cast<std::ptrdiff_t>(m_at), m_delay, m_cells.begin());
        m_at = 0;
    }
    /// Other cells in place of those on their way.
    void replace(const std::vector<Cell>& content) {
        m_delay = content.size();
        m_cells.resize(3 * m_delay + 2 * m_mostBlock);
        std::copy(content.begin(), content.end(), m_cells.begin());
        m_at = 0;
    }

  private:
    std::size_t m_delay;
    std::size_t m_mostBlock;
    std::size_t m_at = 0;
    std::vector<Cell> m_cells;
};

}  // namespace drillwave
