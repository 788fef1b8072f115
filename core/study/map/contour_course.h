// SPDX-License-Identifier: GPL-3.0-or-later
// Which lines between the points of a grid a contour crosses.
#pragma once

#include <array>
#include <cmath>
#include <compare>
#include <cstddef>
#include <vector>

#include "core/study/map/map_grid.h"

namespace drillwave {

/// The points of a grid that are there in every row and column: its nodes, some of them above a level. The
/// grid must outlive it.
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

/// The line from a node to the next one along x or along y.
struct GridEdge {
    std::size_t i = 0, j = 0;
    bool isAlongX = true;
    auto operator<=>(const GridEdge&) const = default;  // NOLINT(modernize-use-nullptr): its 0
};

/// Square that begins at a node, with those of its edges that the contour crosses: two, or all four.
struct GridSquare {
    std::size_t i = 0, j = 0;
    std::array<GridEdge, 4> crossed;  // all four in the order bottom, right, top, left
    std::size_t count = 0;
    bool isSaddle() const { return count == 4; }
};

/// Edges, squares and saddles that a contour passes.
struct ContourCourse {
    std::vector<GridEdge> edges;  ///< ascending, each once
    std::vector<GridSquare> squares;
    std::vector<std::size_t> saddles;  ///< of the squares

    std::size_t size() const { return edges.size() + saddles.size(); }
    /// Returns the number of an edge.
    std::size_t numberOf(const GridEdge& edge) const;
};

/// Returns the course of the contour of the level of the nodes. Leaves out squares with a node without value.
ContourCourse courseOf(const GridNodes& nodes);

}  // namespace drillwave
