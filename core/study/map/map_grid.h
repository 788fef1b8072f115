// SPDX-License-Identifier: GPL-3.0-or-later
// The points of a map: their values, which of them are there, and why some have none.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "core/numeric/ordered_work.h"
#include "core/study/rows/row_block.h"
#include "core/text/message.h"

namespace drillwave {

/// Maximum number of different reasons; all later ones are reported as a single one.
inline constexpr std::size_t maximumMapReasons = 100;

/// Maximum number of points solved before any other: with slow blows of 40 µs they take some 40 ms.
inline constexpr std::size_t coarsestMapPoints = 1024;

/// Values over two axes. Point (column, row) is at the column-th value of x and the row-th of y.
class MapGrid {
  public:
    MapGrid() = default;
    /// Starts without points; requires at least one of xs and of ys (SI), and at most maximumMapPoints in
    /// all.
    MapGrid(std::vector<double> xs, std::vector<double> ys);
    /// A map without points, for a question that has no answer, and why.
    explicit MapGrid(Message refusal) : m_refusal(std::move(refusal)) {}
    const Message& refusal() const { return m_refusal; }  ///< empty where the question has an answer

    std::span<const double> xs() const { return m_xs; }  ///< of the columns [SI]
    std::span<const double> ys() const { return m_ys; }  ///< of the rows [SI]
    std::size_t columns() const { return m_xs.size(); }
    std::size_t rows() const { return m_ys.size(); }
    std::size_t size() const { return m_values.size(); }

    /// Returns the number of present points, solved or not.
    std::size_t done() const { return m_done; }
    bool isComplete() const { return m_done == size(); }
    /// Returns s if every s-th point of every s-th row is present: 1 for all, 0 before the coarsest.
    std::size_t stride() const;
    /// The distance between the points that are solved first: a power of two.
    std::size_t coarsestStride() const { return std::size_t{1} << m_coarsest; }

    bool isThere(std::size_t column, std::size_t row) const { return cell(column, row) != notThere; }
    /// The output, NaN where the point is not there or has none.
    double value(std::size_t column, std::size_t row) const { return m_values[index(column, row)]; }
    /// Why a point that is there could not be solved; empty where it was.
    const Message& reason(std::size_t column, std::size_t row) const;
    struct Place {
        std::size_t column = 0;
        std::size_t row = 0;
        bool operator==(const Place&) const = default;
    };
    /// Returns the place whose value stands for this point until it is there: column and row are rounded down
    /// to the finest grid that has a point there, at most to the coarsest.
    Place standIn(std::size_t column, std::size_t row) const;

    /// The points without a solution by reason, in the order in which each occurred first.
    const std::vector<RowFailure>& failures() const { return m_failures; }
    std::uint64_t failed() const;

    /// A point that was solved, or not and why. Each is set once.
    void set(std::size_t column, std::size_t row, double value);
    void fail(std::size_t column, std::size_t row, const Message& reason);

    /// The smallest and the largest value so far, where they were first; nullopt where there is none.
    struct Extent {
        double least = 0;
        double largest = 0;
        Place leastPlace, largestPlace;
    };
    const std::optional<Extent>& extent() const { return m_extent; }

    /// Returns whether both have the same points with the same values, bit for bit, and the same reasons.
    bool operator==(const MapGrid& other) const;

  private:
    using Cell = std::uint8_t;
    static constexpr Cell notThere = 0;
    static constexpr Cell solved = 1;
    static constexpr Cell firstReason = 2;

    std::size_t index(std::size_t column, std::size_t row) const { return row * m_xs.size() + column; }
    Cell cell(std::size_t column, std::size_t row) const { return m_cells[index(column, row)]; }
    int level(std::size_t column, std::size_t row) const;
    void put(std::size_t column, std::size_t row, Cell cell);

    Message m_refusal;
    std::vector<double> m_xs, m_ys;
    std::vector<double> m_values;  // row after row
    std::vector<Cell> m_cells;     // firstReason + place in m_failures where not solved
    std::vector<RowFailure> m_failures;
    std::optional<Extent> m_extent;
    std::size_t m_done = 0;
    int m_coarsest = 0;  // logarithm of the coarsest stride
    std::vector<std::size_t>
        m_left;  // points that are not there, by the logarithm of the stride they belong to
};

}  // namespace drillwave
