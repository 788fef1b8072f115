// SPDX-License-Identifier: GPL-3.0-or-later
// Rows made on several threads and given to a sink in their order.
#pragma once

#include <stop_token>
#include <string>
#include <utility>

#include "core/study/rows/row_counts.h"
#include "core/study/rows/row_sink.h"

namespace drillwave {

/// Common part of all chunks of rows; makers of rows add the origin of theirs.
struct RowChunk {
    RowBlock rows;
    std::string prepared;
};

/// Runs processInOrder() over chunks that are RowChunks: `fill` takes the next piece of work, a maker (one
/// for each thread) makes its rows as `maker(Chunk&, std::stop_token)`, the sink takes them.
template <typename Chunk, typename Fill, typename MakeMaker>
RowCounts runRows(int jobs, std::stop_token stop, Fill fill, MakeMaker makeMaker, const RowHeader& header,
                  RowSink& sink, const RowProgress& progress) {
    RowCounts counts;
    if (!sink.begin(header)) return {.failures = {}, .end = WorkEnd::stopped};
    const auto makeWorker = [&] {
        return [maker = makeMaker(), &sink](Chunk& chunk, std::stop_token ending) mutable {
            maker(chunk, ending);
            if (ending.stop_requested()) return;
            chunk.prepared.clear();
            sink.prepare(chunk.rows, chunk.prepared);
        };
    };
    const auto deliver = [&](Chunk& chunk) {
        if (!sink.take(chunk.rows, chunk.prepared)) return false;
        counts.add(chunk.rows);
        if (progress) progress(counts);
        return true;
    };
    counts.end = processInOrder<Chunk>(jobs, stop, std::move(fill), makeWorker, deliver);
    return counts;
}

}  // namespace drillwave
