// SPDX-License-Identifier: GPL-3.0-or-later
// The status line of the solver: whether what is shown is the answer to the present input, and what waits for
// it.
#pragma once

#include <QLabel>
#include <QPushButton>
#include <QTimer>
#include <chrono>
#include <functional>

namespace drillwave {

/// Shorter waits are not noticed, and a mark or a line that comes and goes is.
inline constexpr std::chrono::milliseconds usualPatience{150};

/// Follows questions and answers. A late answer is said to be on its way, with a button to stop it; a stopped
/// one stays out of date until it is asked for again. What must not be done with an old result waits here.
class SolveStatus : public QWidget {
    Q_OBJECT

  public:
    explicit SolveStatus(QWidget* parent = nullptr);

    /// How long a question may be without an answer before the old one is marked.
    void setPatience(std::chrono::milliseconds patience) { m_late.setInterval(patience); }

    /// The input has changed, or something else is wanted of it: what is shown is the answer to something
    /// else.
    void asked();
    /// The answer to the present input is shown; its summary in a line. What waited is done.
    void answered(const QString& summary);
    /// A quick answer to the present input is shown, and the sure one is on its way: nothing is out of date,
    /// but what waits is for the sure one.
    void answeredQuickly(const QString& summary);
    /// An answer to an earlier input is shown.
    void answeredEarlier();

    /// Whether what is shown is the sure answer to the present input.
    bool isCurrent() const { return m_state == State::current; }
    /// Whether what is shown is marked as out of date.
    bool isMarked() const { return m_marked; }

    /// Calls `then` as soon as what is shown is current: now, or when the answer comes; `what` names it in
    /// the status line. Asks anew where solving was stopped. Only the last one waits.
    void whenCurrent(const QString& what, std::function<void()> then);
    /// What waits is not done; says so with the reason.
    void callOff(const QString& reason);
    bool isWaiting() const { return bool(m_waiting); }

    QString text() const { return m_text->text(); }
    QPushButton* button() const { return m_button; }

  signals:
    /// isCurrent() has changed.
    void currentChanged(bool current);
    /// What is shown is out of date and is to look like it, or is so no more.
    void marked(bool outOfDate);
    /// The user stops the solver, or wants the answer after all.
    void stopRequested();
    void solveRequested();
    /// Something that waited is not done: why, in a line.
    void calledOff(const QString& message);

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

    QLabel* m_text;
    QPushButton* m_button;
    QTimer m_late;
    State m_state = State::current;
    bool m_marked = false;
    QString m_summary;
    QString m_what;
    std::function<void()> m_waiting;
};

}  // namespace drillwave
