// SPDX-License-Identifier: GPL-3.0-or-later
// Computes rows on several threads and passes them to a sink in order.
#pragma once

#include <stop_token>
#include <string>
#include <utility>

#include "core/study/rows/row_counts.h"
#include "core/study/rows/row_sink.h"

namespace drillwave {

/// Base class of a chunk: consecutive rows that one thread computes together. Derived types add the input of
/// these rows.
struct RowChunk {
    RowBlock rows;
    std::string prepared;
};

/// Computes chunks of rows on `jobs` threads and passes them to the sink in order. Returns how many rows
/// were completed and how many of them failed. `Chunk` must derive from RowChunk. `fill` puts the input of
/// the next rows into a chunk. `makeMaker` creates, for each thread, a function maker(Chunk&,
/// std::stop_token) that computes the rows.
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
