// SPDX-License-Identifier: GPL-3.0-or-later
// Studies computed in another thread than the window's: they show partial results, can be stopped, and
// replace each other.
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

// Progress of a study of any type, for the status line and the pages.

/// Progress of a study: number of computed points, and number of points in total.
struct StudyProgress {
    std::size_t done = 0;
    std::size_t wanted = 0;  ///< number of points in total; 0 if unknown
    bool operator==(const StudyProgress&) const = default;
};

/// Default time limit [s] of studies that the window starts by itself. The user can ask for the rest.
inline constexpr std::chrono::seconds unaskedTime{10};

/// State of a study (a long computation in the background). `stopped` means stopped by the user or by its
/// time limit, with partial results kept. `failed` means that StudyActivity::problem() returns the reason.
enum class StudyState { idle, running, finished, stopped, failed };

/// State and progress of a study (long computation in the background), independent of the type of its result.
class StudyActivity : public QObject {
    Q_OBJECT

  public:
    explicit StudyActivity(QObject* parent = nullptr);

    /// Returns the state of the last study.
    StudyState state() const { return m_state; }
    StudyProgress progress() const { return m_progress; }
    /// Returns the reason why a study has no result, as a sentence; empty unless the state is `failed`.
    QString problem() const { return m_problem; }
    /// Returns true if the shown result belongs to the last study, not to an earlier one.
    virtual bool isCurrent() const = 0;
    /// Returns the number of results received so far, including intermediate results and those of earlier
    /// studies. While it grows, the shown results follow the user's input and are not marked as out of date.
    std::uint64_t answers() const { return m_answers; }
    virtual void cancel() = 0;
    /// Runs a stopped study again, now without a time limit.
    virtual void resume() = 0;
    /// Sets the time limit after which a study is stopped; 0, the initial value, for no limit. Resumed
    /// studies have no limit.
    void setTimeLimit(std::chrono::milliseconds limit) { m_limit = limit; }
    /// Returns true if the last study was stopped because it reached the time limit.
    bool isOutOfTime() const { return m_isOutOfTime; }
    /// Stops the study and removes its results, for example for a new scenario.
    virtual void forget() = 0;

  signals:
    /// Emitted when state, progress or results have changed.
    void changed();

  protected:
    /// Starts the timer of the time limit; called when a study starts.
    void startTime();
    /// Removes the time limit; called when the user resumes a stopped study.
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

/// Callbacks by which a running study reports progress and intermediate results. They may be called in any of
/// its threads until the study returns. The window may skip some reports, but always shows the last progress
/// and the last result.
template <class Value>
struct StudyFeed {
    std::stop_token stop;  ///< stop token; after a stop the study must return soon, with any value
    std::function<void(StudyProgress)> tell;
    std::function<void(Value)> show;  ///< shows an intermediate value, which may be coarse or only a part
};

/// Runner of studies (long computations) outside the window's thread. A new study replaces a waiting one (see
/// Worker). The result of an earlier study stays until the last study has a result.
template <class Value>
class StudyJob : public StudyActivity {
  public:
    /// Function that computes a study in the background. It must own copies of its inputs. If it throws,
    /// problem() returns the text of the exception.
    using Study = std::function<Value(const StudyFeed<Value>&)>;

    /// Makes a job without a study. The destructor stops a running study and waits for its end.
    explicit StudyJob(QObject* parent = nullptr) : StudyActivity(parent) {}

    void submit(Study study);
    void resume() override;
    /// Stops the study; results shown so far stay.
    void cancel() override;
    void forget() override;
    /// Returns the result of the study, or its latest intermediate result; nullptr before there is one.
    const std::shared_ptr<const Value>& value() const { return m_value; }
    bool isCurrent() const override { return m_value && m_valueOf == m_asked; }

  private:
    struct End {
        std::shared_ptr<const Value> value;
        QString problem;
    };
    // Values and progress reported since the window last fetched them.
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

    // Used only in the window's thread. Studies are numbered from 1.
    Study m_study;
    std::uint64_t m_asked = 0;
    std::uint64_t m_dropped = 0;  // studies up to this number were cancelled, and their reports are ignored
    std::uint64_t m_valueOf = 0;
    std::shared_ptr<const Value> m_value;

    // Shared by the threads; protected by m_lock.
    std::mutex m_lock;
    Mail m_mail;
    bool m_announced = false;  // a call of take() is queued in the event loop

    Worker m_worker{Worker::Urgency::background};  // declared last: its thread must end first
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

// Stores a report of a study; called in any thread.
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

// Studies that are run only once for the same question.

/// Runner of one study outside the window's thread, which is not repeated for an equal question. Question is
/// a value type with ==.
template <class Question, class Value>
class StudyRunner {
  public:
    /// Function that computes the study of a question. It is called in another thread than the window's and
    /// must not use objects of the window.
    using Study = std::function<Value(const Question&, const StudyFeed<Value>&)>;

    explicit StudyRunner(Study study) : m_study(std::move(study)) {}

    /// Starts the study for a question, unless it is running or finished for an equal one. Returns true if it
    /// was started.
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

    /// Returns the last question passed to ask(); nothing before the first call.
    const std::optional<Question>& question() const { return m_question; }
    StudyJob<Value>& job() { return m_job; }
    const StudyJob<Value>& job() const { return m_job; }
    /// Returns the last result or intermediate value, which may belong to an earlier question; nullptr at
    /// first.
    const Value* value() const { return m_job.value().get(); }
    /// Returns the number of times that ask() has started the study.
    int started() const { return m_started; }

  private:
    Study m_study;
    std::optional<Question> m_question;
    int m_started = 0;
    StudyJob<Value> m_job;
};

}  // namespace drillwave
