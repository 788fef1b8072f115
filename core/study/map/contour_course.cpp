// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/map/contour_course.h"

#include <algorithm>
#include <optional>
#include <utility>

namespace drillwave {

namespace {

std::optional<GridSquare> squareAt(const GridNodes& nodes, std::size_t i, std::size_t j) {
    for (const auto& [a, b] : {std::pair{i, j}, {i + 1, j}, {i, j + 1}, {i + 1, j + 1}})
        if (!nodes.hasValue(a, b)) return std::nullopt;
    GridSquare square{.i = i, .j = j, .crossed = {}};
    const auto add = [&](const GridEdge& edge) {
        const bool end = nodes.isAbove(edge.i + (edge.isAlongX ? 1 : 0), edge.j + (edge.isAlongX ? 0 : 1));
        if (nodes.isAbove(edge.i, edge.j) != end) square.crossed[square.count++] = edge;
    };
    add({i, j, true});
    add({i + 1, j, false});
    add({i, j + 1, true});
    add({i, j, false});
    if (square.count == 0) return std::nullopt;
    return square;
}

}  // namespace

std::size_t ContourCourse::numberOf(const GridEdge& edge) const {
    return static_cast<std::size_t>(std::ranges::lower_bound(edges, edge) - edges.begin());
}

ContourCourse courseOf(const GridNodes& nodes) {
    ContourCourse course;
    for (std::size_t j = 0; j + 1 < nodes.rows(); ++j)
        for (std::size_t i = 0; i + 1 < nodes.columns(); ++i)
            if (const std::optional<GridSquare> square = squareAt(nodes, i, j)) {
                if (square->isSaddle()) course.saddles.push_back(course.squares.size());
                course.squares.push_back(*square);
                course.edges.insert(course.edges.end(), square->crossed.begin(),
                                    square->crossed.begin() + static_cast<std::ptrdiff_t>(square->count));
            }
    std::ranges::sort(course.edges);
    course.edges.erase(std::ranges::unique(course.edges).begin(), course.edges.end());
    return course;
}

}  // namespace drillwave
