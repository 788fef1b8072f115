// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/pages/wave_picture/play_bar.h"

#include <QComboBox>
#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QPainter>
#include <QSignalBlocker>
#include <QSlider>
#include <QToolButton>
#include <algorithm>
#include <cmath>

#include "ui/text/number_text.h"
#include "ui/text/settings.h"
#include "ui/text/unfocused_wheel.h"

namespace drillwave {
namespace {

constexpr int sliderSteps = 1000;
constexpr int framePeriod = 17;       // [ms], not more than 60 a second
constexpr double longestFrame = 0.1;  // [s]: after a pause of the whole window the cursor does not leap
const QString speedKey = QStringLiteral("wavePicture/seconds");
const QString loopKey = QStringLiteral("wavePicture/loop");

// Drawn in the colour of the text: the icons of a style may be lost on a dark window.
QIcon symbol(bool pause, const QColor& colour) {
    constexpr int size = 64;
    QPixmap pixmap(size, size);
    pixmap.fill(Qt::transparent);
    QPainter painter(&pixmap);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(Qt::NoPen);
    painter.setBrush(colour);
    if (pause) {
        painter.drawRect(QRectF(0.2 * size, 0.15 * size, 0.2 * size, 0.7 * size));
        painter.drawRect(QRectF(0.6 * size, 0.15 * size, 0.2 * size, 0.7 * size));
    } else {
        painter.drawPolygon(
            QPolygonF({{0.2 * size, 0.1 * size}, {0.2 * size, 0.9 * size}, {0.9 * size, 0.5 * size}}));
    }
    return QIcon(pixmap);
}

}  // namespace

PlayBar::PlayBar(QWidget* parent)
    : QWidget(parent),
      m_play(new QToolButton(this)),
      m_slider(new QSlider(Qt::Horizontal, this)),
      m_speed(new QComboBox(this)),
      m_loop(new QToolButton(this)),
      m_slowness(new QLabel(this)) {
    ignoreUnfocusedWheel(*m_speed);
    addControls();
    restoreChoices();
    m_timer.setInterval(framePeriod);
    m_timer.setTimerType(Qt::PreciseTimer);
    presentPlaying();
    connect(&m_timer, &QTimer::timeout, this, &PlayBar::advance);
    connect(m_play, &QToolButton::clicked, this, &PlayBar::toggle);
    connect(m_slider, &QSlider::valueChanged, this, &PlayBar::scrub);
    connect(m_speed, &QComboBox::currentIndexChanged, this, [this] {
        Settings().setValue(speedKey, m_speed->currentData());
        presentSpeed();
    });
    connect(m_loop, &QToolButton::toggled, this, [](bool on) { Settings().setValue(loopKey, on); });
}

void PlayBar::addControls() {
    m_play->setObjectName(QStringLiteral("play"));
    m_play->setFocusPolicy(Qt::StrongFocus);
    m_slider->setObjectName(QStringLiteral("timeSlider"));
    m_slider->setRange(0, sliderSteps);
    m_slider->setPageStep(sliderSteps / 20);
    m_slider->setAccessibleName(tr("Time cursor"));
    m_slider->setToolTip(tr("Moves the time cursor through the times in view"));
    m_speed->setObjectName(QStringLiteral("speed"));
    for (const int seconds : {2, 5, 10, 20, 60}) m_speed->addItem(tr("in %1 s").arg(seconds), seconds);
    m_speed->setAccessibleName(tr("Duration of playing the times in view"));
    m_speed->setToolTip(m_speed->accessibleName());
    m_loop->setObjectName(QStringLiteral("loop"));
    m_loop->setCheckable(true);
    m_loop->setFocusPolicy(Qt::StrongFocus);
    m_loop->setText(tr("Loop"));
    m_loop->setAccessibleName(tr("Play again and again"));
    m_loop->setToolTip(m_loop->accessibleName());
    auto* layout = new QHBoxLayout(this);
    layout->setContentsMargins(8, 0, 8, 6);
    layout->addWidget(m_play);
    layout->addWidget(m_slider, 1);
    layout->addWidget(m_speed);
    layout->addWidget(m_loop);
    layout->addWidget(m_slowness);
}

void PlayBar::restoreChoices() {
    const Settings settings;
    m_speed->setCurrentIndex(std::max(0, m_speed->findData(settings.value(speedKey, 10).toInt())));
    m_loop->setChecked(settings.value(loopKey, true).toBool());
}

double PlayBar::secondsForSpan() const {
    return m_speed->currentData().toDouble();
}

bool PlayBar::loops() const {
    return m_loop->isChecked();
}

void PlayBar::setSpan(const TimeSpan& span, double secondsPerUnit) {
    m_span = span;
    m_secondsPerUnit = secondsPerUnit;
    setTime(m_time);
    presentSpeed();
}

void PlayBar::setTime(double t) {
    m_time = t;
    const double share = (t - m_span.begin) / (m_span.end - m_span.begin);
    const QSignalBlocker quiet(m_slider);
    m_slider->setValue(static_cast<int>(std::lround(sliderSteps * std::clamp(share, 0.0, 1.0))));
}

void PlayBar::setTimeText(const QString& text) {
    m_slider->setAccessibleDescription(text);
}

void PlayBar::scrub(int place) {
    emit timeChosen(m_span.begin + (m_span.end - m_span.begin) * place / sliderSteps);
}

void PlayBar::toggle() {
    isPlaying() ? pause() : play();
}

void PlayBar::play() {
    if (isPlaying() || !isVisible()) return;
    m_clock.start();
    m_timer.start();
    presentPlaying();
    const bool isInside = m_time >= m_span.begin && m_time < m_span.end;
    if (!isInside) emit timeChosen(m_span.begin);
    emit playingChanged(true);
}

void PlayBar::pause() {
    if (!isPlaying()) return;
    m_timer.stop();
    presentPlaying();
    emit playingChanged(false);
}

void PlayBar::advance() {
    if (!isVisible() || window()->isMinimized()) return pause();
    const double seconds = std::min(longestFrame, static_cast<double>(m_clock.nsecsElapsed()) * 1e-9);
    m_clock.start();
    double t = m_time + seconds / secondsForSpan() * (m_span.end - m_span.begin);
    const bool isOver = !(t < m_span.end);
    if (isOver) t = loops() ? m_span.begin : m_span.end;
    emit timeChosen(t);
    if (isOver && !loops()) pause();
}

void PlayBar::hideEvent(QHideEvent* event) {
    pause();
    QWidget::hideEvent(event);
}

void PlayBar::changeEvent(QEvent* event) {
    QWidget::changeEvent(event);
    if (event->type() == QEvent::PaletteChange) presentPlaying();
}

void PlayBar::presentPlaying() {
    const bool playing = isPlaying();
    m_play->setIcon(symbol(playing, palette().color(QPalette::ButtonText)));
    m_play->setAccessibleName(playing ? tr("Pause") : tr("Play"));
    m_play->setToolTip(playing ? tr("Pause (space bar)") : tr("Play the blow (space bar)"));
}

void PlayBar::presentSpeed() {
    const double unitsPerSecond = (m_span.end - m_span.begin) / secondsForSpan();
    if (m_secondsPerUnit > 0)
        m_slowness->setText(
            tr("%1 times slower").arg(locale().toString(1 / (unitsPerSecond * m_secondsPerUnit), 'f', 0)));
    else
        m_slowness->setText(tr("%1 t₀ per second").arg(numberText(unitsPerSecond, 3, locale())));
}

}  // namespace drillwave
