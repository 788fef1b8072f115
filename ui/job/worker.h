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

/// Worker that runs tasks one at a time in its own thread. If several tasks arrive while one runs, only the
/// newest of them is kept. A running task may be stopped for a waiting one after the time `patience`. Results
/// are delivered in the order of the tasks.
class Worker : public QObject {
    Q_OBJECT

  public:
    /// Function that delivers the result of a task; called in the window's thread.
    using Delivery = std::function<void()>;
    /// Task: a function that runs in the worker's thread and must not throw. When `stop` is requested it may
    /// end early. It returns the function that delivers its result.
    using Task = std::function<Delivery(const std::stop_token& stop)>;

    /// Priority of the worker's thread: `answer` is normal, `background` is lower than that of the window's
    /// thread. On Linux, `background` raises the nice value of the thread, and of threads that its tasks
    /// start, by 5.
    enum class Urgency { answer, background };

    explicit Worker(Urgency urgency = Urgency::answer, QObject* parent = nullptr);
    /// Stops the task in progress and waits for its end.
    ~Worker() override;

    void submit(Task task);
    /// Discards the waiting task, stops the one in progress, and discards its result.
    void cancel();
    /// Waits until the worker's thread is idle. Call cancel() first.
    void waitForThread();
    /// Returns true from the start of a task until its result is delivered.
    bool isBusy() const { return m_busy; }

  private:
    /// Time after which a running task may be stopped for a waiting one. While the user drags a value,
    /// results that take less time are all shown.
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
