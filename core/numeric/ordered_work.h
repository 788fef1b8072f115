// SPDX-License-Identifier: GPL-3.0-or-later
// Chunks of rows worked on by several threads and handed over in their order, in bounded memory.
#pragma once

#include <cassert>
#include <condition_variable>
#include <cstddef>
#include <exception>
#include <mutex>
#include <stop_token>
#include <system_error>
#include <thread>
#include <utility>
#include <vector>

namespace drillwave {

/// Reason why a run over rows ended.
enum class WorkEnd {
    finished,  ///< every chunk was delivered
    stopped,   ///< on the stop token, or because `deliver` returned false
};

/// Calls `fill(chunk)` for one chunk after another until it returns false, works on the chunks with one
/// worker per thread, and calls `deliver(chunk)` in the order in which they were filled. Delivered chunks do
/// not depend on the number of threads.
///
/// - `fill(Chunk&) -> bool` runs on any thread, one call at a time.
/// - `makeWorker()` runs once on each thread; the result is called as `worker(Chunk&, std::stop_token)`.
///   Once a stop is requested it may leave its chunk unfinished: such a chunk is not delivered.
/// - `deliver(Chunk&) -> bool` runs on the calling thread; false stops the run.
///
/// Chunks are reused; at most four per thread are in work at once. An exception of any of the three ends the
/// run and leaves this function. If the system provides fewer threads, these do all the work; if it provides
/// none, the calling thread does.
template <typename Chunk, typename Fill, typename MakeWorker, typename Deliver>
WorkEnd processInOrder(int jobs, std::stop_token stop, Fill fill, MakeWorker makeWorker, Deliver deliver) {
    jobs = std::max(jobs, 1);
    struct Place {
        Chunk chunk;
        bool done = false;
    };
    std::mutex mutex;
    std::condition_variable_any changed;
    std::vector<Place> places(static_cast<std::size_t>(jobs) * 4);
    std::size_t filled = 0;     // chunks handed to workers so far
    std::size_t delivered = 0;  // of these, chunks delivered
    bool exhausted = false;
    std::exception_ptr failure;
    std::stop_source ending;  // of the threads, on `stop` or on any early end

    const auto workOnChunks = [&] {
        auto worker = makeWorker();
        std::unique_lock lock(mutex);
        for (;;) {
            const bool ready = changed.wait(lock, ending.get_token(),
                                            [&] { return exhausted || filled - delivered < places.size(); });
            if (!ready || exhausted || ending.stop_requested()) return;
            Place& place = places[filled % places.size()];
            if (!fill(place.chunk)) {
                exhausted = true;
                changed.notify_all();
                return;
            }
            place.done = false;
            ++filled;
            lock.unlock();
            worker(place.chunk, ending.get_token());
            lock.lock();
            place.done = true;
            changed.notify_all();
        }
    };
    const auto runThread = [&] {
        try {
            workOnChunks();
        } catch (...) {
            {
                const std::scoped_lock lock(mutex);
                failure = std::current_exception();
            }
            ending.request_stop();
        }
    };
    const auto deliverChunks = [&] {
        std::unique_lock lock(mutex);
        for (;;) {
            changed.wait(lock, ending.get_token(), [&] {
                return delivered < filled ? places[delivered % places.size()].done : exhausted;
            });
            if (ending.stop_requested()) return WorkEnd::stopped;
            if (delivered == filled) return WorkEnd::finished;
            lock.unlock();
            const bool goOn = deliver(places[delivered % places.size()].chunk);
            lock.lock();
            if (!goOn) return WorkEnd::stopped;
            ++delivered;
            changed.notify_all();
        }
    };

    const auto workAlone = [&] {
        auto worker = makeWorker();
        Chunk& chunk = places.front().chunk;
        while (!ending.stop_requested() && fill(chunk)) {
            worker(chunk, ending.get_token());
            if (ending.stop_requested() || !deliver(chunk)) return WorkEnd::stopped;
        }
        return ending.stop_requested() ? WorkEnd::stopped : WorkEnd::finished;
    };

    WorkEnd end = WorkEnd::stopped;
    {
        std::vector<std::jthread> threads;
        const std::stop_callback relay(stop, [&ending] { ending.request_stop(); });
        // Declared after the threads, to make them stop before they are joined, also on an exception.
        struct EndThreads {
            std::stop_source& ending;
            ~EndThreads() { ending.request_stop(); }
        } endThreads{ending};
        for (int i = 0; i < jobs; ++i) {
            try {
                threads.emplace_back(runThread);
            } catch (const std::system_error&) {
                break;  // fewer will do
            }
        }
        end = threads.empty() ? workAlone() : deliverChunks();
    }
    if (failure) std::rethrow_exception(failure);
    return end;
}

}  // namespace drillwave
