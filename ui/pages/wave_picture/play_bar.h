// SPDX-License-Identifier: GPL-3.0-or-later
// Controls that move the time cursor: play, pause, slider and speed.
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

/// Bar with a play button, a slider and the speed. While it is visible, it moves the time cursor through a
/// time span. Its owner follows timeChosen() and reports the time back by setTime().
class PlayBar : public QWidget {
    Q_OBJECT

  public:
    explicit PlayBar(QWidget* parent = nullptr);

    /// Sets the time span to play [t0]. `secondsPerUnit` is t0 [s], or 0 for a dimensionless scenario.
    void setSpan(const TimeSpan& span, double secondsPerUnit);
    /// Moves the slider to the time t of the time cursor [t0, the time scale of the blow].
    void setTime(double t);
    /// Sets the time of the cursor in words, which screen readers speak at the slider.
    void setTimeText(const QString& text);
    bool isPlaying() const { return m_timer.isActive(); }
    /// Starts playing at the cursor, or at the beginning of the span if the cursor is at its end.
    void play();
    void pause();
    void toggle();

    /// Returns how long playing the whole span takes [s].
    double secondsForSpan() const;
    bool loops() const;

  signals:
    /// Reports a new time t [t0] of the time cursor, set by the user or by playing.
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
