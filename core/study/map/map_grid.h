// SPDX-License-Identifier: GPL-3.0-or-later
// Grid of a map: the values of its points, which points are present, and why some have no value.
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

/// Maximum number of different reasons for unsolved points that a map stores. All further reasons are counted
/// together under "other reasons".
inline constexpr std::size_t maximumMapReasons = 100;

/// Maximum number of points in the coarse grid that is solved first, to show a preview. If a blow takes 40
/// µs, this grid takes about 40 ms.
inline constexpr std::size_t coarsestMapPoints = 1024;

/// Returns the index of the value nearest to `at`, for example to find the point under the mouse pointer. The
/// values have equal steps, or equal ratios if `isLogarithmic`. Empty if `at` is more than half a step
/// outside their range.
std::optional<std::size_t> nearestIndex(std::span<const double> values, bool isLogarithmic, double at);

/// Grid of a map: values of an output over two parameters. Point (column, row) has value number `column` of x
/// and value number `row` of y, both from 0.
class MapGrid {
  public:
    MapGrid() = default;
    /// Creates a map in which no point is computed yet. Requires at least one value in xs and in ys (SI), and
    /// at most maximumMapPoints points.
    MapGrid(std::vector<double> xs, std::vector<double> ys);
    /// Creates a map without points, with the reason why the map cannot be computed.
    explicit MapGrid(Message refusal) : m_refusal(std::move(refusal)) {}
    /// Returns why no point of the map can be computed; empty if the map can be computed.
    const Message& refusal() const { return m_refusal; }

    /// Returns the x value of each column, in SI units.
    std::span<const double> xs() const { return m_xs; }
    /// Returns the y value of each row, in SI units.
    std::span<const double> ys() const { return m_ys; }
    std::size_t columns() const { return m_xs.size(); }
    std::size_t rows() const { return m_ys.size(); }
    std::size_t size() const { return m_values.size(); }

    /// Returns the number of points computed so far, whether solved or failed.
    std::size_t done() const { return m_done; }
    bool isComplete() const { return m_done == size(); }
    /// Returns the spacing s of the finest grid of points that is completely computed: every s-th column and
    /// row. It is 1 if all points are computed, 0 if even the coarsest grid is incomplete.
    std::size_t stride() const;
    /// Returns the spacing of the coarsest grid, which is solved first: a power of two. For example, 4 means
    /// every fourth column and row.
    std::size_t coarsestStride() const { return std::size_t{1} << m_coarsest; }

    bool isThere(std::size_t column, std::size_t row) const { return cell(column, row) != notThere; }
    /// Returns the output at a point; NaN if the point is not yet computed or has no value.
    double value(std::size_t column, std::size_t row) const { return m_values[index(column, row)]; }
    /// Returns why a computed point could not be solved; empty if it was solved.
    const Message& reason(std::size_t column, std::size_t row) const;
    struct Place {
        std::size_t column = 0;
        std::size_t row = 0;
        bool operator==(const Place&) const = default;
    };
    /// Returns the point whose value is shown at the given point while the map is being computed. It is the
    /// point itself if that is computed. Otherwise column and row are rounded down to a coarser grid of
    /// computed points.
    Place standIn(std::size_t column, std::size_t row) const;

    /// Returns the number of unsolved points by reason, in the order in which the reasons first occurred.
    const std::vector<RowFailure>& failures() const { return m_failures; }
    std::uint64_t failed() const;

    /// Stores the value of a solved point. Each point may be set only once, by set() or fail().
    void set(std::size_t column, std::size_t row, double value);
    /// Stores the reason why a point was not solved. Each point may be set only once, by set() or fail().
    void fail(std::size_t column, std::size_t row, const Message& reason);

    /// Smallest and largest value of the points solved so far, and the points where they first occurred.
    struct Extent {
        double least = 0;
        double largest = 0;
        Place leastPlace, largestPlace;
    };
    /// Returns the smallest and largest value of the points solved so far; empty if no point has a value.
    const std::optional<Extent>& extent() const { return m_extent; }

    /// Returns whether both maps have the same points with bit-identical values and the same reasons.
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
    std::vector<Cell> m_cells;     // firstReason + index into m_failures if not solved
    std::vector<RowFailure> m_failures;
    std::optional<Extent> m_extent;
    std::size_t m_done = 0;
    int m_coarsest = 0;  // binary logarithm of the coarsest spacing
    std::vector<std::size_t>
        m_left;  // points that are not present, by the binary logarithm of the spacing to which they belong
};

}  // namespace drillwave
