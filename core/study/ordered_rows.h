// Chunks of rows worked on by several threads and handed over in their order, in bounded memory.
#pragma once

#include <condition_variable>
#include <cstddef>
#include <exception>
#include <mutex>
#include <stop_token>
#include <thread>
#include <utility>
#include <vector>

namespace drillwave {

/// What ended a run over rows.
enum class RowsEnd {
    finished,  ///< every chunk was emitted
    stopped,   ///< on the stop token, or because `emit` returned false
};

/// Calls `fill(chunk)` for one chunk after another until it returns false, works on the chunks with one
/// worker per thread, and calls `emit(chunk)` in the order in which they were filled. What is emitted does
/// not depend on the number of threads.
///
/// - `fill(Chunk&) -> bool` runs on any thread, one call at a time.
/// - `makeWorker()` runs once on each thread; the result is called as `worker(Chunk&, std::stop_token)`. Once
/// a stop
///   is requested it may leave its chunk unfinished: such a chunk is not emitted.
/// - `emit(Chunk&) -> bool` runs on the calling thread; false stops the run.
///
/// Chunks are reused, at most four for each thread are in work at once. An exception of any of the three ends
/// the run and leaves this function.
template <typename Chunk, typename Fill, typename MakeWorker, typename Emit>
RowsEnd processInOrder(int jobs, std::stop_token stop, Fill fill, MakeWorker makeWorker, Emit emit) {
    struct Slot {
        Chunk chunk;
        bool done = false;
    };
    std::mutex mutex;
    std::condition_variable_any changed;
    std::vector<Slot> slots(static_cast<std::size_t>(jobs) * 4);
    std::size_t filled = 0;   // chunks handed to workers so far
    std::size_t emitted = 0;  // of these, chunks emitted
    bool exhausted = false;
    std::exception_ptr failure;
    std::stop_source ending;  // of the threads, on `stop` or on any early end

    const auto workOnChunks = [&] {
        auto worker = makeWorker();
        std::unique_lock lock(mutex);
        for (;;) {
            const bool ready = changed.wait(lock, ending.get_token(),
                                            [&] { return exhausted || filled - emitted < slots.size(); });
            if (!ready || exhausted || ending.stop_requested()) return;
            Slot& slot = slots[filled % slots.size()];
            if (!fill(slot.chunk)) {
                exhausted = true;
                changed.notify_all();
                return;
            }
            slot.done = false;
            ++filled;
            lock.unlock();
            worker(slot.chunk, ending.get_token());
            lock.lock();
            slot.done = true;
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
    const auto emitChunks = [&] {
        std::unique_lock lock(mutex);
        for (;;) {
            changed.wait(lock, ending.get_token(),
                         [&] { return emitted < filled ? slots[emitted % slots.size()].done : exhausted; });
            if (ending.stop_requested()) return RowsEnd::stopped;
            if (emitted == filled) return RowsEnd::finished;
            lock.unlock();
            const bool goOn = emit(slots[emitted % slots.size()].chunk);
            lock.lock();
            if (!goOn) return RowsEnd::stopped;
            ++emitted;
            changed.notify_all();
        }
    };

    RowsEnd end = RowsEnd::stopped;
    {
        std::vector<std::jthread> threads;
        const std::stop_callback relay(stop, [&ending] { ending.request_stop(); });
        // Declared after the threads: they are told to end before they are joined, also on an exception.
        struct EndThreads {
            std::stop_source& ending;
            ~EndThreads() { ending.request_stop(); }
        } endThreads{ending};
        for (int i = 0; i < jobs; ++i) threads.emplace_back(runThread);
        end = emitChunks();
    }
    if (failure) std::rethrow_exception(failure);
    return end;
}

}  // namespace drillwave
