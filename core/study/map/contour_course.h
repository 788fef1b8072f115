// SPDX-License-Identifier: GPL-3.0-or-later
// Finds which edges of a grid a contour crosses.
#pragma once

#include <array>
#include <cmath>
#include <compare>
#include <cstddef>
#include <vector>

#include "core/study/map/map_grid.h"

namespace drillwave {

/// Points of a map from which a contour at one level is found: the finest grid of points that is completely
/// computed (see MapGrid::stride()). Stores a reference to the map, which must outlive this object.
class GridNodes {
  public:
    GridNodes(const MapGrid& grid, double level)
        : m_grid(grid),
          m_level(level),
          m_stride(grid.stride()),
          m_columns(m_stride ? (grid.columns() - 1) / m_stride + 1 : 0),
          m_rows(m_stride ? (grid.rows() - 1) / m_stride + 1 : 0) {}

    std::size_t columns() const { return m_columns; }
    std::size_t rows() const { return m_rows; }
    double x(std::size_t i) const { return m_grid.xs()[i * m_stride]; }
    double y(std::size_t j) const { return m_grid.ys()[j * m_stride]; }
    double value(std::size_t i, std::size_t j) const { return m_grid.value(i * m_stride, j * m_stride); }
    bool hasValue(std::size_t i, std::size_t j) const { return !std::isnan(value(i, j)); }
    bool isAbove(std::size_t i, std::size_t j) const { return value(i, j) >= m_level; }

  private:
    const MapGrid& m_grid;
    double m_level;
    std::size_t m_stride, m_columns, m_rows;
};

/// Edge of the grid of a map: from point (i, j) to the next point along x or along y.
struct GridEdge {
    std::size_t i = 0, j = 0;
    bool isAlongX = true;
    auto operator<=>(const GridEdge&) const = default;  // NOLINT(modernize-use-nullptr): its 0
};

/// Square of the grid whose lower left corner is point (i, j), with its edges that the contour crosses: two
/// or all four.
struct GridSquare {
    std::size_t i = 0, j = 0;
    std::array<GridEdge, 4> crossed;  // crossed edges; if all four, in the order bottom, right, top, left
    std::size_t count = 0;
    bool isSaddle() const { return count == 4; }
};

/// Edges and squares of a grid through which a contour passes. A square with all four edges crossed is called
/// a saddle: its contour points can be connected in two ways.
struct ContourCourse {
    std::vector<GridEdge> edges;  ///< crossed edges, ascending, each once
    std::vector<GridSquare> squares;
    /// Indices into `squares` of the saddles: squares with all four edges crossed.
    std::vector<std::size_t> saddles;

    std::size_t size() const { return edges.size() + saddles.size(); }
    /// Returns the index of an edge in `edges`. Requires that the contour crosses the edge.
    std::size_t numberOf(const GridEdge& edge) const;
};

/// Returns the edges and squares of the grid through which the contour passes, and which squares are saddles.
/// Squares are left out if one of their corners has no value.
ContourCourse courseOf(const GridNodes& nodes);

}  // namespace drillwave
