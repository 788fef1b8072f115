// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/map/contours.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <optional>
#include <utility>

#include "core/numeric/brent.h"
#include "core/numeric/ordered_work.h"
#include "core/study/map/contour_course.h"
#include "core/study/map/map_point.h"
#include "core/text/message.h"

namespace drillwave {

namespace {

/// Where a point is nearer to the level than this, in the same measure as contourAccuracy, it takes the level
/// as far as double precision tells; where it is not, the output jumps.
constexpr double coarsestAccuracy = 1e-9;

/// Result for one crossing, or for the middle of a saddle.
struct Finding {
    std::optional<ContourPoint> point;
    bool isMiddleAbove = false;
    Message reason;  ///< why there is no point
    std::uint64_t solves = 0;
};

/// Solves on the way to a crossing. One for each thread.
class Surveyor {
  public:
    Surveyor(const MapStudy& study, const GridNodes& nodes, double level)
        : m_point(study), m_nodes(nodes), m_level(level) {}

    Finding place(const GridEdge& edge, const std::stop_token& stop) {
        const std::size_t i = edge.i + (edge.isAlongX ? 1 : 0), j = edge.j + (edge.isAlongX ? 0 : 1);
        Sample start{along(edge, edge.i, edge.j), m_nodes.value(edge.i, edge.j)};
        Sample end{along(edge, i, j), m_nodes.value(i, j)};
        const double step = std::max(std::abs(m_level), std::abs(end.value - start.value));
        Finding finding;
        m_below = start.value < m_level ? start : end;
        m_above = start.value < m_level ? end : start;
        bool isIrregular = false;
        const auto miss = [&](double place) {
            Sample sample{place, 0};
            ++finding.solves;
            const double x = edge.isAlongX ? place : m_nodes.x(edge.i);
            const double y = edge.isAlongX ? m_nodes.y(edge.j) : place;
            finding.reason = m_point.solve(x, y, sample.value, stop);
            if (finding.reason.isEmpty() && std::isnan(sample.value))
                finding.reason =
                    m_point.lack().isEmpty() ? translatable("it has no such output") : m_point.lack();
            isIrregular |= m_point.isIrregular();
            if (!finding.reason.isEmpty()) return 0.0;  // ends the search
            (sample.value < m_level ? m_below : m_above) = sample;
            return std::abs(sample.value - m_level) <= contourAccuracy * step ? 0.0 : sample.value - m_level;
        };
        if (best().residual(m_level) > contourAccuracy * step)
            brentRoot(miss, start.place, start.value - m_level, end.place, end.value - m_level);
        if (!finding.reason.isEmpty()) return finding;
        const Sample found = best();
        ContourPoint point{.x = edge.isAlongX ? found.place : m_nodes.x(edge.i),
                           .y = edge.isAlongX ? m_nodes.y(edge.j) : found.place,
                           .value = found.value,
                           .residual = found.residual(m_level),
                           .isIrregular = isIrregular};
        if (point.residual > coarsestAccuracy * step)
            point.jumpWidth = std::abs((m_above.place - m_below.place) / (end.place - start.place));
        finding.point = point;
        return finding;
    }

    Finding lookAtMiddle(const GridSquare& square, const std::stop_token& stop) {
        Finding finding;
        finding.solves = 1;
        double value = 0;
        finding.reason = m_point.solve((m_nodes.x(square.i) + m_nodes.x(square.i + 1)) / 2,
                                       (m_nodes.y(square.j) + m_nodes.y(square.j + 1)) / 2, value, stop);
        finding.isMiddleAbove = finding.reason.isEmpty() && value >= m_level;
        return finding;
    }

  private:
    struct Sample {
        double place = 0;
        double value = 0;
        double residual(double level) const { return std::abs(value - level); }
    };

    double along(const GridEdge& edge, std::size_t i, std::size_t j) const {
        return edge.isAlongX ? m_nodes.x(i) : m_nodes.y(j);
    }
    const Sample& best() const {
        return m_below.residual(m_level) < m_above.residual(m_level) ? m_below : m_above;
    }

    MapPoint m_point;
    const GridNodes& m_nodes;
    double m_level;
    Sample m_below, m_above;  // nearest to the crossing on either side
};

/// Some crossings, and saddles after the last of them, in work.
struct Stretch {
    std::size_t begin = 0, end = 0;
    std::vector<Finding> findings;
};

/// Looks at all of them in parallel; fewer findings after a stop.
std::vector<Finding> survey(const MapStudy& study, const GridNodes& nodes, double level,
                            const ContourCourse& course, int jobs, std::stop_token stop,
                            const ContourProgress& progress) {
    constexpr std::size_t stretchLength = 4;  // of ten or more blows each
    std::vector<Finding> findings;
    findings.reserve(course.size());
    std::size_t next = 0;
    const auto fill = [&](Stretch& stretch) {
        stretch.begin = next;
        stretch.end = next = std::min(next + stretchLength, course.size());
        return stretch.begin < stretch.end;
    };
    const auto makeWorker = [&] {
        return [surveyor = Surveyor(study, nodes, level), &course](Stretch& stretch,
                                                                   const std::stop_token& ending) mutable {
            stretch.findings.clear();
            for (std::size_t n = stretch.begin; n < stretch.end && !ending.stop_requested(); ++n)
                stretch.findings.push_back(
                    n < course.edges.size()
                        ? surveyor.place(course.edges[n], ending)
                        : surveyor.lookAtMiddle(course.squares[course.saddles[n - course.edges.size()]],
                                                ending));
        };
    };
    const auto deliver = [&](Stretch& stretch) {
        std::ranges::move(stretch.findings, std::back_inserter(findings));
        if (progress) progress(findings.size(), course.size());
        return true;
    };
    processInOrder<Stretch>(jobs, std::move(stop), fill, makeWorker, deliver);
    return findings;
}

/// Crossings that belong together, at most two beside each.
class Links {
  public:
    explicit Links(std::size_t crossings) : m_beside(crossings) {}

