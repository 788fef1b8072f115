// SPDX-License-Identifier: GPL-3.0-or-later
// Processing of blocks of rows by several threads, with results delivered in order and in bounded memory.
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

/// Reason why processInOrder() returned.
enum class WorkEnd {
    finished,  ///< every chunk was delivered
    stopped,   ///< a stop was requested, or `deliver` returned false
};

/// Processes a sequence of chunks, such as blocks of table rows, on `jobs` threads, and delivers them in
/// their original order. `fill` fills one chunk after another until it returns false, a worker processes the
/// chunk, and `deliver` takes the result. Returns whether all chunks were delivered. The results do not
/// depend on the number of threads.
///
/// - `fill(Chunk&) -> bool` runs on any thread, one call at a time.
/// - `makeWorker()` runs once on each thread; its result is called as `worker(Chunk&, std::stop_token)`.
///   After a stop request the worker may leave its chunk unfinished: such a chunk is not delivered.
/// - `deliver(Chunk&) -> bool` runs on the calling thread; false stops the run.
///
/// Chunk objects are used again for later chunks; at most four per thread exist. An exception in any of these
/// functions stops the run and is rethrown to the caller. If the system provides fewer threads than `jobs`,
/// these do all the work. If it provides none, the calling thread does the work.
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
    std::size_t filled = 0;     // chunks filled so far
    std::size_t delivered = 0;  // chunks delivered so far
    bool exhausted = false;
    std::exception_ptr failure;
    std::stop_source ending;  // stop of the threads, because of `stop` or of an early end

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
        // Declared after the threads, so that they are asked to stop before they are joined, also on an
        // exception.
        struct EndThreads {
            std::stop_source& ending;
            ~EndThreads() { ending.request_stop(); }
        } endThreads{ending};
        for (int i = 0; i < jobs; ++i) {
            try {
                threads.emplace_back(runThread);
            } catch (const std::system_error&) {
                break;  // fewer threads are sufficient
            }
        }
        end = threads.empty() ? workAlone() : deliverChunks();
    }
    if (failure) std::rethrow_exception(failure);
    return end;
}

}  // namespace drillwave
