// SPDX-License-Identifier: GPL-3.0-or-later
// One thread for tasks that replace each other: of the waiting ones, only the newest is done.
#pragma once

#include <QObject>
#include <QTimer>
#include <chrono>
#include <condition_variable>
#include <functional>
#include <mutex>
#include <stop_token>
#include <thread>

namespace drillwave {

/// Runs tasks one at a time, away from the window's thread. While one is in flight only the newest of those
/// that arrive is kept; one that has been in flight for long is stopped when another is waiting. Deliveries
/// come in the order of their tasks.
class Worker : public QObject {
    Q_OBJECT

  public:
    /// Work that a task leaves for the window's thread.
    using Delivery = std::function<void()>;
    /// Runs on the worker's thread, throws nothing. It may ignore `stop`, or end early on it.
    using Task = std::function<Delivery(const std::stop_token& stop)>;

    /// Work in the background leaves the processors to the window's thread whenever that has something to
    /// do: on Linux the thread and all that its tasks start are nicer by 5.
    enum class Urgency { answer, background };

    explicit Worker(Urgency urgency = Urgency::answer, QObject* parent = nullptr);
    /// Stops the task in flight and waits for its end.
    ~Worker() override;

    void submit(Task task);
    /// Forgets what is waiting, stops what is in flight, and drops its delivery.
    void cancel();
    /// Until nothing is done on the worker's thread any more. Call cancel() first.
    void waitForThread();
    /// Whether a task is between its start and its delivery.
    bool isBusy() const { return m_busy; }

  private:
    /// While values are dragged every answer that takes less is seen.
    static constexpr std::chrono::milliseconds patience{250};

    void start(Task task);
    void finish();
    void work(Urgency urgency);

    // Seen by the window's thread only.
    Task m_waiting;
    bool m_busy = false;      // from start() to finish(), which comes through the event loop
    bool m_dropped = false;   // nobody wants what is in flight any more
    std::stop_source m_stop;  // of what is in flight
    QTimer m_patience;        // runs out when what is in flight may be stopped for what is waiting

    // Shared by the two threads, under the lock.
    std::mutex m_lock;
    std::condition_variable m_changed;
    Task m_task;  // from start() until it is done
    std::stop_token m_taskStop;
    Delivery m_delivery;
    bool m_ending = false;

    std::thread m_thread;
};

}  // namespace drillwave
