// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/curve/curve_points.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "core/study/curve/curve_cells.h"
#include "core/study/rows/study_plan.h"

namespace drillwave {

namespace {

constexpr double farthestPoints = 1.0 / 500;
constexpr double nearestPoints = 1e-9;
constexpr int leastPartsOfGrid = 16;

/// Where a piece is rough in detail: closer than other points where it is narrow.
void addGrid(std::vector<double>& places, const FitPiece& piece) {
    for (int i = 1; i < leastPartsOfGrid; ++i)
        places.push_back(piece.start + (piece.end - piece.start) * i / leastPartsOfGrid);
}

/// The points in a piece, from its start to its end.
std::vector<double> pointsIn(const FitPiece& piece, std::span<const double> points) {
    std::vector<double> inside{piece.start};
    for (const double share : points)
        if (share > piece.start && share < piece.end) inside.push_back(share);
    inside.push_back(piece.end);
    return inside;
}

/// A straight line between two points; off by no more than they differ, in all likelihood.
FitPiece straightPiece(const FitSample& a, const FitSample& b) {
    FitPiece piece = openPiece(a.x, b.x);
    piece.solved = a.solved && b.solved;
    piece.label = a.label;
    if (!piece.solved) return piece;
    const std::array ends{a.values[0], b.values[0]};
    piece.outputs.emplace_back(a.x, b.x, ends);
    piece.error.push_back(std::abs(ends[1] - ends[0]) + std::max(a.error, b.error));
    return piece;
}

const LinePoint& pointAt(std::span<const LinePoint> points, double share) {
    return *std::ranges::lower_bound(points, share, {}, &LinePoint::share);
}

}  // namespace

std::vector<double> pointsOf(const CurveLine& line) {
    std::vector<double> all{0, 1};
    for (const CurveOutput& output : line.outputs) {
        const std::vector<double> places = samplePlaces(output.pieces, farthestPoints);
        all.insert(all.end(), places.begin(), places.end());
        for (const FitPiece& piece : output.pieces) {
            if (!piece.solved) all.push_back(piece.start / 2 + piece.end / 2);
            if (isOpen(piece)) addGrid(all, piece);
        }
    }
    std::ranges::sort(all);
    std::vector<double> points{0};
    for (const double share : all)
        if (share - points.back() > nearestPoints && 1 - share > nearestPoints) points.push_back(share);
    points.push_back(1);
    return points;
}

std::vector<double> openPointsOf(const CurveLine& line, std::span<const double> points) {
    std::vector<double> open;
    for (const CurveOutput& output : line.outputs)
        for (const FitPiece& piece : output.pieces) {
            if (!isOpen(piece)) continue;
            const std::vector<double> inside = pointsIn(piece, points);
            open.insert(open.end(), inside.begin(), inside.end());
        }
    std::ranges::sort(open);
    open.erase(std::ranges::unique(open).begin(), open.end());
    return open;
}

void PointSolver::operator()(PointTask& task, const std::stop_token& stop) const {
    CurveSampler sampler(m_question, m_axes, task.line, stop, studyPlan(m_question.base).curvePart);
    task.points.clear();
    for (const double share : task.shares) {
        LinePoint& point = task.points.emplace_back();
        point.share = share;
        for (std::size_t i = 0; i < m_question.columns.size() && !stop.stop_requested(); ++i) {
            point.outputs.push_back(sampler(share, i));
            point.reasons.push_back(point.outputs.back().solved ? Message() : sampler.reason());
        }
    }
    task.solves = sampler.solves();
    task.effort = sampler.effort();
}

void fillPieces(CurveLine& line, std::size_t i, std::span<const double> points,
                std::span<const LinePoint> solved) {
    CurveOutput& output = line.outputs[i];
    std::vector<FitPiece> filled;
    for (FitPiece& piece : output.pieces) {
        if (!isOpen(piece)) {
            filled.push_back(std::move(piece));
            continue;
        }
        const std::vector<double> nodes = pointsIn(piece, points);
        for (std::size_t n = 0; n + 1 < nodes.size(); ++n) {
            const LinePoint& a = pointAt(solved, nodes[n]);
            const LinePoint& b = pointAt(solved, nodes[n + 1]);
            filled.push_back(straightPiece(a.outputs[i], b.outputs[i]));
            if (!filled.back().solved)
                addStretch(output.unsolved, line.range, filled.back(),
                           a.reasons[i].isEmpty() ? b.reasons[i] : a.reasons[i]);
        }
    }
    output.pieces = std::move(filled);
}

}  // namespace drillwave
