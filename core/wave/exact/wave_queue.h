// SPDX-License-Identifier: GPL-3.0-or-later
// The waves inside the rod: the incident wave of the next round trip, as a queue of pieces.
#pragma once

#include <cstddef>
#include <vector>

namespace drillwave {

/// First-in first-out ring of pieces that keeps its memory between solves. Index 0 is the next to arrive.
template <class Piece>
class WaveQueue {
  public:
    void clear() {
        m_head = 0;
        m_size = 0;
    }
    std::size_t size() const { return m_size; }
    bool empty() const { return m_size == 0; }

    Piece& operator[](std::size_t i) { return m_ring[(m_head + i) & m_mask]; }
    const Piece& operator[](std::size_t i) const { return m_ring[(m_head + i) & m_mask]; }
    Piece& front() { return m_ring[m_head]; }
    Piece& back() { return (*this)[m_size - 1]; }

    void popFront() {
        m_head = (m_head + 1) & m_mask;
        --m_size;
    }
    void popBack() { --m_size; }
    void pushBack(const Piece& piece) { pushBack() = piece; }
    /// A new last piece, to be assigned: it holds what an earlier one has left.
    Piece& pushBack() {
        if (m_size == m_ring.size()) grow();
        ++m_size;
        return back();
    }
    /// The first `count` pieces have arrived and leave again unchanged (free reflection at both ends).
    void rotate(std::size_t count) {
        for (std::size_t i = 0; i < count; ++i) {
            const Piece arrived = front();
            popFront();
            pushBack(arrived);
        }
    }

  private:
    void grow() {
        std::vector<Piece> larger(m_ring.empty() ? 64 : 2 * m_ring.size());
        for (std::size_t i = 0; i < m_size; ++i) larger[i] = (*this)[i];
        m_ring = std::move(larger);
        m_head = 0;
        m_mask = m_ring.size() - 1;
    }

    std::vector<Piece> m_ring;
    std::size_t m_head = 0;
    std::size_t m_size = 0;
    std::size_t m_mask = 0;
};

}  // namespace drillwave
