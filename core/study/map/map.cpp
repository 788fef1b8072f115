// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/map/map.h"

#include <algorithm>
#include <atomic>
#include <cassert>
#include <chrono>
#include <utility>

#include "core/study/map/map_point.h"
#include "core/study/rows/sweep_check.h"
#include "core/text/message.h"

namespace drillwave {

namespace {

using Place = MapGrid::Place;
using Clock = std::chrono::steady_clock;

/// How long a thread is to work on one chunk: what is lost when the map is stopped, and how often it tells.
constexpr auto chunkTime = std::chrono::microseconds(1000);
constexpr std::size_t mostChunkPoints = 512;

/// Counts the points of a grid: every point once, coarse ones first, in rows.
class PlaceCounter {
  public:
    explicit PlaceCounter(const MapGrid& grid)
        : m_columns(grid.columns()),
          m_rows(grid.rows()),
          m_coarsest(grid.coarsestStride()),
          m_stride(m_coarsest) {
        beginRow();
    }

    bool isAtEnd() const { return m_stride == 0; }
    Place place() const { return m_place; }

    void advance() {
        m_place.column += m_step;
        while (!isAtEnd() && m_place.column >= m_columns) {
            m_place.row += m_stride;
            if (m_place.row >= m_rows) {
                m_place.row = 0;
                m_stride /= 2;
            }
            beginRow();
        }
    }

  private:
    /// Of a row that the grid of twice the stride has too, half of the points are there already.
    void beginRow() {
        const bool isNew = m_stride == m_coarsest || m_stride == 0 || m_place.row % (2 * m_stride) != 0;
        m_place.column = isNew ? 0 : m_stride;
        m_step = isNew ? m_stride : 2 * m_stride;
    }

    std::size_t m_columns, m_rows, m_coarsest;
    std::size_t m_stride;  // 0 after the last
    std::size_t m_step = 1;
    Place m_place;
};

struct Chunk {
    std::vector<Place> places;
    std::vector<double> values;
    std::vector<Message> reasons;  // empty where there are none at all
    Clock::duration time{};
};

void solveChunk(MapPoint& point, const MapGrid& grid, Chunk& chunk, const std::stop_token& stop) {
    const auto begin = Clock::now();
    chunk.values.assign(chunk.places.size(), 0);
    chunk.reasons.clear();
    for (std::size_t i = 0; i < chunk.places.size(); ++i) {
        if (stop.stop_requested()) return;
        const auto [column, row] = chunk.places[i];
        Message reason = point.solve(grid.xs()[column], grid.ys()[row], chunk.values[i], stop);
        if (reason.isEmpty()) continue;
        chunk.reasons.resize(chunk.places.size());
        chunk.reasons[i] = std::move(reason);
    }
    chunk.time = Clock::now() - begin;
}

void deliverChunk(const Chunk& chunk, MapGrid& grid) {
    for (std::size_t i = 0; i < chunk.places.size(); ++i) {
        const auto [column, row] = chunk.places[i];
        if (chunk.reasons.empty() || chunk.reasons[i].isEmpty())
            grid.set(column, row, chunk.values[i]);
        else
            grid.fail(column, row, chunk.reasons[i]);
    }
}

/// The number of points that take the time of a chunk, judging by one. It decides on no value.
std::size_t pointsPerChunk(const Chunk& chunk) {
    const double share = std::chrono::duration<double>(chunkTime) / std::max(chunk.time, Clock::duration(1));
    return static_cast<std::size_t>(
        std::clamp(static_cast<double>(chunk.places.size()) * share, 1.0, double{mostChunkPoints}));
}

std::vector<double> valuesOf(const SweepAxis& axis) {
    std::vector<double> values(axis.count);
    for (std::size_t i = 0; i < values.size(); ++i) values[i] = axis.value(i);
    return values;
}

bool isRange(const SweepAxis& axis) {
    return axis.kind == SweepAxis::Kind::linear || axis.kind == SweepAxis::Kind::logarithmic;
}

}  // namespace

std::vector<Message> problemsOf(const MapStudy& study) {
    std::vector<Message> problems;
    for (const SweepAxis& axis : {study.x, study.y})
        if (!isRange(axis))
            problems.emplace_back(
                translatable("the axis %1 of a map needs START:STOP:COUNT or START:STOP:COUNT:log"),
                std::vector<Message>{std::string(axis.key())});
    if (problems.empty() && study.x.count > maximumMapPoints / study.y.count)
        problems.emplace_back(
            translatable(
                "the map has more than %1 points; take fewer, or use `drillwave sweep`, which has no limit"),
            std::vector<Message>{std::to_string(maximumMapPoints)});
    if (!problems.empty()) return problems;
    return problemsOf(Sweep{.base = study.base,
                            .axes = {study.x, study.y},
                            .columns = {study.output},
                            .shard = {},
                            .method = study.method,
                            .workLimit = study.workLimit});
}

MapGrid solveMap(const MapStudy& study, int jobs, std::stop_token stop, const MapProgress& progress) {
    if (Message refusal = inOneLine(problemsOf(study)); !refusal.isEmpty())
        return MapGrid(std::move(refusal));
    MapGrid grid(valuesOf(study.x), valuesOf(study.y));
    PlaceCounter counter(grid);
    std::atomic<std::size_t> chunkPoints = 8;
    const auto fill = [&](Chunk& chunk) {
        chunk.places.clear();
        for (std::size_t left = chunkPoints; left > 0 && !counter.isAtEnd(); --left) {
            chunk.places.push_back(counter.place());
            counter.advance();
        }
        return !chunk.places.empty();
    };
    const auto makeWorker = [&] {
        return [point = MapPoint(study), &grid](Chunk& chunk, const std::stop_token& ending) mutable {
            solveChunk(point, grid, chunk, ending);
        };
    };
    const auto deliver = [&](const Chunk& chunk) {
        deliverChunk(chunk, grid);
        chunkPoints = pointsPerChunk(chunk);
        if (progress) progress(grid);
        return true;
    };
    processInOrder<Chunk>(jobs, std::move(stop), fill, makeWorker, deliver);
    return grid;
}

}  // namespace drillwave
