// SPDX-License-Identifier: GPL-3.0-or-later
// The waves inside the rod: the incident wave of the next round trip, as a queue of pieces.
#pragma once

#include <cstddef>
#include <deque>
#include <utility>
#include <vector>

namespace drillwave {

/// First-in first-out ring of pieces that keeps its memory between solves. Index 0 is the next to arrive.
/// The ring is of places: free flight sends long pieces round and round.
template <class Piece>
class WaveQueue {
  public:
    WaveQueue() = default;
    WaveQueue(const WaveQueue&) = delete;
    WaveQueue& operator=(const WaveQueue&) = delete;

    void clear() {
        m_head = 0;
        m_size = 0;
    }
    std::size_t size() const { return m_size; }
    bool empty() const { return m_size == 0; }

    Piece& operator[](std::size_t i) { return *m_ring[(m_head + i) & m_mask]; }
    const Piece& operator[](std::size_t i) const { return *m_ring[(m_head + i) & m_mask]; }
    Piece& front() { return *m_ring[m_head]; }
    Piece& back() { return (*this)[m_size - 1]; }

    /// The piece that was taken last: it stays until the next is, whatever is put in.
    Piece& taken() { return *m_taken; }
    /// Takes the front piece out.
    Piece& take() {
        std::swap(m_taken, m_ring[m_head]);
        popFront();
        return *m_taken;
    }
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
            std::swap(m_ring[m_head], m_ring[(m_head + m_size) & m_mask]);
            m_head = (m_head + 1) & m_mask;
        }
    }

  private:
    void grow() {
        const std::size_t size = m_ring.empty() ? 64 : 2 * m_ring.size();
        std::vector<Piece*> ring;
        ring.reserve(size);
        for (std::size_t i = 0; i < m_size; ++i) ring.push_back(&(*this)[i]);
        while (ring.size() < size) ring.push_back(&m_pieces.emplace_back());
        m_ring = std::move(ring);
        m_head = 0;
        m_mask = size - 1;
    }

    std::deque<Piece> m_pieces{1};
    Piece* m_taken = &m_pieces.front();
    std::vector<Piece*> m_ring;  ///< all others
    std::size_t m_head = 0;
    std::size_t m_size = 0;
    std::size_t m_mask = 0;
};

}  // namespace drillwave
