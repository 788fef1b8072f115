// SPDX-License-Identifier: GPL-3.0-or-later
// The status line of a study: how far it is, how long it still takes, and a button that stops or resumes it.
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

// The status line of the solver: whether what is shown is the answer to the present input, and what waits for
// it.

/// Shorter waits are not noticed, but a mark or a line that appears and goes is.
inline constexpr std::chrono::milliseconds usualPatience{150};

/// Follows questions and answers. Shows that a late answer is on its way, with a button to stop it; a stopped
/// one stays out of date until it is requested again. Actions that need a current result wait here.
class SolveStatus : public QWidget {
    Q_OBJECT

  public:
    explicit SolveStatus(QWidget* parent = nullptr);

    /// Sets how long a question may be without an answer before the old one is marked.
    void setPatience(std::chrono::milliseconds patience) { m_late.setInterval(patience); }

    /// Notes that the input has changed or that another result is needed: the answer on show is out of
    /// date.
    void asked();
    /// Notes that the answer to the present input is shown; `summary` is one line. Runs the waiting action.
    void answered(const QString& summary);
    /// Notes that a quick answer to the present input is shown, and the sure one is on its way: nothing is
    /// out of date, but the waiting action needs the sure one.
    void answeredQuickly(const QString& summary);
    /// An answer to an earlier input is shown.
    void answeredEarlier();

    /// Whether what is shown is the sure answer to the present input.
    bool isCurrent() const { return m_state == State::current; }
    /// Whether the answer on show is marked as out of date.
    bool isMarked() const { return m_marked; }

    /// Calls `then` as soon as the answer is current: now, or when it arrives; `what` names it in the status
    /// line. Solves again if solving was stopped. Only the last one waits.
    void whenCurrent(const QString& what, std::function<void()> then);
    /// Drops the waiting action and shows the reason.
    void callOff(const QString& reason);
    bool isWaiting() const { return bool(m_waiting); }

    /// Sets what is shown before the summary of a result, such as the answer where its panel is out of sight;
    /// empty for nothing.
    void setLead(const QString& lead);

    /// The text of the line, which is cut short where it has no room.
    QString text() const { return m_line; }
    QPushButton* button() const { return m_button; }

  signals:
    /// isCurrent() has changed.
    void currentChanged(bool current);
    /// The answer on show is out of date and should look so, or is current again.
    void marked(bool outOfDate);
    /// The user stops the solver, or wants the answer after all.
    void stopRequested();
    void solveRequested();
    /// Something that waited is not done: why, in a line.
    void calledOff(const QString& message);

  protected:
    void resizeEvent(QResizeEvent* event) override;

  private:
    enum class State {
        current,
        quick,  ///< of the present input, and the sure answer is on its way
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

/// "Solve all (3 min)": the button that resumes a stopped study, of which these points took that long.
QString resumeText(const StudyProgress& progress, double seconds, const QLocale& locale);

/// Returns a time as "3 s" or "3 min", rounded up.
QString waitText(double seconds, const QLocale& locale);

/// Returns "640/1500 · 2 s left" after that many seconds; "640 · 320/s" for an unknown total. Returns only
/// the count while there is too little for a rate, and once the expected number is done.
QString progressText(const StudyProgress& progress, double seconds, const QLocale& locale);

/// Shows the activity of the page on show while it runs for more than a moment, and the progress of a stopped
/// one, with a button to resume it. It is hidden while it shows nothing.
class StudyStatus : public QWidget {
    Q_OBJECT

  public:
    explicit StudyStatus(QWidget* parent = nullptr);

    /// Sets how long a study may run unseen.
    void setPatience(std::chrono::milliseconds patience) { m_late.setInterval(patience); }
    /// Shows this activity from now on, with its name in front; nullptr for none.
    void follow(StudyActivity* activity, const QString& name);

    /// The text of the line; empty while it shows nothing.
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
    QElapsedTimer m_since;  // the study began
};

}  // namespace drillwave
