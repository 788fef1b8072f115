// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/rows/row_block.h"

#include <algorithm>
#include <cassert>
#include <limits>
#include <utility>

namespace drillwave {

std::size_t addFailure(std::vector<RowFailure>& failures, const RowFailure& more) {
    const auto same = std::ranges::find(failures, more.reason, &RowFailure::reason);
    const auto place = static_cast<std::size_t>(same - failures.begin());
    if (same == failures.end())
        failures.push_back(more);
    else
        same->rows += more.rows;
    return place;
}

void RowBlock::restart(std::uint64_t first, std::size_t width) {
    m_first = first;
    m_width = width;
    m_numbers.clear();
    m_failureOf.clear();
    m_failures.clear();
    m_copied = {};
}

std::span<double> RowBlock::add() {
    m_failureOf.push_back(solved);
    m_numbers.resize(m_numbers.size() + m_width, std::numeric_limits<double>::quiet_NaN());
    return std::span(m_numbers).last(m_width);
}

void RowBlock::fail(Message reason) {
    assert(!m_failureOf.empty() && !reason.isEmpty());
    m_failureOf.back() = addFailure(m_failures, {std::move(reason), 1});
}

}  // namespace drillwave
