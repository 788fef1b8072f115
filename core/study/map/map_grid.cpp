// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/map/map_grid.h"

#include <algorithm>
#include <bit>
#include <cassert>
#include <cmath>
#include <limits>
#include <utility>

namespace drillwave {

namespace {

constexpr double none = std::numeric_limits<double>::quiet_NaN();

}  // namespace

std::optional<std::size_t> nearestIndex(std::span<const double> values, bool isLogarithmic, double at) {
    if (values.empty()) return std::nullopt;
    const double first = values.front(), last = values.back();
    if (first == last) return 0;
    const double share =
        isLogarithmic ? std::log(at / first) / std::log(last / first) : (at - first) / (last - first);
    const double index = std::round(share * static_cast<double>(values.size() - 1));
    if (!(index >= 0 && index < static_cast<double>(values.size()))) return std::nullopt;  // NaN as well
    return static_cast<std::size_t>(index);
}

MapGrid::MapGrid(std::vector<double> xs, std::vector<double> ys)
    : m_xs(std::move(xs)),
      m_ys(std::move(ys)),
      m_values(m_xs.size() * m_ys.size(), none),
      m_cells(m_values.size(), notThere) {
    assert(!m_values.empty());
    const auto pointsOf = [&](int level) {
        const std::size_t stride = std::size_t{1} << level;
        return ((columns() - 1) / stride + 1) * ((rows() - 1) / stride + 1);
    };
    while (pointsOf(m_coarsest) > coarsestMapPoints) ++m_coarsest;
    for (int level = 0; level < m_coarsest; ++level) m_left.push_back(pointsOf(level) - pointsOf(level + 1));
    m_left.push_back(pointsOf(m_coarsest));
}

std::size_t MapGrid::stride() const {
    std::size_t finest = 0;
    for (int level = m_coarsest;
         level >= 0 && !m_left.empty() && m_left[static_cast<std::size_t>(level)] == 0; --level)
        finest = std::size_t{1} << level;
    return finest;
}

int MapGrid::level(std::size_t column, std::size_t row) const {
    return std::min({std::countr_zero(column), std::countr_zero(row), m_coarsest});
}

const Message& MapGrid::reason(std::size_t column, std::size_t row) const {
    const Cell found = cell(column, row);
    static const Message none;
    return found < firstReason ? none : m_failures[std::size_t{found} - firstReason].reason;
}

MapGrid::Place MapGrid::standIn(std::size_t column, std::size_t row) const {
    Place place{column, row};
    for (std::size_t stride = 2; !isThere(place.column, place.row) && stride <= coarsestStride(); stride *= 2)
        place = {column & ~(stride - 1), row & ~(stride - 1)};
    return place;
}

std::uint64_t MapGrid::failed() const {
    std::uint64_t sum = 0;
    for (const RowFailure& failure : m_failures) sum += failure.rows;
    return sum;
}

void MapGrid::put(std::size_t column, std::size_t row, Cell cell) {
    assert(!isThere(column, row));
    m_cells[index(column, row)] = cell;
    ++m_done;
    --m_left[static_cast<std::size_t>(level(column, row))];
}

void MapGrid::set(std::size_t column, std::size_t row, double value) {
    m_values[index(column, row)] = value;
    put(column, row, solved);
    if (std::isnan(value)) return;
    const Place place{column, row};
    if (!m_extent) m_extent = {value, value, place, place};
    if (value < m_extent->least) {
        m_extent->least = value;
        m_extent->leastPlace = place;
    } else if (value > m_extent->largest) {
        m_extent->largest = value;
        m_extent->largestPlace = place;
    }
}

void MapGrid::fail(std::size_t column, std::size_t row, const Message& reason) {
    const bool isKnown = std::ranges::find(m_failures, reason, &RowFailure::reason) != m_failures.end();
    const bool isFull = m_failures.size() + 1 >= maximumMapReasons;
    const std::size_t place =
        addFailure(m_failures, {isKnown || !isFull ? reason : Message(translatable("other reasons")), 1});
    put(column, row, static_cast<Cell>(firstReason + place));
}

bool MapGrid::operator==(const MapGrid& other) const {
    const auto bits = [](double value) { return std::bit_cast<std::uint64_t>(value); };
    return m_xs == other.m_xs && m_ys == other.m_ys && m_cells == other.m_cells &&
           m_failures == other.m_failures && std::ranges::equal(m_values, other.m_values, {}, bits, bits);
}

}  // namespace drillwave
