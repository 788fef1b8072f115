// SPDX-License-Identifier: GPL-3.0-or-later
// Status line of a study: progress, remaining time, and a button that stops or resumes it.
#pragma once

#include <QElapsedTimer>
#include <QLabel>
#include <QLocale>
#include <QPointer>
#include <QProgressBar>
#include <QPushButton>
#include <QTimer>
#include <chrono>
#include <functional>

#include "ui/job/study_job.h"

namespace drillwave {

// Status line of the solver: whether the result shown belongs to the present input, and which action waits
// for it.

/// Time that the solver may take before the old result is marked as out of date. Marking it sooner would only
/// flicker.
inline constexpr std::chrono::milliseconds usualPatience{150};

/// Status line of the solver for the blow that the window shows. If a result takes long, it shows that, with
/// a button to stop the solver. After a stop, the result stays out of date until solving is requested again.
/// It also keeps an action that waits for a current result, such as an export.
class SolveStatus : public QWidget {
    Q_OBJECT

  public:
    explicit SolveStatus(QWidget* parent = nullptr);

    /// Sets how long the solver may work on a new input before the old result is marked as out of date.
    void setPatience(std::chrono::milliseconds patience) { m_late.setInterval(patience); }

    /// Marks the shown result as not current. Must be called when the input has changed or another result is
    /// needed.
    void asked();
    /// Marks the shown result as current and runs the waiting action, if any. Must be called when the answer
    /// to the present input is shown. `summary` describes the answer in one line.
    void answered(const QString& summary);
    /// Reports that a quick answer of reduced accuracy is shown, while the accurate one is being computed.
    /// The result does not count as out of date. An action passed to whenCurrent() still waits for the
    /// accurate answer. `summary` describes the quick answer in one line.
    void answeredQuickly(const QString& summary);
    /// Restarts the time after which the shown result is marked as out of date. Must be called when an answer
    /// to an earlier input is shown, because the display then still follows the input.
    void answeredEarlier();

    /// Returns true if the accurate answer to the present input is shown.
    bool isCurrent() const { return m_state == State::current; }
    /// Returns true if the result shown is marked as out of date.
    bool isMarked() const { return m_marked; }

    /// Calls `then` as soon as the result is current: now, or when it arrives. `what` names this action in
    /// the status line. Solves again if the solver was stopped. An action that already waits is replaced.
    void whenCurrent(const QString& what, std::function<void()> then);
    /// Cancels the action that waits for a current result, if any, and emits calledOff() with the reason.
    void callOff(const QString& reason);
    bool isWaiting() const { return bool(m_waiting); }

    /// Sets a text to show before the summary of the result; empty for no text. It is used for the main
    /// result if the result panel is hidden.
    void setLead(const QString& lead);

    /// Returns the full text of the line, which may be shown abbreviated.
    QString text() const { return m_line; }
    QPushButton* button() const { return m_button; }

  signals:
    /// Emitted when isCurrent() has changed.
    void currentChanged(bool current);
    /// Emitted when the shown result should be marked as out of date (`outOfDate` is true), or as current
    /// again (false).
    void marked(bool outOfDate);
    /// Emitted when the user stops the solver.
    void stopRequested();
    /// Emitted when the user requests the result after solving was stopped.
    void solveRequested();
    /// Emitted when the action that waits for a current result is cancelled; `message` gives the reason in
    /// one line.
    void calledOff(const QString& message);

  protected:
    void resizeEvent(QResizeEvent* event) override;

  private:
    enum class State {
        current,
        quick,  ///< quick answer to the present input is shown; the accurate one is in progress
        solving,
        stopped
    };

    void setState(State state);
    void setMarked(bool outOfDate);
    void press();
    void tell();
    void elide();

    QLabel* m_text;
    QPushButton* m_button;
    QTimer m_late;
    State m_state = State::current;
    bool m_marked = false;
    QString m_summary;
    QString m_lead;
    QString m_line;
    QString m_what;
    std::function<void()> m_waiting;
};

/// Returns the label of the button that resumes a stopped study, "Solve all (3 min)". `seconds` is the time
/// that the points in `progress` took; the total time is extrapolated.
QString resumeText(const StudyProgress& progress, double seconds, const QLocale& locale);

/// Returns a time [s], rounded up, as "3 s", or above 99 s as "3 min".
QString waitText(double seconds, const QLocale& locale);

/// Returns the progress after `seconds`: "640/1500 · 2 s left", or "640 · 320/s" for an unknown total. Only
/// the count is given before a rate is known, and once all points are done.
QString progressText(const StudyProgress& progress, double seconds, const QLocale& locale);

/// Status line for the study (long computation) that the visible page shows. It appears if the study runs
/// longer than a moment. For a stopped study it shows the progress and a button to resume it. Otherwise it is
/// hidden.
class StudyStatus : public QWidget {
    Q_OBJECT

  public:
    explicit StudyStatus(QWidget* parent = nullptr);

    /// Sets how long a study may run before its status is shown.
    void setPatience(std::chrono::milliseconds patience) { m_late.setInterval(patience); }
    /// Shows the status of a study from now on, with its `name` before the progress; nullptr for no study.
    void follow(StudyActivity* activity, const QString& name);

    /// Returns the text of the line; empty while it is hidden.
    QString text() const;
    QPushButton* button() const { return m_button; }

  private:
    void update();
    void showRunning();
    void showStopped(double seconds);
    void setButton(const QString& words, const QString& toolTip);
    void setTitle(const QString& title, const QString& shortTitle);
    bool fitsItsLine() const;
    void clear();

    QPointer<StudyActivity> m_activity;
    QString m_name;
    QLabel* m_title;
    QProgressBar* m_bar;
    QLabel* m_text;
    QPushButton* m_button;
    QTimer m_late;
    QElapsedTimer m_since;  // time since the study began
};

}  // namespace drillwave
