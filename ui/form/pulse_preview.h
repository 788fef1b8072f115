// SPDX-License-Identifier: GPL-3.0-or-later
// A small drawing of the force of the hammer over time.
#pragma once

#include <QPolygonF>
#include <QWidget>

#include "core/model/scenario.h"
#include "ui/text/unit_kind.h"

namespace drillwave {

/// Names the peak of the force and the time t0, in SI where the scenario has it.
class PulsePreview : public QWidget {
    Q_OBJECT

  public:
    explicit PulsePreview(QWidget* parent = nullptr);

    void present(const Scenario& scenario);
    /// The drawing in words: "rectangular, 200 µs, 255 kN".
    QString words() const { return m_words; }

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override;

  protected:
    void paintEvent(QPaintEvent* event) override;

  private:
    QPolygonF m_curve;  // time in t0, force relative to the peak
    double m_end = 0;   // of the curve, in t0
    QString m_peakText;
    QString m_timeText;
    QString m_words;
};

/// "half sine", as people write it.
QString shapeText(PulseShape shape);

/// A duration, force or impulse of the hammer with three digits, in the user's units: "200 µs", "57.3 kip".
QString pulseText(double si, UnitKind kind);

/// The same of a bound ≥ 0, never smaller than it is.
QString pulseBoundText(double si, UnitKind kind);

}  // namespace drillwave
