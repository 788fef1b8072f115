// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/map/map_rows.h"

#include <algorithm>
#include <string>

namespace drillwave {

namespace {

constexpr std::size_t blockRows = 512;
constexpr std::size_t width = 3;

void addRow(const MapGrid& grid, std::size_t column, std::size_t row, RowBlock& block) {
    const std::span<double> numbers = block.add();
    numbers[0] = grid.xs()[column];
    numbers[1] = grid.ys()[row];
    numbers[2] = grid.value(column, row);
    if (!grid.isThere(column, row))
        block.fail("stopped before its turn");
    else if (const Message& reason = grid.reason(column, row); !reason.isEmpty())
        block.fail(reason);
}

}  // namespace

RowCounts giveRows(const MapStudy& study, const MapGrid& grid, RowSink& sink) {
    RowCounts counts;
    counts.end = WorkEnd::stopped;
    if (!sink.begin({.copied = {},
                     .columns = {study.x.column(), study.y.column(), {.header = study.output.header()}}}))
        return counts;
    RowBlock block;
    std::string prepared;
    for (std::size_t first = 0; first < grid.size(); first += blockRows) {
        block.restart(first, width);
        for (std::size_t n = first; n < std::min(first + blockRows, grid.size()); ++n)
            addRow(grid, n / grid.rows(), n % grid.rows(), block);
        prepared.clear();
        sink.prepare(block, prepared);
        if (!sink.take(block, prepared)) return counts;
        counts.add(block);
    }
    counts.end = WorkEnd::finished;
    return counts;
}

}  // namespace drillwave
