// SPDX-License-Identifier: GPL-3.0-or-later
// A study away from the window's thread: shown while it grows, stopped at any time, replaced by the next one.
#pragma once

#include <QObject>
#include <QString>
#include <QTimer>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <stop_token>
#include <utility>

#include "ui/job/worker.h"

namespace drillwave {

// Progress of a study of any kind: for the status line and the pages alike.

/// Count of the points of a study.
struct StudyProgress {
    std::size_t done = 0;
    std::size_t wanted = 0;  ///< 0 while nobody knows
    bool operator==(const StudyProgress&) const = default;
};

/// Seconds that a study may run on a page before the user asks for all of it.
inline constexpr std::chrono::seconds unaskedTime{10};

/// stopped: by the user, or after unaskedTime; what had been found stays. failed: see problem().
enum class StudyState { idle, running, finished, stopped, failed };

/// State and progress of a study as seen from outside.
class StudyActivity : public QObject {
    Q_OBJECT

  public:
    explicit StudyActivity(QObject* parent = nullptr);

    /// State of the last study.
    StudyState state() const { return m_state; }
    StudyProgress progress() const { return m_progress; }
    /// Why there is no result, in a sentence; empty unless the state is failed.
    QString problem() const { return m_problem; }
    /// Whether the value on show belongs to the last study, not to an earlier one.
    virtual bool isCurrent() const = 0;
    /// Number of values received, also of earlier studies: while it grows the window keeps up with the hand.
    std::uint64_t answers() const { return m_answers; }
    virtual void cancel() = 0;
    /// Runs a study that was stopped again, without limit of time.
    virtual void resume() = 0;
    /// Stops every study that runs longer, except resumed ones; 0 for no limit. None at first.
    void setTimeLimit(std::chrono::milliseconds limit) { m_limit = limit; }
    /// Whether the last study was stopped because its time was over.
    bool isOutOfTime() const { return m_isOutOfTime; }
    /// Stops the study and drops what there is to show.
    virtual void forget() = 0;

  signals:
    /// State, progress or value have changed.
    void changed();

  protected:
    /// Begins the time of a study that starts.
    void startTime();
    /// Lets a study that is resumed take the time it needs.
    void endTime();

    StudyState m_state = StudyState::idle;
    StudyProgress m_progress;
    QString m_problem;
    std::uint64_t m_answers = 0;

  private:
    std::chrono::milliseconds m_limit{0};
    QTimer m_time;
    bool m_isOutOfTime = false;
};

/// Receives progress and values from a running study, on any of its threads, until it returns. The window may
/// skip some of them, but always shows the last of each kind.
template <class Value>
struct StudyFeed {
    std::stop_token stop;  ///< a stop: the study returns soon, with anything
    std::function<void(StudyProgress)> tell;
    std::function<void(Value)> show;  ///< what there is so far: coarse, or only a part
};

/// Runs studies that replace each other as the tasks of a Worker do. The value of an earlier study stays
/// until the last study has one. Only the study runs outside the window's thread.
template <class Value>
class StudyJob : public StudyActivity {
  public:
    /// Holds its input by value. The text of an exception becomes problem().
    using Study = std::function<Value(const StudyFeed<Value>&)>;

    /// Stops the study in flight and waits for its end when it goes.
    explicit StudyJob(QObject* parent = nullptr) : StudyActivity(parent) {}

    void submit(Study study);
    void resume() override;
    /// Stops the study. Values shown so far stay.
    void cancel() override;
    void forget() override;
    /// The last that was shown, or the result; nullptr before the first.
    const std::shared_ptr<const Value>& value() const { return m_value; }
    bool isCurrent() const override { return m_value && m_valueOf == m_asked; }

  private:
    struct End {
        std::shared_ptr<const Value> value;
        QString problem;
    };
    // Values and progress reported since the window looked last.
    struct Mail {
        std::uint64_t study = 0;
        std::optional<StudyProgress> progress;
        std::shared_ptr<const Value> value;
    };

    void start();
    StudyFeed<Value> feed(std::uint64_t number, const std::stop_token& stop);
    static End run(const Study& study, const StudyFeed<Value>& feed);
    template <class Write>
    void post(std::uint64_t number, const Write& write);
    void fetch();
    void take();
    void end(std::uint64_t number, const End& end);

    // Seen by the window's thread only. Studies are counted from 1.
    Study m_study;
    std::uint64_t m_asked = 0;
    std::uint64_t m_dropped = 0;  // up to this one nobody wants to hear of them
    std::uint64_t m_valueOf = 0;
    std::shared_ptr<const Value> m_value;

    // Shared by the threads, under the lock.
    std::mutex m_lock;
    Mail m_mail;
    bool m_announced = false;  // take() is on its way through the event loop

