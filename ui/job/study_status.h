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

#include "ui/job/study_activity.h"

namespace drillwave {

/// "Solve all (3 min)": the button that resumes a stopped study, of which these points took that long.
QString resumeText(const StudyProgress& progress, double seconds, const QLocale& locale);

/// "640/1500 · 2 s left" after that many seconds; "640 · 320/s" where nobody knows how many there will be.
/// Only the count while there is too little to tell the rate, and where all that was thought of is done.
QString progressText(const StudyProgress& progress, double seconds, const QLocale& locale);

/// Shows the activity of the page on show while it runs for more than a moment, and what was reached of one
/// that was stopped, with a button to resume it. Its place is kept while it shows nothing.
class StudyStatus : public QWidget {
    Q_OBJECT

  public:
    explicit StudyStatus(QWidget* parent = nullptr);

    /// How long a study may run unseen.
    void setPatience(std::chrono::milliseconds patience) { m_late.setInterval(patience); }
    /// From now on of this activity, whose name goes before; nullptr for none.
    void follow(StudyActivity* activity, const QString& name);

    /// What it says; empty while it shows nothing.
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
