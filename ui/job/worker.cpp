// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/job/worker.h"

#ifdef Q_OS_LINUX
#include <sys/resource.h>
#endif

#include <utility>

namespace drillwave {
namespace {

// Acts only on the calling thread: Linux keeps the value for each, and 0 means the caller.
void yieldToTheWindow() {
#ifdef Q_OS_LINUX
    constexpr int steps = 5;
    setpriority(PRIO_PROCESS, 0, getpriority(PRIO_PROCESS, 0) + steps);
#endif
}

}  // namespace

// The standard library's locks and not Qt's: the thread sanitizer sees what they protect.
Worker::Worker(Urgency urgency, QObject* parent)
    : QObject(parent), m_thread([this, urgency] { work(urgency); }) {
    m_patience.setSingleShot(true);
    m_patience.setInterval(patience);
    connect(&m_patience, &QTimer::timeout, this, [this] {
        if (m_waiting) m_stop.request_stop();
    });
}

Worker::~Worker() {
    m_stop.request_stop();
    {
        const std::lock_guard hold(m_lock);
        m_ending = true;
    }
    m_changed.notify_all();
    m_thread.join();
}

void Worker::submit(Task task) {
    if (!m_busy) return start(std::move(task));
    m_waiting = std::move(task);
    if (!m_patience.isActive()) m_stop.request_stop();
}

void Worker::cancel() {
    m_waiting = nullptr;
    m_dropped = m_busy;
    m_stop.request_stop();
}

void Worker::waitForThread() {
    std::unique_lock hold(m_lock);
    m_changed.wait(hold, [this] { return !m_task; });
}

void Worker::start(Task task) {
    m_busy = true;
    m_dropped = false;
    m_stop = std::stop_source();
    m_patience.start();
    {
        const std::lock_guard hold(m_lock);
        m_task = std::move(task);
        m_taskStop = m_stop.get_token();
    }
    m_changed.notify_all();
}

void Worker::finish() {
    Delivery delivery;
    {
        const std::lock_guard hold(m_lock);
        delivery = std::move(m_delivery);
    }
    m_busy = false;
    const bool wanted = !m_dropped;
    if (m_waiting) start(std::exchange(m_waiting, nullptr));
    if (wanted) delivery();
}

// Runs on the worker's thread. A task stays in m_task while it is done: nobody replaces it before
// finish().
void Worker::work(Urgency urgency) {
    if (urgency == Urgency::background) yieldToTheWindow();
    std::unique_lock hold(m_lock);
    while (true) {
        m_changed.wait(hold, [this] { return m_task || m_ending; });
        if (m_ending) return;
        hold.unlock();
        Delivery delivery = m_task(m_taskStop);
        hold.lock();
        m_delivery = std::move(delivery);
        m_task = nullptr;
        m_changed.notify_all();
        QMetaObject::invokeMethod(this, &Worker::finish, Qt::QueuedConnection);
    }
}

}  // namespace drillwave
