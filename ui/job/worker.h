// SPDX-License-Identifier: GPL-3.0-or-later
// Thread for tasks that replace each other: of several waiting tasks only the newest is run.
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

/// Worker that runs tasks one at a time outside the window's thread. While a task runs, only the newest of
/// the arriving tasks is kept. If another task waits, a task that has run for `patience` is stopped. Results
/// are delivered in the order of the tasks.
class Worker : public QObject {
    Q_OBJECT

  public:
    /// Function that delivers a task's result; called in the window's thread.
    using Delivery = std::function<void()>;
    /// Function that runs in the worker's thread and must not throw. On `stop` it may end early.
    using Task = std::function<Delivery(const std::stop_token& stop)>;

    /// Priority of the worker's thread. With `background`, the window's thread goes first: on Linux the nice
    /// value of the thread and of threads started by its tasks is higher by 5.
    enum class Urgency { answer, background };

    explicit Worker(Urgency urgency = Urgency::answer, QObject* parent = nullptr);
    /// Stops the present task and waits for its end.
    ~Worker() override;

    void submit(Task task);
    /// Drops the waiting task, stops the present one, and discards its result.
    void cancel();
    /// Waits until the worker's thread is idle. Call cancel() first.
    void waitForThread();
    /// Returns true from the start of a task until its result is delivered.
    bool isBusy() const { return m_busy; }

  private:
    /// Time after which a task may be stopped for a waiting one. While the user drags a value, every result
    /// that takes less is shown.
    static constexpr std::chrono::milliseconds patience{250};

    void start(Task task);
    void finish();
    void work(Urgency urgency);

    // Used only in the window's thread.
    Task m_waiting;
    bool m_busy = false;      // true from start() to finish(), which is called by the event loop
    bool m_dropped = false;   // the result of the present task is not wanted any more
    std::stop_source m_stop;  // stops the present task
    QTimer m_patience;        // until it expires, the present task is not stopped for a waiting one

    // Shared by the two threads; protected by m_lock.
    std::mutex m_lock;
    std::condition_variable m_changed;
    Task m_task;  // task to run, from start() until it is done
    std::stop_token m_taskStop;
    Delivery m_delivery;
    bool m_ending = false;

    std::thread m_thread;
};

}  // namespace drillwave
