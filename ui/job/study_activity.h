// SPDX-License-Identifier: GPL-3.0-or-later
// How far a study is, whatever it computes: for the status line and the pages alike.
#pragma once

#include <QObject>
#include <QString>
#include <QTimer>
#include <chrono>
#include <cstddef>
#include <cstdint>

namespace drillwave {

/// Of the points of a study.
struct StudyProgress {
    std::size_t done = 0;
    std::size_t wanted = 0;  ///< 0 while nobody knows
    bool operator==(const StudyProgress&) const = default;
};

/// Seconds that a study may run on a page before the user asks for all of it.
inline constexpr std::chrono::seconds unaskedTime{10};

/// stopped: by the user, or after unaskedTime; what had been found stays. failed: see problem().
enum class StudyState { idle, running, finished, stopped, failed };

/// What can be seen of a study from outside.
class StudyActivity : public QObject {
    Q_OBJECT

  public:
    explicit StudyActivity(QObject* parent = nullptr);

    /// Of the study asked for last.
    StudyState state() const { return m_state; }
    StudyProgress progress() const { return m_progress; }
    /// Why there is no result, in a sentence; empty unless the state is failed.
    QString problem() const { return m_problem; }
    /// Whether what there is to show is of the study asked for last, not of an earlier one.
    virtual bool isCurrent() const = 0;
    /// How many values have come, of earlier studies too: while it grows the window keeps up with the hand.
    std::uint64_t answers() const { return m_answers; }
    virtual void cancel() = 0;
    /// Runs a study that was stopped again, without limit of time.
    virtual void resume() = 0;
    /// Stops every study that runs longer, resumed ones excepted; 0 for no limit. None at first.
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

}  // namespace drillwave
