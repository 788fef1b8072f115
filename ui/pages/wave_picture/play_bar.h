// SPDX-License-Identifier: GPL-3.0-or-later
// Play, pause, scrub and speed: the controls that move the time cursor.
#pragma once

#include <QElapsedTimer>
#include <QTimer>
#include <QWidget>

#include "ui/pages/wave_picture/wave_picture.h"

class QComboBox;
class QLabel;
class QSlider;
class QToolButton;

namespace drillwave {

/// Plays a span of time at a chosen speed, as long as it can be seen. Its owner follows its times, and sets
/// the place of the cursor.
class PlayBar : public QWidget {
    Q_OBJECT

  public:
    explicit PlayBar(QWidget* parent = nullptr);

    /// Sets the span to play and scrub, t/t0; `secondsPerUnit` is t0 [s], 0 where there is none.
    void setSpan(const TimeSpan& span, double secondsPerUnit);
    /// Sets the place of the time cursor, t/t0.
    void setTime(double t);
    /// Sets the time in words.
    void setTimeText(const QString& text);
    bool isPlaying() const { return m_timer.isActive(); }
    /// Starts at the cursor, at the beginning when the cursor is not before the end of the span.
    void play();
    void pause();
    void toggle();

    /// Duration of the span while it is played [s].
    double secondsForSpan() const;
    bool loops() const;

  signals:
    /// Wanted by the user or by playing, t/t0.
    void timeChosen(double t);
    void playingChanged(bool playing);

  protected:
    void hideEvent(QHideEvent* event) override;
    void changeEvent(QEvent* event) override;

  private:
    void addControls();
    void restoreChoices();
    void advance();
    void scrub(int place);
    void presentPlaying();
    void presentSpeed();

    QToolButton* m_play;
    QSlider* m_slider;
    QComboBox* m_speed;
    QToolButton* m_loop;
    QLabel* m_slowness;
    QTimer m_timer;
    QElapsedTimer m_clock;
    TimeSpan m_span;
    double m_secondsPerUnit = 0;
    double m_time = 0;
};

}  // namespace drillwave