    Worker m_worker{Worker::Urgency::background};  // goes first: its thread runs the studies
};

template <class Value>
void StudyJob<Value>::submit(Study study) {
    m_study = std::move(study);
    startTime();
    start();
}

template <class Value>
void StudyJob<Value>::resume() {
    if (m_state != StudyState::stopped) return;
    endTime();
    start();
}

template <class Value>
void StudyJob<Value>::start() {
    const std::uint64_t number = ++m_asked;
    m_state = StudyState::running;
    m_progress = {};
    m_problem.clear();
    m_worker.submit([this, number, study = m_study](const std::stop_token& stop) -> Worker::Delivery {
        End ended = run(study, feed(number, stop));
        // A study that was stopped for the next one is not finished, whatever it reports.
        if (stop.stop_requested()) ended = {};
        return [this, number, ended = std::move(ended)] { end(number, ended); };
    });
    emit changed();
}

template <class Value>
void StudyJob<Value>::cancel() {
    if (m_state != StudyState::running) return;
    fetch();
    m_dropped = m_asked;
    m_worker.cancel();
    m_state = StudyState::stopped;
    emit changed();
}

template <class Value>
void StudyJob<Value>::forget() {
    cancel();
    m_state = StudyState::idle;
    m_value.reset();
    m_valueOf = 0;
    emit changed();
}

template <class Value>
StudyFeed<Value> StudyJob<Value>::feed(std::uint64_t number, const std::stop_token& stop) {
    return {stop,
            [this, number](StudyProgress progress) {
                post(number, [&](Mail& mail) { mail.progress = progress; });
            },
            [this, number](Value value) {
                auto shown = std::make_shared<const Value>(std::move(value));
                post(number, [&](Mail& mail) { mail.value = std::move(shown); });
            }};
}

// An exception that leaves a thread ends the program, so none does.
template <class Value>
typename StudyJob<Value>::End StudyJob<Value>::run(const Study& study, const StudyFeed<Value>& feed) {
    try {
        return {std::make_shared<const Value>(study(feed)), {}};
    } catch (const std::exception& error) {
        return {nullptr, QString::fromUtf8(error.what())};
    } catch (...) {
        return {nullptr, QStringLiteral("The study failed for an unknown reason.")};
    }
}

// On any thread.
template <class Value>
template <class Write>
void StudyJob<Value>::post(std::uint64_t number, const Write& write) {
    {
        const std::lock_guard hold(m_lock);
        if (m_mail.study != number) m_mail = {number, {}, {}};
        write(m_mail);
        if (std::exchange(m_announced, true)) return;
    }
    QMetaObject::invokeMethod(this, &StudyJob::take, Qt::QueuedConnection);
}

template <class Value>
void StudyJob<Value>::take() {
    fetch();
    emit changed();
}

template <class Value>
void StudyJob<Value>::fetch() {
    Mail mail;
    {
        const std::lock_guard hold(m_lock);
        mail = std::exchange(m_mail, {});
        m_announced = false;
    }
    if (mail.study <= m_dropped) return;
    if (mail.value) {
        ++m_answers;
        m_value = mail.value;
        m_valueOf = mail.study;
    }
    if (mail.progress && mail.study == m_asked) m_progress = *mail.progress;
}

template <class Value>
void StudyJob<Value>::end(std::uint64_t number, const End& end) {
    fetch();
    if (end.value) {
        ++m_answers;
        m_value = end.value;
        m_valueOf = number;
    }
    if (number == m_asked) {
        m_state = end.value ? StudyState::finished : StudyState::failed;
        m_problem = end.problem;
    }
    emit changed();
}

// A study that is run for a question, and once only for the same one.

/// Runs `study` of a question away from the window's thread. Question is a value with ==.
template <class Question, class Value>
class StudyRunner {
  public:
    /// Called on the job's thread: holds nothing of the window.
    using Study = std::function<Value(const Question&, const StudyFeed<Value>&)>;

    explicit StudyRunner(Study study) : m_study(std::move(study)) {}

    /// Runs the study unless it runs for the same question, or has been finished for it. Whether it was
    /// started.
    bool ask(Question question) {
        const bool answered = m_job.state() == StudyState::running || m_job.state() == StudyState::finished;
        if (answered && m_question == question) return false;
        m_question = question;
        ++m_started;
        m_job.submit([study = m_study, question = std::move(question)](const StudyFeed<Value>& feed) {
            return study(question, feed);
        });
        return true;
    }

    /// The question asked last; nothing before the first.
    const std::optional<Question>& question() const { return m_question; }
    StudyJob<Value>& job() { return m_job; }
    const StudyJob<Value>& job() const { return m_job; }
    /// The result of the last question, finished or so far, or of an earlier one; nullptr at first.
    const Value* value() const { return m_job.value().get(); }
    /// How many studies were started.
    int started() const { return m_started; }

  private:
    Study m_study;
    std::optional<Question> m_question;
    int m_started = 0;
    StudyJob<Value> m_job;
};

}  // namespace drillwave