    void join(std::size_t a, std::size_t b) {
        m_beside[a].push_back(b);
        m_beside[b].push_back(a);
    }
    bool isEnd(std::size_t crossing) const { return m_beside[crossing].size() == 1; }

    /// Follows a line from one of its crossings and forgets it; a closed one comes back to it.
    std::vector<std::size_t> take(std::size_t from) {
        std::vector<std::size_t> line{from};
        while (!m_beside[line.back()].empty()) {
            const std::size_t last = line.back();
            const std::size_t next = m_beside[last].front();
            m_beside[last].erase(m_beside[last].begin());
            std::erase(m_beside[next], last);
            line.push_back(next);
        }
        return line;
    }
    bool isTaken(std::size_t crossing) const { return m_beside[crossing].empty(); }

  private:
    std::vector<std::vector<std::size_t>> m_beside;
};

Links linksOf(const GridNodes& nodes, const ContourCourse& course, const std::vector<Finding>& findings) {
    Links links(course.edges.size());
    const auto join = [&](const GridEdge& a, const GridEdge& b) {
        const std::size_t first = course.numberOf(a), second = course.numberOf(b);
        if (findings[first].point && findings[second].point) links.join(first, second);
    };
    std::size_t saddle = course.edges.size();
    for (const GridSquare& square : course.squares) {
        const auto& [bottom, right, top, left] = square.crossed;
        if (!square.isSaddle()) {
            join(square.crossed[0], square.crossed[1]);
        } else if (findings[saddle++].isMiddleAbove == nodes.isAbove(square.i, square.j)) {
            // The first node is of one piece with the middle: the other two corners are cut off.
            join(bottom, right);
            join(top, left);
        } else {
            join(bottom, left);
            join(right, top);
        }
    }
    return links;
}

std::vector<ContourLine> linesOf(Links links, const std::vector<Finding>& findings, std::size_t crossings) {
    std::vector<ContourLine> lines;
    const auto take = [&](std::size_t from) {
        ContourLine& line = lines.emplace_back();
        for (const std::size_t crossing : links.take(from)) line.push_back(*findings[crossing].point);
    };
    for (std::size_t n = 0; n < crossings; ++n)
        if (links.isEnd(n)) take(n);
    for (std::size_t n = 0; n < crossings; ++n)
        if (!links.isTaken(n)) take(n);
    return lines;
}

}  // namespace

std::uint64_t Contour::pointCount() const {
    std::uint64_t count = 0;
    for (const ContourLine& line : lines)
        count += line.size() - (line.size() > 1 && line.front() == line.back() ? 1 : 0);
    return count;
}

std::uint64_t Contour::jumpCount() const {
    std::uint64_t count = 0;
    for (const ContourLine& line : lines)
        for (std::size_t n = line.size() > 1 && line.front() == line.back() ? 1 : 0; n < line.size(); ++n)
            count += line[n].isJump() ? 1 : 0;
    return count;
}

std::uint64_t Contour::irregularCount() const {
    std::uint64_t count = 0;
    for (const ContourLine& line : lines)
        for (std::size_t n = line.size() > 1 && line.front() == line.back() ? 1 : 0; n < line.size(); ++n)
            count += line[n].isIrregular ? 1 : 0;
    return count;
}

double Contour::worstResidual() const {
    double worst = 0;
    for (const ContourLine& line : lines)
        for (const ContourPoint& point : line)
            if (!point.isJump()) worst = std::max(worst, point.residual);
    return worst;
}

Contour contourOf(const MapStudy& study, const MapGrid& grid, double level, int jobs, std::stop_token stop,
                  const ContourProgress& progress) {
    assert(std::isfinite(level));
    Contour contour{.level = level, .lines = {}, .reason = {}};
    const GridNodes nodes(grid, level);
    const ContourCourse course = courseOf(nodes);
    const std::vector<Finding> findings =
        survey(study, nodes, level, course, jobs, std::move(stop), progress);
    contour.stopped = findings.size() < course.size();
    if (contour.stopped) return contour;
    for (std::size_t n = 0; n < findings.size(); ++n) {
        contour.solves += findings[n].solves;
        if (n >= course.edges.size() || findings[n].point) continue;
        if (contour.unplaced++ == 0) contour.reason = findings[n].reason;
    }
    contour.lines = linesOf(linksOf(nodes, course, findings), findings, course.edges.size());
    return contour;
}

std::optional<ContourExtent> extentOf(const Contour& contour) {
    std::optional<ContourExtent> extent;
    for (const ContourLine& line : contour.lines)
        for (const ContourPoint& point : line) {
            if (!extent) extent = ContourExtent{point, point};
            if (point.y < extent->lowest.y) extent->lowest = point;
            if (point.y > extent->highest.y) extent->highest = point;
        }
    return extent;
}

LevelSide sideOf(const MapGrid& grid, double level) {
    if (grid.rows() < 2) return LevelSide::mixed;
    const auto exceeds = [&](std::size_t row) {
        for (std::size_t column = 0; column < grid.columns(); ++column)
            if (grid.value(column, row) > level) return true;
        return false;
    };
    const bool isAscending = grid.ys().front() < grid.ys().back();
    const bool first = exceeds(0), last = exceeds(grid.rows() - 1);
    if (first == last) return LevelSide::mixed;
    return last == isAscending ? LevelSide::above : LevelSide::below;
}

}  // namespace drillwave
