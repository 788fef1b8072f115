// SPDX-License-Identifier: GPL-3.0-or-later
// How far a study is, whatever it computes: for the status line and the pages alike.
#pragma once

#include <QObject>
#include <QString>
#include <cstddef>
#include <cstdint>

namespace drillwave {

/// Of the points of a study.
struct StudyProgress {
    std::size_t done = 0;
    std::size_t wanted = 0;  ///< 0 while nobody knows
    bool operator==(const StudyProgress&) const = default;
};

/// stopped: by the user; what had been found stays. failed: see problem().
enum class StudyState { idle, running, finished, stopped, failed };

/// What can be seen of a study from outside.
class StudyActivity : public QObject {
    Q_OBJECT

  public:
    using QObject::QObject;

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
    /// Stops the study and drops what there is to show.
    virtual void forget() = 0;

  signals:
    /// State, progress or value have changed.
    void changed();

  protected:
    StudyState m_state = StudyState::idle;
    StudyProgress m_progress;
    QString m_problem;
    std::uint64_t m_answers = 0;
};

}  // namespace drillwave
