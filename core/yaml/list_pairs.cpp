// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/yaml/list_pairs.h"

#include <algorithm>

namespace drillwave {
namespace {

/// Most pairs that are compared; a list is written while the user types.
constexpr std::size_t mostComparedPairs = 10000;

/// Longest common subsequence, where a pair counts by what it shares.
class BestPairs {
  public:
    BestPairs(std::size_t before, std::size_t after) : m_before(before), m_after(after) {
        m_score.resize((before + 1) * (after + 1), 0);
        m_pairScore.resize(before * after, 0);
    }

    void solve(const std::function<Likeness(std::size_t, std::size_t)>& likeness) {
        for (std::size_t i = m_before; i-- > 0;)
            for (std::size_t j = m_after; j-- > 0;) {
                const Likeness like = likeness(i, j);
                // A pair that shares nothing is still better than one item less and another one more.
                m_pairScore[i * m_after + j] = 1 + 4 * like.shared + (like.isEqual ? 2 : 0);
                score(i, j) = std::max(
                    {m_pairScore[i * m_after + j] + score(i + 1, j + 1), score(i + 1, j), score(i, j + 1)});
            }
    }

    std::vector<std::optional<std::size_t>> pairs() {
        std::vector<std::optional<std::size_t>> result(m_before);
        std::size_t i = 0, j = 0;
        while (i < m_before && j < m_after) {
            if (score(i, j) == m_pairScore[i * m_after + j] + score(i + 1, j + 1))
                result[i++] = j++;
            else if (score(i, j) == score(i + 1, j))
                ++i;
            else
                ++j;
        }
        return result;
    }

  private:
    int& score(std::size_t i, std::size_t j) { return m_score[i * (m_after + 1) + j]; }

    std::size_t m_before, m_after;
    std::vector<int> m_score, m_pairScore;
};

}  // namespace

std::vector<std::optional<std::size_t>> listPairs(
    std::size_t before, std::size_t after,
    const std::function<Likeness(std::size_t before, std::size_t after)>& likeness) {
    std::vector<std::optional<std::size_t>> result(before);
    std::size_t head = 0;
    const std::size_t common = std::min(before, after);
    for (; head < common && likeness(head, head).isEqual; ++head) result[head] = head;
    std::size_t tail = 0;
    for (; tail < common - head && likeness(before - 1 - tail, after - 1 - tail).isEqual; ++tail)
        result[before - 1 - tail] = after - 1 - tail;
    const std::size_t fewerBefore = before - head - tail, fewerAfter = after - head - tail;
    if (fewerBefore * fewerAfter > mostComparedPairs) {
        for (std::size_t i = 0; i < std::min(fewerBefore, fewerAfter); ++i) result[head + i] = head + i;
        return result;
    }
    BestPairs best(fewerBefore, fewerAfter);
    best.solve([&](std::size_t i, std::size_t j) { return likeness(head + i, head + j); });
    const std::vector<std::optional<std::size_t>> pairs = best.pairs();
    for (std::size_t i = 0; i < fewerBefore; ++i)
        if (pairs[i]) result[head + i] = head + *pairs[i];
    return result;
}

}  // namespace drillwave
